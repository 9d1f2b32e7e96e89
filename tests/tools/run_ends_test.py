#!/usr/bin/env python3
"""Runs of many walks: their order, and runs that are stopped, killed, resumed or watched."""

import json
import os
import re
import signal
import subprocess
import time

from program import WALK, ProgramCase, main

FAILING = WALK.replace('never: "collision.enter hut/wall"', "never: popup.open hut")
ENDLESS = WALK.replace("turn: 180", "wait: 9900").replace("steps:", "sim: {ticks_per_second: 10000}\nsteps:")
LONG = ENDLESS.replace("9900", "1200")
WAITING = ENDLESS.replace("wait: 9900", "wait_until: {event: popup.open hut, timeout: 86400}")


class ManyWalks(ProgramCase):
    """Six walks, of which c fails."""

    def setUp(self):
        super().setUp()
        os.remove(self.path("short.walk.yaml"))
        for name in "abcdef":
            self.write(f"{name}.walk.yaml", FAILING if name == "c" else WALK)

    def run_walks(self, *arguments, **options):
        return self.run_program("run", "--rendering-backend", "none", *arguments, **options)

    def results(self, name):
        """The results of a jsonl report, without its first line."""
        return [json.loads(line) for line in self.read(name).splitlines()[1:]]

    def start(self, *arguments):
        process = subprocess.Popen([self.program, "run", "--rendering-backend", "none", *arguments], cwd=self.folder,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.addCleanup(process.stdout.close)
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.kill)
        return process

    def wait_for(self, condition):
        end = time.monotonic() + 60
        while not condition():
            self.assertLess(time.monotonic(), end, "timed out")
            time.sleep(0.01)

    def recorded_lines(self):
        try:
            return self.read("out/last-run.jsonl").count(b"\n")
        except FileNotFoundError:
            return 0


