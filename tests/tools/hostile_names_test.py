#!/usr/bin/env python3
"""Whatever strangers' files call things, their words stay words: on a terminal, in every report, and to a CI machine."""

import json
import re
import sys

from program import CAMPUS, ROOM, WALK, ProgramCase, main

# Each ends a line, moves a cursor, reorders text, or is a command to GitHub or Azure.
HOSTILE = ["\x1b[2J\x1b]0;owned\x07", "\u009b31m", "a\u202eb\u2066c", "::error::x", "  ::add-mask::x", "##[command]x",
           "x##vso[task.setvariable variable=a]b", "a\n::set-output name=b::c", "\u2028::x", "tab\tand\rreturn", "\x7f\ufeff"]

CONTROLS = re.compile("[\x00-\x09\x0b-\x1f\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069\ufeff]")
COMMANDS = re.compile(r"(?m)^[ \t]*(::|##)|##\[|##vso\[")


class HostileNames(ProgramCase):
    def assert_harmless(self, text, where, commands=False):
        self.assertNotRegex(text, CONTROLS, where)
        found = [match.group(0) for match in COMMANDS.finditer(text)]
        self.assertEqual([each for each in found if not (commands and each == "::")], [], (where, text))

    def check(self, *arguments, commands=False):
        outcome = self.run_program(*arguments)
        self.assertIn(outcome.code, (0, 1, 2), outcome.err)
        self.assert_harmless(outcome.out, arguments, commands)
        self.assert_harmless(outcome.err, arguments)
        return outcome

    def write_campus(self, name):
        """A campus and a walk with the name wherever one may be free text; returns it as YAML may have it."""
        in_yaml = re.sub("[\x00-\x1f\x7f]", " ", name)  # others are refused
        quoted = json.dumps(in_yaml)
        single = name.replace("\n", " ").replace("\r", " ").replace("\u2028", " ")
        self.write("room.obj", ROOM.replace("o wall", "mtllib room.mtl\no wall\nusemtl " + single))
        self.write("room.mtl", "newmtl %s\nmap_Kd %s.png\n" % (single, single))
        self.write("small.campus.yaml", CAMPUS.replace("title: The Hut", "title: " + quoted)
                   .replace("text: A wall and nothing behind it.", "text: " + quoted))
        self.write("short.walk.yaml", WALK.replace("  - never:", "  - not: {popup: hut}\n  - never:") +
                   "status: {is: xfail, because: %s, failures: [blocked]}\n" % quoted)
        return in_yaml

    def test_reports(self):
        for name in HOSTILE:
            self.write_campus(name)
            for reporter in ("list", "dot", "junit", "tap", "json", "jsonl", "github", "markdown"):
                self.check("run", "short.walk.yaml", "--rendering-backend", "none", "--reporter", reporter,
                           "--reporter", "jsonl=r.jsonl", "--jsonl", "log.jsonl", commands=reporter == "github")
            self.check("run", "short.walk.yaml", "--rendering-backend", "none")
            self.check("run", "short.walk.yaml", "--rendering-backend", "none", "-v")
            self.check("run", ".", "--list")
            self.check("merge-reports", "r.jsonl")
            self.check("replay", "r.jsonl", "--verify")
            self.check("replay", "log.jsonl", "--walk", "short.walk.yaml")
            self.write("other.jsonl", self.read("log.jsonl").replace(b'"dist":', b'"dust":'))
            self.check("diff", "log.jsonl", "other.jsonl")

    def test_other_commands(self):
        for name in HOSTILE:
            self.write_campus(name)
            self.check("info", "room.obj")
            self.check("info", "room.obj", "--json")
            self.check("info", "room.obj", "--suggest", "new.campus.yaml")
            for format_name in ("text", "json", "sarif", "github"):
                self.check("validate", ".", "--format", format_name, commands=format_name == "github")
            self.check("collide", "room.obj", "room.obj", "--json")
            self.check("collide", "room.obj", "room.obj")
            self.check("explore", "small.campus.yaml", "--json", "r.json", "--write-walks", "walks")

    def test_mistakes_that_quote_the_file(self):
        for name in HOSTILE:
            for text in (WALK.replace("walk_to: end", "walk_to: " + json.dumps(name)),
                         WALK.replace("steps:", json.dumps(name) + ": 1\nsteps:"),
                         WALK.replace("campus: small", "campus: " + json.dumps(name + "/small"))):
                self.write("short.walk.yaml", text)
                with self.subTest(name=name):
                    self.assertEqual(self.check("run", "short.walk.yaml").code, 2)
                    self.check("validate", "short.walk.yaml", "--format", "github", commands=True)

    def test_names_of_files(self):
        for name in HOSTILE:
            if "/" in name:
                continue
            self.write(name + ".walk.yaml", WALK)
        self.check("run", "--rendering-backend", "none", "--reporter", "list", "--reporter", "jsonl=r.jsonl")
        self.check("run", "--rendering-backend", "none", "--reporter", "github", commands=True)
        self.check("run", "--list")
        self.check("merge-reports", "r.jsonl")
        self.check("validate", ".")

    def test_values_survive(self):
        """Escapes in JSON are JSON's own: a reader gets the words back."""
        for name in HOSTILE:
            in_yaml = self.write_campus(name)
            self.run_program("run", "short.walk.yaml", "--rendering-backend", "none", "--reporter", "json=report.json")
            self.assertEqual(json.loads(self.read("report.json"))["results"][0]["status_reason"], in_yaml)
            self.assert_harmless(self.read("report.json").decode("utf-8"), "report.json")


if __name__ == "__main__":
    sys.exit(main())
