"""Links to what is in the repository only, if the program knows where it is published."""

import os
import re

_FENCE = re.compile(r"^```.*?^```", re.MULTILINE | re.DOTALL)
# A path in a code span that isn't a link's words yet.
_PATH = re.compile(r"(?<![\[`])`([A-Za-z][\w.-]*(?:/[\w.-]+)*/?)`(?!\]|`)")


def address(sources):
    """Where files of the program's commit are shown, with a slash at the end; none if the program doesn't know."""
    used = re.search(r"uses: ([^/\s]+/[^/\s@]+)@([0-9a-f]{40})(?= # v)", _own_steps(sources.initial(".github/workflows/walks.yml")))
    return "https://github.com/%s/blob/%s/" % used.groups() if used else None


def _own_steps(workflow):
    """Without the actions of others."""
    return re.sub(r"uses: actions/.*", "", workflow)


def with_links(text, where, root):
    """The page with links to the files and folders of the checkout that it names in code spans."""
    if not where:
        return text

    def link(match):
        path = match[1]
        there = "/" in path or path.endswith(".md")
        return "[`%s`](%s%s)" % (path, where, path) if there and os.path.exists(os.path.join(root, path)) else match[0]

    pieces, end = [], 0
    for fence in _FENCE.finditer(text):
        pieces += [_PATH.sub(link, text[end:fence.start()]), fence[0]]
        end = fence.end()
    return "".join(pieces) + _PATH.sub(link, text[end:])
