"""A hook of mkdocs: of sessions, only lines after `$` are commands. Pygments takes output that begins with # for commands of root,
and the button that copies commands would copy it.
"""

import re

from pygments.lexers.shell import BashSessionLexer

BashSessionLexer._ps1rgx = re.compile(r"^(\$ )(.*\n?)")  # pylint: disable=protected-access
