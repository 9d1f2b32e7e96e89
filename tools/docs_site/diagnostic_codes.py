"""The codes of diagnostics, and what they say, from the string literals of the source.

A code is a literal of words with hyphens (or one of kPlainCodes) that is handed to something which reports. Literals that
look like codes and are none are listed, so that a new one is one or the other.
"""

import os
import re

from check_layers.source import without_comments

FOLDERS = ("collision", "scene", "engine", "config/loader", "tools/campuswalk")
# Codes of a single word.
PLAIN_CODES = {"deprecated", "unreadable"}
# Names of commands, help topics, options, files and formats.
NOT_CODES = {"campuswalk-import-request", "campuswalk-import-response", "exit-codes", "import-helper", "jsonl-log",
             "merge-reports", "nonnull-attribute", "slurm-explore", "system-err", "system-out", "timed-trace",
             "xxxxxxxx-xxxx-xxxx-xxxx-xxxxxxxxxxxx"}
# Of the failures of walks, which the results list, too.
FAILURES = {"not-evaluated", "not-identical"}

_LITERAL = re.compile(r'"((?:[^"\\\n]|\\.)*)"')
_COMPARED = re.compile(r"(?:==\s*|has_lint\([^()]*)$")
_PRINTED = re.compile(r"(error|warning) ([a-z]+(?:-[a-z0-9]+)+): ?(.*)")
_LATER = re.compile(r"\bmessage = ")
_COMMA = re.compile(r"\s*,\s*")
_CODE = re.compile(r"[a-z]+(?:-[a-z0-9]+)+")
_WARNS = re.compile(r"(?:\bwarn|warning)$")
_MOST_MESSAGES = 3


def _opening(text, offset):
    """Where the innermost bracket that is open there was opened, or the statement began."""
    depth = 0
    for i in range(offset - 1, -1, -1):
        if text[i] in ")}]":
            depth += 1
        elif text[i] in "({[":
            if depth == 0:
                return i
            depth -= 1
        elif text[i] == ";" and depth == 0:
            return i
    return 0


def _argument(text, offset):
    """The argument that begins there, up to its comma or bracket."""
    depth, i = 0, offset
    while i < len(text):
        literal = _LITERAL.match(text, i)
        if literal:
            i = literal.end()
            continue
        if text[i] in "({[":
            depth += 1
        elif text[i] in ")}]":
            if depth == 0:
                break
            depth -= 1
        elif text[i] in ",;" and depth == 0:
            break
        i += 1
    return text[offset:i]


def _without_choices(argument):
    """The expression with each (a ? b : c) as a value."""
    before = None
    while before != argument:
        before = argument
        argument = re.sub(r'\([^()"]*\)', " v ", argument)
    return re.sub(r"\([^()]*\?[^()]*\)", " v ", argument)


def _message(argument):
    """The words of an expression that joins literals and values; a value is an ellipsis."""
    argument = _without_choices(argument)
    words, end = [], 0
    for literal in _LITERAL.finditer(argument):
        if re.search(r"[\w)]", argument[end:literal.start()]):
            words.append("…")
        words.append(literal[1].replace('\\"', '"'))
        end = literal.end()
    if words and re.search(r"[\w)]", argument[end:]):
        words.append("…")
    text = re.sub(r"…(?:\s*…)+", "…", "".join(words))
    return text if len(re.findall(r"[a-z]{2,}", text)) >= 3 and "?" not in argument else ""


class Use:
    """A place in the source where a code is reported. Model lint only warns."""

    def __init__(self, file, text, literal):
        opening = _opening(text, literal.start())
        self.warns = "lint" in file or bool(_WARNS.search(text[:opening].rstrip())) or \
            "Severity::warning" in text[opening:literal.start()]
        self.message, end = "", literal.end()
        while not self.message and _COMMA.match(text, end):
            start = _COMMA.match(text, end).end()
            argument = _argument(text, start)
            self.message, end = _message(argument), start + len(argument)
        if not self.message:  # one that is put together later, in the same function
            later = _LATER.search(text, end, max(end, text.find("\n}\n", end)))
            self.message = _message(_argument(text, later.end())) if later else ""


class PrintedUse:
    """A code within the text of a whole diagnostic."""

    def __init__(self, severity, message):
        self.warns = severity == "warning"
        self.message = message


def uses(root):
    """code -> its uses."""
    found = {}
    for folder in FOLDERS:
        for base, _, names in os.walk(os.path.join(root, folder)):
            for name in sorted(names):
                if name.endswith((".h", ".cpp")):
                    with open(os.path.join(base, name), encoding="utf-8") as file:
                        text = without_comments(file.read())
                    for literal in _LITERAL.finditer(text):
                        word = literal[1]
                        printed = _PRINTED.search(word)
                        if printed:
                            found.setdefault(printed[2], []).append(PrintedUse(printed[1], printed[3]))
                        if _COMPARED.search(text[max(0, literal.start() - 80):literal.start()]):
                            continue
                        if word in PLAIN_CODES or _CODE.fullmatch(word) and word not in NOT_CODES | FAILURES:
                            found.setdefault(word, []).append(Use(os.path.join(base, name), text, literal))
    return found


def rows(root):
    """(code, severity, messages) of each."""
    found = []
    for code, places in sorted(uses(root).items()):
        severities = sorted({"warning" if place.warns else "error" for place in places})
        messages = list(dict.fromkeys(place.message for place in places if place.message))
        shown = [_in_cell(message) for message in messages[:_MOST_MESSAGES]]
        if len(messages) > _MOST_MESSAGES:
            shown.append("and others")
        found.append(("`%s`{ #%s }" % (code, code), ", ".join(severities), "<br>".join(shown) or "…"))
    return found


def _in_cell(text):
    for plain, escaped in (("&", "&amp;"), ("<", "&lt;"), ("|", "\\|"), ("*", "\\*"), ("_", "\\_"), ("`", "\\`"), ("{", "&#123;")):
        text = text.replace(plain, escaped)
    return text


def failures(walk_schema):
    """The codes that `status: {failures: …}` of a walk may name."""
    forms = walk_schema["definitions"].get("failure_code") or _enum_of_failures(walk_schema)
    return forms["enum"] + sorted(FAILURES)


def _enum_of_failures(schema):
    """The enumeration that has `unreachable`, wherever the schema defines it."""
    pending = [schema]
    while pending:
        each = pending.pop()
        if isinstance(each, dict):
            if "unreachable" in each.get("enum", []):
                return each
            pending += each.values()
        elif isinstance(each, list):
            pending += each
    raise SystemExit("docs: walk.schema.json names no codes of failures")
