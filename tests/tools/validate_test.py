#!/usr/bin/env python3
"""`validate`: folders, steps files, and its findings as JSON, SARIF and GitHub's workflow commands."""

import json
import os
import re

import jsonschema

from program import CAMPUS, WALK, ProgramCase, main
from suggest_test import boxes_obj

# What the SARIF 2.1.0 standard requires of the parts that we write (sections 3.13 to 3.30), as a JSON Schema.
SARIF = {
    "type": "object",
    "required": ["$schema", "version", "runs"],
    "properties": {
        "version": {"const": "2.1.0"},
        "runs": {"type": "array", "minItems": 1, "maxItems": 1, "items": {
            "type": "object",
            "required": ["tool", "results"],
            "additionalProperties": False,
            "properties": {
                "columnKind": {"enum": ["utf16CodeUnits", "unicodeCodePoints"]},
                "tool": {"type": "object", "required": ["driver"], "properties": {"driver": {
                    "type": "object",
                    "required": ["name", "version", "rules"],
                    "additionalProperties": False,
                    "properties": {
                        "name": {"const": "campuswalk"},
                        "version": {"type": "string", "pattern": r"^\d+\.\d+\.\d+$"},
                        "rules": {"type": "array", "uniqueItems": True, "items": {
                            "type": "object", "required": ["id"], "properties": {"id": {"type": "string"}}}}}}}},
                "results": {"type": "array", "items": {
                    "type": "object",
                    "required": ["ruleId", "ruleIndex", "level", "message", "locations"],
                    "additionalProperties": False,
                    "properties": {
                        "ruleId": {"type": "string"},
                        "ruleIndex": {"type": "integer", "minimum": 0},
                        "level": {"enum": ["none", "note", "warning", "error"]},
                        "message": {"type": "object", "required": ["text"],
                                    "properties": {"text": {"type": "string", "minLength": 1}}},
                        "locations": {"type": "array", "minItems": 1, "items": {
                            "type": "object",
                            "required": ["physicalLocation"],
                            "properties": {"physicalLocation": {
                                "type": "object",
                                "required": ["artifactLocation"],
                                "additionalProperties": False,
                                "properties": {
                                    "artifactLocation": {"type": "object", "required": ["uri"], "properties": {
                                        "uri": {"type": "string", "pattern": r"^([A-Za-z0-9._~/-]|%[0-9A-F]{2})+$"}}},
                                    "region": {"type": "object", "required": ["startLine"], "properties": {
                                        "startLine": {"type": "integer", "minimum": 1},
                                        "startColumn": {"type": "integer", "minimum": 1}}}}}}}}}}}}}}},
}

MISTAKES = [
    ("broken.walk.yaml", 5, 5, "unknown-key", "'walkto' 'walk_to'"),
    ("broken.walk.yaml", 6, 11, "wrong-type", "'turn' '50%'"),
]


