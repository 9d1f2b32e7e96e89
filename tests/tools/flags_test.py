#!/usr/bin/env python3
"""Every flag that some --help shows is named by a test."""

import glob
import os
import re

from program import ProgramCase, main

TESTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")


def quoted_words():
    """Whatever stands between quotes in a test, in words: '--flag', '--flag=value', '-q'."""
    words = set()
    for path in glob.glob(os.path.join(TESTS, "**", "*_test.py"), recursive=True):
        if os.path.basename(path) in ("flags_test.py", "completion_test.py"):
            continue  # they don't use the flags that they name
        with open(path, encoding="utf-8") as file:
            for text in re.findall(r"\"([^\"\n]*)\"|'([^'\n]*)'", file.read()):
                words |= {word.partition("=")[0] for word in "".join(text).split()}
    return words


class Flags(ProgramCase):
    def commands(self, *above):
        """Every command, as the words that name it."""
        yield above
        text = self.passes(*above, "--help").out.partition("Subcommands:")[2]
        for name in re.findall(r"(?m)^  ([a-z0-9-]+) ", text):
            yield from self.commands(*above, name)

    def flags(self, command):
        """The spellings of each flag of a command: {'-o', '--output'}."""
        for names in re.findall(r"(?m)^  (-[^ ]+)", self.passes(*command, "--help").out):
            yield set(names.split(","))

    def test_every_flag_is_named_by_a_test(self):
        named = quoted_words()
        seen = 0
        missing = []
        for command in self.commands():
            for spellings in self.flags(command):
                seen += 1
                if not spellings & named:
                    missing.append(" ".join(("campuswalk",) + command) + ": " + ",".join(sorted(spellings)))
        self.assertGreater(seen, 20)
        self.assertEqual(missing, [], "flags that no tests/**/*_test.py names")


if __name__ == "__main__":
    main()
