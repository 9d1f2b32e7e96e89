#!/usr/bin/env python3
"""Marks names with hyphens in running text, as class `word`, for style.css to keep them on one line: a browser may break after a
hyphen, and `--last-failed` is one name.

`keep_words.py SITE`. A name longer than a phone's line may break.
"""

import os
import re
import sys

BLOCK = re.compile(r"<pre.*?</pre>", re.DOTALL)
CODE = re.compile(r"(<code>)([^<]*)(</code>)")
NAME = re.compile(r"[^\s<>]*-[^\s<>]*")
LONGEST = 30


def kept(text):
    """The page, with marks outside of its blocks of code."""
    def mark(name):
        return '<span class="word">%s</span>' % name[0] if len(name[0]) <= LONGEST else name[0]

    def marked(part):
        return CODE.sub(lambda code: code[1] + NAME.sub(mark, code[2]) + code[3], part)
    pieces, end = [], 0
    for block in BLOCK.finditer(text):
        pieces += [marked(text[end:block.start()]), block[0]]
        end = block.end()
    return "".join(pieces) + marked(text[end:])


def main():
    """Rewrites the pages of the site."""
    for base, _, names in os.walk(sys.argv[1]):
        for name in names:
            if name.endswith(".html"):
                path = os.path.join(base, name)
                with open(path, encoding="utf-8") as file:
                    text = file.read()
                with open(path, "w", encoding="utf-8") as file:
                    file.write(kept(text))


if __name__ == "__main__":
    main()
