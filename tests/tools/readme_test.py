#!/usr/bin/env python3
"""The README's example works: its walk is valid on the school that `init` writes, passes there, and names the two commands.

tests/docs/ runs all snippets of README and docs/; this runs with the other tests.
"""

import os
import re

from program import ProgramCase, main

README = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "README.md")


class Readme(ProgramCase):
    def setUp(self):
        super().setUp()
        with open(README, encoding="utf-8") as file:
            self.readme = file.read()
        (self.name, self.walk), = re.findall(r"```yaml\n# (\S+)\n(.*?)```", self.readme, re.DOTALL)

    def test_the_example_walks(self):
        self.passes("init", "school")
        self.write("school/" + self.name, self.walk)
        self.passes("validate", "school/" + self.name)
        log = self.passes("run", "school/" + self.name, "--rendering-backend", "none").out
        self.assertIn("trigger.enter    library/door", log)
        self.assertIn("result=pass", log)

    def test_the_example_has_ten_lines(self):
        self.assertEqual(len(self.walk.splitlines()), 10)

    def test_the_two_commands_are_there(self):
        tools = os.path.join(os.path.dirname(README), "tools")
        block = re.search(r"```sh\n(.*?)```", self.readme, re.DOTALL)[1]
        self.assertEqual([line.split()[0] for line in block.splitlines()], ["tools/run", "tools/test"])
        for name in ("run", "test"):
            self.assertTrue(os.access(os.path.join(tools, name), os.X_OK))


if __name__ == "__main__":
    main()