class Order(ManyWalks):
    def test_output_is_the_same_with_any_number_of_workers(self):
        outputs = []
        for workers in ("1", "2", "5"):
            outcome = self.run_walks("-j", workers, "--log", "all.log", "--jsonl", "all.jsonl", "--reporter", "list",
                                     "--reporter", "jsonl=r.jsonl", "--reporter", "junit=r.xml", "--reporter", "tap=r.tap",
                                     "--reporter", "json=r.json")
            self.assertEqual((outcome.code, outcome.err), (1, ""))
            files = ("all.log", "all.jsonl", "r.jsonl", "r.xml", "r.tap", "r.json")
            outputs.append((outcome.out, [self.read(file) for file in files]))
        self.assertEqual(outputs[1], outputs[0])
        self.assertEqual(outputs[2], outputs[0])
        self.assertEqual([result["name"] for result in self.results("r.jsonl")], list("abcdef"))
        self.assertEqual(outputs[0][1][0].count(b"walk.end"), 6)

    def test_a_run_stops_after_failures(self):
        for arguments in (("-x",), ("--max-failures", "1")):
            for workers in ("1", "4"):
                outcome = self.run_walks("-j", workers, "--reporter", "jsonl=r.jsonl", *arguments)
                self.assertEqual((outcome.code, outcome.err.count("3 not run")), (1, 1))
                self.assertEqual([result["name"] for result in self.results("r.jsonl")], list("abc"))

    def test_quiet_and_verbose(self):
        self.assertEqual(self.run_walks("--quiet").out, "")
        self.assertIn("a: pass after ", self.run_walks("-q").err)
        self.assertEqual(self.run_walks().err, "")
        self.assertIn("c: FAIL after ", self.run_walks("--verbose").err)

    def test_colors_are_for_terminals_or_on_request(self):
        plain = self.run_walks("--color", "never").out
        self.assertNotIn("\x1b", plain)
        self.assertEqual(self.run_walks().out, plain)  # a pipe isn't a terminal
        self.assertIn("\x1b[", self.run_walks("--color=always").out)

    def test_repetitions_are_identical(self):
        outcome = self.run_walks("a.walk.yaml", "--repeat-each", "3", "--require-identical", "--reporter",
                                 "jsonl=r.jsonl")
        self.assertEqual(outcome.code, 0)
        self.assertEqual([result["id"] for result in self.results("r.jsonl")],
                         ["a.walk.yaml #1", "a.walk.yaml #2", "a.walk.yaml #3"])
        self.assertEqual(len({result["hash"] for result in self.results("r.jsonl")}), 1)

    def test_unwritable_reports_are_refused(self):
        before = self.contents()
        for target, code in (("avatars", "report-unwritable"), ("room.obj/a.xml", "report-unwritable"),
                             ("a.walk.yaml", "report-unwritable")):
            outcome = self.run_walks("--reporter", "junit=" + target)
            self.assertEqual((outcome.code, outcome.out), (2, ""))
            self.assertIn(f"{target}: error {code}: ", outcome.err)
        outcome = self.run_walks("--output", "room.obj")
        self.assertEqual((outcome.code, outcome.out), (2, ""))
        self.assertIn("room.obj/last-run.jsonl: error output-unwritable: ", outcome.err)
        outcome = self.run_walks("--reporter", "dot", "--reporter", "tap")
        self.assertEqual((outcome.code, outcome.out), (2, ""))
        self.assertEqual(self.contents(), before)

    def test_report_on_a_full_disk(self):
        outcome = self.run_walks("--reporter", "junit=/dev/full")
        self.assertEqual(outcome.code, 3)
        self.assertIn("/dev/full: No space left on device", outcome.err)

    def test_a_report_of_a_walk_with_mistakes(self):
        self.write("a.walk.yaml", WALK.replace("walk_to: end", "walk_to: nowhere"))
        outcome = self.run_walks("a.walk.yaml", "--reporter", "jsonl=r.jsonl")
        self.assertEqual(outcome.code, 2)
        self.assertEqual([result["outcome"] for result in self.results("r.jsonl")], ["bad_input"])

    def test_records_hold_every_tick(self):
        outcome = self.run_walks("a.walk.yaml", "--record", "csv", "--record", "tum", "--record", "trace",
                                 "--jsonl", "a.jsonl", "--reporter", "jsonl=r.jsonl")
        self.assertEqual(outcome.code, 0)
        result = self.results("r.jsonl")[0]
        paths = {artifact["name"]: artifact["path"] for artifact in result["artifacts"]}
        self.assertEqual(sorted(paths), ["csv", "trace", "tum"])
        rows = self.read("out/" + paths["csv"]).decode().splitlines()
        poses = self.read("out/" + paths["tum"]).decode().splitlines()
        self.assertEqual((len(rows), len(poses)), (result["ticks"] + 2, result["ticks"] + 1))
        end = json.loads(self.read("a.jsonl").decode().splitlines()[-2])
        for shown, exact in zip(end["pos"], rows[-1].split(",")[1:4]):
            self.assertAlmostEqual(shown, float(exact), delta=6e-4)
        self.assertGreater(len(json.loads(self.read("out/" + paths["trace"]))), 0)

    def test_an_unknown_record_is_refused(self):
        outcome = self.run_walks("--record", "video")
        self.assertEqual((outcome.code, outcome.out), (2, ""))
        self.assertRegex(outcome.err, r"'video' .*csv\|tum\|trace")

    def test_an_unknown_reporter_is_refused(self):
        outcome = self.run_walks("--reporter", "junti=a.xml")
        self.assertEqual((outcome.code, outcome.out), (2, ""))
        self.assertIn("'junit'", outcome.err)


