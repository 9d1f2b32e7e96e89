"""Sections of documents that are kept beside the code."""

import os
import re

_LINK = re.compile(r"\[([^\]]+)\]\((?![a-z]+:|#)([^)]+)\)")
_TOP_KEY = re.compile(r"^\| `(\w+)` \|", re.MULTILINE)


def section(text, folder, heading):
    """The text below a heading of level 2, with its headings one level higher; links to files are their paths."""
    found = re.search(r"^## %s\n(.*?)(?=^## |\Z)" % re.escape(heading), text, re.MULTILINE | re.DOTALL)
    if found is None:
        raise SystemExit("docs: there is no section '%s'" % heading)
    body = re.sub(r"^###", "##", found[1].strip(), flags=re.MULTILINE)
    body = re.sub(r"<!-- (?:keys: \S+|end of keys) -->\n?", "", body)
    body = _LINK.sub(lambda link: "`%s`" % os.path.normpath(os.path.join(folder, link[2])), body)
    seen = {}

    def anchored(match):
        seen[match[1]] = seen.get(match[1], 0) + 1
        number = "" if seen[match[1]] == 1 else "-%d" % seen[match[1]]
        return "| `%s`{ #key-%s%s } |" % (match[1], match[1], number)

    return _TOP_KEY.sub(anchored, body)
