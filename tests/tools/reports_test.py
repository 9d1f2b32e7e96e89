#!/usr/bin/env python3
"""Reports as other programs read them: JSON and JUnit conform to their schemas and agree with each other.

`reports_test.py REPORT_SAMPLES`, the program that writes samples of each.
"""

import copy
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

import jsonschema

HERE = os.path.dirname(os.path.abspath(__file__))
SCHEMAS = os.path.join(HERE, "..", "..", "config", "schema")
RUNS = ("empty", "full", "hostile", "mixed")


def schema(name):
    with open(os.path.join(SCHEMAS, name), encoding="utf-8") as file:
        return json.load(file)


def validator(name):
    content = schema(name)
    jsonschema.Draft7Validator.check_schema(content)
    store = {each: schema(each) for each in ("report.schema.json",)}
    resolver = jsonschema.RefResolver(name, content, store=store)
    return jsonschema.Draft7Validator(content, resolver=resolver)


def places(value, path=()):
    """The path to every object in a JSON value."""
    if isinstance(value, dict):
        yield path
    children = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, child in children:
        yield from places(child, path + (key,))


def at(value, path):
    for key in path:
        value = value[key]
    return value


class Reports(unittest.TestCase):
    """The samples of every reporter."""

    samples = ""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.mkdtemp(prefix="campuswalk-")
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        subprocess.run([cls.samples, cls.folder], check=True)

    def text(self, name):
        with open(os.path.join(self.folder, name), encoding="utf-8", newline="") as file:
            return file.read()


class Json(Reports):
    """The JSON report conforms to its schema, and the schema accepts nothing else."""

    def test_every_report_conforms_to_the_schema(self):
        check = validator("report.schema.json")
        for run in RUNS:
            check.validate(json.loads(self.text(run + ".json")))

    def test_every_line_conforms_to_the_schema(self):
        check = validator("report-line.schema.json")
        for run in RUNS:
            lines = self.text(run + ".jsonl").split("\n")
            self.assertEqual(lines.pop(), "")
            for line in lines:
                check.validate(json.loads(line))
            self.assertEqual(json.loads(lines[0])["cases"], len(lines) - 1)

    def test_no_key_may_be_missing_or_unknown(self):
        check = validator("report.schema.json")
        whole = json.loads(self.text("full.json"))
        described = schema("report.schema.json")
        parts = [described, *described["definitions"].values()]
        optional = {(holder, key) for holder, name in (("failures", "failure"), ("reason", "reason"), ("parts", "reason"))
                    for key in described["definitions"][name]["properties"] if key not in described["definitions"][name]["required"]}
        seen = set()
        for path in places(whole):
            for key in at(whole, path):
                less = copy.deepcopy(whole)
                del at(less, path)[key]
                holder = next((name for name in reversed(path) if isinstance(name, str)), "")
                self.assertEqual(check.is_valid(less), (holder, key) in optional, (path, key))
                seen.add(key)
            more = copy.deepcopy(whole)
            at(more, path)["unknown_key"] = 1
            self.assertFalse(check.is_valid(more), path)
        self.assertEqual({key for part in parts for key in part["properties"]} - seen, set())

    def test_no_key_may_have_another_type(self):
        check = validator("report.schema.json")
        whole = json.loads(self.text("full.json"))
        for path in places(whole):
            for key in at(whole, path):
                wrong = copy.deepcopy(whole)
                part = at(wrong, path)
                part[key] = [] if isinstance(part[key], dict) else {}
                self.assertFalse(check.is_valid(wrong), (path, key))

    def test_outcomes_are_those_of_the_code(self):
        outcomes = schema("report.schema.json")["definitions"]["result"]["properties"]["outcome"]["enum"]
        seen = {result["outcome"] for result in json.loads(self.text("mixed.json"))["results"]}
        self.assertEqual(seen, set(outcomes))

    def test_every_key_has_a_description(self):
        for name in ("report.schema.json", "report-line.schema.json"):
            content = schema(name)
            for path in places(content):
                for key, value in at(content, path).get("properties", {}).items():
                    described = value.get("description") or "$ref" in value
                    self.assertTrue(described, (name, path, key))


class Junit(Reports):
    """The JUnit report."""

    def test_every_report_conforms_to_the_schema(self):
        files = [os.path.join(self.folder, run + ".junit") for run in RUNS]
        done = subprocess.run(["xmllint", "--noout", "--schema", os.path.join(HERE, "junit.xsd"), *files],
                              stderr=subprocess.PIPE, check=False)
        self.assertEqual(done.returncode, 0, done.stderr.decode())

    def test_the_schema_refuses_unknown_elements(self):
        broken = self.text("mixed.junit").replace("<skipped message", "<skip message", 1)
        done = subprocess.run(["xmllint", "--noout", "--schema", os.path.join(HERE, "junit.xsd"), "-"],
                              input=broken.encode(), stderr=subprocess.DEVNULL, check=False)
        self.assertNotEqual(done.returncode, 0)

    def test_counts_are_those_of_the_cases(self):
        for run in RUNS:
            root = ElementTree.fromstring(self.text(run + ".junit"))
            for suite in [root, *root.iter("testsuite")]:
                counted = {"tests": "testcase", "failures": "failure", "errors": "error"}
                for attribute, element in counted.items():
                    self.assertEqual(int(suite.get(attribute)), len(list(suite.iter(element))), (run, attribute))

    def test_suites_are_files_and_agree_with_json(self):
        for run in ("mixed", "full"):
            root = ElementTree.fromstring(self.text(run + ".junit"))
            results = json.loads(self.text(run + ".json"))["results"]
            self.assertEqual([suite.get("name") for suite in root], list(dict.fromkeys(r["file"] for r in results)))
            cases = list(root.iter("testcase"))
            self.assertEqual(len(cases), len(results))
            for case, result in zip(cases, results):
                self.assertEqual(float(case.get("time")), result["ticks"] / result["ticks_per_second"])
                self.assertEqual(case.find("skipped") is not None, result["outcome"] == "skipped")


if __name__ == "__main__":
    Reports.samples = os.path.abspath(sys.argv.pop(1))
    unittest.main(verbosity=2)