class Validate(ProgramCase):
    def setUp(self):
        super().setUp()
        self.write("broken.walk.yaml", WALK.replace("walk_to:", "walkto:").replace("turn: 180", "turn: 50%"))

    def assert_mistakes(self, found):
        """MISTAKES, in order: place and code exactly, the message by its names."""
        self.assertEqual([each[:4] for each in found], [each[:4] for each in MISTAKES])
        self.assert_diagnostics(["error: " + each[4] for each in found], *("error: " + each[4] for each in MISTAKES))

    def test_a_folder_is_searched_for_files(self):
        self.write("parts/lap.steps.yaml", "steps: [{wait: 1}, {walk_to: somewhere}]\n")
        self.write(".hidden/bad.walk.yaml", "steps: 1\n")
        self.write("notes.yaml", "a: 1\n")
        outcome = self.run_program("validate", ".")
        self.assertEqual(outcome.lines, [
            "avatars/adult.avatar.yaml: ok: an avatar",
            "parts/lap.steps.yaml: ok: 2 steps",
            "short.walk.yaml: ok: 3 steps, 2 expectations, on small (1 building, 3 objects, 1 spawn, 1 place)",
            "small.campus.yaml: ok: 1 building, 3 objects, 1 spawn, 1 place"])
        self.assertEqual([line.split(":")[0] for line in outcome.err_lines], ["broken.walk.yaml"] * 2)
        self.assertEqual(outcome.code, 2)

    def test_places_that_a_walk_cannot_get_to(self):
        walk = WALK.replace("expect:", "  - go_to: [0, 2]\n  - go_to: [0, 60]\nexpect:")
        self.assertIn("go_to", walk)
        self.write("lost.walk.yaml", walk)
        line = 1 + walk.splitlines().index("  - go_to: [0, 60]")
        outcome = self.run_program("validate", "lost.walk.yaml")
        self.assertEqual(outcome.code, 0, outcome.err)
        self.assertEqual(len(outcome.out.splitlines()), 1)
        self.assert_diagnostics(outcome.err_lines, f"lost.walk.yaml:{line}:12: warning unreachable-place: go_to 0,60 "
                                                   "reached ground")
        self.write("walks.config.yaml", "walks: [lost.walk.yaml]\nprojects:\n  a:\n  b: {spawn: {at: [0, 0, 3]}}\n")
        outcome = self.run_program("validate", "walks.config.yaml")
        self.assertEqual((outcome.code, len(outcome.err_lines)), (0, 1), "once, as both projects have it")
        self.assertNotIn("project", outcome.err)

    def test_a_warning_names_the_projects_that_have_it(self):
        self.write("sill.campus.yaml", CAMPUS.replace("spawns:", "  - {id: sill, shape: box, center: [0, 0, 7], "
                                                      "size: [20, 0.9, 0.5], mode: solid}\nspawns:"))
        self.write("up.walk.yaml", "campus: sill.campus.yaml\navatar: adult\nsteps:\n  - spawn: start\n  - go_to: [0, 9]\n"
                   "expect:\n  - reaches: [0, 9]\n")
        self.write("walks.config.yaml", "walks: [up.walk.yaml]\nprojects:\n  plain:\n"
                   "  climber: {avatar: {profile: adult, step_height: 0.5}}\n  short: {avatar: {profile: adult, eye_height: 1.5}}\n")
        outcome = self.run_program("validate", "walks.config.yaml")
        self.assertEqual((outcome.code, len(outcome.err_lines)), (0, 1), outcome.err)
        self.assertIn("warning unreachable-place: in projects 'plain', 'short': go_to 0,9 can't be reached", outcome.err)

    def test_a_folder_without_files_is_refused(self):
        self.write("empty/notes.txt", "")
        outcome = self.run_program("validate", "empty")
        self.assert_refused(outcome, "empty: error no-files: .walk.yaml .campus.yaml .avatar.yaml .light.yaml .steps.yaml "
                                     "walks.config.yaml")

    def test_a_campus_of_another_unit_is_reported_where_its_scene_is_named(self):
        self.write("school.obj", boxes_obj(
            [("ground", -4000, -30, -3000, 4000, 0, 3000)] +
            [("step", 0, 0, 29 * i, 150, 17 * (i + 1), 29 * (i + 1)) for i in range(10)]))
        campus = ('scenes:\n  - {file: school.obj}\ncolliders: [{id: world, nodes: "*", shape: mesh, mode: solid}]\n'
                  "spawns: {start: {at: [-20, 1.5, 0]}}\n")
        self.write("school.campus.yaml", campus)
        self.write("school.walk.yaml", "campus: school.campus.yaml\navatar: adult\nsteps: [{spawn: start}, {wait: 1}]\n"
                   "expect: [{never: avatar.jump}]\n")
        hint = "school.campus.yaml:2:12: warning odd-scale: 'school.obj': 9 risers are 17 m high"
        self.assertIn(hint, self.passes("validate", "school.campus.yaml").err)
        for command in ("validate", "run"):  # the visitor hangs in the air, which is the first thing that is wrong
            outcome = self.run_program(command, "school.walk.yaml")
            self.assertEqual(outcome.code, 2)
            self.assertIn("error spawn-in-air", outcome.err)
            self.assertIn(hint, outcome.err)
            self.assertIn("with `scale: 0.01` 9 risers are 0.17 m high", outcome.err)
        self.write("school.campus.yaml", campus.replace("school.obj}", "school.obj, scale: 0.01}"))
        self.assertEqual(self.passes("validate", "school.campus.yaml").err, "")

    def test_steps_file(self):
        self.write("lap.steps.yaml", "steps:\n  - spawn: gate\n  - include: lap.steps.yaml\n")
        outcome = self.run_program("validate", "lap.steps.yaml")
        self.assert_refused(outcome, "lap.steps.yaml:2:12: error bad-value: 'spawn' 'teleport'",
                            "lap.steps.yaml:3:14: error include-cycle: lap.steps.yaml")

    def test_files_and_names_in_a_configuration_file(self):
        os.remove(self.path("broken.walk.yaml"))
        self.write("walks/one.walk.yaml", WALK.replace("campus: small", "campus: ../small") + "tags: [one]\n")
        self.write("east.campus.yaml", CAMPUS.replace("start:", "porch:"))
        whole = "walks: [walks, short.walk.yaml]\nreporters: [list, {junit: a.xml}]\nprojects:\n  plain:\n"
        self.write("walks.config.yaml", whole + "  low: {avatar: {profile: adult, height: 1.7}, spawn: {at: [0, 0, 3]}}\n")
        self.assertEqual(self.passes("validate", "walks.config.yaml").lines, ["walks.config.yaml: ok: 2 projects"])
        self.write("walks.config.yaml", "walks: [walks, none]\nreporters: [junti]\nprojects:\n"
                                        "  a: {campus: none.campus.yaml}\n"
                                        "  b: {avatar: {profile: chidl}}\n"
                                        "  c: {campus: east.campus.yaml, spawn: stat}\n"
                                        "  d: {spawn: stat}\n"
                                        "  e: {grep: 'a('}\n"
                                        "  f: {campus: east.campus.yaml}\n"
                                        "  g: {campus: east.campus.yaml, tags: none}\n")
        outcome = self.run_program("validate", "walks.config.yaml")
        self.assertEqual((outcome.code, outcome.out), (2, ""))
        self.assertEqual([" ".join(line.split()[:3]) for line in outcome.err_lines], [
            "walks.config.yaml:2:13: error unknown-name:",
            "walks.config.yaml:1:16: error missing-file:",
            "walks.config.yaml:4:15: error missing-file:",
            "walks.config.yaml:5:25: error unknown-name:",
            "walks.config.yaml:6:40: error unknown-name:",
            "walks.config.yaml:7:14: error unknown-name:",
            "walks.config.yaml:8:13: error bad-regex:",
            "walks/one.walk.yaml:4:12: error unknown-name:"])

    def test_a_mistake_that_files_share_is_reported_once(self):
        self.write("small.campus.yaml", CAMPUS.replace("[0, 0, 5]", "[0, 0]"))
        self.write("other.walk.yaml", WALK)
        outcome = self.run_program("validate", "short.walk.yaml", "other.walk.yaml", "small.campus.yaml")
        self.assertEqual((outcome.code, outcome.out, len(outcome.err_lines)), (2, "", 1))

    def test_json_lists_every_diagnostic(self):
        outcome = self.run_program("validate", "--format", "json", "short.walk.yaml", "broken.walk.yaml", "none")
        self.assertEqual((outcome.code, outcome.err), (2, ""))
        report = json.loads(outcome.out)
        self.assertEqual([(file["file"], file["valid"]) for file in report["files"]],
                         [("short.walk.yaml", True), ("broken.walk.yaml", False), ("none", False)])
        found = report["diagnostics"]
        self.assert_mistakes([tuple(each[key] for key in ("file", "line", "column", "code", "message"))
                              for each in found[:2]])
        self.assertTrue(found[2].pop("message"))
        self.assertEqual(found[2], {"file": "none", "severity": "error", "code": "missing-file"})

    def test_sarif_conforms_to_its_schema(self):
        self.write("a folder/ü.walk.yaml", self.read("broken.walk.yaml"))
        outcome = self.run_program("validate", "--format", "sarif", "broken.walk.yaml", "a folder", "none")
        self.assertEqual((outcome.code, outcome.err), (2, ""))
        log = json.loads(outcome.out)
        jsonschema.Draft7Validator.check_schema(SARIF)
        jsonschema.validate(log, SARIF)
        run = log["runs"][0]
        ids = [rule["id"] for rule in run["tool"]["driver"]["rules"]]
        self.assertEqual(ids, sorted(set(ids)))
        for result in run["results"]:
            self.assertEqual(ids[result["ruleIndex"]], result["ruleId"])
        places = [result["locations"][0]["physicalLocation"] for result in run["results"]]
        self.assert_mistakes([(place["artifactLocation"]["uri"], place["region"]["startLine"],
                               place["region"]["startColumn"], result["ruleId"], result["message"]["text"])
                              for place, result in zip(places[:2], run["results"])])
        self.assertEqual({place["artifactLocation"]["uri"] for place in places},
                         {"broken.walk.yaml", "a%20folder/%C3%BC.walk.yaml", "none"})
        self.assertNotIn("region", places[-1])

    def test_sarif_without_findings(self):
        log = json.loads(self.passes("validate", "--format", "sarif", "short.walk.yaml").out)
        jsonschema.validate(log, SARIF)
        self.assertEqual(log["runs"][0]["results"], [])

    def test_github_annotations_escape_properties(self):
        self.write("a,b:c.walk.yaml", self.read("broken.walk.yaml"))
        outcome = self.run_program("validate", "--format", "github", "broken.walk.yaml", "a,b:c.walk.yaml")
        self.assertEqual((outcome.code, outcome.err), (2, ""))
        self.assertRegex(outcome.lines[0], "^::error file=broken.walk.yaml,line=5,col=5,title=unknown-key::.*'walkto'.*'walk_to'")
        self.assertRegex(outcome.lines[1], "^::error file=broken.walk.yaml,line=6,col=11,title=wrong-type::.*'turn'.*'50%25'")
        for line in outcome.lines[2:]:
            properties = re.fullmatch(r"::error ([^:]*)::.*", line)[1].split(",")
            self.assertEqual(properties[0], "file=a%2Cb%3Ac.walk.yaml")

    def test_an_unknown_format_is_refused(self):
        self.assert_bad_usage(self.run_program("validate", "--format", "xml", "short.walk.yaml"), "campuswalk validate",
                              "--format 'xml' github|json|sarif|text")


if __name__ == "__main__":
    main()
