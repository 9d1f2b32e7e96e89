#!/usr/bin/env python3
"""Damaged models by the thousand: each loads or is refused with a message, in bounded time, without a crash.

`fuzz_models.py PROGRAM [--mutants N] [--first I] [--formats glb,obj] [--packed FOLDER] [--workers N]`: N mutants of each
format through the commands that read models in turn (COMMANDS). FOLDER has further intact files to start from, as written
by write_packed_models. A mutant follows from its format and number alone: to try new ones, begin at I behind earlier runs.
A crash of the import helper is reported in a message: it is counted, but no failure. Nothing may appear beside the
folder with the models, and nothing that a terminal would obey on standard error.
"""

import argparse
import concurrent.futures
import glob
import os
import re
import subprocess
import sys
import tempfile
import time

from mutants import glb_mutant, mutant
from seed_models import COMPANIONS, seeds

SECONDS = 160  # the helper's 20 s of CPU, and the time it may wait; see ImportLimits

STOPPED = "stopped: it took more than"  # a walk, by --kill-after

# Control characters, changes of direction, commands to CI machines.
OBEYED = re.compile("[\x00-\x09\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069]|^(::|##)|##vso\\[", re.MULTILINE)

# MODEL is the mutant, NAME its name without the extension.
COMMANDS = [["info", "--json", "MODEL"], ["run", "NAME.walk.yaml", "--quiet", "--rendering-backend", "none", "--kill-after", "60"],
            ["collide", "--count", "MODEL", "sphere:1"], ["info", "MODEL", "--suggest", "NAME-new.campus.yaml"],
            ["info", "MODEL", "--map", "NAME.png"]]
CAMPUS = """scenes: [{file: MODEL}]
colliders:
  - {id: solid, nodes: '*', shape: mesh, mode: [solid, ray]}
  - {id: each, nodes: '*', each: true, shape: box, mode: trigger}
spawns: {start: {at: [0.5, 2, 0.5]}}
places: {end: [3, 0, 3]}
"""
WALK = """campus: NAME.campus.yaml
timeout: 5
steps: [{spawn: start}, {walk_to: end}, {jump: {}}, {wait: 1}]
expect: [{never: avatar.stuck}]
"""


class Tally:
    def __init__(self):
        self.loaded = self.refused = self.crashed = 0
        self.slowest = 0.0
        self.failures = []

    def add(self, name, code, errors, seconds):
        self.slowest = max(self.slowest, seconds)
        reported = [line for line in errors.splitlines() if re.search(r": error [a-z-]+: ", line)]
        if OBEYED.search(errors):
            self.failures.append("%s: on standard error: %r" % (name, errors[:300]))
        elif code in (0, 1):  # a walk may fail, bodies may overlap
            self.loaded += 1
        elif (code == 2 and reported) or (code == 3 and STOPPED in errors):
            self.refused += 1
            self.crashed += "crashed (signal" in errors
        else:
            self.failures.append("%s: exit code %s: %s" % (name, code, errors[:300]))


def starting_points(formats, packed):
    """Per format, the extensions and bytes of the intact files."""
    points = {name: [(os.path.splitext(file)[1], data) for file, data in files.items()]
              for name, files in seeds().items()}
    for file in sorted(os.listdir(packed)) if packed else []:
        with open(os.path.join(packed, file), "rb") as whole:
            points[os.path.splitext(file)[0]] = [(os.path.splitext(file)[1], whole.read())]
    return {name: points[name] for name in formats or points}


def one(program, folder, name, extension, data, command):
    """Returns the model's name, the exit code, what was said and how long it took."""
    def filled(text):
        return text.replace("MODEL", name + extension).replace("NAME", name)

    for ending, text in ((extension, data), (".campus.yaml", filled(CAMPUS).encode()), (".walk.yaml", filled(WALK).encode())):
        with open(os.path.join(folder, name + ending), "wb") as file:
            file.write(text)
    start = time.monotonic()
    try:
        done = subprocess.run([program, *map(filled, command), "--no-cache"], cwd=folder, stdin=subprocess.DEVNULL,
                              stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, timeout=SECONDS, check=False,
                              env={**os.environ, "HOME": os.path.dirname(folder), "TMPDIR": os.path.dirname(folder),
                                   "CAMPUSWALK_RUN_KEY": "so that none is made here"})
        result = (done.returncode, done.stderr.decode("utf-8", "replace"))
    except subprocess.TimeoutExpired:
        result = ("none", "still running after %d s" % SECONDS)
    if result[0] in (0, 1, 2) or STOPPED in result[1]:
        for file in glob.glob(os.path.join(folder, name + "[.-]*")):
            os.remove(file)
    return (" ".join([name + extension, *command[:1], *command[2:3]]), *result, time.monotonic() - start)


def fuzz(program, name, points, numbers, workers, keep, draws):
    tally = Tally()
    commands = COMMANDS if draws else COMMANDS[:-1]
    with tempfile.TemporaryDirectory(prefix="campuswalk-fuzz-") as sentinel:
        folder = os.path.join(sentinel, "models")
        os.mkdir(folder)
        for companion, data in COMPANIONS.items():
            with open(os.path.join(folder, companion), "wb") as file:
                file.write(data)
        for extension, data in points:
            whole = one(program, folder, "whole", extension, data, COMMANDS[0])
            if whole[1] != 0:
                tally.failures.append("%s: the intact file doesn't load: %s" % (whole[0], whole[2]))
        with concurrent.futures.ThreadPoolExecutor(workers) as pool:
            def run(i):
                extension, data = points[i % len(points)]
                change = glb_mutant if extension == ".glb" else mutant
                changed = change("%s %d" % (name, i), data)
                command = commands[i // len(points) % len(commands)]  # so that each intact file meets each
                return one(program, folder, "m%d" % i, extension, changed, command)
            for outcome in pool.map(run, numbers):
                tally.add(*outcome)
        if os.listdir(sentinel) != ["models"]:
            tally.failures.append("files appeared beside the models: %s" % os.listdir(sentinel))
        for failure in tally.failures if keep else []:
            file = failure.split(":")[0].split()[0]
            if os.path.exists(os.path.join(folder, file)):
                os.rename(os.path.join(folder, file), os.path.join(keep, name + "-" + file))
    return tally


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--mutants", type=int, default=1500)
    parser.add_argument("--first", type=int, default=0, help="the number of the first mutant of each format")
    parser.add_argument("--formats")
    parser.add_argument("--packed")
    parser.add_argument("--workers", type=int, default=os.cpu_count())
    parser.add_argument("--without-rendering", action="store_true", help="the program can't draw a map")
    parser.add_argument("--keep", help="a folder for the mutants that failed")
    options = parser.parse_args()
    formats = options.formats.split(",") if options.formats else None
    failed = False
    for name, points in starting_points(formats, options.packed).items():
        numbers = range(options.first, options.first + options.mutants)
        tally = fuzz(os.path.abspath(options.program), name, points, numbers, options.workers, options.keep,
                     not options.without_rendering)
        print("%-8s %5d mutants from %d: %5d loaded, %5d refused, %4d of them crashes of the helper; slowest %.1f s"
              % (name, options.mutants, options.first, tally.loaded, tally.refused, tally.crashed, tally.slowest), flush=True)
        for failure in tally.failures:
            print("  FAILED " + failure, flush=True)
        failed = failed or bool(tally.failures)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
