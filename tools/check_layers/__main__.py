"""Usage: tools/check-layers [--root FOLDER]

Prints `file:line:col: error CODE: message` for every violation and exits 1 if there is one.
"""

import argparse
import os
import sys

from .include_rules import check_cycles, check_includes, check_pragma_once
from .same_bits_rules import check_compiler_flags, check_libm
from .source import Tree

RULES = (check_includes, check_pragma_once, check_cycles, check_libm, check_compiler_flags)


def main():
    """Checks a tree and returns the exit code."""
    parser = argparse.ArgumentParser(prog="check-layers", description=sys.modules[__name__].__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--root", default=os.path.join(os.path.dirname(__file__), "..", ".."),
                        help="the checkout to check (default: this one)")
    tree = Tree(parser.parse_args().root)
    diagnostics = sorted(diagnostic for rule in RULES for diagnostic in rule(tree))
    for diagnostic in diagnostics:
        print("%s:%d:%d: error %s: %s" % diagnostic)
    print("layers: %d C++ files, %d build files, %s" % (
        len(tree.cpp), len(tree.build), "%d wrong" % len(diagnostics) if diagnostics else "all in order"))
    return 1 if diagnostics else 0


if __name__ == "__main__":
    sys.exit(main())
