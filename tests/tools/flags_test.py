#!/usr/bin/env python3
"""Every flag in the help of a command is passed to that command by some test."""

import ast
import glob
import os
import re

from program import ProgramCase, main

TESTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
RUNNERS = {"run_program", "passes", "Popen"}  # what starts the program


def words_in(node):
    """The words in the string literals of a part of a test: 'run', '--flag', and '--flag=value' as '--flag'."""
    words = set()

    def look(part):
        if isinstance(part, ast.keyword) and part.arg == "expected":
            return
        if isinstance(part, ast.Call):
            name = getattr(part.func, "attr", getattr(part.func, "id", ""))
            if name.startswith("assert") or name in ("write", "replace"):  # what is expected, what is in files
                part = ast.Tuple([each for each in part.args if any(isinstance(c, ast.Call) for c in ast.walk(each))],
                                 ast.Load())
                for each in part.elts:
                    for call in (c for c in ast.walk(each) if isinstance(c, ast.Call)):
                        look(call)
                return
        if isinstance(part, ast.Constant) and isinstance(part.value, str):
            words.update(word.partition("=")[0] for word in part.value.split())
        for child in ast.iter_child_nodes(part):
            look(child)
    look(node)
    return words


class Piece:
    """A function or a constant of a test: its words, and the names of others that it uses."""

    def __init__(self, node):
        body = node.body if isinstance(node, ast.FunctionDef) else [node.value]
        if isinstance(node, ast.FunctionDef) and ast.get_docstring(node) is not None:
            body = body[1:]
        self.words = set().union(*(words_in(each) for each in body))
        self.uses = {getattr(each, "attr", getattr(each, "id", None)) for part in body for each in ast.walk(part)
                     if isinstance(each, (ast.Attribute, ast.Name))}


def command_lines(path):
    """For each test that runs the program: all words that it, and what it uses, may pass to the program."""
    with open(path, encoding="utf-8") as file:
        tree = ast.parse(file.read())
    pieces = {}
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef):
            pieces.setdefault(node.name, []).append(Piece(node))
        elif isinstance(node, ast.Assign):
            for target in node.targets:
                if isinstance(target, ast.Name) and target.id.isupper():
                    pieces.setdefault(target.id, []).append(Piece(node))
    for name in pieces:
        if not name.startswith("test"):
            continue
        words, uses, waiting = set(), set(), [name]
        while waiting:
            used = waiting.pop()
            if used in uses:
                continue
            uses.add(used)
            for piece in pieces.get(used, ()):
                words |= piece.words
                waiting += piece.uses
        if uses & RUNNERS:
            yield words


class Flags(ProgramCase):
    def commands(self, *above):
        """Every command, as the words that name it."""
        yield above
        text = self.passes(*above, "--help").out.partition("Subcommands:")[2]
        for name in re.findall(r"(?m)^  ([a-z0-9-]+) ", text):
            yield from self.commands(*above, name)

    def flags(self, command):
        """The names of each flag of a command: {'-o', '--output'}."""
        for each in re.findall(r"(?m)^  (-[^ ]+)", self.passes(*command, "--help").out):
            yield set(each.split(","))

    def test_every_flag_is_passed_to_its_command_by_a_test(self):
        given = [words for path in glob.glob(os.path.join(TESTS, "**", "*_test.py"), recursive=True)
                 if os.path.basename(path) not in ("flags_test.py", "completion_test.py")
                 for words in command_lines(path)]
        self.assertGreater(len(given), 100)
        seen = 0
        missing = []
        for command in self.commands():
            for names in self.flags(command):
                seen += 1
                # Help and version are the same code everywhere.
                where = set() if names & {"--help", "--version"} else set(command)
                if not any(where <= words and names & words for words in given):
                    missing.append(" ".join(("campuswalk",) + command) + ": " + ",".join(sorted(names)))
        self.assertGreater(seen, 60)
        self.assertEqual(missing, [], "flags that no test passes to the command")


if __name__ == "__main__":
    main()
