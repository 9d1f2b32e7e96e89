#!/usr/bin/env python3
"""Which walks `run` plays: paths, expressions, projects, walks.config.yaml."""

import json
import math
import os
import re

from program import CAMPUS, WALK, ProgramCase, main

NESTED = WALK.replace("campus: small", "campus: ../small")


class Selection(ProgramCase):
    """`run --list`, which plays nothing."""

    def setUp(self):
        super().setUp()
        os.remove(self.path("short.walk.yaml"))
        for name in ("stairs", "ramp", "lift"):
            self.write(f"walks/{name}.walk.yaml", NESTED)

    def listed(self, *arguments, **options):
        return self.passes("run", "--list", *arguments, **options).lines

    def test_every_walk_below_the_current_folder(self):
        self.write("other/more.walk.yaml", NESTED)
        self.write(".cache/hidden.walk.yaml", NESTED)
        everything = ["other/more.walk.yaml", "walks/lift.walk.yaml", "walks/ramp.walk.yaml",
                      "walks/stairs.walk.yaml"]
        self.assertEqual(self.listed(), everything)
        self.assertEqual(self.listed("walks", "other", "walks/ramp.walk.yaml"), everything)
        self.assertEqual(self.listed("other"), everything[:1])

    def test_paths_are_relative_to_the_current_folder(self):
        self.write(".git/HEAD", "")  # the project is above the current folder
        self.assertEqual(self.listed(self.path("walks/lift.walk.yaml")), ["walks/lift.walk.yaml"])
        self.assertEqual(self.listed("..", cwd=self.path("avatars"))[0], "../walks/lift.walk.yaml")

    def test_expressions(self):
        self.assertEqual(self.listed("-g", "lift|ramp"), ["walks/lift.walk.yaml", "walks/ramp.walk.yaml"])
        self.assertEqual(self.listed("--grep", "walks", "--grep-invert", "(st|r)a"), ["walks/lift.walk.yaml"])
        self.assertEqual(self.listed("-G", "walks/[^s]"), ["walks/stairs.walk.yaml"])

    def test_an_invalid_expression_is_refused(self):
        outcome = self.run_program("run", "-g", "lift(")
        self.assertEqual((outcome.code, outcome.out), (2, ""))
        self.assertRegex(outcome.err, r"^--grep: error bad-regex: 'lift\('")

    def test_an_empty_selection_has_its_own_exit_code(self):
        for arguments in (("-g", "none"), ("--tag", "none"), ("avatars",)):
            outcome = self.run_program("run", *arguments)
            self.assertEqual((outcome.code, outcome.out), (5, ""), arguments)
            self.assertEqual(len(outcome.err_lines), 1)
            self.passes("run", "--pass-with-no-tests", *arguments)

    def test_listing_plays_and_writes_nothing(self):
        before = self.contents()
        self.listed()
        self.assertEqual(self.contents(), before)

    def test_walks_with_mistakes_are_listed(self):
        self.write("walks/lift.walk.yaml", NESTED.replace("walk_to: end", "walk_to: nowhere"))
        outcome = self.run_program("run", "--list")
        self.assertEqual((outcome.code, outcome.lines[0]), (2, "walks/lift.walk.yaml (has errors)"))
        self.assertEqual(self.listed("-G", "lift"), ["walks/ramp.walk.yaml", "walks/stairs.walk.yaml"])

    def test_shard_of_the_environment(self):
        def shard(**variables):
            return self.listed(env={**os.environ, **variables})
        parts = [shard(CAMPUSWALK_SHARD_INDEX=str(i), CAMPUSWALK_SHARD_COUNT="2") for i in range(2)]
        self.assertEqual(parts[0] + parts[1], self.listed())
        bazel = shard(TEST_SHARD_INDEX="1", TEST_TOTAL_SHARDS="2", TEST_SHARD_STATUS_FILE=self.path("touched"))
        self.assertEqual(bazel, parts[1])
        self.assertEqual(self.read("touched"), b"")
        self.assertEqual(self.listed("--shard=2/2"), parts[1])
        self.assertEqual(self.listed("--shard", "4/4"), ["walks/stairs.walk.yaml"])

    def test_invalid_shards_are_refused(self):
        for arguments, variables in ((("--shard=3/2",), {}), ((), {"CAMPUSWALK_SHARD_INDEX": "1"})):
            outcome = self.run_program("run", *arguments, env={**os.environ, **variables})
            self.assertEqual((outcome.code, outcome.out), (2, ""))
            self.assertIn(" error bad-shard: ", outcome.err)


