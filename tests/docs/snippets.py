"""The snippets of a Markdown document, and how they are run. Needs only Python's standard library and yaml.

    ```console      commands after `$ `, each followed by what it prints; `…` stands for any text, a line of it for any lines;
                    `\\` at a line's end continues a command. A command fails unless `$ echo $?` follows and prints its code
    ```sh           commands that must succeed, whatever they print
    ```yaml         a file, if the first line is `# NAME`: it is written, and validated where campuswalk can; otherwise keys
                    that replace those of the page's base file, which must validate then
    ```cpp          a program, which is compiled
    ```json         lines of JSON, which are parsed
    ```text         not run; `ini`, `cmake` and `groovy` neither

A comment `<!-- test: … -->` before a snippet, or anywhere on its own, says more:

    setup COMMANDS        run silently, there
    base FILE             what fragments of YAML are part of
    same FILE             the YAML is what that file says, comments aside
    picture FILE          the next picture of the page is this one, which the commands have made
    excerpt FILE          the text is from this file of the checkout, with ellipses
    skip REASON           the next snippet isn't run; its reason is printed
"""

import os
import re
from collections import namedtuple

Snippet = namedtuple("Snippet", "line language text directives")
Directive = namedtuple("Directive", "line kind argument")
Picture = namedtuple("Picture", "line target expected")

_ANY = re.compile(
    r"^<!-- test: (?P<kind>\w+) ?(?P<argument>.*?) ?-->$|^```(?P<language>\w*)[^\n]*\n(?P<text>.*?)^```$"
    r"|^!\[[^\]]*\]\((?P<target>[^)]+)\)", re.MULTILINE | re.DOTALL)


def read(text):
    """The setups, snippets and pictures that are compared, in the page's order."""
    found, waiting = [], []
    for match in _ANY.finditer(text):
        line = text.count("\n", 0, match.start()) + 1
        if match["kind"] == "setup":
            found.append(Directive(line, "setup", match["argument"]))
        elif match["kind"] == "base":
            found.append(Directive(line, "base", match["argument"]))
        elif match["kind"]:
            waiting.append(Directive(line, match["kind"], match["argument"]))
        elif match["target"]:
            pictures = [each for each in waiting if each.kind == "picture"]
            waiting = [each for each in waiting if each.kind != "picture"]
            found += [Picture(line, match["target"], each.argument) for each in pictures]
        else:
            found.append(Snippet(line, match["language"], match["text"], waiting))
            waiting = []
    if waiting:
        raise ValueError("line %d: nothing follows <!-- test: %s -->" % (waiting[0].line, waiting[0].kind))
    return found


def commands(text):
    """(command, expected lines) of a console snippet."""
    found = []
    for line in text.splitlines():
        if found and found[-1][0].endswith("\\\n"):
            found[-1][0] += line.removeprefix("> ") + ("\n" if line.endswith("\\") else "")
        elif line.startswith("$ "):
            found.append([line[2:] + ("\n" if line.endswith("\\") else ""), []])
        elif found:
            found[-1][1].append(line)
        else:
            raise ValueError("a console snippet begins with `$ `")
    return found


def _pattern(line):
    return ".*".join(re.escape(part) for part in line.split("…")) if "…" in line else re.escape(line)


def matches(printed, expected):
    """Whether the lines are as expected, with ellipses."""
    pattern = "".join(r"(?:.*\n)*?" if line.strip() == "…" else _pattern(line.rstrip()) + r"[ \t]*\n" for line in expected)
    return re.fullmatch(pattern, printed.rstrip("\n") + "\n" if printed.strip() else "") is not None


def named_file(text):
    """The name in the first line of a YAML snippet, if it has one."""
    match = re.match(r"# ([\w./-]+\.(?:yaml|yml))\n", text)
    return match[1] if match else None


def pages(root):
    """The documents whose snippets are run."""
    found = ["README.md"]
    for base, _, names in os.walk(os.path.join(root, "docs")):
        found += [os.path.relpath(os.path.join(base, name), root) for name in names if name.endswith(".md")]
    return sorted(found)
