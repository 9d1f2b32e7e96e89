"""Tables of events and their fields.

The kinds are in engine/events/event.cpp, when they occur in `campuswalk help events`. The simulation adds fields where an
event arises; what they mean is in event_fields.toml, which `source_fields` and the logs of walks are compared with
(tests/docs/reference_test.py).
"""

import os
import re
import tomllib

_KIND = re.compile(r'std::pair\{EventKind::\w+, "([a-z]+\.[a-z]+)"\}')
_HELP = re.compile(r"^  (\w+\.\w+(?: \.\w+)*) {2,}(\S.*)$", re.MULTILINE)
_FIELD = re.compile(r'\{"([a-z_]+)",|\{(kWhy),')


def kinds(sources):
    """The names of all kinds, in their order."""
    return _KIND.findall(sources.text("engine", "events", "event.cpp"))


def meanings(sources):
    """When each event occurs, by its name."""
    found = {}
    for names, text in _HELP.findall(sources.output("help", "events")):
        first, *others = names.split()
        for name in [first] + [first.split(".")[0] + other for other in others]:
            found[name] = text
    return found


def described(sources):
    """The fields of event_fields.toml: name -> {value, meaning, events}."""
    return tomllib.loads(sources.text("tools", "docs_site", "event_fields.toml"))


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
    """(event, when, fields) of each."""
    when, fields_of = meanings(sources), described(sources)
    return [("`%s`" % kind, when[kind],
             ", ".join("`%s`" % name for name, field in fields_of.items() if kind in field["events"]))
            for kind in kinds(sources)]


def fields(sources):
    """(field, value, meaning) of each."""
    return [("`%s`" % name, field["value"], field["meaning"]) for name, field in described(sources).items()]
