#!/usr/bin/env python3
"""`init`: its files run in any folder, and nothing that was there is touched."""

import os
import re
import subprocess

import yaml

from program import ProgramCase, main

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
TEMPLATES = ("minimal", "stairs", "campus")


class Init(ProgramCase):
    def test_every_template_validates_and_passes(self):
        for template in TEMPLATES:
            with self.subTest(template=template):
                made = self.passes("init", template, "--template", template)
                self.assertEqual(sorted(made.lines), sorted(name for name, content in self.contents().items()
                                                            if name.startswith(template + "/") and content is not None))
                self.passes("validate", ".", cwd=self.path(template))
                outcome = self.passes("run", "--rendering-backend", "none", cwd=self.path(template))
                for walk in os.listdir(self.path(template + "/walks")):
                    self.assertIn(walk.partition(".")[0], outcome.out)
                self.assertIn("xfail", outcome.out)

    def test_the_same_files_every_time(self):
        self.passes("init", "a", "--template", "campus")
        self.passes("init", "b", "--template", "campus")
        for name, content in self.contents().items():
            if name.startswith("a/"):
                self.assertEqual(self.read("b" + name[1:]) if content is not None else None, content, name)

    def test_the_defaults_are_minimal_and_the_current_folder(self):
        self.passes("init", "one")
        os.makedirs(self.path("two/.git"))
        self.passes("init", cwd=self.path("two"))
        self.assertEqual(sorted(set(os.listdir(self.path("two"))) - {".git"}), sorted(os.listdir(self.path("one"))))

    def refused(self, arguments, start, *names, **options):
        """The diagnostic starts with `start` and contains `names`; nothing is touched."""
        before = self.contents()
        outcome = self.run_program("init", *arguments, **options)
        self.assertEqual((outcome.code, outcome.out), (2, ""))
        self.assertTrue(outcome.err.startswith(start), outcome.err)
        self.assertEqual([name for name in names if name not in outcome.err], [])
        self.assertEqual(self.contents(), before)

    def test_nothing_is_overwritten(self):
        self.refused(["avatars"], "avatars: error not-empty: ", "'adult.avatar.yaml'")
        self.refused(["room.obj"], "room.obj: error not-a-folder: ")

    def test_unwritable_folders_are_refused(self):
        self.refused(["room.obj/new"], "room.obj/new: error output-unwritable: ", "'room.obj'")

    def test_the_workflow_is_pinned_and_strict(self):
        self.passes("init", "one")
        text = self.read("one/.github/workflows/walks.yml").decode()
        workflow = yaml.safe_load(text)
        self.assertEqual(workflow["permissions"], {"contents": "read"})
        steps = workflow["jobs"]["walks"]["steps"]
        for used in re.findall(r"uses: (.*)", text):
            if not used.startswith("./"):
                self.assertRegex(used, r"^[^@ ]+@([0-9a-f]{40} # v[0-9.]+|v[0-9.]+( # .*)?)$")
        for step in steps:
            if step.get("uses", "").startswith("actions/checkout@"):
                self.assertIs(step["with"]["persist-credentials"], False)
        action = steps[-1]["with"]
        arguments = action["arguments"].split()
        self.assertEqual(arguments, ["--strict", "--forbid-only"])
        self.passes("run", "--rendering-backend", "none", *arguments, cwd=self.path("one"))
        with open(os.path.join(ROOT, "action.yml"), encoding="utf-8") as file:
            self.assertLessEqual(set(action), set(yaml.safe_load(file)["inputs"]))
        for step in steps:
            if "exit 1" in step.get("run", ""):  # this build doesn't know its repository
                self.assertIn("vars.CAMPUSWALK == ''", step["if"])
                self.assertEqual(subprocess.run(["sh", "-e", "-c", step["run"]], check=False,
                                                stdout=subprocess.DEVNULL).returncode, 1)

    def test_a_pipeline_of_gitlab_finds_its_attachments(self):
        self.passes("init", "one", "--ci", "gitlab")
        self.assertNotIn("one/.github", self.contents())
        job = yaml.safe_load(self.read("one/.gitlab-ci.yml"))["walks"]
        [command] = job["script"]
        self.assertIn(" --strict --forbid-only ", command)
        self.write("bin/campuswalk", '#!/bin/sh\nexec "%s" "$@" --rendering-backend none --record csv\n' % self.program)
        os.chmod(self.path("bin/campuswalk"), 0o755)
        command = re.sub(r" --reporter html=\S+", "", command)  # which not every build writes
        done = subprocess.run(["sh", "-e", "-c", command], cwd=self.path("one"), stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=120, check=False,
                              env={**os.environ, "CI": "true", "CI_PROJECT_DIR": self.path("one"),
                                   "PATH": self.path("bin") + ":" + os.environ["PATH"]})
        self.assertEqual(done.returncode, 0, done.stdout)
        report = self.read("one/" + job["artifacts"]["reports"]["junit"]).decode()
        attachments = re.findall(r"\[\[ATTACHMENT\|(.*?)\]\]", report)
        self.assertEqual(len(attachments), 2)
        for attachment in attachments:
            self.assertTrue(os.path.isfile(self.path("one/" + attachment)), attachment)
            self.assertTrue(any(attachment.startswith(kept + "/") for kept in job["artifacts"]["paths"]))

    def test_a_pipeline_installs_only_the_package_that_it_names(self):
        self.passes("init", "one", "--ci", "gitlab")
        job = yaml.safe_load(self.read("one/.gitlab-ci.yml"))["walks"]
        os.makedirs(self.path("bin"))
        for name in ("apt-get", "curl"):
            self.write("bin/" + name, '#!/bin/sh\necho %s "$@"\n' % name)
            os.chmod(self.path("bin/" + name), 0o755)

        def prepare(**variables):
            script = "\n".join(line.replace("/tmp/", self.folder + "/") for line in job["before_script"])
            return subprocess.run(["sh", "-e", "-c", script], cwd=self.path("one"), stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, check=False, timeout=60,
                                  env={"PATH": self.path("bin") + ":" + os.environ["PATH"],
                                       **job["variables"], "CAMPUSWALK_CACHE_DIR": self.path("cache"), **variables})
        self.assertEqual(prepare(CAMPUSWALK="").returncode, 1)
        self.write("campuswalk.deb", "package")
        self.write("one/.campuswalk/kept", "")
        done = prepare(CAMPUSWALK="https://files.example/c.deb")
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn("apt-get install -y -q %s/campuswalk.deb" % self.folder, done.stdout.decode())
        self.assertIn("cache/kept", self.contents())
        wrong = prepare(CAMPUSWALK="https://files.example/c.deb", CAMPUSWALK_SHA256="0" * 64)
        self.assertEqual(wrong.returncode, 1)
        self.assertNotIn("campuswalk.deb\n", wrong.stdout.decode().split("FAILED")[-1])

    def test_no_service(self):
        self.passes("init", "one", "--ci", "none")
        self.assertEqual([name for name in self.contents() if "/.git" in name and "ignore" not in name], [])

    def test_an_unknown_template_is_refused(self):
        self.assert_bad_usage(self.run_program("init", "new", "--template", "castle"), "campuswalk init",
                              "--template 'castle' campus|minimal|stairs")


if __name__ == "__main__":
    main()
