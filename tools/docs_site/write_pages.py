#!/usr/bin/env python3
"""Writes what mkdocs builds: copies docs/, fills in what has its source elsewhere, and copies mkdocs.yml and its hook beside it.

In a page, a line

    <!-- generated: NAME ARGUMENTS -->

is replaced by what `generators.py` makes of it: so a key, an event, an option or a code is described only where it is
defined. Files of the repository are linked to where it is published, if the program knows that (`repository.py`). `<!-- test: ... -->`, which tests/docs/snippets_test.py reads, is left out, and so is a paragraph after `<!-- in the repository -->`.
"""

import argparse
import os
import re
import shutil
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))

from docs_site import repository  # noqa: E402  (the path first)
from docs_site.generators import GENERATORS, Sources  # noqa: E402

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
GENERATED = re.compile(r"^<!-- generated: (.+?) -->$", re.MULTILINE)
FOR_OTHERS = re.compile(r"^<!-- test: .*? -->\n|^<!-- in the repository -->\n.*?\n\n", re.MULTILINE | re.DOTALL)
PICTURES = "campus_assets/pictures"  # which README shows, too
TO_PICTURES = re.compile(r"(?<=\]\()(?:\.\./)+%s(?=/)" % PICTURES)


def with_generated(text, sources, to_images):
    """The page, complete; `to_images` leads from its folder to that of the pictures."""

    def fill(match):
        name, *arguments = match[1].split(" ", 1)
        made = GENERATORS[name](sources, *arguments)
        if not made.strip():
            raise SystemExit("docs: nothing is made of <!-- generated: %s -->" % match[1])
        return made

    return FOR_OTHERS.sub("", GENERATED.sub(fill, TO_PICTURES.sub(to_images, text)))


def main():
    """Writes the folder and returns the exit code."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="the campuswalk whose help is shown")
    parser.add_argument("out", help="a folder, such as build/docs")
    options = parser.parse_args()
    sources = Sources(ROOT, os.path.abspath(options.program))
    where = repository.address(sources)
    pages = os.path.join(options.out, "pages")
    shutil.rmtree(pages, ignore_errors=True)
    shutil.copytree(os.path.join(ROOT, "docs"), pages)
    images = os.path.join(pages, "images")
    shutil.copytree(os.path.join(ROOT, PICTURES), images, dirs_exist_ok=True)
    for base, _, names in os.walk(pages):
        for name in sorted(names):
            if name.endswith(".md"):
                path = os.path.join(base, name)
                with open(path, encoding="utf-8") as file:
                    text = file.read()
                with open(path, "w", encoding="utf-8") as file:
                    page = with_generated(text, sources, os.path.relpath(images, base))
                    file.write(repository.with_links(page, where, ROOT))
    for name in ("mkdocs.yml", "session_prompts.py"):
        shutil.copy(os.path.join(ROOT, "tools", "docs_site", name), options.out)
    return 0


if __name__ == "__main__":
    sys.exit(main())
