#!/usr/bin/env python3
"""A plain `cmake -S . -B build`, which writes makefiles, can begin: `makefiles_test.py SOURCES`.

Ninja makes the folders that commands work in; make changes into them first.
"""

import os
import re
import subprocess
import sys
import tempfile
import unittest

SOURCES = ""


class Makefiles(unittest.TestCase):
    def test_each_command_works_in_a_folder_that_is_there(self):
        with tempfile.TemporaryDirectory() as built:
            configured = subprocess.run(["cmake", "-S", SOURCES, "-B", built, "-G", "Unix Makefiles", "-DCAMPUSWALK_TESTS=ON"],
                                        stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
            self.assertEqual(configured.returncode, 0, configured.stderr)
            folders = set()
            for parent, _, names in os.walk(built):
                for name in names:
                    if name == "build.make":
                        with open(os.path.join(parent, name), encoding="utf-8") as file:
                            folders.update(re.findall(r"^\tcd (\S+) &&", file.read(), re.MULTILINE))
            self.assertGreater(len(folders), 5)
            self.assertEqual([folder for folder in sorted(folders) if not os.path.isdir(folder)], [])


if __name__ == "__main__":
    SOURCES = sys.argv.pop(1)
    unittest.main()
