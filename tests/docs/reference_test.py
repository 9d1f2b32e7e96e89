#!/usr/bin/env python3
"""The reference misses nothing: it is compared with the program, the schemas, the source, and the logs of real walks.

`reference_test.py PROGRAM SITE`. Plays all walks of config/walks without pictures.
"""

import itertools
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(ROOT, "tools"))

from docs_site import command_lines, diagnostic_codes, event_tables  # noqa: E402  (the path first)
from docs_site.generators import Sources  # noqa: E402

# What no walk of config/walks has: one is teleported into a wall, and an expectation of an included file fails.
MORE_WALKS = {
    "pushed.walk.yaml": "campus: ../school.campus.yaml\nsteps: [{spawn: gate}, {teleport: {at: [3, 0, -5.85]}}, {wait: 1}]\n",
    "including.walk.yaml": "campus: ../school.campus.yaml\nsteps: [{spawn: gate}, {include: late.steps.yaml}]\n",
    "late.steps.yaml": "steps: [{expect: {popup: library}}]\n",
}
# Events that only programs that use the library cause.
OF_PROGRAMS = {"avatar.spawn"}
# Failures that no walk may name as the one that it must have.
OTHERS = {"golden-missing", "golden-unreadable", "snapshot-missing", "not-evaluated", "route-unknown", "not-identical", "xfail"}
TESTS_OF_TOOLS = {"check_layers_test.py", "check_citations_test.py", "check_glossary_test.py"}
# Failures that have the names of expectations, and their own rows, since more than the expectation ends with them.
EXPECTATIONS = {"fell", "log", "snapshot"}
SOURCES = ("scene", "engine", "config/loader", "tools/campuswalk")
# Warnings of an import, which a comparison of pictures refuses.
MADE_ERRORS = {"bad-texture"}


