#!/usr/bin/env python3
"""The glossary check finds refused words in identifiers and prose, where they are, and keeps CONTRIBUTING's table."""

import os
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
TABLE = """
libraries = ["topLeftCorner"]

[[entry]]
term = "vertex"
meaning = "a point of a mesh"
where = "`scene/`"
parts = ["corner", "corners"]
instead = {corners = "vertices"}
allow = ["scene/room.h: corner"]  # of a room

[[entry]]
term = "tick"
names = ["FrameRecord"]
phrases = ["every frame"]
"""


class CheckGlossary(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.write("tools/glossary.toml", TABLE)

    def write(self, name, text):
        path = os.path.join(self.folder.name, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)

    def check(self, *flags):
        """(exit code, what it found)."""
        done = subprocess.run([sys.executable, os.path.join(ROOT, "tools", "check-glossary"), "--root", self.folder.name,
                               *flags], capture_output=True, text=True, check=False)
        self.assertEqual(done.stderr, "")
        return done.returncode, done.stdout.splitlines()[:-1]

    def found(self, name, text):
        self.write(name, text)
        code, lines = self.check()
        self.assertEqual(code, 1 if lines else 0)
        return lines

    def test_parts_of_identifiers(self):
        self.assertEqual(self.found("scene/a.cpp", "int kCornerCount;\nint box_corners(CORNER);\nint cornering, cornered;\n"),
                         ["scene/a.cpp:1:6: corner → vertex", "scene/a.cpp:2:9: corners → vertices",
                          "scene/a.cpp:2:17: corner → vertex"])

    def test_whole_identifiers(self):
        self.assertEqual(self.found("scene/a.h", "FrameRecord a;\nFrameRecorder b;\n"), ["scene/a.h:1:1: FrameRecord → tick"])

    def test_phrases_in_comments_literals_and_documents(self):
        self.assertEqual(self.found("scene/a.h", '/// In every  frame.\nauto a = "Every frame";\n'),
                         ["scene/a.h:1:8: every frame → tick", "scene/a.h:2:11: every frame → tick"])
        self.assertEqual(self.found("docs/a.md", "In every\nframe\n"), ["docs/a.md:1:4: every frame → tick"] + [
            "scene/a.h:1:8: every frame → tick", "scene/a.h:2:11: every frame → tick"])

    def test_quoted_words_and_user_facing_names_are_allowed(self):
        self.assertEqual(self.found("README.md", "`every frame` and 'every frame'\n```\nevery frame\n```\n"), [])
        self.assertEqual(self.found("scene/a.cpp", 'auto key = "corner";  // a corner\n'), [])

    def test_places_where_a_word_is_right(self):
        self.assertEqual(self.found("scene/room.h", "int corner;\nint corners;\n"), ["scene/room.h:2:5: corners → vertices"])

    def test_identifiers_of_libraries_are_allowed(self):
        self.assertEqual(self.found("scene/a.h", "m.topLeftCorner();\nm.rightCorner();\n"), ["scene/a.h:2:8: corner → vertex"])

    def test_the_table_in_contributing(self):
        self.assertEqual(self.found("CONTRIBUTING.md", "# A\n<!-- glossary -->\n<!-- end of glossary -->\nB\n"),
                         ["CONTRIBUTING.md:2:1: the glossary differs from tools/glossary.toml → run tools/check-glossary --write"])
        self.check("--write")
        self.assertEqual(self.check(), (0, []))
        with open(os.path.join(self.folder.name, "CONTRIBUTING.md"), encoding="utf-8") as file:
            self.assertIn("-->\n| term | means | where |\n|---|---|---|\n| vertex | a point of a mesh | `scene/` |\n<!--", file.read())

    def test_this_checkout_is_in_order(self):
        done = subprocess.run([sys.executable, os.path.join(ROOT, "tools", "check-glossary")], capture_output=True, text=True,
                              check=False)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "glossary: all in order\n", ""))


if __name__ == "__main__":
    unittest.main()