class Status(ProgramCase):
    """The keys `status` and `tags` of a walk."""

    FAILING = WALK.replace('never: "collision.enter hut/wall"', "never: popup.open hut")

    def run_walks(self, *arguments, **options):
        return self.run_program("run", "--rendering-backend", "none", *arguments, **options)

    def test_tags(self):
        self.write("other.walk.yaml", WALK + "tags: [smoke, door]\n")
        self.assertEqual(self.passes("run", "--list", "--tag", "door", "--tag", "none").lines,
                         ["other.walk.yaml @smoke @door"])
        self.assertEqual(self.passes("run", "--list", "-G", "smoke").lines, ["short.walk.yaml"])

    def test_a_walk_with_mistakes_may_have_any_tag(self):
        self.write("short.walk.yaml", WALK.replace("walk_to: end", "walk_to: nowhere"))
        self.assertEqual(self.run_walks("--tag", "door").code, 2)

    def test_skipped_walks_do_not_run(self):
        self.write("short.walk.yaml", WALK + "status: {is: skip, because: the door is being painted}\n")
        self.assertEqual(self.passes("run", "--list").lines, ["short.walk.yaml (skip: the door is being painted)"])
        outcome = self.run_walks("short.walk.yaml")
        self.assertEqual((outcome.code, outcome.out, outcome.err), (0, "", "short: skipped: the door is being painted\n"))

    def test_only_excludes_other_walks(self):
        self.write("other.walk.yaml", WALK + "status: only\n")
        self.assertEqual(self.passes("run", "--list").lines, ["other.walk.yaml"])
        for arguments, ci in ((("--forbid-only",), ""), ((), "true")):
            outcome = self.run_program("run", *arguments, env={**os.environ, "CI": ci})
            self.assertEqual((outcome.code, outcome.out), (2, ""))
            self.assertRegex(outcome.err, r"^other.walk.yaml:\d+:\d+: error only-forbidden: ")

    def test_the_summary_tells_how_many_walks_only_leaves_out(self):
        for name, status in (("other", "status: only\n"), ("third", "")):
            self.write(name + ".walk.yaml", WALK + status)
        outcome = self.run_program("run", "--rendering-backend", "none")
        self.assertEqual(outcome.code, 0)
        self.assertEqual(outcome.err_lines[-1], "2 walks not run, because others are marked 'status: only'")

    def test_expected_failures_pass(self):
        self.write("short.walk.yaml", self.FAILING + "status: {is: xfail, because: the hut has a window, "
                                                     "failures: [never]}\n")
        outcome = self.run_walks("-q", "short.walk.yaml")
        self.assertEqual(outcome.code, 0)
        self.assertRegex(outcome.err, r"^short: fails as expected after .* m: the hut has a window\n$")
        self.write("short.walk.yaml", WALK + "status: xfail\n")
        self.assertEqual(self.run_walks("-q").code, 1)


