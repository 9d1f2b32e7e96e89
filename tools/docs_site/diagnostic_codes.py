"""The codes of diagnostics and failures with what they mean, from diagnostics.toml; and those of the program, to compare it with."""

import os
import re
import tomllib

TABLE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "diagnostics.toml")
SEVERITIES = {"errors": ("error",), "warnings": ("warning",), "errors_or_warnings": ("error", "warning")}


def table():
    """Section -> code -> meaning."""
    with open(TABLE, "rb") as file:
        return tomllib.load(file)


def severities():
    """code -> how it is reported: `error`, `warning` or both."""
    described = table()
    return {code: words for section, words in SEVERITIES.items() for code in described[section]}


def of_diagnostics(root):
    """The codes that the program has, in their order."""
    with open(os.path.join(root, "scene", "base", "diagnostic_code.h"), encoding="utf-8") as file:
        return re.findall(r'"([a-z-]+)"', re.search(r"kDiagnosticCodes = .*?;", file.read(), re.DOTALL)[0])


def of_failures(root):
    """The codes of failures that aren't the names of expectations."""
    with open(os.path.join(root, "engine", "script", "failure_codes.h"), encoding="utf-8") as file:
        return re.findall(r'"([a-z-]+)"', file.read())


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
