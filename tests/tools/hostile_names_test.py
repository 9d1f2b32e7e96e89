#!/usr/bin/env python3
"""Whatever strangers' files call things, their words stay words: on a terminal, in every report, and to a CI machine."""

import json
import pathlib
import re
import sys

from program import CAMPUS, ROOM, WALK, ProgramCase, main

# Each ends a line, moves a cursor, reorders text, isn't seen, or means something to GitHub, Azure, Jenkins or GitLab.
HOSTILE = ["\x1b[2J\x1b]0;owned\x07", "\u009b31m", "a\u202eb\u2066c", "::error::x", "  ::add-mask::x", "##[command]x",
           "x##vso[task.setvariable variable=a]b", "a\n::set-output name=b::c", "\u2028::x", "tab\tand\rreturn", "\x7f\ufeff",
           "[[ATTACHMENT|/etc/passwd]]", "x[[[property|a=b]]", "##VSO[x]##teamcity[y]",
           "a\u200bb\u00a0c\u3164d\u2800e\ufe0ff\u00adg\u2060h"]

CONTROLS = re.compile("[\x00-\x09\x0b-\x1f\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069\ufeff"
                      "\u00a0\u00ad\u200b-\u200d\u2060\u2800\u3164]")
COMMANDS = re.compile(r"(?m)^[ \t]*::|##[A-Za-z]*\[|\[\[[A-Za-z]*\|")
REPORTERS = ("list", "dot", "junit", "tap", "json", "jsonl", "github", "markdown")


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
            for reporter in REPORTERS:
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

    def test_command_line(self):
        """A script may pass on what it got from elsewhere, such as the name of a branch."""
        self.write_campus("hut")
        choices_and_numbers = ("--rendering-backend", "--sandbox", "--reporter", "--shard", "--min-cases", "-j")
        for name in HOSTILE:
            refused = [[name], ["run", "--" + name], ["run", "short.walk.yaml", name], ["run", name]]
            refused += [["run", "short.walk.yaml", option, name] for option in choices_and_numbers]
            for arguments in refused:
                self.assertEqual(self.check(*arguments).code, 2, arguments)
            for option in ("--project", "--grep"):
                done = self.run_program("run", "short.walk.yaml", option, name)
                self.assertIn(done.code, (2, 5), done.err)  # 5: no walk is of that name
                self.assert_harmless(done.err, option)

    def test_files(self):
        """A job may print any file, and other programs read it."""
        for name in HOSTILE:
            self.write_campus(name)
            files = ["%s.report" % reporter for reporter in REPORTERS]
            targets = ["--reporter=%s=%s.report" % (reporter, reporter) for reporter in REPORTERS]
            self.run_program("run", "short.walk.yaml", "--rendering-backend", "none", "--output", "out", "--log", "log.txt",
                             "--jsonl", "log.jsonl", "--record", "csv", "--record", "tum", "--record", "trace", *targets)
            self.run_program("explore", "small.campus.yaml", "--json", "explored.json", "--geojson", "explored.geojson",
                             "--write-walks", "walks")
            records = [path.relative_to(self.folder) for folder in ("out", "walks")
                       for path in pathlib.Path(self.folder, folder).rglob("*") if path.is_file()]
            self.assertGreater(len(records), 1)
            for file in files + records + ["log.txt", "log.jsonl", "explored.json", "explored.geojson"]:
                text = self.read(str(file)).decode("utf-8")
                if file == "junit.report":
                    text, meant = re.subn(r"\[\[ATTACHMENT\|out/short/[a-z.]+\]\]", "", text)
                    self.assertEqual(meant, 3)
                if file == "markdown.report":
                    text = text.replace("\ufe0f", "")  # of its own symbols
                self.assert_harmless(text, file, commands=file == "github.report")

    def test_markdown_keeps_its_headings(self):
        self.write_campus("::error::x")
        outcome = self.run_program("run", "short.walk.yaml", "--rendering-backend", "none", "--reporter", "markdown")
        self.assertRegex(outcome.out, r"\A## campuswalk: [^\n]*\n")
        self.assertRegex(outcome.out, r"\n### short.walk.yaml\n")

    def test_names_of_folders_that_are_paths_of_artifacts(self):
        """Reports are valid whatever a walk's folder is called, and its files are where they say."""
        names = ["a]]|b", "[[ATTACHMENT|x", "C:x", "a\\..\\b", "a\nb", "%5D", "a\u202eb"]
        for name in names:
            self.write("walks/" + name + "/short.walk.yaml", WALK.replace("campus: small", "campus: ../../small"))
        self.assertEqual(self.run_program("run", "walks", "--rendering-backend", "none", "--output", "out", "--record", "csv",
                                          "--reporter", "jsonl=r.jsonl", "--reporter", "junit=j.xml").code, 0)
        results = [json.loads(line) for line in self.read("r.jsonl").splitlines()[1:]]
        self.assertEqual({result["file"] for result in results}, {"walks/" + name + "/short.walk.yaml" for name in names})
        paths = [artifact["path"] for result in results for artifact in result["artifacts"]]
        self.assertEqual(len(set(paths)), len(names))
        for path in paths:
            self.assertTrue(pathlib.Path(self.folder, "out", path).is_file(), path)
            marker = b"[[ATTACHMENT|out/" + path.encode() + b"]]"  # in which GitLab takes no brackets
            self.assertEqual(marker in self.read("j.xml"), "[" not in path and "]" not in path)
        self.check("merge-reports", "r.jsonl", "--reporter", "junit=merged.xml")
        self.assertEqual(self.read("merged.xml").count(b"[[ATTACHMENT|"), 5)

    def test_reports_name_no_files_outside_of_the_run(self):
        self.write_campus("x")
        self.run_program("run", "short.walk.yaml", "--rendering-backend", "none", "--reporter", "jsonl=r.jsonl")
        header, line = self.read("r.jsonl").decode("utf-8").splitlines()
        result = json.loads(line)
        good = {"name": "x", "path": "a/b.png", "media_type": "image/png"}
        bad = [dict(good, path=path) for path in
               ("/etc/passwd", "../x", "a/../../x", "a\\..\\x", "C:/x", "a]]x", "[[a", "a|b", "a\nb", "a\u202eb", "", ".")]
        bad += [dict(good, media_type="image"), dict(good, media_type="a/b\" x"), dict(good, name="a\u200bb")]
        for artifact in [good] + bad:
            result["artifacts"] = [artifact]
            self.write("r.jsonl", header + "\n" + json.dumps(result) + "\n")
            outcome = self.check("merge-reports", "r.jsonl", "--reporter", "junit=j.xml")
            refused = outcome.code == 2 and "bad-report" in outcome.err
            self.assertEqual(refused, artifact != good, (artifact, outcome.err))

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
