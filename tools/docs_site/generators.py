"""What `<!-- generated: NAME ARGUMENTS -->` in a page stands for."""

import json
import os
import re
import subprocess
import tempfile

from . import command_lines, diagnostic_codes, event_tables, json_tables, sections


class Sources:
    """A checkout, and the program that was built from it."""

    def __init__(self, root, program):
        self.root = root
        self.program = program

    def text(self, *path):
        with open(os.path.join(self.root, *path), encoding="utf-8") as file:
            return file.read()

    def schema(self, name):
        return json.loads(self.text("config", "schema", name))

    def initial(self, file, *options):
        """A file that `campuswalk init` writes, with these options."""
        with tempfile.TemporaryDirectory(prefix="campuswalk-docs-") as folder:
            subprocess.run([self.program, "init", *options, folder], check=True, capture_output=True)
            with open(os.path.join(folder, file), encoding="utf-8") as opened:
                return opened.read()

    def output(self, *arguments):
        """What the program prints."""
        return subprocess.run([self.program, *arguments], check=True, capture_output=True, text=True).stdout


def table(head, rows):
    """A Markdown table of cells."""
    lines = ["| %s |" % " | ".join(head), "|%s" % ("---|" * len(head))]
    return "\n".join(lines + ["| %s |" % " | ".join(row) for row in rows])


def exit_codes(sources):
    return table(("exit code", "means"), command_lines.exit_codes(sources.output("help", "exit-codes")))


def reporters(sources):
    rows = command_lines.named_lines(sources.output("help", "reports"))
    return table(("reporter", "writes"), [("`%s`" % name, command_lines.in_markdown(text)) for name, text in rows])


def commands(sources):
    return command_lines.reference(sources.output)


def events(sources):
    return table(("event", "object", "fields", "when"), event_tables.events(sources))


def event_fields(sources):
    return table(("field", "value", "meaning"), event_tables.fields(sources))


def error_codes(_):
    return table(("code", "is", "means"), diagnostic_codes.rows())


def failure_codes(_):
    return table(("code", "means"), diagnostic_codes.failures())


def expectation_codes(sources):
    codes = diagnostic_codes.expectations(sources.schema("walk.schema.json"))
    return ", ".join("`%s`" % code for code in codes)


def downloads(sources):
    """Where the packages are, if the program knows where it is published."""
    address = re.search(r'CAMPUSWALK: "(https://github\.com/[^/]+/[^/]+/releases)/', sources.initial(".gitlab-ci.yml", "--ci", "gitlab"))
    if address:
        return "The packages are at <%s>." % address[1]
    return ("The program that this page was made with doesn't know where it is published (CMake's `CAMPUSWALK_REPOSITORY` is empty), so "
            "there is no address here: take the packages from where you got this page, or [build them](#build-the-packages).")


def section(sources, argument):
    file, heading = argument.split(" ", 1)
    return sections.section(sources.text(file), os.path.dirname(file), heading)


def opening(sources, file):
    """What a document says between its title and its first table or section."""
    return re.search(r"\A# [^\n]*\n+(.*?)\n+(?=\||## )", sources.text(file), re.DOTALL)[1]


def json_keys(sources, argument):
    file, _, pointer = argument.partition("#")
    schemas = {name: sources.schema(name) for name in os.listdir(os.path.join(sources.root, "config", "schema"))}
    return table(("key", "value", "meaning"), json_tables.rows(schemas, file, pointer))


def initial_file(sources, argument):
    language, file, *options = argument.split(" ")
    return "```%s\n%s```" % (language, sources.initial(file, *options))


GENERATORS = {
    "commands": commands,
    "downloads": downloads,
    "error-codes": error_codes,
    "event-fields": event_fields,
    "events": events,
    "exit-codes": exit_codes,
    "expectation-codes": expectation_codes,
    "failure-codes": failure_codes,
    "initial-file": initial_file,
    "json": json_keys,
    "opening": opening,
    "reporters": reporters,
    "section": section,
}
