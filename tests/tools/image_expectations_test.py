#!/usr/bin/env python3
"""`expect: snapshot` and `visible`. `image_expectations_test.py PROGRAM [--without-rendering]`."""

import json
import os
import sys
import unittest

from program import WALK, ProgramCase, main

WITHOUT_RENDERING = "--without-rendering" in sys.argv
EXAMPLES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "config", "walks", "expectations")

STEPS = WALK[:WALK.index("expect:")].replace(
    "  - turn: 180", "  - snapshot: {name: hut, width: 96, height: 64}\n"
                     "  - turn: 180\n"
                     "  - snapshot: {name: away, width: 96, height: 64}")
REFERENCE = "short.walk.yaml-snapshots/hut.png"


class ImageCase(ProgramCase):
    def walk(self, *expectations, head=""):
        self.write("short.walk.yaml", head + STEPS + "expect:\n" + "".join("  - %s\n" % each for each in expectations))

    def run_walk(self, *arguments):
        return self.run_program("run", "short.walk.yaml", *arguments)

    def failures(self, *arguments):
        """[(code, message)] from the report."""
        self.run_walk("--reporter", "json=report.json", *arguments)
        return [(each["code"], each["message"]) for each in self.result()["failures"]]

    def result(self):
        return json.loads(self.read("report.json"))["results"][0]


