#!/usr/bin/env python3
"""Damaged and forged binary files by the thousand: those of the cache, and responses of the import helper.

`fuzz_binary.py PROGRAM CORRECT_CHECKSUMS READ_RESPONSES [--mutants N] [--targets cache,responses] [--workers N]`: N
mutants of each. Half of them get a correct checksum, and most keep their size. A cache file with a wrong one must
change nothing: the walk's log is that of a run without a cache. A forged file may be accepted where it makes sense; it
must never crash, hang or exhaust the memory.
"""

import argparse
import concurrent.futures
import glob
import os
import shutil
import subprocess
import sys
import tempfile
import time

from mutants import mutant, same_size_mutant

SECONDS = 60
MEMORY = 4 << 20  # KiB of address space
BATCH = 25
TGA = bytes([0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 2, 0, 32, 0]) + bytes(range(16))


def run(command, cwd, limited, **environment):
    """Returns the exit code (or what went wrong), standard output and error."""
    if limited:
        command = ["/bin/sh", "-c", "ulimit -v %d; exec \"$@\"" % MEMORY, "sh", *command]
    try:
        done = subprocess.run(command, cwd=cwd, env={**os.environ, **environment}, stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=SECONDS, check=False)
        return done.returncode, done.stdout, done.stderr.decode("utf-8", "replace")
    except subprocess.TimeoutExpired:
        return "none after %d s" % SECONDS, b"", ""


class School:
    """A small campus to walk in, and the cache of it."""

    def __init__(self, program, folder, limited):
        self.program, self.limited = program, limited
        self.folder = os.path.join(folder, "school")
        code, _, errors = run([program, "init", self.folder], folder, False)
        if code != 0:
            sys.exit("init: " + errors)
        with open(os.path.join(self.folder, "school.mtl"), "a", encoding="utf-8") as materials:
            materials.write("map_Kd small.tga\n")
        with open(os.path.join(self.folder, "small.tga"), "wb") as image:
            image.write(TGA)
        self.cache = os.path.join(folder, "intact-cache")
        self.log = self.walk(None, "--no-cache")[1]
        self.walk(self.cache)
        self.files = sorted(name for name in glob.glob(os.path.join(self.cache, "*.campuswalk")) if ".stamp." not in name)
        if len(self.files) != 3 or self.walk(self.cache)[1] != self.log:
            sys.exit("the cache of the school isn't complete")

    def walk(self, cache, *options):
        """Each cache has an output of its own, as walks go on at once: where CI is set, another's files are refused."""
        cache = cache or os.path.join(self.folder, "none")
        return run([self.program, "run", "walks/visit.walk.yaml", "--output", cache + "-out", *options], self.folder,
                   self.limited, CAMPUSWALK_CACHE_DIR=cache)


def write_mutants(folder, count, correct_checksums, files, label):
    """Mutants of the files in turn, as (path, is_forged, is_unchanged); every second one gets a correct checksum."""
    made = []
    for i in range(count):
        with open(files[i // 2 % len(files)], "rb") as whole:
            data = whole.read()
        is_forged = i % 2 == 1
        # A changed header is detected by itself; what the checksum protects needs the forger.
        change = mutant if i % 8 < 2 else same_size_mutant
        changed = (data[:64] if is_forged else b"") + change("%s %d" % (label, i), data[64 if is_forged else 0:])
        place = os.path.join(folder, "m%d" % i)
        os.mkdir(place)
        path = os.path.join(place, os.path.basename(files[i // 2 % len(files)]))
        with open(path, "wb") as file:
            file.write(changed)
        made.append((path, is_forged, changed == data))
    forged = [path for path, is_forged, _ in made if is_forged]
    for at in range(0, len(forged), 500):
        subprocess.run([correct_checksums, *forged[at:at + 500]], check=True)
    return made


def fuzz_cache(options, folder, school):
    mutants = write_mutants(folder, options.mutants, options.correct_checksums, school.files, "cache")

    def check(made):
        path, is_forged, _ = made
        place = os.path.dirname(path)
        for whole in school.files:
            if os.path.basename(whole) != os.path.basename(path):
                shutil.copy(whole, place)
        start = time.monotonic()
        code, log, errors = school.walk(place)
        took = time.monotonic() - start
        shutil.rmtree(place) if code in (0, 1, 2) else None
        if code not in (0, 1, 2) or (not is_forged and (code, log) != (0, school.log)):
            return "%s%s: exit code %s: %s" % (path, " (forged)" if is_forged else "", code, errors[:300]), took, False
        return None, took, log == school.log

    with concurrent.futures.ThreadPoolExecutor(options.workers) as pool:
        outcomes = list(pool.map(check, mutants))
    print("cache     %5d mutants: %5d walked the same, %4d forged ones another way; slowest %.1f s"
          % (len(mutants), sum(same for _, _, same in outcomes), sum(not same for _, _, same in outcomes),
             max(took for _, took, _ in outcomes)), flush=True)
    return [failure for failure, _, _ in outcomes if failure]


def fuzz_responses(options, folder, school):
    models = [file for file in school.files if ".model." in file]
    mutants = write_mutants(folder, options.mutants, options.correct_checksums, models, "responses")
    paths = [path for path, _, _ in mutants]

    def check(batch):
        code, output, errors = run([options.read_responses, *batch], folder, options.limited)
        lines = output.decode("utf-8", "replace").splitlines()
        if code != 0 or len(lines) != len(batch):
            return "%s: %s: %s" % (batch[min(len(lines), len(batch) - 1)], code, errors[:600]), lines
        return None, lines

    batches = [paths[at:at + BATCH] for at in range(0, len(paths), BATCH)]
    with concurrent.futures.ThreadPoolExecutor(options.workers) as pool:
        outcomes = list(pool.map(check, batches))
    lines = [line for _, output in outcomes for line in output]
    print("responses %5d mutants: %5d accepted, %5d refused"
          % (len(mutants), sum(line.startswith("accepted") for line in lines),
             sum(line.startswith("refused") for line in lines)), flush=True)
    damaged = [line for (_, is_forged, same), line in zip(mutants, lines) if not is_forged and not same]
    accepted = [line for line in damaged if not line.startswith("refused")]
    failures = [failure for failure, _ in outcomes if failure]
    return failures + (["%d damaged responses were accepted" % len(accepted)] if accepted and not failures else [])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=os.path.abspath)
    parser.add_argument("correct_checksums", type=os.path.abspath)
    parser.add_argument("read_responses", type=os.path.abspath)
    parser.add_argument("--mutants", type=int, default=1500)
    parser.add_argument("--targets", default="cache,responses")
    parser.add_argument("--workers", type=int, default=os.cpu_count())
    parser.add_argument("--no-limit", dest="limited", action="store_false", help="of memory: for sanitizers")
    options = parser.parse_args()
    failures = []
    with tempfile.TemporaryDirectory(prefix="campuswalk-fuzz-") as folder:
        school = School(options.program, folder, options.limited)
        for name in options.targets.split(","):
            place = os.path.join(folder, name)
            os.mkdir(place)
            failures += {"cache": fuzz_cache, "responses": fuzz_responses}[name](options, place, school)
    for failure in failures:
        print("  FAILED " + failure, flush=True)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
