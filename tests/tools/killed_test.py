#!/usr/bin/env python3
"""Killed at any moment: no process is left, no half-written file counts, no result that was reported is lost, and
--resume ends with the same bytes as an undisturbed run. `--rounds N` (20): how often, at random moments.
"""

import ctypes
import glob
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import time

from program import WALK, ProgramCase, main

ROUNDS = 20
PR_SET_CHILD_SUBREAPER = 36
WALKS = 12
# The leak checker waits forever for its own process when that is killed.
SANITIZER = os.environ.get("ASAN_OPTIONS", "") + ":detect_leaks=0"


def children_of(process):
    found = []
    for path in glob.glob("/proc/%d/task/*/children" % process):
        try:
            with open(path, encoding="ascii") as file:
                found += [int(child) for child in file.read().split()]
        except OSError:
            pass  # it has ended
    return found


def descendants_of(process):
    found = []
    for child in children_of(process):
        found += [child] + descendants_of(child)
    return found


def is_running(process):
    try:
        with open("/proc/%d/stat" % process, encoding="ascii") as file:
            return file.read().rsplit(")", 1)[1].split()[0] not in "ZX"
    except OSError:
        return False


class Killed(ProgramCase):
    def setUp(self):
        super().setUp()
        # Orphans become children of this process, where they can be counted.
        ctypes.CDLL(None).prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)
        self.dice = random.Random(self.id())
        os.remove(self.path("short.walk.yaml"))
        for i in range(WALKS):
            self.write("w%02d.walk.yaml" % i, WALK.replace("turn: 180", "wait: %d" % (200 + 40 * i)))
        self.cache = self.path("../" + os.path.basename(self.folder) + "-cache")
        self.addCleanup(shutil.rmtree, self.cache, ignore_errors=True)

    def start(self, *arguments, cwd=None):
        return subprocess.Popen([self.program, *arguments], cwd=cwd or self.folder, stdin=subprocess.DEVNULL,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                env=dict(os.environ, CAMPUSWALK_CACHE_DIR=self.cache, ASAN_OPTIONS=SANITIZER))

    def run_to_end(self, *arguments, codes=(0,)):
        process = self.start(*arguments)
        out, err = process.communicate(timeout=120)
        self.assertIn(process.returncode, codes, err.decode())
        return out.decode()

    def kill_during(self, seconds, victim, *arguments):
        """Kills the process itself, or one that it has started, at a random moment; returns what it printed."""
        process = self.start(*arguments)
        time.sleep(self.dice.uniform(0, 1.05 * seconds))
        started = descendants_of(process.pid) if victim == "child" else []
        try:
            os.kill(self.dice.choice(started) if started else process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass  # it had just ended
        out, err = process.communicate(timeout=60)
        self.assertNotIn(process.returncode, (-signal.SIGSEGV, -signal.SIGABRT), err.decode())
        self.assert_nothing_runs()
        return process.returncode, out.decode()

    def assert_nothing_runs(self):
        until = time.monotonic() + 5
        while any(is_running(child) for child in descendants_of(os.getpid())):
            self.assertLess(time.monotonic(), until, "processes are left")
            time.sleep(0.005)
        try:
            while os.waitpid(-1, os.WNOHANG)[0]:
                pass
        except ChildProcessError:
            pass

    def duration_of(self, *arguments):
        start = time.monotonic()
        self.run_to_end(*arguments)
        return time.monotonic() - start

    def whole_lines(self, name):
        """What readers take for written: lines with their end."""
        if not os.path.exists(self.path(name)):
            return []
        return [json.loads(line) for line in self.read(name).decode().split("\n")[:-1]]

    def run_arguments(self, *more):
        return ("run", ".", "-j2", "--quiet", "--rendering-backend", "none", "--reporter", "jsonl=r.jsonl", "--reporter",
                "junit=r.xml", "--reporter", "json=r.json", *more)

    def reports(self):
        return {name: self.read(name) for name in ("r.jsonl", "r.xml", "r.json")}

    def assert_reports_are_whole_or_none(self):
        for name in ("r.xml", "r.json"):
            if os.path.exists(self.path(name)):
                self.assertEqual(self.read(name), self.undisturbed[name])

    def assert_no_parts(self):
        """What was killed has left none that the next command would leave, too."""
        self.assertEqual([name for name in self.contents() if name.endswith(".part")], [])

    def remove_results(self):
        shutil.rmtree(self.path("out"), ignore_errors=True)
        for name in glob.glob(self.path("r.*")):
            os.remove(name)

    def test_a_run(self):
        self.run_to_end(*self.run_arguments())  # fills the cache
        seconds = self.duration_of(*self.run_arguments())
        self.undisturbed = self.reports()
        resumed = 0
        for round_ in range(ROUNDS):
            self.remove_results()
            victim = "child" if round_ % 3 == 2 else "parent"
            code, _ = self.kill_during(seconds, victim, *self.run_arguments())
            if victim == "parent" and code == -signal.SIGKILL:
                self.assert_reports_are_whole_or_none()
            saved = {each["id"] for each in self.whole_lines("out/last-run.jsonl")[1:]}
            reported = {each["id"] for each in self.whole_lines("r.jsonl")[1:]}
            self.assertLessEqual(reported, saved, "a result was reported and is lost")
            outcome = self.start(*self.run_arguments("--resume"))
            _, err = outcome.communicate(timeout=60)
            if not saved and outcome.returncode == 2:
                self.assertIn("--resume", err.decode())  # there was nothing yet
                continue
            self.assertEqual(outcome.returncode, 0, err.decode())
            self.assertEqual(self.reports(), self.undisturbed)
            self.assert_no_parts()
            resumed += 0 < len(saved) < WALKS
        self.assertGreater(resumed, ROUNDS // 10, "the moments are well spread")

    def test_an_import_and_the_cache_it_fills(self):
        log = self.run_to_end("run", "w00.walk.yaml", "--no-cache")
        shutil.rmtree(self.cache, ignore_errors=True)
        seconds = self.duration_of("run", "w00.walk.yaml")
        for round_ in range(ROUNDS):
            shutil.rmtree(self.cache, ignore_errors=True)
            self.kill_during(seconds, "child" if round_ % 2 else "parent", "run", "w00.walk.yaml")
            self.assertEqual(self.run_to_end("run", "w00.walk.yaml"), log, "with what is in the cache now")
            self.assertEqual(self.run_to_end("run", "w00.walk.yaml"), log)

    def test_a_merge_of_reports(self):
        for i in (1, 2):
            self.run_to_end("run", ".", "-j2", "--quiet", "--rendering-backend", "none", "--shard", "%d/2" % i,
                            "--reporter", "jsonl=shard-%d.jsonl" % i)
        merge = ("merge-reports", "shard-1.jsonl", "shard-2.jsonl", "--reporter", "junit=r.xml", "--reporter", "json=r.json",
                 "--reporter", "jsonl=r.jsonl")
        seconds = self.duration_of(*merge)
        self.undisturbed = self.reports()
        for _ in range(ROUNDS):
            self.remove_results()
            self.kill_during(seconds, "parent", *merge)
            self.assert_reports_are_whole_or_none()
            self.run_to_end(*merge)
            self.assertEqual(self.reports(), self.undisturbed)
            self.assert_no_parts()

    def test_golden_files(self):
        for i in range(WALKS):
            self.write("w%02d.walk.yaml" % i, self.read("w%02d.walk.yaml" % i).decode() + "  - log: {golden: true}\n")
        update = ("run", ".", "-j2", "--quiet", "--rendering-backend", "none", "-u")
        seconds = self.duration_of(*update)
        goldens = sorted(glob.glob(self.path("*-snapshots/log.jsonl")))
        self.assertEqual(len(goldens), WALKS)
        whole = {name: self.read(name) for name in goldens}
        for round_ in range(ROUNDS):
            for folder in glob.glob(self.path("*-snapshots")):
                shutil.rmtree(folder)
            self.kill_during(seconds, "child" if round_ % 2 else "parent", *update)
            for name in goldens:
                if os.path.exists(name):
                    self.assertEqual(self.read(name), whole[name])
            self.run_to_end(*update)
            self.assert_no_parts()
            self.run_to_end("run", ".", "-j2", "--quiet", "--rendering-backend", "none")


if __name__ == "__main__":
    if "--rounds" in sys.argv:
        at = sys.argv.index("--rounds")
        ROUNDS = int(sys.argv[at + 1])
        del sys.argv[at:at + 2]
    main()