@unittest.skipIf(WITHOUT_RENDERING, "this build draws nothing")
class Snapshots(ImageCase):
    def setUp(self):
        super().setUp()
        self.walk("snapshot: hut")

    def change(self):
        """Makes the image of the next run differ."""
        self.write("small.campus.yaml", self.read("small.campus.yaml").replace(b"end: [0, 0, -2]", b"end: [0, 0, 0]"))

    def test_pictures_without_their_textures_are_not_compared(self):
        self.write("room.mtl", "newmtl brick\nmap_Kd gone.png\n")
        self.write("room.obj", b"mtllib room.mtl\nusemtl brick\n" + self.read("room.obj"))
        self.write("short.walk.yaml", WALK)
        self.assertEqual(self.run_walk().code, 0)
        self.walk("visible: {building: hut, in: hut}")
        outcome = self.run_walk()
        self.assertEqual(outcome.code, 2)
        self.assertRegex(outcome.err_lines[-1], r"^small.campus.yaml:2:\d+: error bad-texture: .*'gone.png'")

    def test_a_missing_reference_fails_and_is_written_on_request(self):
        for ci in ("", "1"):
            outcome = self.run_program("run", "short.walk.yaml", env={**os.environ, "CI": ci})
            self.assertEqual(outcome.code, 1)
            self.assertIn("'%s'" % REFERENCE, outcome.err)
            self.assertNotIn(REFERENCE, self.contents())
        outcome = self.run_walk("-u")
        self.assertEqual((outcome.code, outcome.err_lines[0]), (0, "wrote " + REFERENCE))
        self.assertEqual(self.read(REFERENCE), self.read("out/short/hut.png"))
        self.assertEqual(self.run_program("run", "short.walk.yaml", env={**os.environ, "CI": "1"}).code, 0)
        self.assert_refused(self.run_program("run", "short.walk.yaml", "-u", env={**os.environ, "CI": "1"}),
                            "--update-snapshots: error bad-value: logs images CI")

    def test_another_image_fails_and_is_attached(self):
        log = self.run_walk("-u").out
        self.change()
        outcome = self.run_walk("--reporter", "json=report.json", "--reporter", "junit=junit.xml")
        self.assertEqual(outcome.code, 1)
        (failure,) = self.result()["failures"]
        self.assertEqual((failure["code"], failure["line"]), ("snapshot", 10))
        self.assertRegex(failure["message"], "'hut'.*hut.png.*pixels.*--update-snapshots=changed")
        paths = [each["path"] for each in self.result()["artifacts"]]
        for which in ("actual", "expected", "diff"):
            self.assertIn("short/hut-%s.png" % which, paths)
            self.assertIn("short/hut-%s.png" % which, self.read("junit.xml").decode())
        self.assertEqual(self.read("out/short/hut-expected.png"), self.read(REFERENCE))
        self.assertEqual(self.read("out/short/hut-actual.png"), self.read("out/short/hut.png"))
        self.assertNotIn("snapshot-passes", log)
        self.assertNotIn("expect.fail", self.run_walk().out, "images aren't in the log")

        outcome = self.run_walk("-u")
        self.assertEqual((outcome.code, outcome.err_lines[0]), (0, "wrote " + REFERENCE))
        self.assertEqual(self.read(REFERENCE), self.read("out/short/hut.png"))
        self.assertNotIn("out/short/hut-diff.png", self.contents(), "the previous run's files are removed")

    def test_a_walk_that_fails_otherwise_writes_no_reference(self):
        self.write("short.walk.yaml", self.read("short.walk.yaml") + b"  - never: popup.open hut\n")
        for mode in ("-u", "--update-snapshots=all", "--update-snapshots=missing"):
            outcome = self.run_walk(mode)
            self.assertEqual(outcome.code, 1)
            self.assertIn("not written, because the walk fails: " + REFERENCE, outcome.err_lines)
            self.assertNotIn(REFERENCE, self.contents())

    def test_a_failed_image_expectation_keeps_the_golden_log_from_being_written(self):
        self.walk("snapshot: hut")
        self.write("short.walk.yaml", self.read("short.walk.yaml") + b"  - log: {golden: true}\n"
                   b"  - visible: {building: hut, in: hut, min_pixels: 1000000}\n")
        self.assertEqual(self.run_walk("-u").code, 1)
        self.assertFalse([name for name in self.contents() if "-snapshots/" in name])

    def test_update_modes(self):
        self.run_walk("-u")
        before = self.read(REFERENCE)
        self.change()
        for mode in ("none", "missing"):
            self.assertEqual(self.run_walk("--update-snapshots=" + mode).code, 1)
            self.assertEqual(self.read(REFERENCE), before)
        self.assertEqual(self.run_walk("--update-snapshots=all").code, 0)
        self.assertNotEqual(self.read(REFERENCE), before)
        os.remove(self.path(REFERENCE))
        self.assertEqual(self.run_walk("--update-snapshots=none").code, 1)
        self.assertEqual(self.run_walk("--update-snapshots=missing").code, 0)

    def test_tolerances_of_the_walk_and_of_all_walks(self):
        self.run_walk("-u")
        self.change()
        lax = "{min_tile_ssim: -1, max_diff_pixel_ratio: 1}"
        self.walk("snapshot: {name: hut, min_tile_ssim: -1, max_diff_pixel_ratio: 1}")
        self.assertEqual(self.run_walk().code, 0)
        self.walk("snapshot: {name: hut, masks: [[0, 0, 96, 64]]}")
        self.assertEqual(self.run_walk().code, 0)
        self.walk("snapshot: {name: hut, masks: [[0, 0, 96, 2]]}")
        self.assertEqual(self.run_walk().code, 1)
        self.walk("snapshot: hut")
        self.write("walks.config.yaml", "snapshots: %s\n" % lax)
        self.assertEqual(self.run_walk().code, 0)
        shown = json.loads(self.run_walk("--print-config").out)["snapshots"]
        self.assertEqual(shown, {"threshold": 0.2, "max_diff_pixels": None, "max_diff_pixel_ratio": 1.0,
                                 "min_tile_ssim": -1.0, "masks": []})
        self.walk("snapshot: {name: hut, min_tile_ssim: 1}")
        self.assertEqual(self.run_walk().code, 1, "the walk takes precedence")

    def test_projects_have_their_own_references(self):
        self.write("walks.config.yaml", "projects: {near: {}, far: {spawn: {at: [0, 0, 6]}}}\n")
        self.run_walk("-u")
        self.assertIn("short.walk.yaml-snapshots/near-hut.png", self.contents())
        self.assertIn("short.walk.yaml-snapshots/far-hut.png", self.contents())

    def test_other_size_and_broken_file(self):
        self.run_walk("-u")
        os.rename(self.path("out/short/away.png"), self.path(REFERENCE))
        self.write("short.walk.yaml", self.read("short.walk.yaml").replace(b"hut, width: 96", b"hut, width: 97"))
        ((code, message),) = self.failures()
        self.assertEqual(code, "snapshot")
        self.assertRegex(message, "97x64.*96x64")
        self.assertIn("out/short/hut-expected.png", self.contents())
        self.assertNotIn("out/short/hut-diff.png", self.contents())
        self.write(REFERENCE, "no picture")
        self.assertIn("PNG", self.failures()[0][1])
        self.assertEqual(self.failures("-u"), [])

    def test_snapshot_that_was_never_taken(self):
        self.run_walk("-u")
        self.write("short.walk.yaml", self.read("short.walk.yaml").replace(b"  - walk_to: end",
                                                                           b"  - walk_to: {to: [0, -8], timeout: 4}"))
        [message] = [message for code, message in self.failures() if code in ("snapshot", "snapshot-missing")]
        self.assertIn("'hut'", message)

    def test_unknown_snapshots_are_refused(self):
        self.walk("snapshot: hat", "visible: {building: hut, in: hot}")
        outcome = self.run_walk()
        self.assert_refused(outcome, "short.walk.yaml:10:15: error unknown-name: 'hat' 'hut'",
                            "short.walk.yaml:11:34: error unknown-name: 'hot' 'hut'")

    def test_image_expectations_do_not_change_the_log(self):
        self.walk("grounded")
        without = self.run_walk("--jsonl", "a.jsonl")
        self.walk("grounded", "snapshot: hut", "visible: {building: hut, in: hut}")
        self.assertEqual(self.run_walk("--jsonl", "b.jsonl").out, without.out)
        self.assertEqual(self.read("a.jsonl"), self.read("b.jsonl"))


