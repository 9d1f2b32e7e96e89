"""Tables of events and their fields, from `campuswalk help events --json`.

The simulation adds fields where an event arises; tests/docs/reference_test.py compares `source_fields` and the logs of walks with
what the program says of them.
"""

import json
import os
import re

from . import command_lines

_KIND = re.compile(r'std::pair\{EventKind::\w+, "([a-z]+\.[a-z]+)"\}')
_FIELD = re.compile(r'\{"([a-z_]+)",|\{(kWhy),')


def kinds(sources):
    """The names of all kinds in the source, in their order."""
    return _KIND.findall(sources.text("engine", "events", "event.cpp"))


def described(sources):
    """What the program says: {events: [{event, object, when, fields}], fields: [{field, value, meaning}]}."""
    return json.loads(sources.output("help", "events", "--json"))


def source_fields(sources):
    """The names of the fields that the simulation adds to events."""
    folder = os.path.join(sources.root, "engine", "simulation")
    found = set()
    for name in sorted(os.listdir(folder)):
        if name.endswith(".cpp"):
            text = sources.text("engine", "simulation", name)
            if "events.add(" in text or "event.fields" in text:
                found |= {field or "why" for field, _ in _FIELD.findall(text)}
    return found


def events(sources):
    """(event, object, fields, when) of each."""
    return [("`%s`" % each["event"], each["object"], ", ".join("`%s`" % name for name in each["fields"]),
             command_lines.in_markdown(each["when"])) for each in described(sources)["events"]]


def fields(sources):
    """(field, value, meaning) of each."""
    return [("`%s`" % each["field"], each["value"], each["meaning"]) for each in described(sources)["fields"]]
