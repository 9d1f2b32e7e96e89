#!/usr/bin/env python3
"""The JSON Schemas in config/schema and the loader agree on every key.

The loader lists the known keys when it finds an unknown one; jsonschema evaluates the schemas.
A key that was added only to the loader, or only to a schema, is named in the failure.
"""

import glob
import json
import os
import re
import shutil
import subprocess
import sys
import warnings

import jsonschema
import yaml

import schema_documents
from program import CAMPUS as CAMPUS_FILE, ProgramCase, main

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
ADDRESS = "https://campuswalk.invalid/"
SCHEMAS = schema_documents.load_all()

# Only keys are checked, so the model doesn't exist.
CAMPUS = {
    "scenes": [{"file": "none.glb"}],
    "layers": ["trees"],
    "buildings": [{"id": "library", "title": "Library"}],
    "colliders": [{"id": "ground", "shape": "mesh", "mode": "solid"}],
    "spawns": {"gate": {"at": [0, 0, 5]}},
    "places": {"desk": [0, 0, -2]},
}
WALK = {"campus": "a.campus.yaml", "avatar": "adult", "steps": [{"spawn": "gate"}]}
STEPS = {"steps": [{"wait": 1}]}
AVATAR = {"height": 1.8}
# Schema, suffix of its files, a valid document.
KINDS = [
    ("campus.schema.json", ".campus.yaml", CAMPUS),
    ("walk.schema.json", ".walk.yaml", WALK),
    ("steps.schema.json", ".steps.yaml", STEPS),
    ("avatar.schema.json", ".avatar.yaml", AVATAR),
    ("light.schema.json", ".light.yaml", {"shadows": True}),
    ("walks-config.schema.json", ".config.yaml", {}),
]
# The loader's codes about the form of a file; later ones, about models and places, have nothing to do with keys.
FORM = {"unknown-key", "missing-key", "duplicate-key", "wrong-type", "bad-value", "unknown-name", "duplicate-name",
        "yaml-syntax", "empty-file"}
DIAGNOSTIC = re.compile(r"(?P<file>[^:]+)(:\d+:\d+)?: error (?P<code>\S+): (?P<message>.*)")


class Yaml12(yaml.SafeLoader):
    """`on` and `off` are words."""


Yaml12.yaml_implicit_resolvers = {
    first: [(tag, pattern) for tag, pattern in entries if tag != "tag:yaml.org,2002:bool"]
    for first, entries in yaml.SafeLoader.yaml_implicit_resolvers.items()}
Yaml12.add_implicit_resolver("tag:yaml.org,2002:bool", re.compile("^(true|false)$"), "tf")


def validator(name):
    store = {ADDRESS + each: schema for each, schema in SCHEMAS.items()}
    warnings.simplefilter("ignore", DeprecationWarning)  # later versions than Debian's have another resolver
    resolver = jsonschema.RefResolver(ADDRESS + name, SCHEMAS[name], store)
    return jsonschema.Draft7Validator(SCHEMAS[name], resolver=resolver)


