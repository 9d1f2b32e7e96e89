#!/usr/bin/env python3
"""`campuswalk diff` and `campuswalk replay` on logs of the small campus."""

import json
import os
import re
import sys

from program import WALK, ProgramCase, main

WITHOUT_RENDERING = "--without-rendering" in sys.argv


class Compare(ProgramCase):
    """a.jsonl is a log of short.walk.yaml, and b.jsonl that of a walk of the same name that ends 0.5 m to its side."""

    def setUp(self):
        super().setUp()
        self.passes("run", "short.walk.yaml", "--jsonl", "a.jsonl", "-q")
        aside = WALK.replace("small.campus", "../small.campus").replace("walk_to: end", "walk_to: [0.5, -2]")
        self.write("other/short.walk.yaml", aside)
        self.passes("run", "other/short.walk.yaml", "--jsonl", "b.jsonl", "-q")

    def lines(self, name):
        return self.read(name).decode().splitlines()

    def refused(self, arguments, *, expected, code=2):
        before = self.contents()
        outcome = self.run_program(*arguments)
        self.assertEqual(outcome.out, "")
        self.assert_refused(outcome, expected, code=code)
        self.assertEqual(self.contents(), before)


class Diff(Compare):
    """Where two logs diverge."""

    def test_equal_logs(self):
        self.assertRegex(self.passes("diff", "a.jsonl", "a.jsonl", "--no-cache").out, "^a.jsonl .*a.jsonl .* 16 .*\n$")
        reformatted = "\n".join(json.dumps(json.loads(line)) for line in self.lines("a.jsonl"))
        self.write("c.jsonl", reformatted)
        self.assertEqual(self.passes("diff", "a.jsonl", "c.jsonl").code, 0)

    def test_the_first_divergence_with_both_sides(self):
        outcome = self.run_program("diff", "a.jsonl", "b.jsonl")
        self.assertEqual((outcome.code, outcome.err), (1, ""))
        pairs = zip(self.lines("a.jsonl"), self.lines("b.jsonl"))
        first = next(i for i, (a, b) in enumerate(pairs, 1) if a != b)
        self.assertRegex(outcome.lines[0], rf"^a.jsonl .*b.jsonl .* line {first}\b.* short\b.* 1\.000000 s ray.stay hut/wall\b.* pos "
                                           r".*0\.100,0\.000,3\.604 .*0\.000,0\.000,3\.600")
        text = self.passes("run", "short.walk.yaml").lines
        around = [f"  {i:6}  {text[i - 1]}" for i in range(first - 3, first)]
        around += [f"A {i:6}  {text[i - 1]}" for i in range(first, first + 3)]
        self.assertEqual(outcome.lines[2:8], around)
        self.assertEqual([line[:9] for line in outcome.lines[8:]], [f"B {i:6} " for i in range(first, first + 3)])

    def test_a_log_that_ends_earlier(self):
        lines = self.lines("a.jsonl")
        self.write("c.jsonl", "\n".join(lines[:5]) + "\n")
        outcome = self.run_program("diff", "a.jsonl", "c.jsonl")
        self.assertEqual(outcome.code, 1)
        self.assertRegex(outcome.lines[0], r" line 6\b.* short: B ")
        self.assertRegex(outcome.lines[-1], r"^B      6  \(")
        outcome = self.run_program("diff", "c.jsonl", "a.jsonl")
        self.assertRegex(outcome.lines[0], r" line 6\b.* short: A ")
        self.write("c.jsonl", "\n".join(lines[:5]) + "\n" + lines[5][:20])
        outcome = self.run_program("diff", "a.jsonl", "c.jsonl")
        self.assertEqual(outcome.code, 1)
        self.assertRegex(outcome.lines[0], r" line 6\b.* short: .*\bB\b.*JSON")

    def test_names_the_walk_of_several(self):
        self.write("tardy.walk.yaml", WALK)
        self.passes("run", "short.walk.yaml", "tardy.walk.yaml", "--jsonl", "c.jsonl", "-q")
        lines = self.lines("c.jsonl")
        changed = lines[:-1] + [lines[-1].replace('"result":"pass"', '"result":"fail"')]
        self.write("d.jsonl", "\n".join(changed) + "\n")
        outcome = self.run_program("diff", "c.jsonl", "d.jsonl")
        self.assertEqual(outcome.code, 1)
        self.assertRegex(outcome.lines[0], rf" line {len(lines)}\b.* tardy: .*result .*fail .*pass")

    def test_files_that_are_not_logs_are_refused(self):
        for text in ("", "{}\n", "[" * 100000, b"\x00\xff\n", "# walk-log 1 walk=a\n"):
            self.write("c.jsonl", text)
            self.refused(("diff", "a.jsonl", "c.jsonl"), expected="c.jsonl:1:1: error no-log: --jsonl")
            self.refused(("diff", "c.jsonl", "a.jsonl"), expected="c.jsonl:1:1: error no-log: --jsonl")
        self.refused(("diff", "a.jsonl", "none.jsonl"), expected="none.jsonl: error unreadable:")
        self.refused(("diff", "a.jsonl", "other"), expected="other: error unreadable:")

    def test_images_need_a_walk_and_a_folder(self):
        both = ("diff", "a.jsonl", "b.jsonl")
        self.refused(both + ("--pictures", "p"), expected="--pictures: error bad-value: --walk")
        self.refused(both + ("--walk", "short.walk.yaml"), expected="--walk: error bad-value: --pictures")
        if WITHOUT_RENDERING:
            self.refused(both + ("--pictures", "p", "--walk", "short.walk.yaml"),
                         expected="error: rendering CAMPUSWALK_RENDER=ON", code=3)
            return
        self.refused(both + ("--pictures", "p", "--walk", "short.walk.yaml", "--rendering-backend", "none"),
                     expected="--rendering-backend: error bad-value: 'none'")
        self.refused(both + ("--pictures", "a.jsonl", "--walk", "short.walk.yaml"),
                     expected="a.jsonl: error output-unwritable: 'a.jsonl'")

    def test_images_of_both_sides(self):
        if WITHOUT_RENDERING:
            self.skipTest("this build has no rendering")
        outcome = self.run_program("diff", "a.jsonl", "b.jsonl", "--pictures", "p", "--walk", "short.walk.yaml")
        self.assertEqual((outcome.code, outcome.err), (1, ""))
        self.assertEqual(outcome.lines[-2:], ["p/a.png", "p/b.png"])
        for name in ("p/a.png", "p/b.png"):
            self.assertTrue(self.read(name).startswith(b"\x89PNG"))
        self.assertNotEqual(self.read("p/a.png"), self.read("p/b.png"))
        self.assertEqual(sorted(os.listdir(self.path("p"))), ["a.png", "b.png"])

    def test_images_of_places_that_no_walk_reaches(self):
        if WITHOUT_RENDERING:
            self.skipTest("this build has no rendering")
        for far in ("1e30", "1.7e308"):
            self.write("c.jsonl", re.sub(r'"pos":\[[^,]*,', '"pos":[' + far + ",", self.read("b.jsonl").decode()))
            outcome = self.run_program("diff", "a.jsonl", "c.jsonl", "--pictures", "p", "--walk", "short.walk.yaml")
            self.assertEqual((outcome.code, outcome.err), (1, ""))
            self.assertEqual(outcome.lines[-2:], ["p/a.png", "b has no position up to there: no picture"])


