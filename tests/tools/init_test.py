#!/usr/bin/env python3
"""`init`: what it makes runs, in whatever folder, and nothing that was there is touched."""

import os
import subprocess

import yaml

from program import ProgramCase, main

TEMPLATES = ("minimal", "stairs", "campus")


class Init(ProgramCase):
    def test_every_template_holds_and_passes(self):
        for template in TEMPLATES:
            with self.subTest(template=template):
                made = self.passes("init", template, "--template", template)
                self.assertEqual(sorted(made.lines), sorted(name for name, content in self.contents().items()
                                                            if name.startswith(template + "/") and content is not None))
                self.passes("validate", ".", cwd=self.path(template))
                said = self.passes("run", "--rendering-backend", "none", cwd=self.path(template))
                for walk in os.listdir(self.path(template + "/walks")):
                    self.assertIn(walk.partition(".")[0], said.out)
                self.assertIn("xfail", said.out)

    def test_the_same_files_every_time(self):
        self.passes("init", "a", "--template", "campus")
        self.passes("init", "b", "--template", "campus")
        for name, content in self.contents().items():
            if name.startswith("a/"):
                self.assertEqual(self.read("b" + name[1:]) if content is not None else None, content, name)

    def test_minimal_is_the_default_and_here(self):
        self.passes("init", "one")
        os.makedirs(self.path("two/.git"))
        self.passes("init", cwd=self.path("two"))
        self.assertEqual(sorted(set(os.listdir(self.path("two"))) - {".git"}), sorted(os.listdir(self.path("one"))))

    def refused(self, arguments, start, *names, **options):
        """The diagnostic starts so and names these; nothing is touched."""
        before = self.contents()
        outcome = self.run_program("init", *arguments, **options)
        self.assertEqual((outcome.code, outcome.out), (2, ""))
        self.assertTrue(outcome.err.startswith(start), outcome.err)
        self.assertEqual([name for name in names if name not in outcome.err], [])
        self.assertEqual(self.contents(), before)

    def test_nothing_is_overwritten(self):
        self.refused(["avatars"], "avatars: error not-empty: ", "'adult.avatar.yaml'")
        self.refused(["room.obj"], "room.obj: error not-a-folder: ")

    def test_where_nothing_can_be_written(self):
        self.refused(["room.obj/new"], "room.obj/new: error output-unwritable: ", "'room.obj'")

    def test_what_the_workflow_does(self):
        """Its commands, where its other steps would have put campuswalk; that is built by tools/run."""
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
        [kept] = [step["with"]["path"] for step in steps if "upload-artifact" in step.get("uses", "")]
        self.assertIn(f"one/{kept}/junit.xml", self.contents())
        [told] = [step for step in steps if "exit 1" in step.get("run", "")]
        self.assertIn("vars.CAMPUSWALK == ''", told["if"])
        self.assertEqual(subprocess.run(["sh", "-e", "-c", told["run"]], check=False, stdout=subprocess.DEVNULL).returncode, 1)

    def test_unknown_template(self):
        outcome = self.run_program("init", "new", "--template", "castle")
        self.assertEqual((outcome.code, outcome.complaints[0]), (
            2, "error: --template: 'castle' is none of campus|minimal|stairs"))


if __name__ == "__main__":
    main()
