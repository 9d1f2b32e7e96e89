"""Rules about #include lines and headers."""

import re

from .source import Diagnostic, code_only, includes
from .table import (KERNEL_FOLDERS, PROJECT, REFUSED_STANDARD, OPTIONAL_PREFIXES, STRICTER, THIRD_PARTY,
                    THREAD_DOORS, is_in, needs_same_bits, place_of)

_PRAGMA_ONCE = re.compile(r"^[ \t]*#[ \t]*pragma[ \t]+once\b", re.MULTILINE)


def _without_optional_prefix(target):
    for prefix in OPTIONAL_PREFIXES:
        if target.startswith(prefix):
            return target[len(prefix):]
    return target


def _stem(file):
    return file.rpartition(".")[0]


def _project_fault(file, include):
    """What is wrong with including a file of the project: (code, message) or None."""
    if include.quote == "<":
        return "include-path", 'files of the project are included as "%s"' % include.target
    owner = place_of(file, PROJECT)
    if owner is None:
        return "layer", "%s has no place in tools/check_layers/table.py" % file
    allowed, target = [owner] + PROJECT[owner], include.target
    if _stem(file) in STRICTER:
        owner, allowed, target = file, STRICTER[_stem(file)], _stem(include.target)
    if is_in(target, allowed):
        return None
    return "layer", '%s may not include "%s"; it may include %s' % (owner, include.target, ", ".join(allowed))


def _third_party_fault(file, target):
    """What is wrong with including a third-party header: (code, message) or None."""
    prefixes = [prefix for prefix in THIRD_PARTY if target.startswith(prefix)]
    if not prefixes:
        return "third-party", "<%s> has no place in tools/check_layers/table.py" % target
    places = THIRD_PARTY[max(prefixes, key=len)]
    if is_in(file, places):
        return None
    return "third-party", "<%s> may be included in %s only" % (target, ", ".join(places))


def _fault(tree, file, include):
    if include.target in tree.cpp:
        return _project_fault(file, include)
    target = _without_optional_prefix(include.target)
    if any(target.startswith(prefix) for prefix in THIRD_PARTY):
        return _third_party_fault(file, target)
    if include.quote == '"':
        return "include-path", '"%s" isn\'t a file below the repository\'s root' % include.target
    if "/" in target or "." in target:
        return _third_party_fault(file, target)
    is_door = target == "thread" and _stem(file) in THREAD_DOORS
    if target in REFUSED_STANDARD and needs_same_bits(file) and not is_door:
        return "same-bits", "<%s> is not for %s: %s" % (target, place_of(file, PROJECT), REFUSED_STANDARD[target])
    return None


def check_includes(tree):
    """Checks layers, third-party headers, and that paths start at the root."""
    for file, text in tree.cpp.items():
        for include in includes(text):
            fault = _fault(tree, file, include)
            if fault:
                yield Diagnostic(file, include.line, include.column, *fault)


def check_pragma_once(tree):
    """Checks that every header can be included twice, and a kernel's once for each instruction set."""
    for file, text in tree.cpp.items():
        if not file.endswith((".h", ".hpp")):
            continue
        if file.endswith("_inl.h") and is_in(file, KERNEL_FOLDERS):
            if "defined(HWY_TARGET_TOGGLE)" not in text:
                yield Diagnostic(file, 1, 1, "target-toggle", "a kernel's header needs HWY_TARGET_TOGGLE's guard")
        elif not _PRAGMA_ONCE.search(code_only(text)):
            yield Diagnostic(file, 1, 1, "pragma-once", "a header needs #pragma once")


def check_cycles(tree):
    """Checks that no file includes itself indirectly; reports each cycle once, from its first file."""
    graph = {file: [i for i in includes(text) if i.target in tree.cpp] for file, text in tree.cpp.items()}
    done = set()
    for start in sorted(graph):
        if start not in done:
            yield from _cycles_from(start, graph, done)


def _cycles_from(start, graph, done):
    """Depth first without recursion: `path` leads to the current file, `left` holds the includes still to follow."""
    path, left = [start], [list(graph[start])]
    while path:
        if not left[-1]:
            done.add(path.pop())
            left.pop()
            continue
        include = left[-1].pop(0)
        if include.target in path:
            cycle = path[path.index(include.target):] + [include.target]
            yield Diagnostic(path[-1], include.line, include.column, "include-cycle", " -> ".join(cycle))
        elif include.target not in done:
            path.append(include.target)
            left.append(list(graph[include.target]))
