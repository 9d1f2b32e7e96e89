#!/usr/bin/env python3
"""`init`: what it makes runs, in whatever folder, and nothing that was there is touched."""

import os

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

    def refused(self, arguments, complaint, **options):
        before = self.contents()
        outcome = self.run_program("init", *arguments, **options)
        self.assertEqual((outcome.code, outcome.out, outcome.err), (2, "", complaint + "\n"))
        self.assertEqual(self.contents(), before)

    def test_nothing_is_overwritten(self):
        self.refused(["avatars"], "avatars: error not-empty: there are files in this folder ('adult.avatar.yaml'), and "
                                  "none shall be overwritten; name a new folder")
        self.refused(["room.obj"], "room.obj: error not-a-folder: there is a file of this name; name another folder")

    def test_where_nothing_can_be_written(self):
        self.refused(["room.obj/new"], "room.obj/new: error output-unwritable: nothing can be written here: 'room.obj' "
                                       "is not a folder")

    def test_unknown_template(self):
        outcome = self.run_program("init", "new", "--template", "castle")
        self.assertEqual((outcome.code, outcome.complaints[0]), (
            2, "error: --template: 'castle' is none of campus|minimal|stairs"))


if __name__ == "__main__":
    main()
