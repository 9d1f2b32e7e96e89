#!/usr/bin/env python3
"""The citation check finds files and names that are cited and don't exist, and passes this checkout."""

import os
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
CODE = {"scene/base/glob.h": "#pragma once\nbool glob_matches(int pattern);  // see glob.cpp\nnamespace scene {}\nclass GlobList {};\n",
        "scene/base/glob.cpp": "int pattern_length = 0;\n"}


def run_check(root):
    """(exit code, lines but the last)."""
    done = subprocess.run([sys.executable, os.path.join(ROOT, "tools", "check-citations"), "--root", root],
                          capture_output=True, text=True, check=False)
    assert not done.stderr, done.stderr
    return done.returncode, done.stdout.splitlines()[:-1]


class CheckCitations(unittest.TestCase):
    def found(self, files):
        """Where something is wrong in a tree of CODE and these files, and what is missing."""
        with tempfile.TemporaryDirectory() as root:
            for name, text in {**CODE, **files}.items():
                path = os.path.join(root, name)
                os.makedirs(os.path.dirname(path), exist_ok=True)
                with open(path, "w", encoding="utf-8") as file:
                    file.write(text)
            code, lines = run_check(root)
        self.assertEqual(code, 1 if lines else 0)
        for line in lines:
            self.assertIn(": error citation: ", line)
        return [(line.split(": ")[0], line.split()[-1]) for line in lines]

    def test_this_checkout_is_in_order(self):
        self.assertEqual(run_check(ROOT), (0, []))

    def test_citations_of_what_exists_pass(self):
        self.assertEqual(self.found({
            "README.md": "[all](scene/base) [one](scene/base/glob.h#L2) [far](https://example.org/x.md) `glob.h` `scene/base/`\n"
                         "`glob_matches` in `scene/base/glob.h`, `scene::GlobList`, `scene/base/{glob,list}.*`"
                         .replace("{glob,list}", "{glob,gl*}") + " `base/` `glob_matches()`\n```\n`no/such.h` `no_such_name`\n```\n",
            "docs/walk.md": "`../scene/base/glob.h` `school.glb` `NAME.walk.yaml` `walk_to`\n",
            "tools/words.py": "walk_to = 1\n"}), [])

    def test_broken_links_are_found(self):
        self.assertEqual(self.found({"README.md": "see [the\ndoor](scene/door.h)\n"}), [("README.md:2:7", "scene/door.h")])

    def test_unknown_paths_in_code_spans_are_found(self):
        self.assertEqual(self.found({"CONTRIBUTING.md": "`scene/base/glob.hpp` `scene/{base,top}/` `lists.cpp` `tops/`\n"}),
                         [("CONTRIBUTING.md:1:2", "scene/base/glob.hpp"), ("CONTRIBUTING.md:1:24", "scene/{base,top}/"),
                          ("CONTRIBUTING.md:1:44", "lists.cpp"), ("CONTRIBUTING.md:1:56", "tops/")])

    def test_unknown_names_of_code_are_found(self):
        self.assertEqual(self.found({"docs/deep/a.md": "`glob_match` `scene::GlobLists` `kGlobs`\n"}),
                         [("docs/deep/a.md:1:2", "glob_match"), ("docs/deep/a.md:1:15", "GlobLists"),
                          ("docs/deep/a.md:1:34", "kGlobs")])

    def test_names_that_only_comments_have_are_found(self):
        self.assertEqual(self.found({"README.md": "`old_name`\n", "scene/a.cpp": "// old_name\n"}), [("README.md:1:2", "old_name")])

    def test_names_that_are_in_another_file_are_found(self):
        self.assertEqual(self.found({"README.md": "`pattern_length` in `scene/base/glob.h`\n"}), [("README.md:1:2", "pattern_length")])

    def test_unknown_files_in_comments_are_found(self):
        self.assertEqual(self.found({"scene/b.h": "#pragma once\n// as base/glob.h, not scene/glob.h or globs.cpp\n"
                                                  'const char* text = "none.h";  /* none.cpp */\n'}),
                         [("scene/b.h:2:24", "scene/glob.h"), ("scene/b.h:2:40", "globs.cpp"), ("scene/b.h:3:34", "none.cpp")])


if __name__ == "__main__":
    unittest.main()