class Replay(Compare):
    """Whether walks from logs and reports play the same again."""

    def result(self, **changes):
        """A line of a report about short.walk.yaml."""
        end = json.loads(self.lines("a.jsonl")[-1])
        return json.dumps({"id": "short.walk.yaml", "file": "short.walk.yaml", "name": "short", "project": "",
                           "config": "", "timeout": None, "repetition": 0, "tags": [], "status_reason": "", "expected_to_fail": False,
                           "outcome": "passed", "failures": [], "complaints": [], "campus": "small",
                           "ticks_per_second": 60, "ticks": end["tick"], "events": end["events"],
                           "distance": end["dist"], "not_evaluated": 0, "hash": end["hash"], "artifacts": [], **changes})

    def report(self, *results, missing=0):
        planned = len(results) + missing
        header = {"campuswalk_results": 6, "cases": planned, "shard": 1, "shards": 1, "all_cases": planned,
                  "contents": "0a", "division": "1b", "fingerprint": {"program": "", "options": "", "files": ""}, "start": ""}
        self.write("r.jsonl", "\n".join((json.dumps(header), *results)) + "\n")

    def test_a_replayed_log_prints_the_same(self):
        outcome = self.passes("replay", "--walk", "short.walk.yaml", "a.jsonl", "--no-cache")
        self.assertEqual(outcome.out, self.passes("run", "short.walk.yaml").out)

    def test_a_log_is_verified(self):
        verify = ("replay", "a.jsonl", "--verify", "--walk")
        lines = self.passes(*verify, "short.walk.yaml").lines
        self.assertEqual((len(lines), lines[0]), (2, "same    short.walk.yaml"))
        self.assertTrue(lines[1].startswith("1 of 1 "), lines)
        outcome = self.run_program(*verify, "other/short.walk.yaml")
        was = json.loads(self.lines("a.jsonl")[-1])["hash"]
        now = json.loads(self.lines("b.jsonl")[-1])["hash"]
        self.assertEqual(outcome.code, 1)
        self.assertRegex(outcome.lines[0], f"^DIFFERS other/short.walk.yaml: .*{now}.*{was}")
        self.assertTrue(outcome.lines[1].startswith("0 of 1 "), outcome.out)

    def test_a_walk_is_the_same_with_either_tree(self):
        for tree in "bvh8", "hybrid":
            self.assertEqual(self.passes("replay", "a.jsonl", "--verify", "--walk", "short.walk.yaml", "--tree",
                                         tree).lines[0], "same    short.walk.yaml")
            self.passes("run", "short.walk.yaml", "--tree", tree, "--log", f"{tree}.log", "--output", tree,
                        "--record", "trace", "--record", "timed-trace")
            for record in "trace", "timed-trace":
                terms = json.loads(self.read(f"{tree}/short/{record}.json"))["otherData"]
                self.assertEqual((terms["tree"], "wall_time_us" in terms), (tree, record == "timed-trace"))
                self.assertGreater(terms["Nv"], 0)
        self.assertEqual(self.lines("bvh8.log"), self.lines("hybrid.log"))
        self.assertEqual(self.run_program("run", "short.walk.yaml", "--tree", "oak").code, 2)

    def test_a_report_is_verified(self):
        self.write("left-out.walk.yaml", self.read("short.walk.yaml") + b"status: skip\n")
        skipped = self.result(id="left-out.walk.yaml", file="left-out.walk.yaml", name="left-out", outcome="skipped",
                              hash="0" * 16)
        self.report(self.result(), skipped)
        lines = self.passes("replay", "r.jsonl", "--verify").lines
        self.assertEqual(lines[:2], ["same    short.walk.yaml", "no hash left-out.walk.yaml: skipped"])
        self.assertTrue(lines[2].startswith("1 of 2 "), lines)
        self.write("left-out.walk.yaml", self.read("short.walk.yaml"))  # it isn't skipped any more
        self.report(self.result(), skipped)
        self.assertEqual(self.run_program("replay", "r.jsonl", "--verify").code, 1)
        self.report(self.result(), self.result())  # one that stands for another
        self.assertEqual(self.run_program("replay", "r.jsonl", "--verify").code, 1)
        self.report(self.result(), self.result(id="short.walk.yaml #2", hash="00000000000000ab"))
        outcome = self.run_program("replay", "r.jsonl", "--verify")
        self.assertEqual(outcome.code, 1)
        self.assertRegex(outcome.lines[1], "^DIFFERS short.walk.yaml: .*[0-9a-f]{16}.* 00000000000000ab$")

    def test_deep_nesting_is_no_log(self):
        for text in ("[" * 200_000, '{"walk_log":1,"a":' + "[" * 200_000 + "]" * 200_000 + "}"):
            self.write("deep.jsonl", text + "\n")
            self.write("deeper.jsonl", text.replace("1", "2") + "\n")
            self.assertIn(self.run_program("diff", "deep.jsonl", "deeper.jsonl").code, (0, 1, 2))

    def test_a_report_is_verified_only_if_every_walk_has_a_hash(self):
        for outcome in ("interrupted", "broken", "bad_input"):
            self.report(self.result(), self.result(outcome=outcome, hash="0" * 16))
            verified = self.run_program("replay", "r.jsonl", "--verify")
            self.assertEqual((verified.code, verified.lines[1]), (1, f"no hash short.walk.yaml: {outcome}"))
        self.report(self.result(), missing=2)
        verified = self.run_program("replay", "r.jsonl", "--verify")
        self.assertEqual(verified.code, 1)
        self.assertRegex(verified.lines[1], "^MISSING .* 2 walks: ")
        self.assertTrue(verified.lines[2].startswith("1 of 3 "), verified.lines)
        log = self.read("a.jsonl")
        self.write("c.jsonl", log + log[:log.rindex(b"\n", 0, -1) + 1])
        verified = self.run_program("replay", "c.jsonl", "--verify", "--walk", "short.walk.yaml")
        self.assertEqual((verified.code, verified.lines[1]), (1, "no hash short.walk.yaml: cut short"))

    def verifies_both(self, *arguments):
        lines = self.passes(*arguments).lines
        self.assertEqual(lines[:2], ["same    short.walk.yaml near", "same    short.walk.yaml plain"])
        self.assertEqual(len(lines), 3, lines)
        self.assertTrue(lines[2].startswith("2 of 2 "), lines)

    def test_a_run_in_projects_with_a_timeout(self):
        self.write("walks.config.yaml", "timeout: 50\nprojects: {near: {spawn: {at: [0, 0, 3]}}, plain: }\n")
        outcome = self.run_program("run", "short.walk.yaml", "--timeout", "1.5",
                                   "--jsonl", "c.jsonl", "--log", "c.log", "--reporter", "jsonl=r.jsonl")
        self.assertEqual(outcome.code, 1)
        headers = [line for line in self.lines("c.log") if line.startswith("#")]
        self.assertEqual(headers, ["# walk-log 1 walk=short campus=small tps=60 "
                                   f"project={name} timeout=1.500" for name in ("near", "plain")])
        ends = [json.loads(line)["tick"] for line in self.lines("c.jsonl") if "walk.end" in line]
        self.assertEqual(ends, [90, 90])
        self.verifies_both("replay", "r.jsonl", "--verify")
        log = ("replay", "c.jsonl", "--walk", "short.walk.yaml")
        self.verifies_both(*log, "--verify")
        self.assertEqual([line for line in self.passes(*log).lines if "expect.fail" not in line],
                         [line for line in self.lines("c.log") if "expect.fail" not in line])
        # The project is taken from today's configuration file, or from the one that is given.
        os.rename(self.path("walks.config.yaml"), self.path("other/old.config.yaml"))
        self.refused((*log, "--verify"), expected="c.jsonl:1:1: error missing-file: 'near' walks.config.yaml --config")
        self.verifies_both("replay", "r.jsonl", "--verify", "--config", "other/old.config.yaml")
        self.write("walks.config.yaml", "projects: {near: {spawn: {at: [0, 0, 4]}}, plain: }\n")
        self.assertEqual(self.run_program(*log, "--verify").code, 1)
        self.write("walks.config.yaml", "projects: {plain: }\n")
        self.refused(("replay", "r.jsonl", "--verify"),
                     expected="r.jsonl:2:1: error unknown-name: walks.config.yaml 'near' --config")

    def test_files_that_cannot_be_replayed_are_refused(self):
        self.refused(("replay", "a.jsonl", "--verify"),
                     expected="a.jsonl:1:1: error unknown-walk: --walk short.walk.yaml")
        self.refused(("replay", "short.walk.yaml", "--verify"),
                     expected="short.walk.yaml:1:1: error no-log: --jsonl --reporter")
        self.refused(("replay", "a.jsonl", "--walk", "short.walk.yaml", "--walk", "other/short.walk.yaml"),
                     expected="other/short.walk.yaml: error duplicate-name: short --walk")
        self.write("c.jsonl", self.lines("a.jsonl")[0] + "\n")
        self.refused(("replay", "c.jsonl", "--verify", "--walk", "short.walk.yaml"),
                     expected="c.jsonl: error nothing-to-replay:")
        self.report(self.result(), self.result()[:40])
        self.assertIn("r.jsonl:3:1: error no-result: ", self.run_program("replay", "r.jsonl", "--verify").err)
        self.report(self.result())
        self.refused(("replay", "r.jsonl", "--verify", "--walk", "short.walk.yaml"),
                     expected="--walk: error bad-value: report")


if __name__ == "__main__":
    if WITHOUT_RENDERING:
        sys.argv.remove("--without-rendering")
    main()