class Again(ManyWalks):
    def test_last_failed(self):
        self.run_walks()
        outcome = self.run_walks("--last-failed", "--list")
        self.assertEqual(outcome.lines, ["c.walk.yaml"])
        self.write("c.walk.yaml", WALK)
        self.assertEqual(self.run_walks("--last-failed").code, 0)
        outcome = self.run_walks("--last-failed")
        self.assertEqual(outcome.code, 5)
        self.assertIn("no walk failed in the last run", outcome.err)

    def test_without_a_last_run_nothing_can_be_repeated(self):
        for option in ("--last-failed", "--resume"):
            outcome = self.run_walks(option)
            self.assertEqual((outcome.code, outcome.out), (2, ""))
            self.assertIn("out/last-run.jsonl: error missing-file: ", outcome.err)

    def test_logs_cannot_be_resumed(self):
        self.run_walks()
        for arguments in (("--log", "a.log"), ("--jsonl", "a.jsonl"), ("--reporter", "log"), ("a.walk.yaml",),
                          ("a.walk.yaml", "--reporter", "list")):
            outcome = self.run_walks("--resume", *arguments)
            self.assertEqual((outcome.code, outcome.out), (2, ""))
            self.assertIn("--resume: error bad-value: ", outcome.err)

    def test_resumes_a_run_that_was_killed(self):
        whole = self.run_walks("--reporter", "jsonl=whole.jsonl")
        self.write("e.walk.yaml", ENDLESS)
        running = self.start("-j", "1")
        self.wait_for(lambda: self.recorded_lines() == 5)  # its header, then a to d
        running.kill()
        running.wait(timeout=60)
        with open(self.path("out/last-run.jsonl"), "ab") as file:
            file.write(b'{"id":"e.walk.ya')  # as if it had been killed while writing
        self.write("e.walk.yaml", WALK)
        changed = self.run_walks("--resume")  # the run has changed
        self.assertEqual((changed.code, changed.out), (2, ""))
        self.assertIn("out/last-run.jsonl: error other-run: ", changed.err)
        self.run_walks("-x", "-j", "1")
        self.assertGreaterEqual(self.recorded_lines(), 4)  # its header, then a to c
        with open(self.path("out/last-run.jsonl"), "ab") as file:
            file.write(b'{"id":"d.walk.ya')
        before = self.read("out/last-run.jsonl")
        resumed = self.run_walks("--resume", "--reporter", "jsonl=resumed.jsonl", "-v")
        self.assertEqual(resumed.code, whole.code)
        self.assertEqual(self.read("resumed.jsonl"), self.read("whole.jsonl"))
        after = self.read("out/last-run.jsonl")
        self.assertTrue(after.startswith(before[:before.rindex(b"\n") + 1]))
        self.assertEqual(len(after.splitlines()), 7)  # no walk was played twice

    def test_reports_of_a_killed_run_have_what_was_known(self):
        self.write("e.walk.yaml", ENDLESS)
        running = self.start("-j", "1", "--reporter", "jsonl=now.jsonl", "--reporter", "tap=now.tap")
        self.wait_for(lambda: self.recorded_lines() == 5)
        self.wait_for(lambda: self.read("now.tap").count(b"\nok ") + self.read("now.tap").count(b"\nnot ok ") == 4)
        running.kill()
        self.assertEqual([result["name"] for result in self.results("now.jsonl")], ["a", "b", "c", "d"])

    def test_resumes_only_the_same_run(self):
        def changes():
            """Of everything that results depend on, keeping sizes and dates."""
            for name in ("room.obj", "small.campus.yaml", "avatars/adult.avatar.yaml", "b.walk.yaml",
                         "a.walk.yaml-snapshots/log.jsonl", "outer.steps.yaml"):
                before, status = self.read(name), os.stat(self.path(name))
                at = before.index(b"8") if b"8" in before else before.index(b"0")
                self.write(name, before[:at] + b"7" + before[at + 1:])
                os.utime(self.path(name), ns=(status.st_atime_ns, status.st_mtime_ns))
                yield name
                self.write(name, before)
                os.utime(self.path(name), ns=(status.st_atime_ns, status.st_mtime_ns))

        self.write("a.walk.yaml-snapshots/log.jsonl", "0\n")
        # No step of its own tells of a file that only includes.
        self.write("inner.steps.yaml", "steps: [{wait: 0.1}]\n")
        self.write("outer.steps.yaml", "steps: [{repeat: {times: 8, steps: [{include: inner.steps.yaml}]}}]\n")
        self.write("c.walk.yaml", WALK.replace("  - turn: 180", "  - turn: 180\n  - include: outer.steps.yaml"))
        code = self.run_walks("-q").code
        self.assertEqual(self.run_walks("--resume", "-q").code, code)
        for name in changes():
            outcome = self.run_walks("--resume", "-q")
            self.assertEqual(outcome.code, 2, name)
            self.assertIn("out/last-run.jsonl: error other-run: ", outcome.err, name)
        for options in (("--strict",), ("--record", "csv"), ("--timeout", "3"), ("--repeat-each", "2")):
            self.assertIn("error other-run: ", self.run_walks("--resume", "-q", *options).err, options)

    def test_resumes_no_results_that_others_have_written(self):
        def resumed(**variables):
            outcome = self.run_walks("--resume", "-q", env={**os.environ, **variables})
            return outcome.code, re.findall("error ([a-z-]*): ", outcome.err.replace("error never", ""))

        secret = "0123456789abcdef"
        self.run_walks("-q")
        code = self.run_walks("-q").code
        self.assertEqual(resumed(), (code, []))
        genuine = self.read("out/last-run.jsonl")
        # Somebody who has no key turns a failure into a pass.
        self.assertIn(b'"outcome":"failed"', genuine)
        self.write("out/last-run.jsonl", genuine.replace(b'"outcome":"failed"', b'"outcome":"passed"'))
        self.assertEqual(resumed(), (2, ["foreign-results"]))
        self.assertIn(self.run_walks("--last-failed", "--list").code, (0, 5), "it only selects")
        self.assertIn("error foreign-results: ", self.run_walks("--last-failed", "--strict").err)
        self.write("out/last-run.jsonl", genuine)
        self.assertEqual(resumed(CAMPUSWALK_RUN_KEY=secret), (2, ["foreign-results"]))
        self.assertEqual(resumed(XDG_STATE_HOME=self.path("elsewhere")), (2, ["foreign-results"]))
        self.assertEqual(resumed(XDG_STATE_HOME="", HOME=""), (2, ["foreign-results"]))
        self.assertEqual(resumed(CAMPUSWALK_RUN_KEY="short"), (2, ["bad-value"]))
        self.run_walks("-q", env={**os.environ, "CAMPUSWALK_RUN_KEY": secret})
        self.assertEqual(resumed(CAMPUSWALK_RUN_KEY=secret, XDG_STATE_HOME=self.path("elsewhere")), (code, []))

    def test_the_key_is_nobody_elses_to_read(self):
        self.run_walks("-q", env={**os.environ, "XDG_STATE_HOME": self.path("state")})
        self.assertEqual(os.stat(self.path("state/campuswalk/run.key")).st_mode & 0o777, 0o600)
        self.assertEqual(len(self.read("state/campuswalk/run.key")), 32)

    def test_watch_replays_a_changed_walk(self):
        watching = self.start("--watch", "--reporter", "dot")
        lines = []

        def wait_for_lines(count):
            while len(lines) < count:
                lines.append(watching.stderr.readline())
        wait_for_lines(1)
        self.assertTrue(lines[0].startswith(b"watching"), lines)
        self.write("c.walk.yaml", WALK)
        wait_for_lines(2)
        watching.send_signal(signal.SIGINT)
        out = watching.stdout.read().decode()
        self.assertEqual(watching.wait(timeout=60), 130)
        self.assertIn("5 passed, 1 failed", out)
        self.assertIn("\n1 passed", out)  # the one that changed

    def test_watch_plays_the_walks_that_use_a_changed_file(self):
        self.write("avatars/child.avatar.yaml", "height: 1.3\nradius: 0.2\neye_height: 1.2\n")
        self.write("lap.steps.yaml", "steps: [{wait: 0.1}]\n")
        self.write("models/room.obj", self.read("room.obj"))
        self.write("models/own.campus.yaml", self.read("small.campus.yaml"))
        self.write("a.walk.yaml", WALK.replace("adult", "child"))
        self.write("shared/outer.steps.yaml", "steps: [{include: ../lap.steps.yaml}]\n")
        self.write("b.walk.yaml", WALK.replace("  - turn: 180", "  - turn: 180\n  - include: shared/outer.steps.yaml"))
        self.write("c.walk.yaml", WALK.replace("small.campus", "models/own.campus"))
        self.write("d.walk.yaml", WALK.replace("small.campus", "models/own.campus"))
        watching = self.start("--watch", "--reporter", "dot", "--reporter", "jsonl=r.jsonl")

        def played():
            self.assertTrue(watching.stderr.readline().startswith(b"watching"))
            return "".join(result["name"] for result in self.results("r.jsonl"))
        self.assertEqual(played(), "abcdef")
        for file, walks in (("avatars/child.avatar.yaml", "a"), ("lap.steps.yaml", "b"),
                            ("shared/outer.steps.yaml", "b"), ("models/own.campus.yaml", "cd"),
                            ("models/room.obj", "cd"), ("small.campus.yaml", "abef"), ("f.walk.yaml", "f"),
                            ("avatars/giant.avatar.yaml", "abcdef")):
            self.write(file, self.read(file) if "giant" not in file else "height: 3\n")
            self.assertEqual(played(), walks, file)
        os.remove(self.path("f.walk.yaml"))
        self.assertEqual(played(), "abcde")
        watching.send_signal(signal.SIGINT)
        self.assertEqual(watching.wait(timeout=60), 130)