@unittest.skipIf(WITHOUT_RENDERING, "this build draws nothing")
class Visible(ImageCase):
    def test_in_sight_and_behind(self):
        self.walk("visible: {building: hut, in: hut}", "not: {visible: {building: hut, in: away}}")
        self.assertEqual(self.failures(), [])
        self.walk("visible: {building: hut, in: away, min_ratio: 0.1}", "not: {visible: {building: hut, in: hut}}")
        (there, here) = self.failures()
        self.assertEqual((there[0], here[0]), ("visible", "not-visible"))
        self.assertRegex(there[1], r"^0 .*'hut' .*'away' .*0\.000 %.* 1 .*10\.000 %")
        self.assertRegex(here[1], r"^[1-9][0-9]+ .*'hut' .*'hut' .*[0-9.]+ %.* 1 ")

    def test_limits(self):
        """The wall's upper and lower edge and its sides are known: it is 2 m wide, 3 m high and 2 m ahead."""
        self.walk("not: {visible: {building: hut, in: hut}}")
        seen = int(self.failures()[0][1].split(" ")[0])
        self.walk("visible: {building: hut, in: hut, min_pixels: %d}" % seen)
        self.assertEqual(self.failures(), [])
        self.walk("visible: {building: hut, in: hut, min_pixels: %d}" % (seen + 1))
        self.assertEqual(len(self.failures()), 1)
        self.walk("visible: {building: \"h*\", in: hut, min_ratio: %.6f}" % (seen / 96 / 64 - 1e-5))
        self.assertEqual(self.failures(), [])
        self.walk("visible: {building: hut, in: hut, min_ratio: %.6f}" % (seen / 96 / 64 + 1e-5))
        self.assertEqual(len(self.failures()), 1)
        # 60 degrees across 64 rows from 2 m: a column is 27.7 pixels per metre, so 2 m are 55.4 pixels wide.
        self.assertGreater(seen, 55 * 40)
        self.assertLess(seen, 57 * 64)

    def test_unknown_buildings_are_refused(self):
        self.walk("visible: {building: hat, in: hut}")
        outcome = self.run_walk()
        self.assert_refused(outcome, "short.walk.yaml:10:25: error unknown-name: 'hat' 'hut'")


