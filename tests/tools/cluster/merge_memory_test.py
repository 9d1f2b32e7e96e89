#!/usr/bin/env python3
"""The merge of an array of 10,000 tasks, whose files are made here: its memory doesn't grow with the number of cases,
and its time grows in proportion.

Usage: merge_memory_test.py PROGRAM [CASES…] (10000 100000 1000000)
"""

import hashlib
import json
import os
import struct
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from program import ProgramCase, main

FILES = 10_000
CASES = [10_000, 100_000, 1_000_000]


def name_of(shard, i):
    return "w%07d" % (shard + i * FILES)


def division(each):
    """The hash of which case is in which shard, as run/plan/plan_hash.h describes it."""
    digest = hashlib.sha256()
    for shard in range(FILES):
        for i in range(each):
            case = (name_of(shard, i) + ".walk.yaml").encode()
            digest.update(struct.pack("<QQ", shard + 1, len(case)) + case)
    return digest.hexdigest()


class Merge(ProgramCase):
    def shards(self, cases):
        """Reports of shards of a run that never was, made from one real result: as balanced shards, each has
        cases of all parts of the run. Returns their folder."""
        self.passes("run", ".", "-q", "--rendering-backend", "none", "--reporter", "jsonl=one.jsonl")
        header, result = self.read("one.jsonl").decode().splitlines()
        header = json.loads(header)
        folder = f"shards-{cases}"
        os.mkdir(self.path(folder))
        each = cases // FILES
        header.update(shards=FILES, all_cases=cases, cases=each, division=division(each))
        for shard in range(FILES):
            lines = [json.dumps(dict(header, shard=shard + 1))]
            lines += [result.replace("short", name_of(shard, i)) for i in range(each)]
            with open(self.path(f"{folder}/{shard + 1:05}.jsonl"), "w", encoding="utf-8") as file:
                file.write("\n".join(lines) + "\n")
        return folder

    def measure(self, cases):
        folder = self.shards(cases)
        reports = [argument for name in ("json", "jsonl", "junit", "list", "markdown")
                   for argument in ("--reporter", f"{name}=merged.{name}")]
        process = subprocess.Popen([self.program, "merge-reports", folder, *reports], cwd=self.folder,
                                   stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        err = process.stderr.read().decode()
        process.stderr.close()
        # The memory counts from before the program replaces this one: so this one keeps no list of cases.
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        seconds = usage.ru_utime + usage.ru_stime  # of processors: others may use the machine, too
        self.assertEqual((process.returncode, err), (0, ""))
        self.assert_whole(cases)
        for name in os.listdir(self.path(folder)):
            os.remove(self.path(f"{folder}/{name}"))
        return seconds, usage.ru_maxrss / 1024

    def assert_whole(self, cases):
        """Every case once, in order."""
        number = 0
        with open(self.path("merged.jsonl"), encoding="utf-8") as file:
            next(file)
            for line in file:
                self.assertIn('"id":"w%07d.walk.yaml"' % number, line)
                number += 1
        self.assertEqual(number, cases)
        with open(self.path("merged.junit"), encoding="utf-8") as file:
            file.readline()
            self.assertIn('tests="%d"' % cases, file.readline())

    def test_memory_is_flat_and_time_linear(self):
        measured = {}
        for cases in CASES:
            measured[cases] = self.measure(cases)
            print("\n%d files, %d cases: %.1f s of a processor, %.0f MB at most" % (FILES, cases, *measured[cases]), flush=True)
        least, most = min(CASES), max(CASES)
        self.assertLess(measured[most][1], 1.3 * measured[least][1] + 8, "the memory grows with the cases")
        if len(CASES) > 2:
            middle = sorted(CASES)[-2]
            ratio = measured[most][0] / measured[middle][0]
            self.assertLess(ratio, 1.4 * most / middle, "the time does not grow linearly")


if __name__ == "__main__":
    if len(sys.argv) > 2 and sys.argv[2].isdigit():
        CASES = [int(each) for each in sys.argv[2:]]
        del sys.argv[2:]
    main()
