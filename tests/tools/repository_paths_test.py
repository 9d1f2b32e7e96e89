#!/usr/bin/env python3
"""Reports name files as seen from the repository's root, wherever in it the run was started."""

import json
import os
import re

from program import WALK, CheckoutCase, main

FAILING = WALK.replace('never: "collision.enter hut/wall"', "never: popup.open hut")
BROKEN = WALK.replace("walk_to: end", "walk_to: nowhere")
REPORTERS = ("list", "junit", "tap", "json", "jsonl", "github", "markdown")


class RepositoryPaths(CheckoutCase):
    """The files are in checkout/campus, and so is the run, unless a test says otherwise."""

    def setUp(self):
        super().setUp()
        os.makedirs(self.path("campus"))
        for name in set(os.listdir(self.folder)) - {".git", "campus"}:
            os.rename(self.path(name), self.path("campus/" + name))
        self.write("campus/failing.walk.yaml", FAILING)
        self.write("campus/broken.walk.yaml", BROKEN)

    def run_there(self, *arguments, folder="campus", **options):
        reporters = [word for name in REPORTERS for word in ("--reporter", f"{name}=reports/{name}")]
        outcome = self.run_program("run", "--rendering-backend", "none", *reporters, *arguments, cwd=self.path(folder),
                                   **options)
        self.assertEqual(outcome.code, 2, outcome.err)

    def assert_names(self, expected, folder="campus/reports"):
        """Each report names the walk so, and nothing of this machine."""
        for name in REPORTERS:
            text = self.read(f"{folder}/{name}").decode()
            self.assertRegex(text, r'(?<![\w/.])' + re.escape(expected) + r"failing\.walk\.yaml", name)
            self.assertNotRegex(text, r'(?<!/)(?<!' + re.escape(expected) + r')\bfailing\.walk\.yaml', name)
            self.assertNotIn(os.path.dirname(self.folder), text, name)
            self.assertNotIn("../", text, name)

    def test_in_a_folder_of_a_repository(self):
        self.run_there()
        self.assert_names("campus/")
        self.assertIn(b"::error file=campus/failing.walk.yaml,line=9", self.read("campus/reports/github"))
        self.assertIn(b"::error file=campus/broken.walk.yaml,line=5", self.read("campus/reports/github"))
        self.assertIn(b'classname="campus/failing.walk.yaml"', self.read("campus/reports/junit"))

    def test_from_its_root(self):
        self.run_there("campus", folder=".")
        self.assert_names("campus/", folder="reports")

    def test_with_absolute_paths(self):
        self.run_there(self.path("campus"), "--output", self.path("results"))
        self.assert_names("campus/")

    def test_the_variables_of_services_come_first(self):
        outer = os.path.dirname(self.folder)
        for variable in ("GITHUB_WORKSPACE", "CI_PROJECT_DIR"):
            self.run_there(env={**os.environ, variable: outer})
            self.assert_names("checkout/campus/")
            self.run_there(env={**os.environ, variable: self.path("campus")})
            self.assert_names("")
            for elsewhere in (self.path("campus/avatars"), "/nowhere", ""):
                self.run_there(env={**os.environ, variable: elsewhere})
                self.assert_names("campus/")

    def test_outside_a_repository(self):
        os.rmdir(self.path(".git"))
        self.run_there()
        self.assert_names("")

    def test_attachments_are_where_the_files_are(self):
        self.run_there("--record", "csv")
        attachments = re.findall(r"\[\[ATTACHMENT\|(.*?)\]\]", self.read("campus/reports/junit").decode())
        self.assertEqual(len(attachments), 2)
        for attachment in attachments:
            self.assertTrue(os.path.isfile(self.path(attachment)), attachment)

    def test_reports_are_read_back(self):
        self.run_there()
        merged = [word for name in REPORTERS for word in ("--reporter", f"{name}=merged/{name}")]
        # The report says where the run was started: it is the same report, wherever it is merged.
        outcome = self.run_program("merge-reports", "campus/reports/jsonl", *merged)
        self.assertEqual(outcome.code, 2, outcome.err)
        for name in REPORTERS:
            self.assertEqual(self.read("merged/" + name), self.read("campus/reports/" + name), name)
        replayed = self.run_program("replay", "reports/jsonl", "--verify", cwd=self.path("campus"))
        self.assertIn("2 of 3 walks went the same again", replayed.out)
        os.remove(self.path("campus/broken.walk.yaml"))
        again = self.run_program("run", "--last-failed", "--list", cwd=self.path("campus"))
        self.assertEqual(again.lines, ["failing.walk.yaml"])

    def test_pictures_are_shown_where_they_are_published(self):
        self.run_program("run", "failing.walk.yaml", "--reporter", "jsonl=run.jsonl", cwd=self.path("campus"))
        artifacts = json.loads(self.read("campus/run.jsonl").splitlines()[1])["artifacts"]
        pictures = [each["path"] for each in artifacts if each["media_type"] == "image/png"]
        if not pictures:
            self.skipTest("this program draws none")
        self.run_program("merge-reports", "campus/run.jsonl", "--output", "campus/out", "--pictures-url",
                         "https://pictures.example/42", "--reporter", "markdown=summary.md")
        shown = re.findall(r"!\[.*\]\(<https://pictures\.example/42/(.*)>\)", self.read("summary.md").decode())
        self.assertEqual(shown, ["campus/out/" + picture for picture in pictures])

    def test_validation_for_services(self):
        for name, place in (("github", "file=campus/broken.walk.yaml,"), ("sarif", '"campus/broken.walk.yaml"'),
                            ("json", '"campus/broken.walk.yaml"')):
            for path in (".", "broken.walk.yaml", self.path("campus/broken.walk.yaml")):
                outcome = self.run_program("validate", "--format", name, path, cwd=self.path("campus"))
                self.assertIn(place, outcome.out, name)
                self.assertNotIn(os.path.dirname(self.folder), outcome.out)
        text = self.run_program("validate", ".", cwd=self.path("campus"))
        self.assertIn("broken.walk.yaml:5:14: error", text.err)

    def test_shards_of_another_folder_are_another_run(self):
        for i, folder in ((1, "campus"), (2, "moved")):
            if i == 2:
                os.rename(self.path("campus"), self.path("moved"))
            self.run_program("run", "--rendering-backend", "none", f"--shard={i}/2", "--reporter", f"jsonl=../{i}.jsonl",
                             cwd=self.path(folder))
        self.assertEqual(json.loads(self.read("2.jsonl").splitlines()[0])["start"], "moved")
        outcome = self.run_program("merge-reports", "1.jsonl", "2.jsonl")
        self.assertIn("2.jsonl: error other-plan", outcome.err)


if __name__ == "__main__":
    main()
