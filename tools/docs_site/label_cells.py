#!/usr/bin/env python3
"""Writes each column's head into its cells, as data-label, for style.css to show on a phone, where a row is a paragraph.

`label_cells.py SITE`. Of tables of two columns only those of pictures need it: their heads are captions.
"""

import os
import re
import sys

TABLE = re.compile(r"<table>.*?</table>", re.DOTALL)
HEAD = re.compile(r"<th[^>]*>(.*?)</th>", re.DOTALL)
ROW = re.compile(r"<tr>.*?</tr>", re.DOTALL)
CELL = re.compile(r"<td(?=[ >])")
TAG = re.compile(r"<[^>]+>")


def labelled(table):
    """The table with labels in its cells."""
    heads = [TAG.sub("", head).strip().replace('"', "&quot;") for head in HEAD.findall(table)]
    if len(heads) < 3 and "<img" not in table:
        return table
    first = 0 if "<img" in table else 1

    def row(match):
        column = iter(range(len(heads)))

        def cell(_):
            i = next(column)
            return '<td data-label="%s"' % heads[i] if i >= first and heads[i] else "<td"
        return CELL.sub(cell, match[0])
    return ROW.sub(row, table)


def main():
    """Rewrites the pages of the site."""
    for base, _, names in os.walk(sys.argv[1]):
        for name in names:
            if name.endswith(".html"):
                path = os.path.join(base, name)
                with open(path, encoding="utf-8") as file:
                    text = file.read()
                with open(path, "w", encoding="utf-8") as file:
                    file.write(TABLE.sub(lambda match: labelled(match[0]), text))


if __name__ == "__main__":
    main()
