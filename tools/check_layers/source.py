"""Reads a tree's files, and blanks what isn't code in C++ text."""

import os
import re
from collections import namedtuple

from .table import CODE_FOLDERS

Diagnostic = namedtuple("Diagnostic", "file line column code message")
Include = namedtuple("Include", "line column quote target")

_NOT_CODE = re.compile(
    r'(?P<comment>//(?:\\\n|[^\n])*|/\*.*?\*/)'
    r'|(?P<string>R"(?P<tag>[^(\s"]*)\(.*?\)(?P=tag)"|"(?:\\.|[^"\\\n])*"|(?<!\w)\'(?:\\.|[^\'\\\n])+\')',
    re.DOTALL)
_INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*(?P<target>"[^"\n]*"|<[^>\n]*>)', re.MULTILINE)


def _blanked(text):
    """As many blanks and lines as the text has."""
    return re.sub(r"[^\n]", " ", text)


def without_comments(text):
    """The text with comments blanked; lines and columns stay the same."""
    return _NOT_CODE.sub(lambda m: _blanked(m[0]) if m["comment"] else m[0], text)


def code_only(text):
    """The text with comments, strings and characters blanked."""
    return _NOT_CODE.sub(lambda m: _blanked(m[0]), text)


def position(text, offset):
    """(line, column) of an offset, both from 1."""
    return text.count("\n", 0, offset) + 1, offset - text.rfind("\n", 0, offset)


def includes(text):
    """The #include lines of a text."""
    plain = without_comments(text)
    found = []
    for match in _INCLUDE.finditer(plain):
        line, column = position(plain, match.start("target"))
        found.append(Include(line, column, match["target"][0], match["target"][1:-1]))
    return found


class Tree:
    """The C++ and CMake files of a checkout, by their path from its root."""

    def __init__(self, root):
        self.root = root
        self.cpp = {}
        self.build = {}
        for name in ("CMakeLists.txt", "CMakePresets.json"):
            if os.path.isfile(os.path.join(root, name)):
                self.build[name] = self._read(name)
        for folder in CODE_FOLDERS:
            self._read_folder(folder)

    def _read_folder(self, folder):
        for base, folders, names in os.walk(os.path.join(self.root, folder)):
            folders.sort()
            for name in sorted(names):
                path = os.path.relpath(os.path.join(base, name), self.root).replace(os.sep, "/")
                if name.endswith((".h", ".hpp", ".cpp", ".cc")):
                    self.cpp[path] = self._read(path)
                elif name == "CMakeLists.txt" or name.endswith((".cmake", ".cmake.in")):
                    self.build[path] = self._read(path)

    def _read(self, path):
        with open(os.path.join(self.root, path), encoding="utf-8") as file:
            return file.read()
