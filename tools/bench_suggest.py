#!/usr/bin/env python3
"""Measures what suggestions for models cost, and exits with 1 if that is more than they may: tools/bench suggest MODEL…

Each model: the processor time of `info --suggest`, import included and nothing cached, beside that of the `assimp` program
reading the same file. At most 10 s, and for more than 500,000 triangles at most as much a triangle. Of several runs the least
counts. A model for which nothing can be suggested is measured, too. Needs only the standard library.
"""

import argparse
import json
import os
import resource
import subprocess
import sys
import tempfile

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
MOST_SECONDS = 10.0
MOST_SECONDS_A_TRIANGLE = MOST_SECONDS / 500_000


def processor_seconds(*command):
    """Returns what the command and its children take; exit codes above 2 and signals are errors of the benchmark."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, check=False, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    if done.returncode not in (0, 1, 2):
        done.check_returncode()
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


def triangles_of(program, model):
    done = subprocess.run([program, "info", model, "--json"], check=True, capture_output=True, text=True)
    return json.loads(done.stdout)["triangles"]


def main():
    """Prints a line for each model, and the verdict."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("models", nargs="+")
    parser.add_argument("--program", default=os.path.join(ROOT, "build", "release", "campuswalk"))
    parser.add_argument("--runs", type=int, default=3)
    options = parser.parse_args()
    good = True
    print("%-40s %10s %10s %10s %8s" % ("model", "triangles", "suggest/s", "assimp/s", "ratio"))
    with tempfile.TemporaryDirectory() as folder:
        campus = os.path.join(folder, "new.campus.yaml")
        for model in options.models:
            triangles = triangles_of(options.program, model)
            suggest = min(processor_seconds(options.program, "info", model, "--no-cache", "--suggest", campus, "--overwrite")
                          for _ in range(options.runs))
            peer = min(processor_seconds("assimp", "info", model) for _ in range(options.runs))
            most = max(MOST_SECONDS, MOST_SECONDS_A_TRIANGLE * triangles)
            good = good and suggest <= most
            print("%-40s %10d %10.2f %10.2f %8.1f%s" % (os.path.basename(model), triangles, suggest, peer, suggest / peer,
                                                       "" if suggest <= most else "  over %.1f s" % most), flush=True)
    print("within the budget" if good else "over the budget")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