class Strict(ProgramCase):
    """`--strict` and `--min-cases`: nothing passes that wasn't evaluated."""

    SNAPSHOT = WALK.replace("turn: 180", "snapshot: view") + "  - visible: {building: hut, in: view}\n"

    def run_walks(self, *arguments):
        return self.run_program("run", "-q", "--rendering-backend", "none", *arguments)

    def refused(self, text, expected, *arguments):
        self.write("short.walk.yaml", text)
        self.assertNotEqual(self.run_walks().code, 2, "without --strict")
        outcome = self.run_walks("--strict", *arguments)
        self.assert_refused(outcome, "short.walk.yaml:" + expected)

    def refused_at(self, text, pattern):
        self.write("short.walk.yaml", text)
        self.assertNotEqual(self.run_walks().code, 2, "without --strict")
        outcome = self.run_walks("--strict")
        self.assertEqual(outcome.code, 2)
        self.assertRegex(outcome.err, r"(?m)^short.walk.yaml:" + pattern)

    def test_a_walk_that_judges_what_it_says_passes(self):
        self.assertEqual(self.run_walks("--strict").code, 0)

    def test_a_walk_must_run_and_may_fail_in_one_way_only(self):
        self.refused(WALK + "status: {is: skip, because: painting}\n", "10:9: error strict: skip")
        self.refused(WALK + "status: xfail\n", "10:9: error strict: xfail failures")
        self.refused(WALK + "status: only\n", "10:9: error only-forbidden: only")

    def test_a_walk_that_expects_nothing_is_warned_of_and_refused(self):
        nothing = WALK[:WALK.index("expect:")]
        self.write("short.walk.yaml", nothing)
        warned = self.run_walks()
        self.assertEqual(warned.code, 0)
        self.assert_diagnostics(warned.err_lines[:1], "short.walk.yaml: warning expects-nothing: expect")
        self.assertIn("expects-nothing", self.passes("validate", "short.walk.yaml").err)
        self.write("short.walk.yaml", nothing + "  - expect: {popup: hut}\n")
        self.assertEqual(self.run_walks("--strict").code, 0)
        self.write("short.walk.yaml", nothing)
        outcome = self.run_walks("--strict")
        self.assertEqual(outcome.code, 2)
        self.assertRegex(outcome.err, "short.walk.yaml: error strict: ")

    def test_expectations_that_cant_fail_are_refused(self):
        head = WALK[:WALK.index("expect:")] + "expect:\n  - "
        for vacuous, judged in (("no_penetration: {tolerance: 0.3}", "no_penetration: {tolerance: 0.1}"),
                                ("duration: {at_least: 0}", "duration: {at_least: 1}"),
                                ("near: {place: end, within: 1000000}", "near: {place: end, within: 1}"),
                                ("visits: {ratio: 0}", "visits: {ratio: 1}"),
                                ("count: {event: avatar.fell, at_least: 0}", "count: {event: popup.open, at_least: 1}"),
                                ("grounded: {ratio: 0}", "grounded: {ratio: 0.5}"),
                                ("sequence: [walk.start]", "sequence: [popup.open]"),
                                ("log: {golden: false}", "never: avatar.fell")):
            self.refused_at(head + vacuous + "\n", r"8:\d+: error strict: '.*' can't fail")
            self.write("short.walk.yaml", head + judged + "\n")
            self.assertEqual(self.run_walks("--strict").code, 0, judged)
        self.refused_at(head + "not: {within: {after: walk.end, event: '*', seconds: 1}}\n",
                        r"8:\d+: error strict: 'not-within' can't fail")
        self.refused_at(head + "not: {popup: {building: hut, title: Castle}}\n", r"8:\d+: error strict: 'not-popup' can't fail")
        self.refused_at(WALK.replace("  - turn: 180", "  - expect: {count: {event: popup.open, at_least: 0}}"),
                     r"6:\d+: error strict: 'count' can't fail")

    def test_failures_that_are_expected_and_certain_are_refused(self):
        for code, certain in (("reaches", "reaches: [5000, 5000]"), ("count", "count: {event: walk.end, equals: 2}"),
                              ("sequence", "sequence: [walk.end, walk.start]"), ("never", "never: walk.start"),
                              ("not-distance", "not: {distance: {at_least: 0}}")):
            text = WALK[:WALK.index("expect:")] + f"expect:\n  - {certain}\n"
            text += f"status: {{is: xfail, because: x, failures: [{code}]}}\n"
            self.refused_at(text, rf"8:\d+: error strict: '{code}' fails like this whatever the walk does")
        text = WALK + "status: {is: xfail, because: x, failures: [timeout]}\ntimeout: 0.02\n"
        self.refused_at(text, r"10:\d+: error strict: 'timeout' fails like this")

    def test_an_xfail_decides_all_that_it_expects(self):
        """What follows a step that fails is never evaluated."""
        steps = WALK[:WALK.index("expect:")] + "  - walk_to: {to: [0, 90], timeout: 200}\n%s"
        status = "status: {is: xfail, because: x, failures: [%s]}\n"
        self.write("short.walk.yaml", steps % status % "fell")
        self.assertEqual(self.run_walks("--strict").code, 0)
        self.write("short.walk.yaml", steps % "expect:\n  - never: avatar.landed\n" + status % "fell")
        self.assertEqual(self.run_walks().code, 0)
        outcome = self.run_walks("--strict")
        self.assertEqual(outcome.code, 1)
        self.assertRegex(outcome.err, r"short.walk.yaml:9:\d+: error not-evaluated: the walk failed at a step before")
        self.write("short.walk.yaml", steps % "  - expect: [{never: avatar.landed}]\n" + status % "fell")
        self.assertEqual(self.run_walks("--strict").code, 1)
        self.write("short.walk.yaml", steps % "expect:\n  - never: walk.start\n" + status % "fell, never")
        self.assertNotIn("error not-evaluated", self.run_walks("--strict").err)

    def test_waiting_for_what_a_step_causes_expects_nothing(self):
        text = WALK[:WALK.index("expect:")] + "  - disable: hut/wall\n  - wait_until: {event: '*', timeout: 10}\n"
        self.refused_at(text, " error strict: the walk expects nothing")

    def test_a_fall_at_the_start_is_announced(self):
        falling = WALK.replace("spawn: start", "spawn: %s")
        for spawn in ("{at: [0, 0.6, 5]}", "{at: [0, 3, 5]}", "{at: [50, 0, 5]}"):
            self.write("short.walk.yaml", falling % spawn)
            for command in (("run", "-q"), ("validate",)):
                outcome = self.run_program(*command, "short.walk.yaml")
                self.assertEqual(outcome.code, 2)
                self.assertRegex(outcome.err, r"(?m)^short.walk.yaml:4:\d+: error spawn-in-air: .*fall: true")
        self.write("short.walk.yaml", falling % "{at: [0, 0.6, 5], fall: true}")
        self.assertNotIn("error strict", self.run_walks("--strict").err)
        self.refused_at(falling % "{at: [0, 0.4, 5], fall: true}", r"4:\d+: error strict: 'fall: true' .* 0.40 m")
        self.refused_at(falling % "{at: start, fall: true}", r"4:\d+: error strict: 'fall: true' .* 0.00 m")
        self.write("short.walk.yaml", falling % "{at: start, yaw_deg: 10, fall: false}")
        self.assertNotIn("error", self.run_walks("--strict").err)
        self.write("small.campus.yaml", CAMPUS.replace("at: [0, 0, 5]", "at: [0, 2, 5], fall: true"))
        self.write("short.walk.yaml", WALK)
        self.assertNotIn("error strict", self.run_walks("--strict").err)

    def test_tolerances_are_the_default_or_tighter(self):
        walk = WALK.replace("turn: 180", "snapshot: view") + "  - snapshot: %s\n"
        for looser in ("threshold: 0.3", "max_diff_pixels: 1", "max_diff_pixel_ratio: 0.01", "min_tile_ssim: 0.9",
                       "masks: [[0, 0, 10, 10]]"):
            self.refused(walk % ("{name: view, " + looser + "}"), "10:22: error strict: tolerance")
        self.write("short.walk.yaml", walk % "{name: view, threshold: 0.1, max_diff_pixels: 0}")
        self.assertNotIn("error strict", self.run_walks("--strict").err)
        self.write("walks.config.yaml", "snapshots: {threshold: 0.3}\n")
        self.refused(walk % "view", "10:15: error strict: tolerance")

    def test_images_that_nothing_draws_are_counted_and_fail(self):
        self.write("short.walk.yaml", self.SNAPSHOT)
        names = ("json", "jsonl", "junit", "tap", "dot", "list", "github", "markdown")
        reporters = [argument for name in names for argument in ("--reporter", f"{name}={name}")]
        self.assertEqual(self.run_walks(*reporters).code, 0)
        self.assertEqual(json.loads(self.read("json"))["summary"]["not_evaluated"], 1)
        self.assertEqual(json.loads(self.read("jsonl").splitlines()[1])["not_evaluated"], 1)
        for name in ("junit", "tap", "dot", "list", "github", "markdown"):
            self.assertIn(b"1 expectation not evaluated", self.read(name), name)
        outcome = self.run_walks("--strict")
        self.assertEqual(outcome.code, 1)
        self.assertRegex(outcome.err, r"short.walk.yaml:10:\d+: error not-evaluated: ")

    def test_a_walk_that_must_fail_in_images_is_not_left_out(self):
        self.write("short.walk.yaml", self.SNAPSHOT + "status: {is: xfail, failures: [visible]}\n")
        self.assertEqual(self.run_walks().code, 0)
        self.assertEqual(self.run_walks("--strict").code, 1)

    def test_a_configuration_file_can_ask_for_it(self):
        self.write("short.walk.yaml", WALK + "status: xfail\n")
        self.write("strict.config.yaml", "strict: true\nmin_cases: 2\n")
        outcome = self.run_walks("--config", "strict.config.yaml", "--min-cases", "1")
        self.assertEqual(outcome.code, 2)
        self.assertIn("error strict: ", outcome.err)
        outcome = self.run_walks("--config", "strict.config.yaml")
        self.assert_refused(outcome, *outcome.err_lines[:-1], "--min-cases: error too-few-cases: 1 2")

    def test_links_copies_and_projects_make_no_more_of_a_walk(self):
        for i in range(3):
            os.symlink("short.walk.yaml", self.path("link%d.walk.yaml" % i))
        for strict in (), ("--strict",):
            self.assertEqual(self.run_walks("--min-cases", "1", *strict).code, 0)
            self.assert_refused(self.run_walks("--min-cases", "2", *strict),
                                "--min-cases: error too-few-cases: 1 2 3 files same")
        self.write("copy.walk.yaml", WALK)
        self.assertEqual(self.run_walks("--min-cases", "2").code, 0)
        self.assert_refused(self.run_walks("--min-cases", "2", "--strict"),
                            "--min-cases: error too-few-cases: 1 2 4 files same")
        self.write("other.walk.yaml", WALK.replace("walk_to: end", "walk_to: {to: end, speed: 1}"))
        self.write("walks.config.yaml", "projects: {a: , b: }\n")
        self.assertEqual(self.run_walks("--min-cases", "2", "--strict").code, 0)
        self.assert_refused(self.run_walks("--min-cases", "3", "--strict"), "--min-cases: error too-few-cases: 2 3")

    def test_fewer_cases_than_asked_for_are_an_error(self):
        self.write("other.walk.yaml", WALK)
        for shard in (), ("--shard", "2/2"):
            self.assertEqual(self.run_walks("--min-cases", "2", *shard).code, 0)
            self.assert_refused(self.run_walks("--min-cases", "3", *shard), "--min-cases: error too-few-cases: 2 3")
        self.assert_refused(self.run_walks("--min-cases", "2", "-g", "other"),
                            "--min-cases: error too-few-cases: 1 2")
        self.assertEqual(self.run_walks("--min-cases", "1", "-g", "nothing").code, 2)
        self.write("walks.config.yaml", "projects: {a: , b: }\n")
        self.assert_refused(self.run_walks("--min-cases", "3", "--repeat-each", "2"),
                            "--min-cases: error too-few-cases: 2 3")