class PicturesOfFailures(ImageCase):
    def failures(self):
        return sorted(name for name in self.contents() if os.path.basename(name).startswith("failure-"))

    def test_go_when_the_walk_passes(self):
        for arguments in ((), ("--rendering-backend", "none")):
            self.write("short.walk.yaml", WALK + "  - never: trigger.enter\n  - never: ray.enter\n")
            self.run_program("run", "short.walk.yaml")
            self.assertGreaterEqual(len(self.failures()), 0 if WITHOUT_RENDERING else 4)
            self.write("out/short/failure-3-eyes.png", "of a run before that")
            self.write("out/short/failure.txt", "mine")
            self.write("short.walk.yaml", WALK)
            self.passes("run", "short.walk.yaml", *arguments)
            self.assertEqual(self.failures(), [])
            self.assertEqual(self.read("out/short/failure.txt"), b"mine")

    def test_show_no_moment_of_a_walk_that_should_have_failed(self):
        self.write("short.walk.yaml", WALK + "status: {is: xfail, failures: [never]}\n")
        outcome = self.run_program("run", "short.walk.yaml", "--reporter", "list")
        self.assertEqual(outcome.code, 1)
        self.assertEqual(self.failures(), [])
        complaints = [line for line in outcome.lines if line.startswith("   ")]
        self.assertEqual(len(complaints), 1, complaints)
        self.assertRegex(complaints[0], r"^   short.walk.yaml:10:\d+: error xfail: expected to fail with never, but passed$")

    def test_and_snapshots_that_the_walk_does_not_get_to_any_more_go(self):
        taken = "turn: 180\n  - snapshot: {name: away, width: 96, height: 64, channels: [depth]}"
        self.write("short.walk.yaml", WALK.replace("turn: 180", taken))
        self.passes("run", "short.walk.yaml")
        for name in ("away.png", "away-depth.png", "other.png"):
            self.write("out/short/" + name, "of a run before")
        self.write("short.walk.yaml", WALK.replace("turn: 180", "walk_to: [0, -8]\n  - " + taken))
        blocked = self.run_program("run", "short.walk.yaml")
        self.assertEqual(blocked.code, 1)
        self.assertIn("error blocked", blocked.err)
        left = [name for name in ("away.png", "away-depth.png", "other.png") if "out/short/" + name in self.contents()]
        self.assertEqual(left, ["away.png", "away-depth.png", "other.png"] if WITHOUT_RENDERING else ["other.png"])

    def test_are_not_removed_through_a_link(self):
        self.write("precious/short/failure-eyes.png", "precious")
        os.symlink("precious", self.path("out"))
        self.passes("run", "short.walk.yaml", "--rendering-backend", "none")
        self.assertEqual(self.read("precious/short/failure-eyes.png"), b"precious")


@unittest.skipIf(WITHOUT_RENDERING, "this build draws nothing")
class Examples(ImageCase):
    def test_walks_about_images_end_as_their_status_says(self):
        outcome = self.run_program("run", EXAMPLES, "--tag", "pictures", "--output", "out", "--reporter", "list",
                                   env={**os.environ, "CI": "1"})
        self.assertEqual((outcome.code, outcome.lines[-1][:9]), (0, "5 passed "), outcome.out + outcome.err)


class NothingIsDrawn(ImageCase):
    def run_without_images(self, *arguments):
        outcome = self.run_walk("--reporter", "json=report.json", *arguments)
        self.assertEqual(len([line for line in outcome.err_lines if " 2 expectations " in line]), 1, outcome.err)
        self.assertNotIn("short.walk.yaml-snapshots/hut.png", self.contents())
        return outcome.code

    def arguments(self):
        return () if WITHOUT_RENDERING else ("--rendering-backend", "none")

    def test_skipped_expectations_are_reported(self):
        self.walk("snapshot: hut", "visible: {building: hut, in: away}")
        self.assertEqual(self.run_without_images(*self.arguments()), 0)

    def test_walks_that_must_fail_in_images_are_skipped(self):
        self.walk("snapshot: hut", "visible: {building: hut, in: away}",
                  head="status: {is: xfail, because: it is behind, failures: [visible]}\n")
        self.assertEqual(self.run_without_images(*self.arguments()), 0)
        self.assertEqual(self.result()["outcome"], "skipped")


if __name__ == "__main__":
    if WITHOUT_RENDERING:
        sys.argv.remove("--without-rendering")
    main()
