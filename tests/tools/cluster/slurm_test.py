#!/usr/bin/env python3
"""`run --slurm` on a real Slurm, which this test starts and ends: the merged bytes of one machine, tasks that are
killed, nodes that die, tasks that are cancelled or time out, Ctrl-C, and what a shard costs.

Usage: slurm_test.py PROGRAM. Skipped, with exit code 77, where Slurm isn't installed.
"""

import json
import os
import pty
import re
import signal
import subprocess
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from program import SKIPPED, WALK, ProgramCase, main
from slurm_cluster import SlurmCluster, missing_programs

FAILING = WALK.replace('never: "collision.enter hut/wall"', "never: popup.open hut")
REPORTERS = ("json", "jsonl", "junit", "tap", "dot", "list", "markdown")
NODES = 2
CPUS = 2
cluster = None


def reports(folder):
    return [argument for name in REPORTERS for argument in ("--reporter", f"{name}={folder}/{name}")]


class Slurm(ProgramCase):
    def setUp(self):
        super().setUp()
        os.remove(self.path("short.walk.yaml"))
        os.mkdir(self.path("walks"))
        self.addCleanup(self.end_jobs)

    def end_jobs(self):
        cluster.ask("scancel", "--state=PENDING", "--state=RUNNING", "--user", str(os.getuid()))
        self.wait_until(lambda: not cluster.queue(), "an empty queue")

    def write_walks(self, count, seconds=lambda i: 1 + i % 7, failing=()):
        """They wait so many simulated seconds."""
        for i in range(count):
            text = FAILING if i in failing else WALK.replace("turn: 180", f"wait: {seconds(i)}")
            self.write(f"walks/w{i:03}.walk.yaml", text.replace("small.campus", "../small.campus"))

    @staticmethod
    def wait_until(condition, what, seconds=120):
        until = time.monotonic() + seconds
        while not condition():
            if time.monotonic() > until:
                raise AssertionError("there never was " + what)
            time.sleep(0.02)

    def command(self, *arguments):
        return [self.program, "run", "walks", "--rendering-backend", "none", *arguments]

    def whole(self, *arguments):
        outcome = self.run_program(*self.command()[1:], "--output", "alone", *reports("whole"), *arguments)
        return outcome.code

    def start(self, *arguments):
        process = subprocess.Popen(self.command("--slurm", *reports("merged"), *arguments), cwd=self.folder,
                                   env=cluster.environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.stderr.close)
        return process

    def end(self, process, seconds=300):
        out, err = process.communicate(timeout=seconds)
        return process.returncode, out, err

    def submit(self, *arguments):
        return self.end(self.start(*arguments))

    def job(self):
        self.wait_until(lambda: os.path.exists(self.path("out/slurm/job")), "a job")
        return self.read("out/slurm/job").decode().split()[0]

    def saved(self, task):
        """How many results a task has saved."""
        try:
            return max(0, self.read(f"out/slurm/saved/{task}.jsonl").count(b"\n") - 1)
        except FileNotFoundError:
            return 0

    def saved_cases(self, *tasks):
        """The ids of cases with a result: those that were interrupted have another one later."""
        lines = [line for task in tasks for line in self.read(f"out/slurm/saved/{task}.jsonl").splitlines()[1:]]
        results = [json.loads(line) for line in lines]
        return {each["id"] for each in results if each["outcome"] == "passed"}

    def program_of(self, task):
        """The process that runs a task's shard, not its workers: the one whose parent is the script."""
        found = []
        for process in cluster.task_processes(SLURM_ARRAY_TASK_ID=task):
            try:
                with open(f"/proc/{process}/cmdline", "rb") as file:
                    arguments = file.read().split(b"\0")
                if os.path.basename(arguments[0]) == b"campuswalk":
                    found.append(process)
            except OSError:
                pass
        return min(found) if found else None

    def assert_merged_as_whole(self):
        for name in REPORTERS:
            self.assertEqual(self.read(f"merged/{name}"), self.read(f"whole/{name}"), name)

    def restarts_of(self, task):
        state = cluster.ask("scontrol", "--oneliner", "show", "job", f"{self.job()}_{task}")
        return int(re.search(r"Restarts=(\d+)", state)[1])

    def test_300_walks_give_the_bytes_of_one_machine(self):
        self.write_walks(300, failing=(5, 150, 299))
        self.write("walks/w007.walk.yaml", "campus: ../none.campus.yaml\n")
        self.write("walks.config.yaml", "projects: {plain: , slow: {avatar: {profile: adult, speed: 0.9}}}\n")
        start = time.monotonic()
        self.assertEqual(self.whole(), 2)
        alone = time.monotonic() - start
        for shards in (16, 16, 7):  # the second time they are balanced by the first one's times
            start = time.monotonic()
            code, out, err = self.submit("--shards", str(shards))
            print(f"\n600 cases in {shards} shards on {NODES}x{CPUS} CPUs of Slurm: {time.monotonic() - start:.1f} s, "
                  f"alone {alone:.1f} s", flush=True)
            self.assertEqual(code, 2, err)
            self.assert_merged_as_whole()
            self.assertRegex(err, r"(?m)^job \d+: 300 walks|^job \d+: 600")
            self.assertRegex(err, rf"(?m)^job \d+: \d+ of {shards} tasks done")
        # Without a file, the report is printed as one machine prints it.
        printed = self.end(subprocess.Popen(self.command("--slurm", "--shards=3", "--color=never"), cwd=self.folder,
                                            env=cluster.environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                            text=True))
        self.assertEqual((printed[0], printed[1]), (2, self.read("whole/list").decode()))

    def test_a_task_that_is_killed_is_requeued_and_goes_on(self):
        self.write_walks(40, seconds=lambda i: 3000)
        self.assertEqual(self.whole(), 0)
        process = self.start("--shards", "2")
        self.wait_until(lambda: 2 <= self.saved(1) < 15, "a task in its middle")
        os.kill(self.program_of(1), signal.SIGKILL)
        before = self.saved(1)
        kept = self.read("out/slurm/saved/1.jsonl").splitlines()[:before]
        code, _, err = self.end(process)
        self.assertEqual(code, 0, err)
        self.assertEqual(self.restarts_of(1), 1)
        self.assertEqual(self.read("out/slurm/saved/1.jsonl").splitlines()[:before], kept, "results were played again")
        self.assertEqual(self.saved(1), 20)
        self.assert_merged_as_whole()
        print(f"\nkilled after {before} of 20 results, resumed", flush=True)

    def test_a_node_that_dies_does_not_lose_its_tasks(self):
        self.write_walks(40, seconds=lambda i: 3000)
        self.assertEqual(self.whole(), 0)
        process = self.start("--shards", "2")
        self.wait_until(lambda: 2 <= self.saved(1) < 15, "a task in its middle")
        node = cluster.queue()[self.job() + "_1"][1]
        cluster.kill_node(node)
        self.addCleanup(cluster.start_node, node)
        before = self.saved(1)
        code, _, err = self.end(process)
        self.assertEqual(code, 0, err)
        self.assertEqual(self.restarts_of(1), 1)
        self.assertEqual(self.saved(1), 20)
        self.assert_merged_as_whole()
        self.assertNotIn(node, cluster.ask("scontrol", "--oneliner", "show", "job", self.job() + "_1").split("NodeList=")[-1])
        print(f"\nthe node of a task died after {before} of 20 results, resumed", flush=True)

    def test_a_task_that_is_killed_with_its_script_is_named_and_can_be_resumed(self):
        self.write_walks(40, seconds=lambda i: 3000)
        self.assertEqual(self.whole(), 0)
        process = self.start("--shards", "2")
        self.wait_until(lambda: 2 <= self.saved(1) < 15, "a task in its middle")
        for each in cluster.task_processes(SLURM_ARRAY_TASK_ID=1):
            os.kill(each, signal.SIGKILL)
        code, _, err = self.end(process)
        self.assertEqual(code, 3)
        self.assertRegex(err, rf"(?m)^task {self.job()}_1: error task-failed: ")
        self.assertNotRegex(err, rf"task {self.job()}_2")
        code, _, err = self.submit("--resume")
        self.assertEqual(code, 0, err)
        self.assertEqual(self.saved(1), 20)
        self.assert_merged_as_whole()

    def test_a_task_that_is_cancelled_is_named(self):
        self.write_walks(12, seconds=lambda i: 20000)
        process = self.start("--shards", "3")
        self.wait_until(lambda: self.program_of(2) is not None, "a running task")
        cluster.ask("scancel", self.job() + "_2")
        code, _, err = self.end(process)
        self.assertEqual(code, 3)
        self.assertRegex(err, rf"(?m)^task {self.job()}_2: error task-cancelled: ")
        self.assertNotRegex(err, rf"task {self.job()}_[13]")
        self.assertIn(b"passed", self.read("merged/list"))

    def test_a_task_that_never_started_is_named(self):
        self.write_walks(6)
        process = self.start("--shards", "3", "--sbatch=--begin=now+5")
        cluster.ask("scancel", self.job() + "_3")
        code, _, err = self.end(process)
        self.assertEqual(code, 3)
        # Without accounting, Slurm forgets a task that it cancels before it started.
        self.assertRegex(err, rf"(?m)^task {self.job()}_3: error task-(lost|cancelled): ")
        self.assertRegex(err, r"(?m)^out/slurm: error missing-shard: .* 3$")
        self.assertNotRegex(err, rf"task {self.job()}_[12]")

    def test_a_task_that_times_out_is_named(self):
        self.write_walks(2, seconds=lambda i: 20000)
        process = self.start("--shards", "2", "--time", "1")
        self.wait_until(lambda: self.program_of(1) is not None, "a running task")
        os.kill(self.program_of(1), signal.SIGSTOP)  # it needs no processor to time out
        code, _, err = self.end(process)
        self.assertEqual(code, 3)
        self.assertRegex(err, rf"(?m)^task {self.job()}_1: error task-timed-out: ")

    def test_interrupted_it_cancels_its_jobs_and_resume_goes_on(self):
        self.write_walks(40, seconds=lambda i: 3000)
        self.assertEqual(self.whole(), 0)
        process = self.start("--shards", "2")
        self.wait_until(lambda: self.saved(1) >= 2, "some results")
        busy = self.submit("--shards", "2")
        self.assertEqual(busy[0], 2)
        self.assertIn("error job-unfinished: ", busy[2])
        process.send_signal(signal.SIGINT)
        code, _, err = self.end(process)
        self.assertEqual(code, 130)
        self.assertIn("--resume", err)
        self.wait_until(lambda: not cluster.queue(), "an empty queue")
        before = self.saved_cases(1, 2)
        self.assertLess(len(before), 40)
        code, _, err = self.submit("--resume")
        self.assertEqual(code, 0, err)
        self.assertEqual(len(self.saved_cases(1, 2)), 40)
        self.assert_merged_as_whole()

    def test_a_terminal_shows_a_bar(self):
        self.write_walks(6, seconds=lambda i: 3000)
        ours, theirs = pty.openpty()
        process = subprocess.Popen(self.command("--slurm", "--shards=3", "--reporter=tap=merged.tap"), cwd=self.folder,
                                   env=cluster.environment, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                   stderr=theirs)
        os.close(theirs)
        shown = b""
        try:
            while part := os.read(ours, 4096):
                shown += part
        except OSError:  # the other end is closed
            pass
        os.close(ours)
        self.assertEqual(process.wait(), 0, shown)
        self.assertRegex(shown, rb"\[#*\.+\] job \d+: [012] of 3 tasks done, \d (running|waiting)")
        self.assertRegex(shown, rb"\r\x1b\[K$")

    def test_scripts_can_be_submitted_by_hand(self):
        self.write_walks(10)
        self.assertEqual(self.whole(), 0)
        scripts = self.run_program(*self.command()[1:], "--slurm=script", "--shards=3", *reports("merged"),
                                   env=cluster.environment)
        self.assertEqual(scripts.code, 0, scripts.err)
        subprocess.run(["bash", "-ec", scripts.out], cwd=self.folder, env=cluster.environment, check=True, timeout=60,
                       stdout=subprocess.DEVNULL)
        self.wait_until(lambda: os.path.exists(self.path("out/slurm/merged")), "a merged report")
        self.assertEqual(self.read("out/slurm/merged"), b"0\n")
        self.assert_merged_as_whole()

    def test_campuses_are_explored_as_on_one_machine(self):
        self.write("avatars/child.avatar.yaml", "height: 1.2\nradius: 0.2\neye_height: 1.1\n")
        self.write("other.campus.yaml", self.read("small.campus.yaml").replace(b"[0, 0, -2]", b"[0, 0, -8]"))
        explore = ("explore", "small.campus.yaml", "other.campus.yaml", "--avatar=adult", "--avatar=child")
        whole = self.passes(*explore, "--json", "whole.json")
        merged = self.run_program(*explore, "--slurm", "--json", "merged.json", env=cluster.environment)
        self.assertEqual((merged.code, merged.out), (whole.code, whole.out), merged.err)
        self.assertEqual(self.read("merged.json"), self.read("whole.json"))

    def test_what_a_shard_costs(self):
        self.write_walks(128)
        self.submit("--shards", "4")
        took = {}
        for shards in (4, 128):
            start = time.monotonic()
            code, _, err = self.submit("--shards", str(shards))
            took[shards] = time.monotonic() - start
            self.assertEqual(code, 0, err)
        start = time.monotonic()
        for shard in range(1, 11):
            self.run_program(*self.command()[1:], "-q", "-j1", "--shard", f"{shard}/128", "--output", f"o{shard}")
        own = (time.monotonic() - start) / 10
        cost = (took[128] - took[4]) / 124
        bare = self.seconds_of_empty_tasks(128) / 128
        print(f"\n128 walks in 4 shards: {took[4]:.2f} s; in 128: {took[128]:.2f} s; so another shard takes the cluster "
              f"{1000 * cost:.0f} ms, an empty task of Slurm {1000 * bare:.0f} ms; campuswalk alone, one process after the "
              f"other, {1000 * own:.0f} ms", flush=True)
        self.assertLess(cost, 2 * bare + own)

    def seconds_of_empty_tasks(self, count):
        start = time.monotonic()
        cluster.ask("sbatch", f"--array=1-{count}", "--output=/dev/null", "--wrap=true")
        self.wait_until(lambda: not cluster.queue(), "an empty queue")
        return time.monotonic() - start


if __name__ == "__main__":
    missing = missing_programs()
    if missing:
        print("skipped: there is no " + ", ".join(missing))
        sys.exit(SKIPPED)
    with SlurmCluster(NODES, CPUS) as cluster:
        main()
