#!/usr/bin/env python3
"""Walks of config/walks, packed into files and played by the core alone, end with the hashes of tests/golden.

`packed_walks_test.py WRITER PLAYER…`: the program write_packed_walk, and play_packed_walk, perhaps after a command
that runs it, such as an emulator of another processor.
"""

import glob
import os
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def golden(name):
    with open(os.path.join(ROOT, "tests", "golden", name), "rb") as file:
        return file.read()


class PackedWalks(unittest.TestCase):
    maxDiff = None

    def play(self, walk):
        with tempfile.TemporaryDirectory() as folder:
            packed = os.path.join(folder, "packed")
            subprocess.run([self.writer, walk, packed], check=True, cwd=ROOT)
            return subprocess.run([*self.player, packed], check=True, cwd=ROOT, stdout=subprocess.PIPE).stdout

    def test_every_walk_ends_with_its_golden_hash(self):
        walks = sorted(glob.glob(os.path.join(ROOT, "config", "walks", "*.walk.yaml")))
        logs = {os.path.basename(walk): self.play(os.path.relpath(walk, ROOT)) for walk in walks}
        ends = b"".join(log.splitlines(keepends=True)[-1] for log in logs.values())
        self.assertEqual(ends.decode(), golden("walk-ends.txt").decode())
        # A packed campus has no models, so that reasons name no node: why="bench/bench-01 (bench_01) is …".
        tour = re.sub(r'(why="\S+) \(\w+\)', r"\1", golden("first-tour.log").decode())
        self.assertEqual(logs["first-tour.walk.yaml"].decode(), tour)


if __name__ == "__main__":
    PackedWalks.writer, *PackedWalks.player = os.path.abspath(sys.argv[1]), *sys.argv[2:]
    unittest.main(argv=sys.argv[:1], verbosity=2)
