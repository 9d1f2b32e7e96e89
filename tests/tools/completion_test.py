#!/usr/bin/env python3
"""`completion`: the shells offer what the help shows."""

import os
import re
import shutil
import subprocess
import unittest

from program import ProgramCase, main

# Ask bash as readline does: the words so far, the last of them being typed.
ASK_BASH = r"""
source /dev/stdin
COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); COMPREPLY=()
_campuswalk 2>/dev/null
printf '%s\n' "${COMPREPLY[@]}"
"""

# zsh's completion functions work only inside its line editor: these print their arguments instead.
ASK_ZSH = r"""
compdef() { : }
compadd() { shift; print -l -- "$@" }
_files() { print -l -- "FILES $*" }
_describe() { while [[ $1 == -* ]]; do [[ $1 == -V ]] || [[ $1 == -o ]]; shift; done; shift; print -l -- ${${(P)1}%%:*} }
eval "$(cat)"
words=("$@"); CURRENT=$#
_campuswalk
"""


class Completion(ProgramCase):
    def setUp(self):
        super().setUp()
        self.scripts = {shell: self.passes("completion", shell).out for shell in ("bash", "zsh", "fish")}

    def ask(self, command, script):
        done = subprocess.run(command, input=script.encode(), cwd=self.folder, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, check=False, timeout=60)
        self.assertEqual(done.stderr.decode(), "")
        return [line for line in done.stdout.decode().split("\n") if line]

    def bash(self, *words):
        return self.ask(["bash", "--norc", "-c", ASK_BASH, "bash", "campuswalk", *words], self.scripts["bash"])

    def zsh(self, *words):
        return self.ask(["zsh", "-f", "-c", ASK_ZSH, "zsh", "campuswalk", *words], self.scripts["zsh"])

    def fish(self, *words):
        line = " ".join(("campuswalk",) + words)
        script = self.scripts["fish"] + "\ncomplete -C '%s'\n" % line
        environment = dict(os.environ, HOME=self.folder, XDG_CONFIG_HOME=self.folder)
        done = subprocess.run(["fish", "--no-config", "-c", script], cwd=self.folder, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, stdin=subprocess.DEVNULL, env=environment, check=False,
                              timeout=60)
        self.assertEqual(done.stderr.decode(), "")
        return [entry.split("\t")[0] for entry in done.stdout.decode().splitlines()]

    def shells(self):
        """The installed shells; bash always is one."""
        return [("bash", self.bash)] + [(name, ask) for name, ask in (("zsh", self.zsh), ("fish", self.fish))
                                        if shutil.which(name)]

    def commands(self):
        text = self.passes("--help").out.partition("Subcommands:")[2]
        return re.findall(r"(?m)^  ([a-z-]+) ", text)

    def options(self, *command):
        return set(re.findall(r"(?m)^  (?:-\w,)?(--[a-z-]+)", self.passes(*command, "--help").out))

    def test_commands_are_completed(self):
        commands = self.commands()
        self.assertIn("run", commands)
        for name, ask in self.shells():
            with self.subTest(shell=name):
                self.assertLessEqual(set(commands), set(ask("")))
                self.assertEqual(ask("val")[:1] if name != "zsh" else ["validate"], ["validate"])

    def test_options_of_every_command_are_completed(self):
        for command in self.commands():
            expected = self.options(command)
            self.assertIn("--help", expected)
            for name, ask in self.shells():
                with self.subTest(shell=name, command=command):
                    offered = {word for word in ask(command, "--") if word.startswith("--")}
                    self.assertEqual(offered, expected)

    def test_values_of_options_are_completed(self):
        for name, ask in self.shells():
            with self.subTest(shell=name):
                self.assertEqual(sorted(ask("validate", "--format", "")), ["github", "json", "sarif", "text"])
                self.assertEqual(sorted(set(ask("completion", "")) & {"bash", "zsh", "fish"}), ["bash", "fish", "zsh"])

    def test_files_and_folders_are_completed(self):
        self.assertEqual(self.bash("validate", "small"), ["small.campus.yaml"])
        self.assertEqual(self.bash("init", "av"), ["avatars"])
        self.assertEqual(self.bash("snapshot", "--output", "ro"), ["room.obj"])
        self.assertEqual(self.bash("snapshot", "--output", "=", "ro"), ["room.obj"])
        self.assertEqual(self.bash("snapshot", "--width", ""), [])

    def test_an_unknown_shell_is_refused(self):
        self.assert_bad_usage(self.run_program("completion", "ksh"), "campuswalk completion", "SHELL 'ksh' bash|fish|zsh")

    @unittest.skipUnless(shutil.which("zsh"), "zsh is not installed")
    def test_zsh_parses_the_script(self):
        self.ask(["zsh", "-f", "-n", "/dev/stdin"], self.scripts["zsh"])


if __name__ == "__main__":
    main()
