#!/usr/bin/env python3
"""`init`: its files run in any folder, and nothing that was there is touched."""

import os
import subprocess

import yaml

from program import ProgramCase, main

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

    def test_commands_of_the_workflow_pass(self):
        """With campuswalk where the workflow's other steps would have put it."""
        self.passes("init", "one")
        self.write("one/.campuswalk/tools/run", '#!/bin/sh\nexec "%s" run --rendering-backend none "$@"\n' % self.program)
        os.chmod(self.path("one/.campuswalk/tools/run"), 0o755)
        os.makedirs(self.path("one/.campuswalk/build/release"))
        os.symlink(self.program, self.path("one/.campuswalk/build/release/campuswalk"))
        steps = yaml.safe_load(self.read("one/.github/workflows/walks.yml"))["jobs"]["walks"]["steps"]
        ours = [step["run"] for step in steps if ".campuswalk/" in step.get("run", "")]
        self.assertEqual(len(ours), 2)
        for command in ours:
            done = subprocess.run(["sh", "-e", "-c", command], cwd=self.path("one"), stdin=subprocess.DEVNULL,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=120, check=False,
                                  env={**os.environ, "CI": "true", "GITHUB_ACTIONS": "true"})
            self.assertEqual(done.returncode, 0, done.stdout)
        [uploaded] = [step["with"]["path"] for step in steps if "upload-artifact" in step.get("uses", "")]
        self.assertIn(f"one/{uploaded}/junit.xml", self.contents())
        [check] = [step for step in steps if "exit 1" in step.get("run", "")]
        self.assertIn("vars.CAMPUSWALK == ''", check["if"])
        self.assertEqual(subprocess.run(["sh", "-e", "-c", check["run"]], check=False, stdout=subprocess.DEVNULL).returncode, 1)

    def test_an_unknown_template_is_refused(self):
        self.assert_bad_usage(self.run_program("init", "new", "--template", "castle"), "campuswalk init",
                              "--template 'castle' campus|minimal|stairs")


if __name__ == "__main__":
    main()
