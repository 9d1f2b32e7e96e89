"""Tables of commands, options, exit codes and reporters, from what the program prints with --help."""

import re

_COLUMN = 30  # where help describes an option
_RANGE = re.compile(r":(?:INT|FLOAT) in \[(\S+) - (\S+?)\]")
_DEFAULT = re.compile(r"(?<=\S)=(\S+)$")
_WORDS = re.compile(r"(?: |=)\[?=?((?:[a-z0-9_-]+\|)+[a-z0-9_-]+)\]?( \.\.\.)?$")
_VARIABLE = re.compile(r" \(Env:(\w+)\)")
_EXCLUDES = re.compile(r" Excludes: (\S+)")


def in_markdown(text):
    """Plain text, as a table's cell."""
    pieces = re.split(r"(?<![\w`'])'([^'|]+)'(?![\w'])", text)  # every other one was quoted
    plain = [re.sub(r"([|*_<])", r"\\\1", piece) for piece in pieces[::2]]
    return "".join(a + b for a, b in zip(plain, ["`%s`" % piece for piece in pieces[1::2]] + [""]))


def subcommands(text):
    """(name, summary) of each, from `campuswalk --help`."""
    return re.findall(r"^  ([a-z-]+) {2,}(\S.*)$", text.partition("Subcommands:\n")[2], re.MULTILINE)


def parts(text):
    """Of a command's help: its summary, usage, positionals, options and the text after them."""
    summary, _, rest = text.partition("\nUsage: ")
    usage, _, rest = rest.partition("\n")
    blocks = {"Positionals": [], "Options": []}
    notes, block, lines = [], None, rest.splitlines()
    for i, line in enumerate(lines):
        if line.endswith(":") and line[:-1] in blocks:
            block = blocks[line[:-1]]
        elif block is not None and re.match(r"  \S", line):
            is_alone = i + 1 < len(lines) and lines[i + 1].startswith(" " * _COLUMN)
            block.append((line.strip(), "") if is_alone else (line[:_COLUMN].strip(), line[_COLUMN:].strip()))
        elif block and line.startswith(" " * _COLUMN):
            block[-1] = (block[-1][0], (block[-1][1] + " " + line.strip()).strip())
        elif line.strip() or notes:
            block = None
            notes.append(line)
    return summary.strip(), usage, blocks["Positionals"], blocks["Options"], "\n".join(notes).strip()


def _row(spec, text):
    """An option, and what it means, with its limits and its default."""
    more = []
    for pattern, words in ((_RANGE, "%s to %s"), (_VARIABLE, "also the variable `%s`"), (_EXCLUDES, "not with `%s`")):
        match = pattern.search(spec)
        if match:
            more.append(words % match.groups())
            spec = spec[:match.start()] + spec[match.end():]
    match = _WORDS.search(spec)
    if match:
        more.append(", ".join("`%s`" % word for word in match[1].split("|")))
        spec = spec[:match.start()] + (match[2] or "")
    match = _DEFAULT.search(spec)
    if match and not spec.endswith(("[=FILE]", "]")):
        more.append("default `%s`" % match[1])
        spec = spec[:match.start()]
    meaning = in_markdown(text) + (" (%s)" % "; ".join(more) if more else "")
    return "`%s`" % spec.replace(",--", ", --").replace("|", "\\|"), meaning.strip()


def _positional(spec):
    """An argument's name, `...` if there may be several, and its values if they are listed."""
    name, *types = re.sub(r"=\S+$", "", spec).split()
    words = [name] + ["..."] * ("..." in types) + [word for word in types if "|" in word]
    return " ".join(words) + "".join(re.findall(r"=\S+$", spec))


def _table(head, entries):
    rows = ["| %s | %s |" % _row(spec, text) for spec, text in entries]
    return "\n".join(["| %s | |" % head, "|---|---|", *rows]) + "\n"


def reference(output):
    """A section for each command. `output(*arguments)` is what the program prints."""
    pages = []
    for name, summary in subcommands(output("--help")):
        _, usage, positionals, options, notes = parts(output(name, "--help"))
        pages.append("## %s\n\n%s.\n\n```text\n%s\n```\n" % (name, summary.rstrip("."), usage))
        if positionals:
            pages.append(_table("argument", [(_positional(spec), text) for spec, text in positionals]))
        own = [each for each in options if each[0] not in ("-h,--help", "--version")]
        if own:
            pages.append(_table("option", own))
        if notes:
            pages.append("```text\n%s\n```\n" % notes)
    return "\n".join(pages)


def exit_codes(text):
    """(code, meaning) of `campuswalk help exit-codes`; lines that go on are indented."""
    rows = []
    for line in text.splitlines():
        match = re.match(r"(\d+) +(\S.*)", line)
        if match:
            rows.append([match[1], match[2]])
        elif line.strip() and rows:
            rows[-1][1] += " " + line.strip()
    return [(code, in_markdown(meaning)) for code, meaning in rows]


def named_lines(text):
    """(name, text) of the first block of lines that begin with a name."""
    block = re.search(r"(?:^  [a-z]+ {2,}\S.*\n)+", text, re.MULTILINE)[0]
    return re.findall(r"^  ([a-z]+) {2,}(\S.*)$", block, re.MULTILINE)