class GoldenLog(ProgramCase):
    """`expect: log`, `-u` and CI."""

    GOLDEN = "short.walk.yaml-snapshots/log.jsonl"

    def setUp(self):
        super().setUp()
        self.write("short.walk.yaml", WALK + "  - log: {golden: true}\n")

    def run_walk(self, *arguments, ci=""):
        environment = {**os.environ, "CI": ci}
        return self.run_program("run", "-q", "--rendering-backend", "none", *arguments, "short.walk.yaml", env=environment)

    def test_fails_while_it_is_missing(self):
        before = self.contents()
        missing = self.run_walk()
        self.assertEqual(missing.code, 1)
        self.assertRegex(missing.err_lines[0], r"^short.walk.yaml:10:\d+: error golden-missing: .*" + re.escape(self.GOLDEN))
        self.assertEqual(self.contents(), before)

    def test_no_walk_is_expected_to_fail_for_want_of_it(self):
        walk = self.read("short.walk.yaml").decode("utf-8") + "status: {is: xfail, %s}\n"
        for status in ("failures: [log]", "because: the hut has moved"):
            self.write("short.walk.yaml", walk % status)
            outcome = self.run_walk()
            self.assertEqual(outcome.code, 1)
            self.assertRegex(outcome.err, "error xfail: .*can't be evaluated: golden-missing")
        self.write("short.walk.yaml", walk % "failures: [golden-missing]")
        self.assert_refused(self.run_walk(), "short.walk.yaml:11:32: error bad-value: golden-missing")

    def test_is_written_on_request_and_then_compared(self):
        first = self.run_walk("-u")
        self.assertEqual((first.code, first.err_lines[0]), (0, "wrote " + self.GOLDEN))
        golden = self.read(self.GOLDEN)
        self.assertEqual(len(self.run_walk().err_lines), 1)
        self.write("short.walk.yaml", self.read("short.walk.yaml").replace(b"turn: 180", b"turn: 170"))
        changed = self.run_walk("--reporter", "json=report.json")
        self.assertEqual(changed.code, 1)
        self.assertRegex(changed.err_lines[0], r"^short.walk.yaml:10:\d+: error log: ")
        (failure,) = json.loads(self.read("report.json"))["results"][0]["failures"]
        self.assertAlmostEqual(failure["scene"]["yaw_rad"], math.radians(170), msg="turned all the way by then")
        self.assertEqual(self.read(self.GOLDEN), golden)
        self.assertEqual(self.run_walk("--update-snapshots=none").code, 1)
        self.assertEqual(self.run_walk("-u").code, 0)
        self.assertNotEqual(self.read(self.GOLDEN), golden)
        self.assertEqual(self.run_walk().code, 0)

    def test_is_not_written_for_a_walk_that_fails(self):
        self.write("short.walk.yaml", WALK.replace('never: "collision.enter hut/wall"', "never: popup.open hut") +
                   "  - log: {golden: true}\n")
        for arguments in (("-u",), ("--update-snapshots=all",), ("--update-snapshots=missing",)):
            outcome = self.run_walk(*arguments)
            self.assertEqual(outcome.code, 1)
            self.assertRegex(outcome.err_lines[0], "^not written.*" + re.escape(self.GOLDEN))
            self.assertNotIn(self.GOLDEN, self.contents())
        self.write("short.walk.yaml", self.read("short.walk.yaml") + b"status: {is: xfail, failures: [never]}\n")
        outcome = self.run_walk("-u")  # fails as expected
        self.assertEqual((outcome.code, outcome.err_lines[0]), (0, "wrote " + self.GOLDEN))

    def test_is_never_written_in_ci(self):
        before = self.contents()
        self.assertEqual(self.run_walk(ci="true").code, 1)
        outcome = self.run_walk("--update-snapshots=all", ci="true")
        self.assertEqual((outcome.code, outcome.out), (2, ""))
        self.assertIn("--update-snapshots: error bad-value: ", outcome.err)
        self.assertEqual(self.contents(), before)

    def test_update_modes(self):
        self.assertEqual(self.run_walk("--update-snapshots=sometimes").code, 2)
        self.assertEqual(json.loads(self.passes("run", "-u", "--print-config").out)
                         ["update_snapshots"], "changed")

    def test_each_project_has_its_own(self):
        self.write("walks.config.yaml", "projects: {plain: , near: {spawn: {at: [0, 0, 3]}}}\n")
        self.assertEqual(self.run_walk("-u").code, 0)
        self.assertEqual(self.run_walk("--workers", "2", ci="true").code, 0)
        for name in ("plain", "near"):
            self.assertIn(f"short.walk.yaml-snapshots/{name}-log.jsonl", self.contents())


