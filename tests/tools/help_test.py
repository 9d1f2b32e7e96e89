#!/usr/bin/env python3
"""`help TOPIC`: every topic has a text, and together they name every key, event, variable and reporter."""

import json
import re

import schema_documents
from program import CAMPUS, ProgramCase, main

SCHEMAS = schema_documents.load_all()


class Help(ProgramCase):
    def topics(self):
        return re.findall(r"(?m)^  ([a-z-]+)  +\S", self.passes("help").out)

    def test_topics_are_listed(self):
        self.assertLessEqual({"walks", "steps", "expectations", "events", "campus", "avatars", "exit-codes"},
                             set(self.topics()))

    def test_every_topic_fits_a_terminal(self):
        for topic in self.topics():
            text = self.passes("help", topic).out
            self.assertGreater(len(text.splitlines()), 4, topic)
            self.assertEqual([line for line in text.splitlines() if len(line) > 110], [], topic)

    def keys(self, name, *path):
        schema = SCHEMAS[name]
        for part in path:
            schema = schema[part]
        return set(schema["properties"])

    def test_topics_name_every_key(self):
        for topic, keys in (("walks", self.keys("walk.schema.json")),
                            ("steps", self.keys("walk.schema.json", "definitions", "step")),
                            ("expectations", self.keys("walk.schema.json", "definitions", "single_expectation")),
                            ("campus", self.keys("campus.schema.json")),
                            ("projects", self.keys("walks-config.schema.json")),
                            ("avatars", self.keys("avatar.schema.json"))):
            named = set(re.findall(r"(?m)^  ([a-z_]+)  ", self.passes("help", topic).out))
            self.assertEqual(keys - named, set(), topic)

    def test_events_are_named(self):
        """The loader lists the known kinds of events when it finds an unknown one."""
        self.write("short.walk.yaml", "campus: small.campus.yaml\nsteps: [{spawn: start}]\nexpect: [{never: qqqq}]\n")
        known = self.run_program("validate", "short.walk.yaml").err.partition("known here: ")[2].strip().split(", ")
        self.assertGreater(len(known), 15)
        text = self.passes("help", "events").out
        self.assertEqual(set(known) - {"…"} - set(re.findall(r"(?m)^  (\w+\.\w+)  ", text)), set())

    def test_events_as_json(self):
        text, described = self.passes("help", "events").out, json.loads(self.passes("help", "events", "--json").out)
        fields = [each["field"] for each in described["fields"]]
        for event in described["events"]:
            self.assertRegex(text, r"(?m)^  %s +%s +%s$" % tuple(re.escape(event[key]) for key in ("event", "object", "when")))
            self.assertLessEqual(set(event["fields"]), set(fields))
        self.assertEqual({name for event in described["events"] for name in event["fields"]}, set(fields))
        for arguments in ((), ("walks",)):
            outcome = self.run_program("help", "--json", *arguments)
            self.assertEqual((outcome.code, outcome.out), (2, ""))
            self.assertRegex(outcome.err, "^--json.*: error .*events\n$")

    def test_variables_of_popups_are_named(self):
        """The loader lists the known variables when it finds an unknown one."""
        self.write("small.campus.yaml", CAMPUS.replace("A wall", "'{qqqq}'").replace("text: '{qqqq}'", "text: '{qqqq}' #"))
        known = self.run_program("validate", "small.campus.yaml").err.partition("known here: ")[2].strip().split(", ")
        self.assertGreater(len(known), 5)
        text = self.passes("help", "popups").out
        self.assertEqual([name for name in known if "{" + name + "}" not in text], [])
        self.assertLessEqual({"once", "cooldown", "dwell"}, set(re.findall(r"(?m)^  ([a-z_]+)  ", text)))

    def test_reporters_are_named(self):
        known = self.run_program("run", "--reporter", "qqqq").err.partition("must be one of ")[2].partition(", not")[0].split(", ")
        self.assertGreater(len(known), 6)
        named = re.findall(r"(?m)^  ([a-z]+)  ", self.passes("help", "reports").out)
        self.assertEqual(set(known) - set(named), set())
        in_schema = SCHEMAS["walks-config.schema.json"]["properties"]["reporters"]["items"]["anyOf"]
        self.assertEqual(set(in_schema[0]["enum"]), set(known))
        self.assertEqual(in_schema[1]["propertyNames"]["enum"], in_schema[0]["enum"])

    def test_an_unknown_topic_is_refused(self):
        outcome = self.run_program("help", "stesp")
        self.assertEqual((outcome.code, outcome.out), (2, ""))
        self.assertRegex(outcome.err, r"^error: .*'stesp' .*'steps'.*\n.*campuswalk help\n$")


if __name__ == "__main__":
    main()