class Reference(unittest.TestCase):
    program, site = "", ""

    @classmethod
    def setUpClass(cls):
        cls.sources = Sources(ROOT, cls.program)
        pages = os.path.join(os.path.dirname(cls.site), "pages", "reference")
        cls.pages = {}
        for name in os.listdir(pages):
            with open(os.path.join(pages, name), encoding="utf-8") as file:
                cls.pages[name] = file.read()

    def first_cells(self, page):
        """The code in the first cell of each row of a page's tables."""
        return set(re.findall(r"^\| (?:· )*`([^`]+)`", self.pages[page], re.MULTILINE))

    def test_every_kind_of_event_has_a_meaning_and_a_row(self):
        kinds = event_tables.kinds(self.sources)
        enumerators = re.findall(r"^    ([a-z_]+),", self.sources.text("engine", "events", "event.h").partition("enum class EventKind")[2]
                                 .partition("};")[0], re.MULTILINE)
        self.assertEqual([kind.replace(".", "_", 1) for kind in sorted(kinds)], sorted(enumerators))
        described = event_tables.described(self.sources)["events"]
        self.assertEqual([each["event"] for each in described], kinds)
        self.assertEqual(len({each["when"] for each in described}), len(kinds))
        self.assertLessEqual(set(kinds), self.first_cells("events.md"))

    def test_every_field_in_the_source_is_described(self):
        self.assertEqual(event_tables.source_fields(self.sources),
                         {each["field"] for each in event_tables.described(self.sources)["fields"]})

    def test_the_fields_of_real_walks_are_those_described(self):
        described = {(each["event"], name) for each in event_tables.described(self.sources)["events"] for name in each["fields"]}
        described = {(kind, name) for kind, name in described if kind not in OF_PROGRAMS}
        seen = self.fields_of_real_walks()
        self.assertEqual(sorted(seen - described), [], "in logs, but not described")
        self.assertEqual(sorted(described - seen), [], "described, but in no log")

    def test_the_header_of_json_lines_is_that_described(self):
        text = self.sources.text("engine", "observers", "json_lines.cpp").partition("void JsonLines::begin")[2].partition("\n}\n")[0]
        keys = set(re.findall(r'\{"([a-z_]+)",|header\["([a-z_]+)"\]', text))
        self.assertEqual({a or b for a, b in keys} | {"campus"}, {key for cell in re.findall(
            r"(?m)^\| (.*?) \|", self.pages["events.md"].partition("| key of the header |")[2]) for key in re.findall(r"`([a-z_]+)`", cell)})

    def fields_of_real_walks(self):
        seen = set()
        walks = [(ROOT, os.path.join(base, name)) for base, _, names in os.walk(os.path.join(ROOT, "config", "walks"))
                 for name in sorted(names) if name.endswith(".walk.yaml")]
        with tempfile.TemporaryDirectory(prefix="campuswalk-docs-") as folder:
            school = os.path.join(folder, "school")
            subprocess.run([self.program, "init", school], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True)
            for name, text in MORE_WALKS.items():
                with open(os.path.join(school, "walks", name), "w", encoding="utf-8") as file:
                    file.write(text)
                if name.endswith(".walk.yaml"):
                    walks.append((school, "walks/" + name))
            log = os.path.join(folder, "log.jsonl")
            for place, walk in walks:
                subprocess.run([self.program, "run", walk, "-q", "--rendering-backend", "none", "--jsonl", log, "--output",
                                os.path.join(folder, "out")], cwd=place, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
                if os.path.exists(log):
                    with open(log, encoding="utf-8") as file:
                        events = [json.loads(line) for line in file][1:]
                    os.remove(log)
                    seen |= {(event["event"], key) for event in events for key in event if key not in ("tick", "time", "event", "object")}
        print("reference: %d walks, %d fields of events" % (len(walks), len(seen)))
        return seen

    def test_every_code_of_the_program_is_described_and_no_other(self):
        """The compiler refuses a diagnostic whose code isn't in the program's table."""
        failures = set(diagnostic_codes.table()["failures"])
        codes = set(diagnostic_codes.severities())
        self.assertEqual(diagnostic_codes.of_diagnostics(ROOT), sorted(codes))
        self.assertEqual(failures - EXPECTATIONS, set(diagnostic_codes.of_failures(ROOT)))
        self.assertEqual(codes & failures, set())
        print("reference: %d codes, %d failures" % (len(codes), len(failures)))

    def test_every_code_is_reported_somewhere(self):
        """A code that nothing reports any more goes out of the program's table."""
        unreported = set(diagnostic_codes.of_diagnostics(ROOT))
        for base, _, names in itertools.chain.from_iterable(os.walk(os.path.join(ROOT, folder)) for folder in SOURCES):
            for name in names:
                if name.endswith((".h", ".cpp")) and name != "diagnostic_code.h":
                    with open(os.path.join(base, name), encoding="utf-8") as file:
                        unreported -= set(re.findall(r'"([a-z-]+)"', file.read()))
        self.assertEqual(unreported, set())

    def test_every_code_has_a_sentence_and_a_row(self):
        described = diagnostic_codes.table()
        self.assertEqual(set(described), {*diagnostic_codes.SEVERITIES, "failures"})
        for section in described.values():
            self.assertEqual(list(section), sorted(section) if section is not described["failures"] else list(section))
            for code, meaning in section.items():
                with self.subTest(code=code):
                    self.assertRegex(meaning, r"^[A-Z`].{30,}\.$")
                    self.assertEqual(meaning.count("`") % 2, 0)
                    self.assertNotIn("|", meaning)
        self.assertLessEqual({code for section in described.values() for code in section}, self.first_cells("diagnostics.md"))

    def test_every_failure_that_a_walk_may_name_is_there(self):
        schema = self.sources.schema("walk.schema.json")
        codes = re.findall(r"`([a-z_-]+)`", self.pages["diagnostics.md"])
        expectations = diagnostic_codes.expectations(schema)
        self.assertLessEqual(set(expectations), set(codes))
        own = set(diagnostic_codes.table()["failures"]) - OTHERS
        self.assertEqual(own | set(expectations), set(diagnostic_codes.enum_of_failures(schema)))

    def test_findings_have_the_same_names_everywhere(self):
        page = self.sources.output("explore", "--help")
        names = re.findall(r"(?m)^  (\w+)  ", page[page.index("What --fail-on looks for:"):])
        self.assertGreater(len(names), 5)
        kinds = self.sources.schema("explore.schema.json")["properties"]["findings"]["items"]["properties"]["kind"]["enum"]
        self.assertEqual(names, kinds)
        with open(os.path.join(ROOT, "docs", "how-to", "reachability.md"), encoding="utf-8") as file:
            table = file.read().split("| `--fail-on` |")[1].split("\n\n")[0]
        described = [name for row in table.splitlines()[1:] for name in re.findall(r"`(\w+)`", row.split("|")[-2])]
        self.assertEqual(sorted(names), sorted(described))

    def test_codes_are_reported_as_tests_expect(self):
        """The tests name codes as the program prints them, and don't read its source."""
        severities, count = diagnostic_codes.severities(), 0
        for base, _, names in os.walk(os.path.join(ROOT, "tests")):
            if os.path.basename(base) == "docs":
                continue
            for name in sorted(names):
                if name.endswith("_test.py") and name not in TESTS_OF_TOOLS:
                    with open(os.path.join(base, name), encoding="utf-8") as file:
                        text = file.read()
                    for severity, code in re.findall(r"(error|warning) ([a-z]+(?:-[a-z0-9]+)+)\b", text):
                        if code in OTHERS:
                            continue
                        count += 1
                        with self.subTest(test=name, code=code):
                            self.assertIn("warning" if code in MADE_ERRORS else severity, severities.get(code, "no such code"))
        print("reference: %d mentions of codes in tests" % count)
        self.assertGreater(count, 100)

    def test_every_option_of_every_command_is_there(self):
        page, count = self.pages["commands.md"], 0
        for name, _ in command_lines.subcommands(self.sources.output("--help")):
            section = re.search(r"^## %s\n(.*?)(?=^## |\Z)" % name, page, re.MULTILINE | re.DOTALL)[1]
            for option in set(re.findall(r"(?m)^  (?:-\w,)?(--[a-z-]+)", self.sources.output(name, "--help"))) - {"--help", "--version"}:
                count += 1
                with self.subTest(command=name, option=option):
                    self.assertRegex(section, r"(?m)^\| `[^|]*%s\b" % option)
        print("reference: %d options" % count)
        self.assertGreater(count, 80)

    def test_every_key_of_every_schema_is_there(self):
        pages = {"campus": "campus.md", "walk": "walk.md", "avatar": "avatar.md", "light": "light.md", "walks-config": "config.md",
                 "report": "results.md", "report-line": "results.md", "explore": "results.md", "explorations": "results.md", "info": "results.md",
                 "recording": "results.md", "steps": "walk.md"}
        for file in os.listdir(os.path.join(ROOT, "config", "schema")):
            page = self.pages[pages[file.removesuffix(".schema.json")]]
            for key in sorted(self.keys_of(self.sources.schema(file))):
                with self.subTest(schema=file, key=key):
                    self.assertIn("`%s`" % key, page)

    def keys_of(self, schema):
        if isinstance(schema, list):
            return set().union(*map(self.keys_of, schema)) if schema else set()
        if not isinstance(schema, dict):
            return set()
        found = set(schema["properties"]) - {"$schema"} if isinstance(schema.get("properties"), dict) else set()
        return found.union(*[self.keys_of(value) for value in schema.values()])

    def test_every_exit_code_of_the_source_is_there(self):
        text = self.sources.text("tools", "campuswalk", "base", "exit_codes.h")
        codes = set(re.findall(r"constexpr int \w+ = (\d+);", text))
        self.assertEqual(set(re.findall(r"(?m)^\| (\d+) \|", self.pages["exit-codes.md"])), codes)

    def test_every_variable_of_the_environment_is_there(self):
        text = ""
        for folder in ("tools/campuswalk", "scene", "engine", "collision"):
            for base, _, names in os.walk(os.path.join(ROOT, folder)):
                for name in names:
                    if name.endswith(".cpp"):
                        with open(os.path.join(base, name), encoding="utf-8") as file:
                            text += file.read()
        for variable in sorted(set(re.findall(r'"(CAMPUSWALK_[A-Z_]+)"', text))):
            with self.subTest(variable=variable):
                self.assertIn(variable, self.pages["environment.md"])


if __name__ == "__main__":
    Reference.program, Reference.site = (os.path.abspath(each) for each in sys.argv[1:3])
    unittest.main(argv=[sys.argv[0]])