class Schemas(ProgramCase):
    def setUp(self):
        super().setUp()
        self.write("a.campus.yaml", json.dumps(CAMPUS))
        self.write("lap.steps.yaml", json.dumps(STEPS))
        # A walks.config.yaml is checked with the walks beside it.
        self.write("short.walk.yaml", json.dumps({**WALK, "campus": "small.campus.yaml"}))
        self.write("small.campus.yaml", CAMPUS_FILE.replace("start:", "gate:"))

    def diagnostics_of(self, documents, suffix):
        """The loader's (code, message) pairs for each document; all are read in one run of the program."""
        names = ["d%d%s" % (i, suffix) for i in range(len(documents))]
        for name, document in zip(names, documents):
            self.write(name, json.dumps(document))
        found = {name: [] for name in names}
        outcome = self.run_program("validate", *names)
        for name in names:
            os.remove(self.path(name))
        for line in outcome.err_lines:
            diagnostic = DIAGNOSTIC.fullmatch(line)
            if diagnostic and diagnostic["code"] in FORM and diagnostic["file"] in found:
                found[diagnostic["file"]].append((diagnostic["code"], diagnostic["message"]))
        self.assertIn(outcome.code, (0, 2), outcome.err)
        return [found[name] for name in names]

    def for_every_kind(self, check):
        for name, suffix, base in KINDS:
            documents = schema_documents.Documents(SCHEMAS, name, base)
            with self.subTest(schema=name):
                check(documents, suffix, validator(name))

    # ---- the schemas by themselves

    def test_every_schema_is_valid_and_tested(self):
        for name, schema in SCHEMAS.items():
            jsonschema.Draft7Validator.check_schema(schema)
            self.assertIn("description", schema, name)
        self.assertLessEqual({name for name, _, _ in KINDS}, set(SCHEMAS))

    def test_every_key_has_a_description(self):
        def check(documents, _suffix, _validator):
            bare = [node.trail for node in documents.nodes() if node.is_property and "description" not in node.schema]
            self.assertEqual(bare, [])
        self.for_every_kind(check)

    def reference(self, root, *flags):
        return subprocess.run([sys.executable, os.path.join(ROOT, "tools", "config-reference"), "--root", root, *flags],
                              capture_output=True, text=True, check=False)

    def test_the_reference_is_up_to_date(self):
        done = self.reference(ROOT, "--check")
        self.assertEqual((done.returncode, done.stdout), (0, ""), done.stderr)

    def test_an_outdated_reference_is_found_and_rewritten(self):
        shutil.copytree(os.path.join(ROOT, "config"), self.path("copy/config"))
        changed = self.read("copy/config/schema/avatar.schema.json").decode().replace("Radius of the capsule", "Half its width")
        self.write("copy/config/schema/avatar.schema.json", changed)
        done = self.reference(self.path("copy"), "--check")
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stdout, r"^config/README\.md:\d+:1: error reference: ")
        self.assertEqual(self.reference(self.path("copy")).returncode, 0)
        self.assertIn("Half its width in metres", self.read("copy/config/README.md").decode())
        self.assertEqual(self.reference(self.path("copy"), "--check").returncode, 0)

    def test_every_schema_has_its_tables(self):
        with open(os.path.join(ROOT, "config", "README.md"), encoding="utf-8") as file:
            tables = set(re.findall(r"<!-- keys: ([^ #]+)", file.read()))
        self.assertEqual({name for name, _, _ in KINDS} - {"steps.schema.json"}, tables)

    # ---- schema and loader

    def test_loader_and_schema_have_the_same_keys(self):
        def check(documents, suffix, _validator):
            nodes = [node for node in documents.nodes()
                     if node.schema.get("type") == "object" and "properties" in node.schema
                     and not isinstance(node.schema.get("additionalProperties"), dict)]  # any other key is a name
            found = self.diagnostics_of([documents.with_unknown_key(node) for node in nodes], suffix)
            for node, diagnostics in zip(nodes, found):
                with self.subTest(map=node.trail):
                    unknown = [text for code, text in diagnostics
                            if code == "unknown-key" and schema_documents.UNKNOWN_KEY in text]
                    self.assertEqual(len(unknown), 1, diagnostics)
                    known = unknown[0].partition("; known here: ")[2].split(", ")
                    self.assertNotIn("…", known, "the loader doesn't list all; see kMostListed in wording.cpp")
                    in_schema = set(node.schema["properties"])
                    self.assertEqual((set(known) - in_schema, in_schema - set(known)), (set(), set()),
                                     "keys that only the loader has, keys that only the schema has")
        self.for_every_kind(check)

    def test_examples_of_the_schema_are_accepted_by_both(self):
        def check(documents, suffix, schema_validator):
            shown = [(node.trail, value, node.wrap(value)) for node in documents.nodes()
                     if not is_out_of_place(node, suffix) for value in schema_documents.accepted(node.schema)]
            self.assertGreater(len(shown), 8)
            found = self.diagnostics_of([document for _, _, document in shown], suffix)
            for (trail, value, document), diagnostics in zip(shown, found):
                with self.subTest(key=trail, value=value):
                    self.assertEqual([error.message for error in schema_validator.iter_errors(document)], [])
                    self.assertEqual(diagnostics, [])
        self.for_every_kind(check)

    def test_limits_are_the_same(self):
        def check(documents, suffix, schema_validator):
            shown = [(node.trail, value, node.wrap(value)) for node in documents.nodes()
                     for value in schema_documents.limits(node.schema) if "items" not in node.schema]
            found = self.diagnostics_of([document for _, _, document in shown], suffix)
            for (trail, value, document), diagnostics in zip(shown, found):
                with self.subTest(key=trail, value=value):
                    self.assertEqual([error.message for error in schema_validator.iter_errors(document)], [])
                    out_of_range = [text for _, text in diagnostics
                                    if re.search(r" must be (from|more than|a whole|a number)", text)]
                    self.assertEqual(out_of_range, [])
        self.for_every_kind(check)

    def test_the_loader_refuses_what_the_schema_refuses(self):
        def check(documents, suffix, schema_validator):
            refused = [(node.trail, value, node.wrap(value)) for node in documents.nodes()
                       if (node.is_property or node.trail.endswith("-")) for value in suspects_of(documents, node)
                       if not schema_validator.is_valid(node.wrap(value))]
            found = self.diagnostics_of([document for _, _, document in refused], suffix)
            for (trail, value, document), diagnostics in zip(refused, found):
                with self.subTest(key=trail, value=value):
                    self.assertNotEqual(diagnostics, [], document)
            keys = {node.trail for node in documents.nodes() if node.is_property}
            self.assertEqual(keys - {trail for trail, _, _ in refused}, set(), "keys without a refused value")
        self.for_every_kind(check)

    def test_words_are_the_same(self):
        """The loader lists the accepted words when it finds another."""
        def check(documents, suffix, _validator):
            nodes = [node for node in documents.nodes() if "enum" in node.schema]
            found = self.diagnostics_of([node.wrap("no-such-word") for node in nodes], suffix)
            for node, diagnostics in zip(nodes, found):
                lists = [re.search(r" must be one of (.*), not 'no-such-word'", text) for _, text in diagnostics]
                for words in filter(None, lists):
                    with self.subTest(key=node.trail):
                        listed = words[1].split(", ")
                        cut = listed[-1] == "…"
                        self.assertEqual(set(listed[:-1] if cut else listed) - set(node.schema["enum"]), set())
                        self.assertTrue(cut or len(listed) == len(node.schema["enum"]), listed)
        self.for_every_kind(check)

    # ---- files in the repository

    def test_repository_files_conform_and_name_their_schema(self):
        files = glob.glob(os.path.join(ROOT, "config", "**", "*.yaml"), recursive=True)
        self.assertGreater(len(files), 8)
        for path in files:
            with self.subTest(file=os.path.relpath(path, ROOT)), open(path, encoding="utf-8") as file:
                text = file.read()
                modeline = re.match(r"# yaml-language-server: \$schema=(\S+)\n", text)
                self.assertTrue(modeline, "the first line names no schema")
                named = os.path.normpath(os.path.join(os.path.dirname(path), modeline[1]))
                self.assertEqual(os.path.dirname(named), os.path.normpath(schema_documents.FOLDER))
                schema_validator = validator(os.path.basename(named))
                self.assertEqual([error.message for error in schema_validator.iter_errors(yaml.load(text, Yaml12))], [])


def is_out_of_place(node, suffix):
    """Valid, but not here: a steps file has no spawn; logs and images are evaluated after the walk."""
    late = suffix == ".steps.yaml" and node.trail.startswith("steps/-/spawn")
    return late or (node.trail.startswith("steps/-/expect") and
                    any("/" + key in node.trail for key in ("log", "snapshot", "visible")))


def alternatives(documents, file, schema):
    """The schema and all its alternatives."""
    found = [schema]
    for key in ("anyOf", "oneOf"):
        for each in schema.get(key, []):
            if "properties" not in schema:
                found += alternatives(documents, *documents.resolve(file, each))
    return found


def suspects_of(documents, node):
    """Values to refuse. In YAML, any scalar is a text, and an empty section is an empty list or map."""
    forms = alternatives(documents, node.file, node.schema)
    types = {kind for form in forms for kind in ([form["type"]] if isinstance(form.get("type"), str)
                                                 else form.get("type", []))}
    values = [value for form in forms for value in schema_documents.suspects(form)]
    if "string" in types:
        values = [value for value in values if value is None or isinstance(value, (dict, list))]
    if types & {"array", "object"}:
        values = [value for value in values if value is not None]
    return values


if __name__ == "__main__":
    main()