class CutShort(ManyWalks):
    def test_interrupt_keeps_what_is_finished(self):
        self.write("e.walk.yaml", ENDLESS)
        running = self.start("-j", "2", "--reporter", "dot", "--reporter", "jsonl=r.jsonl")
        self.wait_for(lambda: self.recorded_lines() == 6)  # all but e
        running.send_signal(signal.SIGINT)
        _, err = running.communicate(timeout=60)
        self.assertEqual((running.returncode, err), (130, b"interrupted\n"))
        self.assertEqual([(result["name"], result["outcome"]) for result in self.results("r.jsonl")],
                         [("a", "passed"), ("b", "passed"), ("c", "failed"), ("d", "passed"), ("e", "interrupted"),
                          ("f", "passed")])

    def test_a_process_that_dies_breaks_one_walk(self):
        self.write("b.walk.yaml", ENDLESS)
        running = self.start("-j", "1", "--reporter", "jsonl=r.jsonl")
        self.wait_for(lambda: self.recorded_lines() == 2)  # a
        with open(f"/proc/{running.pid}/task/{running.pid}/children", encoding="ascii") as file:
            os.kill(int(file.read().split()[0]), signal.SIGKILL)
        _, err = running.communicate(timeout=60)
        self.assertEqual(running.returncode, 3)
        self.assertRegex(err, rb"b\.walk\.yaml: .*signal 9 \(Killed\)")
        self.assertEqual([result["outcome"] for result in self.results("r.jsonl")],
                         ["passed", "broken", "failed", "passed", "passed", "passed"])

    def test_memory_stays_flat(self):
        """A worker's memory, after 200 walks and after 1,800."""
        with open(self.program, "rb") as file:
            if b"__asan_init" in file.read():
                self.skipTest("AddressSanitizer delays the reuse of freed memory")
        running = self.start("-j", "1", "--repeat-each", "2000", "--reporter", "dot", "a.walk.yaml")

        def memory():
            with open(f"/proc/{running.pid}/task/{running.pid}/children", encoding="ascii") as file:
                worker = int(file.read().split()[0])
            with open(f"/proc/{worker}/status", encoding="ascii") as file:
                return next(int(line.split()[1]) for line in file if line.startswith("VmRSS"))  # KiB
        self.wait_for(lambda: self.recorded_lines() > 200)
        early = memory()
        self.wait_for(lambda: self.recorded_lines() > 1800)
        late = memory()
        running.communicate(timeout=60)
        self.assertEqual(running.returncode, 0)
        self.assertLess(late - early, 512)

    def test_a_timeout_is_a_failure(self):
        self.write("b.walk.yaml", ENDLESS)
        outcome = self.run_walks("--timeout", "2", "-q", "b.walk.yaml")
        self.assertEqual(outcome.code, 1)
        self.assertIn(" error timeout: ", outcome.err)
        self.assertIn("b: FAIL after 2.0 s", outcome.err)

    def test_the_timeout_of_the_command_line_limits_that_of_the_walk(self):
        for own, after in (("3", "2.0"), ("1", "1.0")):
            self.write("b.walk.yaml", ENDLESS + "timeout: %s\n" % own)
            self.assertIn("b: FAIL after %s s" % after, self.run_walks("--timeout", "2", "-q", "b.walk.yaml").err)

    def seen_on_a_terminal(self, until, *arguments, walk=ENDLESS):
        """What an endless run prints until `until` matches, and then when it is interrupted."""
        mine, theirs = os.openpty()
        self.addCleanup(os.close, mine)
        self.write("b.walk.yaml", walk)
        process = subprocess.Popen([self.program, "run", "--rendering-backend", "none", *arguments], cwd=self.folder,
                                   stdout=subprocess.PIPE, stderr=theirs)
        os.close(theirs)
        self.addCleanup(process.stdout.close)
        seen = b""
        while not re.search(until, seen):
            seen += os.read(mine, 1000)
        process.send_signal(signal.SIGINT)
        while b"interrupted" not in seen:
            seen += os.read(mine, 1000)
        self.assertEqual(process.wait(timeout=60), 130)
        return seen

    def test_progress_on_a_terminal(self):
        seen = self.seen_on_a_terminal(rb"1/6, b at \d+\.\d of 99\d+\.\d s", "-j", "1")
        self.assertRegex(seen, rb"\[#{5}\.{25}\] 1/6, b at \d+\.\d of 99\d+\.\d s\r\x1b\[K")

    def test_progress_of_a_single_walk_on_a_terminal(self):
        place = rb"\[#*\.+\] b at \d+\.\d of 99\d+\.\d s"
        seen = self.seen_on_a_terminal(place + rb"\r\x1b\[K" + place, "--reporter", "list", "b.walk.yaml")
        for bar in re.findall(rb"\[(#*\.*)\]", seen):
            self.assertEqual(len(bar), 30)

    def test_the_bar_fills_during_the_walk(self):
        seen = self.seen_on_a_terminal(rb"\[##", "--reporter", "list", "b.walk.yaml", walk=LONG)
        steps = [len(bar) for bar in re.findall(rb"\[(#*)\.+\] b at", seen)]
        self.assertEqual(steps, sorted(steps))
        self.assertGreaterEqual(steps[-1], 2)

    def test_a_walk_of_unknown_length_has_no_bar(self):
        seen = self.seen_on_a_terminal(rb"b at \d+\.\d s\r\x1b\[Kb at", "--reporter", "list", "b.walk.yaml", walk=WAITING)
        self.assertNotIn(b"[#", seen)
        self.assertNotIn(b"..]", seen)

    def test_a_walk_that_takes_too_long_is_killed(self):
        self.write("b.walk.yaml", ENDLESS)
        outcome = self.run_walks("--kill-after", "0.5", "--reporter", "jsonl=r.jsonl", "a.walk.yaml", "b.walk.yaml")
        self.assertEqual(outcome.code, 3)
        self.assertRegex(outcome.err, r"b\.walk\.yaml: .*0\.5 s")
        self.assertEqual([result["outcome"] for result in self.results("r.jsonl")], ["passed", "broken"])
        self.assertIn("more than 0.001 s of", self.run_walks("--kill-after", "0.001", "b.walk.yaml").err)


if __name__ == "__main__":
    main()
