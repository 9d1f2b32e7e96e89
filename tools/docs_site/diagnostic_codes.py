"""The codes of diagnostics and failures with what they mean, from diagnostics.toml; and those in the source, to compare it with.

In the source, a code is a string literal of words with hyphens (or one of PLAIN_CODES). Literals that look like codes and are
none are listed, so that a new one has to be put either here or into diagnostics.toml.
"""

import os
import re
import tomllib

from check_layers.source import without_comments

FOLDERS = ("collision", "scene", "engine", "config/loader", "tools/campuswalk")
TABLE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "diagnostics.toml")
# Codes of a single word.
PLAIN_CODES = {"strict", "unreadable", "xfail"}
# Names of commands, help topics, options, files, formats and attributes; tags of maps and what is made of them.
NOT_CODES = {"also-called", "assumed-entrance", "bicycle-stand", "bridge-pier", "campuswalk-import-request", "campuswalk-import-response",
             "cycle-barrier", "exit-codes", "half-hipped", "image-helper", "import-helper", "jsonl-log", "map-helper", "merge-reports",
             "multi-storey", "nonnull-attribute", "parcel-locker", "post-box", "short-name", "slurm-explore", "stop-sign", "system-err", "system-out",
             "timed-trace", "vending-machine", "xxxxxxxx-xxxx-xxxx-xxxx-xxxxxxxxxxxx"}
SEVERITIES = {"errors": ("error",), "warnings": ("warning",), "errors_or_warnings": ("error", "warning")}

_LITERAL = re.compile(r'"((?:[^"\\\n]|\\.)*)"')
_PRINTED = re.compile(r"(?:error|warning) ([a-z]+(?:-[a-z0-9]+)+):")
_CODE = re.compile(r"[a-z]+(?:-[a-z0-9]+)+")


def table():
    """Section -> code -> meaning."""
    with open(TABLE, "rb") as file:
        return tomllib.load(file)


def severities():
    """code -> how it is reported: `error`, `warning` or both."""
    described = table()
    return {code: words for section, words in SEVERITIES.items() for code in described[section]}


def in_source(root):
    """The literals that are, or look like, codes."""
    found = set()
    for folder in FOLDERS:
        for base, _, names in os.walk(os.path.join(root, folder)):
            for name in names:
                if name.endswith((".h", ".cpp")):
                    with open(os.path.join(base, name), encoding="utf-8") as file:
                        for literal in _LITERAL.findall(without_comments(file.read())):
                            found.update(_PRINTED.findall(literal))
                            if literal in PLAIN_CODES or _CODE.fullmatch(literal):
                                found.add(literal)
    return found - NOT_CODES


def rows():
    """(code, severity, meaning) of each diagnostic."""
    described = table()
    found = sorted((code, words, described[section][code]) for section, words in SEVERITIES.items() for code in described[section])
    return [("`%s`{ #%s }" % (code, code), ", ".join(words), meaning) for code, words, meaning in found]


def failures():
    """(code, meaning) of each failure that isn't an expectation of its own name."""
    return [("`%s`" % code, meaning) for code, meaning in table()["failures"].items()]


def expectations(walk_schema):
    """The codes that `status: {failures: …}` of a walk may name, and that are the names of expectations."""
    described = table()["failures"]
    return [code for code in enum_of_failures(walk_schema) if code not in described]


def enum_of_failures(schema):
    """The enumeration that has `unreachable`, wherever the schema defines it."""
    pending = [schema]
    while pending:
        each = pending.pop()
        if isinstance(each, dict):
            if "unreachable" in each.get("enum", []):
                return each["enum"]
            pending += each.values()
        elif isinstance(each, list):
            pending += each
    raise SystemExit("docs: walk.schema.json names no codes of failures")