class Config(ProgramCase):
    """walks.config.yaml and its projects."""

    def setUp(self):
        super().setUp()
        self.write("walks/one.walk.yaml", NESTED)
        self.write("walks/two.walk.yaml", NESTED)
        self.write("avatars/child.avatar.yaml", "height: 1.2\nradius: 0.2\neye_height: 1.1\nspeed: 0.9\n")
        self.write("east.campus.yaml", CAMPUS.replace("[0, 0, 5]", "[3, 0, 5]").replace("[0, 0, -2]", "[3, 0, -2]"))
        self.write("walks.config.yaml", "walks: walks\nreporters: [tap]\nprojects:\n  young: {avatar: child, grep: one}\n"
                                        "  east: {campus: east.campus.yaml}\n  near: {spawn: {at: [0, 0, 3]}}\n")

    def test_every_walk_in_every_project(self):
        expected = [f"walks/{walk}.walk.yaml {project}" for walk, projects in
                    (("one", ("east", "near", "young")), ("two", ("east", "near"))) for project in projects]
        self.assertEqual(self.passes("run", "--list").lines, expected)
        self.assertEqual(self.passes("run", "--list", cwd=self.path("avatars")).lines,
                         ["../" + line for line in expected])
        self.assertEqual(self.passes("run", "--list", "--project", "young").lines, ["walks/one.walk.yaml young"])

    def test_overrides_of_a_project_apply(self):
        def log(project):
            return self.run_program("run", "--reporter", "log", "--project", project, "walks/one.walk.yaml").lines
        self.assertIn(" pos=3.000,0.000,5.000 ", log("east")[1])
        self.assertIn(" pos=0.000,0.000,3.000 ", log("near")[1])
        self.assertIn(" campus=east ", log("east")[0])
        self.assertGreater(int(log("young")[-1].split()[0]), int(log("near")[-1].split()[0]))  # a slow avatar

    def test_reporters_of_the_command_line_replace_those_of_the_file(self):
        self.assertEqual(self.run_program("run").lines[0], "TAP version 14")
        self.assertNotIn("TAP", self.run_program("run", "--reporter", "dot").out)

    def test_reporters_of_the_file_apply_to_a_single_walk(self):
        self.write("walks.config.yaml", "reporters: [{tap: out/one.tap}]\n")
        outcome = self.passes("run", "walks/one.walk.yaml")
        self.assertTrue(outcome.lines[0].startswith("# walk-log 1 walk=one "), outcome.lines[0])
        self.assertIn(b"\nok 1 ", self.read("out/one.tap"))
        self.write("walks.config.yaml", "reporters: [tap]\n")
        self.assertEqual(self.passes("run", "walks/one.walk.yaml").lines[0], "TAP version 14")
        self.assertEqual(self.passes("run", "--reporter", "dot", "walks/one.walk.yaml").out.count("TAP"), 0)

    def test_a_walk_that_cannot_be_read_is_reported(self):
        self.write("walks.config.yaml", "reporters: [{tap: out/one.tap}]\n")
        self.write("walks/one.walk.yaml", "campus: none.campus.yaml\n")
        self.assertEqual(self.run_program("run", "walks/one.walk.yaml").code, 2)
        self.assertIn(b"\nnot ok 1 ", self.read("out/one.tap"))

    def test_another_configuration_file(self):
        self.write("ci/walks.config.yaml", "walks: ../walks\nworkers: 3\noutput: results\n")
        outcome = self.passes("run", "--config", "ci/walks.config.yaml", "--print-config", "-j", "1")
        found = json.loads(outcome.out)
        self.assertEqual((found["walks"], found["workers"], found["output"]), (["walks"], 1, "ci/results"))

    def test_mistakes_are_reported_once_at_their_place(self):
        self.write("walks.config.yaml", "projects:\n  young: {avatar: chidl}\n")
        outcome = self.run_program("run")
        self.assertEqual(outcome.code, 2)
        self.assertEqual(len(outcome.err_lines), 1)  # once for all walks
        self.assertRegex(outcome.err, r"^walks.config.yaml:2:19: error unknown-name: ")
        outcome = self.run_program("run", "--project", "yuong")
        self.assertEqual((outcome.code, outcome.out), (2, ""))
        self.assertIn("'young'", outcome.err)
        self.write("walks.config.yaml", "reporters: [junti]\n")
        outcome = self.run_program("run")
        self.assertRegex(outcome.err, r"^walks.config.yaml:1:13: error unknown-name: .*'junit'")
        self.assertEqual(outcome.code, 2)


if __name__ == "__main__":
    main()
