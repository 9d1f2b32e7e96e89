#!/usr/bin/env python3
"""The commands in running text: each names a command of the program, and options that it has; and the ten steps of
docs/how-to/your-own-campus.md run as written, on a model that `init` makes.

`inline_commands_test.py PROGRAM [SITE]`.
"""

import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(ROOT, "tools"))
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import snippets  # noqa: E402  (the path first)
from docs_site import command_lines  # noqa: E402
from docs_site.generators import Sources  # noqa: E402

FENCE = re.compile(r"^```.*?^```", re.MULTILINE | re.DOTALL)
SPAN = re.compile(r"(?<!`)`([^`]+)`(?!`)")
OPTION = re.compile(r"(?<![\w-])--[a-z][a-z-]+")
# Of other programs, which the documents name.
OTHERS = {"--check", "--program"}


class InlineCommands(unittest.TestCase):
    program = ""

    @classmethod
    def setUpClass(cls):
        sources = Sources(ROOT, cls.program)
        cls.options = {name: set(OPTION.findall(sources.output(name, "--help")))
                       for name, _ in command_lines.subcommands(sources.output("--help"))}

    def spans(self):
        for page in snippets.pages(ROOT):
            with open(os.path.join(ROOT, page), encoding="utf-8") as file:
                text = FENCE.sub("", file.read())
            for span in SPAN.findall(text):
                yield page, " ".join(span.split())

    def test_commands_and_options_exist(self):
        known, count = set().union(*self.options.values(), OTHERS), 0
        for page, span in self.spans():
            command = re.match(r"campuswalk ([a-z][a-z-]*)", span)
            with self.subTest(page=page, span=span):
                if command:
                    count += 1
                    self.assertIn(command[1], self.options)
                if command or OPTION.match(span):
                    self.assertLessEqual(set(OPTION.findall(span)), self.options[command[1]] if command else known)
        print("inline: %d commands" % count)
        self.assertGreater(count, 30)

    def test_options_of_runs_in_ci_exist(self):
        """Those of Jenkins, whose file isn't run."""
        count = 0
        for page in snippets.pages(ROOT):
            with open(os.path.join(ROOT, page), encoding="utf-8") as file:
                for call in re.findall(r"^ +sh '''campuswalk run( --.*?)'''", file.read(), re.MULTILINE | re.DOTALL):
                    count += 1
                    with self.subTest(page=page, call=call):
                        self.assertLessEqual(set(OPTION.findall(call)), self.options["run"])
        self.assertGreater(count, 0)

    def test_the_ten_steps_run_as_written(self):
        with open(os.path.join(ROOT, "docs", "how-to", "your-own-campus.md"), encoding="utf-8") as file:
            section = re.search(r"## Ten steps.*?\n(.*?)\n\n[A-Z]", file.read(), re.DOTALL)[1]
        self.assertEqual(re.findall(r"^(\d+)\. ", section, re.MULTILINE), [str(i) for i in range(1, 11)])
        commands = re.findall(r"`campuswalk ([^`]+)`", section)
        self.assertEqual([command.split()[0] for command in commands], ["info", "info", "run", "snapshot", "validate", "run"])
        with tempfile.TemporaryDirectory(prefix="campuswalk-docs-") as folder:
            example = os.path.join(folder, "example")
            subprocess.run([self.program, "init", example], check=True, capture_output=True)
            for name in ("school.obj", "school.mtl"):
                shutil.copy(os.path.join(example, name), folder)
            for command in commands:
                with self.subTest(command=command):
                    done = subprocess.run([self.program, *shlex.split(command.replace("school.glb", "school.obj"))], cwd=folder,
                                          capture_output=True, text=True, check=False)
                    self.assertEqual(done.returncode, 0, done.stderr)


if __name__ == "__main__":
    InlineCommands.program = os.path.abspath(sys.argv[1])
    unittest.main(argv=[sys.argv[0]])
