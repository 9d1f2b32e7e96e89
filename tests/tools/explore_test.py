#!/usr/bin/env python3
"""`campuswalk explore`: where a visitor gets to, and why not elsewhere, on a yard built for it."""

import json
import os
import pty
import re
import shutil
import subprocess

import jsonschema

from program import ProgramCase, main

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
with open(os.path.join(ROOT, "config", "schema", "explore.schema.json"), encoding="utf-8") as schema_file:
    SCHEMA = json.load(schema_file)

FLOOR = "o floor\nv -10 0 -10\nv 10 0 -10\nv 10 0 10\nv -10 0 10\nf 1 4 3\nf 1 3 2\n"


def box(name, low, high, mode="solid"):
    center = ["%g" % (0.5 * (a + b)) for a, b in zip(low, high)]
    size = ["%g" % (b - a) for a, b in zip(low, high)]
    return "  - {id: %s, shape: box, center: [%s], size: [%s], mode: %s}\n" % (name, ", ".join(center),
                                                                           ", ".join(size), mode)


# A yard of 20 m x 20 m: a stage 0.45 m high, a shed whose gate leaves 0.55 m, a pen that one falls into from steps, and
# a gap in the wall at the rim of the world.
YARD = ("scenes: [{file: floor.obj}]\n"
        "colliders:\n"
        "  - {id: ground, nodes: floor, shape: mesh, mode: solid}\n"
        + box("wall/north", (-10, 0, -10.2), (10, 3, -9.8)) + box("wall/south", (-10, 0, 9.8), (10, 3, 10.2))
        + box("wall/east", (9.8, 0, -10), (10.2, 3, 10)) + box("wall/west", (-10.2, 0, -10), (-9.8, 3, 4))
        + box("wall/west-end", (-10.2, 0, 6), (-9.8, 3, 10))
        + box("stage", (4, -0.1, 4), (9.8, 0.45, 9.8))
        + box("shed/left", (2, 0, -5.2), (4.4, 2.5, -5)) + box("shed/right", (5.6, 0, -5.2), (9.8, 2.5, -5))
        + box("shed/side", (2, 0, -9.8), (2.2, 2.5, -5))
        + box("shed/gate-leaf", (4.4, 0, -5.13), (5.05, 2.2, -5.07))
        + box("shed/inside", (2.2, 0, -9.8), (9.8, 2, -5.6), "trigger")
        + box("pen/south", (-8, -0.1, -4), (-4, 1, -3)) + box("pen/west", (-8, -0.1, -8), (-7, 1, -3))
        + box("pen/east", (-5, -0.1, -8), (-4, 1, -3)) + box("pen/north", (-8, -0.1, -8), (-4, 1, -7))
        + box("step/1", (-8, -0.1, -2.1), (-4, 0.25, -1.5)) + box("step/2", (-8, -0.1, -2.6), (-4, 0.5, -2.1))
        + box("step/3", (-8, -0.1, -3), (-4, 0.75, -2.6))
        + "spawns: {start: {at: [0, 0, 0]}}\n"
          "places: {stage: [7, 0.45, 7], shed: [6, 0, -8], corner: [-8, 0, 8], inside-the-wall: [3, 1, -5.1]}\n")


class Explore(ProgramCase):
    def setUp(self):
        super().setUp()
        self.write("floor.obj", FLOOR)
        self.write("yard.campus.yaml", YARD)

    def shown_on_terminal(self, *arguments):
        """What it writes to standard error if that is a terminal."""
        terminal, its_end = pty.openpty()
        with subprocess.Popen([self.program, "explore", "yard.campus.yaml", *arguments], cwd=self.folder,
                              stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=its_end) as process:
            os.close(its_end)
            shown = b""
            try:
                while part := os.read(terminal, 4096):
                    shown += part
            except OSError:  # the program has closed its end
                pass
            self.assertEqual(0, process.wait())
        os.close(terminal)
        return shown.decode()

    def test_on_a_terminal_a_bar_shows_how_far_it_is(self):
        for arguments, count in (((), 5), (("--min-width", "1"), 6)):
            shown = self.shown_on_terminal("--no-cache", *arguments)
            stages = re.findall(r"\[(#*)(\.*)\] (\d)/(\d) ", shown)
            self.assertEqual({str(count)}, {stage[3] for stage in stages})
            numbers = [int(stage[2]) for stage in stages]
            self.assertEqual(numbers, sorted(numbers))
            self.assertEqual(set(range(1, count + 1)), set(numbers))
            for done, left, number, _ in stages:
                self.assertEqual((20 * (int(number) - 1) // count, 20), (len(done), len(done + left)))
            self.assertRegex(shown, r"1/%d explored \d+ places" % count)
            self.assertTrue(shown.endswith("\r\x1b[K"), "it is cleared")
        self.assertNotIn("/5", self.run_program("explore", "yard.campus.yaml", "--no-cache").err)

    def report(self, *arguments, code=0):
        done = self.run_program("explore", "yard.campus.yaml", "--json", "report.json", *arguments)
        self.assertEqual(code, done.code, done.err)
        with open(self.path("report.json"), encoding="utf-8") as file:
            report = json.load(file)
        jsonschema.validate(report, SCHEMA)
        return report

    def subject(self, report, kind, name):
        return next(s for s in report["subjects"] if (s["kind"], s["name"]) == (kind, name))

    def finding(self, report, words):
        found = [f for f in report["findings"] if words in f["subject"] + ": " + f["text"]]
        self.assertEqual(1, len(found), report["findings"])
        return found[0]

    def test_tells_what_is_reached_and_how_far_it_is(self):
        report = self.report()
        corner = self.subject(report, "place", "corner")
        self.assertTrue(corner["reached"])
        self.assertAlmostEqual(128 ** 0.5, corner["distance"], delta=0.5)  # straight across, a diagonal of the grid
        # Between the walls, less stage and shed, each with the body's radius around it. Steps and pen can be walked on.
        self.assertAlmostEqual(19 ** 2 - 5.8 ** 2 - 7.8 * 4.8, report["area"], delta=12)

    def test_measures_why_not(self):
        report = self.report()
        self.assertFalse(self.subject(report, "place", "stage")["reached"])
        riser = self.finding(report, "place stage")
        self.assertRegex(riser["text"], r"^riser of 0\.45 m at stage, .*; the avatar steps 0\.30 m; 30 m² of ground lie beyond$")
        gate = self.finding(report, "place shed, trigger shed/inside")
        self.assertRegex(gate["text"], r"^shed/gate-leaf stands in the way at 5\.\d\d, \d\.\d\d, -[45]\.\d\d; "
                                       r"the opening beside it is 0\.55 m wide, the body needs 0\.60 m; 28 m² of ground lie beyond$")
        self.assertIn("is inside shed/left", self.finding(report, "inside-the-wall")["text"])
        # In the text, each finding has its place once.
        lines = re.findall(r"(?m)^ +\d+  (.*)$", self.run_program("explore", "yard.campus.yaml").out)
        self.assertEqual(len(lines), len(report["findings"]))
        for line, finding in zip(lines, report["findings"], strict=True):
            self.assertEqual(line.count("%.2f, %.2f, %.2f" % tuple(finding["at"])), 1, line)

    def test_spawns_that_no_path_joins(self):
        self.assertEqual([], self.report()["separate"])
        self.write("yard.campus.yaml", YARD.replace("spawns: {", "spawns: {corner: {at: [-8, 0, 8]}, shed: {at: [6, 0, -8]}, "))
        report = self.report()
        yard, shed = report["separate"]
        self.assertEqual((["corner", "start"], ["shed"]), (yard["spawns"], shed["spawns"]))
        self.assertAlmostEqual((7.6 - 0.6) * (4.6 - 0.6), shed["area"], delta=3)
        self.assertAlmostEqual(report["area"], yard["area"] + shed["area"], delta=0.001)
        self.assertIn("spawns     3 of 3\n  nobody gets from shed, on %.1f m², to the other spawns or back\n" % shed["area"],
                      self.run_program("explore", "yard.campus.yaml").out)

    def test_finds_traps_and_holes(self):
        report = self.report()
        trap, = report["traps"]
        self.assertAlmostEqual(1.0, trap["drop"], delta=0.02)
        self.assertAlmostEqual((2 - 0.6) * (3 - 0.6), trap["area"], delta=1.0)  # the pen's floor, for the body's middle
        self.assertEqual(("ledge", 1.0), (trap["out"]["kind"], round(trap["out"]["measured"], 2)))
        self.assertRegex(self.finding(report, "trap of ")["text"],
                         r"^one gets in over an edge of 1\.00 m and not out again: ledge of 1\.00 m at ")
        hole, = report["holes"]
        self.assertAlmostEqual(2 - 0.6, hole["length"], delta=0.6)
        self.assertAlmostEqual(-9.8, hole["edge"][0], delta=0.5)

    def test_islands_of_one_kind_are_one_finding(self):
        tables = "".join(box("table-%d" % i, (-8 + 3 * i, 0, 6), (-6 + 3 * i, 0.45, 7.5 + 0.1 * i)) for i in range(3))
        self.write("yard.campus.yaml", YARD.replace("spawns:", tables + box("desk", (-3, 0, 3), (-1, 0.5, 5)) + "spawns:"))
        report = self.report()
        group = self.finding(report, "3 islands of 3.")
        self.assertRegex(group["subject"], r"^3 islands of 3\.\d to 3\.\d m² each on table-\*$")
        self.assertRegex(group["text"], r"^riser of 0\.45 m at table-\d, .*; the avatar steps 0\.30 m; likewise at -?\d")
        of_group = [island for island in report["islands"] if island["finding"] == group["number"]]
        self.assertEqual(["table-0", "table-1", "table-2"], sorted(island["object"] for island in of_group))
        self.assertNotEqual(group["number"], self.finding(report, "on desk: riser of 0.50 m at desk")["number"])

    def test_a_gate_that_is_not_there_lets_one_in(self):
        report = self.report("--disable", "shed/gate-leaf")
        self.assertTrue(self.subject(report, "place", "shed")["reached"])
        self.assertTrue(self.subject(report, "trigger", "shed/inside")["reached"])

    def test_a_narrow_passage_is_measured(self):
        report = self.report("--disable", "shed/gate-leaf", "--min-width", "1.3")
        narrow, = report["narrow"]
        self.assertEqual("opening", narrow["barrier"]["kind"])
        self.assertAlmostEqual(1.2, narrow["barrier"]["measured"], delta=0.01)
        self.assertAlmostEqual(7.6 * 4.6, narrow["area"], delta=9)  # the shed's floor, less what the wide one sees through
        finding = self.finding(report, "narrow passage to")
        self.assertIn("place shed", finding["subject"])
        self.assertRegex(finding["text"], r"^the opening at shed/\w+, .* is 1\.20 m wide, the body needs 1\.30 m$")
        self.report("--disable", "shed/gate-leaf", "--min-width", "1.3", "--fail-on", "narrow", code=1)
        self.assertEqual([], self.report("--disable", "shed/gate-leaf", "--min-width", "1.1", "--fail-on", "narrow")["narrow"])

    def test_a_width_that_no_visitor_has(self):
        """A wider visitor is no taller; one that is no wider than the avatar would find nothing."""
        for arguments, words in ((("--min-width", "0.6"), "0.60 m wide itself"), (("--min-width", "1.81"), "1.80 m high"),
                                 (("--min-width", "1.2", "--allow", "crouch"), "1.08 m high when it crouches"),
                                 (("--min-width", "0.8", "--avatar", "{profile: adult, radius: 0.4}"), "0.80 m wide")):
            for campuses in (("yard.campus.yaml",), ("yard.campus.yaml", "yard.campus.yaml")):
                done = self.run_program("explore", *campuses, *arguments)
                self.assertEqual((2, ""), (done.code, done.out), done.err)
                self.assertIn("--min-width:1:1: error bad-value", done.err)
                self.assertIn(words, done.err)
        # Under a lintel of 1.85 m a visitor of 1.8 m width gets as well as one of 0.7 m.
        lintel = box("shed/gate-leaf", (2.2, 1.85, -5.2), (9.8, 2.5, -5))
        self.write("yard.campus.yaml", YARD.replace(box("shed/gate-leaf", (4.4, 0, -5.13), (5.05, 2.2, -5.07)), lintel).replace(
            box("shed/left", (2, 0, -5.2), (4.4, 2.5, -5)) + box("shed/right", (5.6, 0, -5.2), (9.8, 2.5, -5)), "").replace(
            ", inside-the-wall: [3, 1, -5.1]", ""))
        for width in ("0.7", "1.8"):
            self.assertEqual([], [n for n in self.report("--min-width", width)["narrow"] if n["barrier"]["kind"] == "headroom"])

    def test_a_narrow_passage_has_a_walk_by_a_wide_visitor(self):
        no_gate = YARD.replace(box("shed/gate-leaf", (4.4, 0, -5.13), (5.05, 2.2, -5.07)), "")
        self.write("yard.campus.yaml", no_gate)
        self.passes("explore", "yard.campus.yaml", "--min-width", "1.3", "--write-walks", "walks",
                    "--avatar", "{radius: 0.35, profile: adult}")
        walk, = [name for name in os.listdir(self.path("walks")) if "-narrow-" in name]
        self.assertIn(b"radius: 0.65", self.read("walks/" + walk))
        self.passes("run", "walks/" + walk, "--rendering-backend", "none")
        self.write("yard.campus.yaml", no_gate.replace(box("shed/right", (5.6, 0, -5.2), (9.8, 2.5, -5)),
                                                       box("shed/right", (7.6, 0, -5.2), (9.8, 2.5, -5))))
        done = self.run_program("run", "walks/" + walk, "--rendering-backend", "none")
        self.assertEqual(1, done.code, done.out)
        self.assertIn("expected to fail", done.out + done.err)

    def test_coverage_by_walks(self):
        walk = "campus: yard.campus.yaml\navatar: adult\nsteps:\n  - spawn: start\n  - walk_to: [-8, 8]\n"
        os.mkdir(self.path("walks"))
        self.write("walks/corner.walk.yaml", walk + "expect:\n  - reaches: corner\n")
        self.write("walks/fails.walk.yaml", walk + "expect:\n  - fell\n")
        self.write("walks/other.walk.yaml", walk.replace("yard", "other"))
        self.write("walks/other.campus.yaml", YARD)
        self.write("walks/floor.obj", FLOOR)
        for name in ("corner", "fails"):
            self.write("walks/%s.walk.yaml" % name, self.read("walks/%s.walk.yaml" % name).decode()
                       .replace("campus: ", "campus: ../"))
        coverage = self.report("--walks", "walks", "--fail-under", "1")["coverage"]
        self.assertEqual((2, 1), (coverage["walks"], coverage["failed"]))
        self.write("walks/fails.walk.yaml", self.read("walks/fails.walk.yaml").decode() + "status: {is: xfail, failures: [fell]}\n")
        self.assertEqual(0, self.report("--walks", "walks")["coverage"]["failed"])
        # A strip as wide as the body, and what its ends cover.
        self.assertAlmostEqual(128 ** 0.5 * 0.6 + 0.28, coverage["area"], delta=1.5)
        self.assertEqual([], coverage["visited"])
        self.report("--walks", "walks", "--fail-under", "50", code=1)
        self.assertRegex(self.run_program("explore", "yard.campus.yaml", "--walks", "walks", "--fail-under", "50").out,
                         r"(?m)^failed     --fail-under 50\.0: the walks visit %.1f %%$" % (100 * coverage["share"]))
        self.write("walks/inside.walk.yaml", "campus: ../yard.campus.yaml\navatar: adult\nsteps:\n"
                   "  - spawn: {at: [6, 0, -8]}\n")
        visited = self.report("--walks", "walks/inside.walk.yaml", "--disable", "shed/gate-leaf")["coverage"]["visited"]
        self.assertEqual([{"kind": "trigger", "name": "shed/inside"}], visited)
        self.assertIn("--walks: 1 walk is left out, being skipped or on other campuses\n",
                      self.run_program("explore", "yard.campus.yaml", "--walks", "walks").err)
        for arguments, words in ((("--walks", "walks/other.walk.yaml"), "no-walks"), (("--fail-under", "5"), "--walks")):
            done = self.run_program("explore", "yard.campus.yaml", *arguments)
            self.assertEqual((2, ""), (done.code, done.out), done.err)
            self.assertIn(words, done.err)

    def test_geojson_holds_the_ground(self):
        def area(ring):
            return 0.5 * sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(ring, ring[1:]))
        report = self.report("--geojson", "ground.geojson")
        ground = json.loads(self.read("ground.geojson"))
        storeys = [f for f in ground["features"] if f["properties"]["kind"] == "reached"]
        for storey, feature in zip(report["storeys"], storeys, strict=True):
            rings = [ring for polygon in feature["geometry"]["coordinates"] for ring in polygon]
            self.assertTrue(all(ring[0] == ring[-1] for ring in rings))
            self.assertTrue(all(area(polygon[0]) > 0 for polygon in feature["geometry"]["coordinates"]))
            self.assertTrue(all(area(hole) < 0 for p in feature["geometry"]["coordinates"] for hole in p[1:]))
            # A cell with two levels of one storey, such as the edge of a step, is one on the map.
            self.assertAlmostEqual(storey["area"], sum(map(area, rings)), delta=0.5)
        points = {f["properties"]["name"]: f for f in ground["features"] if f["properties"]["kind"] == "place"}
        self.assertEqual([-8.0, -8.0], points["corner"]["geometry"]["coordinates"][:2])  # north is -z
        self.assertEqual(len(report["findings"]), sum("number" in f["properties"] for f in ground["features"]))
        self.write("yard.campus.yaml", YARD + "origin: {latitude_deg: 48, longitude_deg: 11}\n")
        done = self.run_program("explore", "yard.campus.yaml", "--geojson", "earth.geojson")
        self.assertEqual(0, done.code, done.err)
        corner = next(f for f in json.loads(self.read("earth.geojson"))["features"]
                      if f["properties"].get("name") == "corner")["geometry"]["coordinates"]
        # 8 m to the west and to the south; a degree of latitude is 111.2 km there, one of longitude 74.6 km.
        self.assertAlmostEqual(11 - 8 / 74628, corner[0], places=6)
        self.assertAlmostEqual(48 - 8 / 111200, corner[1], places=6)

    def test_the_avatar_decides(self):
        report = self.report("--avatar", "{profile: adult, step_height: 0.46}")
        self.assertTrue(self.subject(report, "place", "stage")["reached"])
        report = self.report("--allow", "jump")
        self.assertTrue(self.subject(report, "place", "stage")["reached"])

    def test_the_same_bytes_for_any_number_of_workers(self):
        texts = set()
        for workers in ("1", "2", "3"):
            done = self.passes("explore", "yard.campus.yaml", "--json", "r.json", "-j", workers, "--no-cache")
            with open(self.path("r.json"), encoding="utf-8") as file:
                texts.add(done.out + file.read())
        self.assertEqual(1, len(texts))

    def test_crouching_leads_under_what_is_low(self):
        """A shed behind a sill of 1.2 m: below half the body's height it is too low for crouching, too."""
        for ceiling, reached in ((1.2, True), (1.05, False)):
            self.write("yard.campus.yaml", YARD.replace(
                box("shed/gate-leaf", (4.4, 0, -5.13), (5.05, 2.2, -5.07)),
                box("shed/gate-leaf", (4.4, ceiling, -6.2), (5.6, 2.2, -5)) +
                box("shed/lamp", (5.5, 1.4, -8.5), (6.5, 1.7, -7.5), "trigger")))
            upright = self.report("--no-cache")
            self.assertFalse(self.subject(upright, "place", "shed")["reached"])
            self.assertEqual(0, upright["crouched_area"])
            crouching = self.report("--allow", "crouch", "--no-cache")
            self.assertEqual(reached, self.subject(crouching, "place", "shed")["reached"], ceiling)
            # Beyond the sill one stands up: the lamp hangs above a body that crouches, of 1.08 m.
            self.assertEqual(reached, self.subject(crouching, "trigger", "shed/lamp")["reached"], ceiling)
            if reached:
                self.assertTrue(0.5 < crouching["crouched_area"] < 3.5, crouching["crouched_area"])
            else:
                barrier = crouching["islands"][self.subject(crouching, "place", "shed")["island"]]["barrier"]
                self.assertEqual("headroom", barrier["kind"])
                self.assertAlmostEqual(1.05, barrier["measured"], delta=0.01)
                self.assertAlmostEqual(1.08, barrier["allowed"], delta=0.001)
        self.passes("explore", "yard.campus.yaml", "--allow", "crouch", "--write-walks", "walks", "--no-cache")
        self.assert_walks_show_their_findings("walks")

    def test_crouching_is_what_the_step_crouch_does(self):
        self.write("yard.campus.yaml", YARD.replace(box("shed/gate-leaf", (4.4, 0, -5.13), (5.05, 2.2, -5.07)),
                                                    box("shed/gate-leaf", (4.4, 1.2, -6.2), (5.6, 2.2, -5))))
        steps = "campus: yard.campus.yaml\navatar: adult\nsteps:\n  - spawn: start\n%s  - walk_to: [5, -3]\n  - walk_to: [5, -8]\n"
        self.write("in.walk.yaml", steps % "  - crouch: on\n")
        self.passes("run", "in.walk.yaml", "--rendering-backend", "none")
        self.write("in.walk.yaml", steps % "")
        self.assertEqual(1, self.run_program("run", "in.walk.yaml", "--rendering-backend", "none").code)

    def test_a_report_is_cached_by_body_and_objects(self):
        environment = dict(os.environ, CAMPUSWALK_CACHE_DIR=self.path("cache"))

        def explore(*arguments):
            done = self.passes("explore", "yard.campus.yaml", "--json", "r.json", *arguments, env=environment)
            cached = [name for name in os.listdir(self.path("cache")) if name.endswith(".reach.campuswalk")]
            return done.out + self.read("r.json").decode(), cached

        first, cached = explore()
        self.assertEqual(1, len(cached))
        self.assertEqual((first, cached), explore())
        self.assertEqual((first, cached), explore("--require", "corner", "-j", "1"))
        for number, arguments in enumerate((("--avatar", "{profile: adult, radius: 0.31}"), ("--allow", "jump"),
                                            ("--disable", "stage"), ("--min-width", "1"), ("--allow", "crouch"))):
            other, cached = explore(*arguments)
            self.assertEqual(2 + number, len(cached), arguments)
            self.assertEqual(other, explore("--no-cache", *arguments)[0], arguments)
        self.write("yard.campus.yaml", YARD.replace("[7, 0.45, 7]", "[7, 0.45, 6]"))
        self.assertNotEqual(first, explore()[0])

    def test_a_cached_report_is_what_is_printed(self):
        """Shown by a report that is put in another's place."""
        environment = dict(os.environ, CAMPUSWALK_CACHE_DIR=self.path("cache"))
        names = []
        for arguments in ((), ("--disable", "stage")):
            printed = self.passes("explore", "yard.campus.yaml", *arguments, env=environment).out
            names += [name for name in os.listdir(self.path("cache")) if ".reach." in name and name not in names]
        os.replace(self.path("cache/" + names[1]), self.path("cache/" + names[0]))
        self.assertEqual(printed, self.passes("explore", "yard.campus.yaml", env=environment).out)

    def test_a_damaged_report_is_made_anew(self):
        environment = dict(os.environ, CAMPUSWALK_CACHE_DIR=self.path("cache"))
        first = self.passes("explore", "yard.campus.yaml", env=environment).out
        name, = [name for name in os.listdir(self.path("cache")) if name.endswith(".reach.campuswalk")]
        whole = self.read("cache/" + name)
        for damaged in (whole[:-1], b"", whole[:200] + bytes([whole[200] ^ 1]) + whole[201:]):
            with open(self.path("cache/" + name), "wb") as file:
                file.write(damaged)
            self.assertEqual(first, self.passes("explore", "yard.campus.yaml", env=environment).out)
            self.assertEqual(whole, self.read("cache/" + name))

    def test_plans_are_the_same_bytes_again(self):
        """In a build without rendering, they are refused instead."""
        images = []
        for folder in ("plans", "again"):
            done = self.run_program("explore", "yard.campus.yaml", "--from", "start", "--map", folder, "--no-cache",
                                    "--sandbox", "auto", "--workers", "2")
            if done.code == 2:
                self.assertIn("no-rendering", done.err)
                return
            self.assertEqual(["storey-0.png"], os.listdir(self.path(folder)))
            images.append(self.read(folder + "/storey-0.png"))
        self.assertTrue(images[0].startswith(b"\x89PNG"))
        self.assertEqual(images[0], images[1])

    def test_what_the_most_cells_cut_off(self):
        whole = self.run_program("explore", "yard.campus.yaml")
        self.assertNotIn("the most cells", whole.out)
        reports = []
        for arguments in (("-j", "1", "--no-cache"), ("-j", "2", "--no-cache"), ("-j", "2"), ("-j", "2")):
            outcome = self.run_program("explore", "yard.campus.yaml", "--max-cells", "100", "--json", "cut.json", *arguments)
            self.assertEqual(outcome.code, 3, outcome.err)
            self.assertIn("incomplete: the most cells", outcome.out)
            self.assertRegex(outcome.out, r"failed     --max-cells: \d+ cells, [\d.]+ m²")
            self.assertIn("nodes", json.loads(self.read("cut.json"))["incomplete"])
            reports.append((outcome.out, self.read("cut.json")))
        self.assertEqual(len(set(reports)), 1)
        self.assertEqual(self.run_program("explore", "yard.campus.yaml").out, whole.out)  # not the cut one from the cache
        self.assertEqual(self.run_program("explore", "yard.campus.yaml", "--max-cells", "0").code, 2)

    def test_more_unreached_ground_than_the_most_cells(self):
        # The middle of a floor of 40 m x 40 m, walled in: 25,600 cells, and over 25,000 beyond the walls.
        wall = [(x, y, z) for y in (0, 3) for x, z in ((-2, -2), (2, -2), (2, 2), (-2, 2))]
        floor = [(-20, 0, -20), (20, 0, -20), (20, 0, 20), (-20, 0, 20)]
        sides = ((1, 2, 6, 5), (2, 3, 7, 6), (3, 4, 8, 7), (4, 1, 5, 8), (9, 12, 11, 10))
        self.write("cell.obj", "".join("v %g %g %g\n" % point for point in wall + floor) +
                   "".join("f %d %d %d %d\n" % side for side in sides))
        self.write("cell.campus.yaml", """scenes: [{file: cell.obj}]
colliders: [{id: ground, nodes: "*", shape: mesh, mode: [solid]}]
spawns: {gate: {at: [0, 0.01, 0]}}
places: {corner: [19, 0, 19]}
""")
        whole = self.run_program("explore", "cell.campus.yaml", "--json", "whole.json")
        self.assertEqual(whole.code, 0, whole.err)
        self.assertGreater(json.loads(self.read("whole.json"))["islands"][0]["area"], 1500.0)
        outcomes = []
        for workers in ("1", "2"):
            cut = self.run_program("explore", "cell.campus.yaml", "--max-cells", "10000", "--no-cache", "-j", workers,
                                   "--json", "cut.json")
            self.assertEqual(cut.code, 3, cut.err)
            self.assertIn("incomplete: there is more ground that isn't reached than is looked at", cut.out)
            self.assertRegex(cut.out, r"failed     --max-cells: \d+ cells, [\d.]+ m², are reached")
            report = json.loads(self.read("cut.json"))
            self.assertEqual(report["incomplete"], ["islands"])
            outcomes.append((cut.out, report))
        self.assertEqual(outcomes[0], outcomes[1])

    def test_exit_codes(self):
        self.report("--require", "corner")
        self.report("--require", "shed", code=1)
        self.report("--require", "all", code=1)
        self.report("--fail-on", "traps", code=1)
        self.report("--fail-on", "islands", "--disable", "stage")
        done = self.run_program("explore", "yard.campus.yaml", "--require", "shed,corner", "--fail-on", "traps,popups")
        trap = next(line for line in done.out.splitlines() if " trap of " in line).split()[0]
        self.assertEqual("failed     --require: nobody gets to shed\nfailed     --fail-on traps: finding %s\n" % trap,
                         done.out[done.out.index("failed"):])
        for arguments, words in ((("--require", "crner"), "yard.campus.yaml has no place 'crner' (did you mean 'corner'?)"),
                                 (("--map", ""), "--map:1:1: error bad-value"), (("--write-walks", ""), "--write-walks:1:1: error bad-value"), (("--from", "strt"), "did you mean 'start'"),
                                 (("--disable", "gat*"), "no object 'gat*'"), (("--disable", "stge"), "did you mean 'stage'"), (("--avatar", "adlt"), "adlt"),
                                 (("--json", "floor.obj/report.json"), "floor.obj")):
            done = self.run_program("explore", "yard.campus.yaml", *arguments)
            self.assertEqual((2, ""), (done.code, done.out), done.err)
            self.assertIn(words, done.err)

    def with_buildings(self, colliders, names):
        """The yard with these buildings, of which each object of it is a line of `colliders`."""
        self.write("yard.campus.yaml", YARD.replace("colliders:\n", "buildings:\n" + "".join(
            "  - {id: %s, title: T, kind: k, text: x}\n" % name for name in names) + "colliders:\n" + colliders))

    def opens_in_a_run(self, building, *steps):
        self.write("near.walk.yaml", "campus: yard.campus.yaml\navatar: adult\nsteps:\n  - spawn: start\n" +
                   "".join("  - walk_to: {to: %s, if_blocked: continue}\n" % step for step in steps))
        return re.search("popup.open +" + building, self.passes("run", "near.walk.yaml", "--rendering-backend", "none",
                                                                "--reporter", "log").out) is not None

    def test_popups_that_nobody_can_open(self):
        """As a run opens them, or doesn't."""
        walls = ("solid, building: tower, popup: %s", (-1, 0, 5), (1, 3, 7))
        top = box("tower/top", (-1, 3, 5), (1, 5, 7), "trigger, building: tower")
        for popup, opens in (("false", False), ("true", True)):
            self.with_buildings(box("tower/walls", *walls[1:], walls[0] % popup) + top, ["tower"])
            report = self.report("--fail-on", "popups", code=0 if opens else 1)
            tower = self.subject(report, "building", "tower")
            self.assertEqual((True, opens), (tower["reached"], tower["popup_opens"]))
            self.assertEqual(opens, self.opens_in_a_run("tower", "[0, 7]"))
            found = [f for f in report["findings"] if f["kind"] == "popups"]
            self.assertEqual([] if opens else ["building tower"], [f["subject"] for f in found])
            text = self.run_program("explore", "yard.campus.yaml").out
            self.assertIn("\nbuildings  1 of 1 touched or seen, not necessarily entered\n"
                          "pop-ups    %d of 1 that somebody can open\n" % opens, text)
        self.with_buildings(box("tower/walls", *walls[1:], walls[0] % "false") + top, ["tower"])
        self.assertIn("what opens it, tower/top", self.finding(self.report(), "pop-up")["text"])
        # Nothing that was taken away on purpose is missed.
        self.report("--disable", "tower/top", "--fail-on", "popups")

    def test_buildings_without_a_contact(self):
        """Nothing of one that belongs nowhere is said to be somewhere."""
        self.with_buildings(box("kite/string", (0, 5, 0), (1, 6, 1), "trigger, building: kite"), ["kite", "idea"])
        report = self.report("--geojson", "ground.geojson", "--fail-on", "popups", code=1)
        kite, idea = (self.finding(report, "building " + name) for name in ("kite", "idea"))
        self.assertEqual(([0.5, 5.5, 0.5], ["popups"]), (kite["at"], kite["also"]))
        self.assertRegex(kite["text"], "^nobody touches, .* so that its pop-up never opens$")
        self.assertEqual((False, False), ("at" in idea, "also" in idea))
        features = json.loads(self.read("ground.geojson"))["features"]
        self.assertIsNone(next(f["geometry"] for f in features if f["properties"].get("subject") == "building idea"))
        self.assertRegex(self.run_program("explore", "yard.campus.yaml").out,
                         r"(?m)building idea: nobody touches, enters or sees anything of it$")

    def test_triggers_that_nobody_can_enter(self):
        """Whether a place shares their finding, or they are where nobody could stand."""
        kite = box("kite", (0, 5, 0), (1, 6, 1), "trigger")
        for more, arguments, unentered in (("", (), ["shed/inside"]), ("", ("--disable", "shed/gate-leaf"), []),
                                           (kite, ("--disable", "shed/gate-leaf"), ["kite"])):
            self.write("yard.campus.yaml", YARD.replace("spawns:", more + "spawns:"))
            report = self.report("--fail-on", "triggers", *arguments, code=1 if unentered else 0)
            self.assertEqual(unentered, [s["name"] for s in report["subjects"] if s["kind"] == "trigger" and not s["reached"]])
            found = [f for f in report["findings"] if "triggers" in f.get("also", ())]
            self.assertEqual(["unreached"] * len(unentered), [f["kind"] for f in found])
            for name, finding in zip(unentered, found):
                self.assertIn("trigger " + name, finding["subject"])

    def test_distances_have_a_start(self):
        """The nearer of two spawns; with one of them only, it is named once."""
        self.write("yard.campus.yaml", YARD.replace("{start: {at: [0, 0, 0]}}", "{start: {at: [0, 0, 0]}, south: {at: [-8, 0, 7]}}")
                   .replace("places: {", "places: {middle: [1, 0, 0], "))
        report = self.report()
        for name, start, distance in (("corner", "south", 1), ("middle", "start", 1)):
            place = self.subject(report, "place", name)
            self.assertEqual(start, place["from"])
            self.assertAlmostEqual(distance, place["distance"], delta=0.3)
        text = self.run_program("explore", "yard.campus.yaml").out
        self.assertRegex(text, r"(?m)^ways$\n^  middle +[01]\.\d m from start$\n^  corner +[01]\.\d m from south$")
        text = self.run_program("explore", "yard.campus.yaml", "--from", "start").out
        self.assertRegex(text, r"(?m)^ways from start$\n^  middle +[01]\.\d m$\n^  corner +1\d\.\d m$")

    def test_no_plan_where_nothing_is_reached(self):
        self.write("yard.campus.yaml", YARD.replace("start: {at: [0, 0, 0]}", "start: {at: [100, 0, 0]}"))
        done = self.run_program("explore", "yard.campus.yaml", "--map", "plans")
        if done.code != 2:
            self.assertEqual(0, done.code, done.err)
            self.assertRegex(done.out, "(?m)^plans +none: nothing is reached$")

    def test_what_an_earlier_run_left(self):
        """What explore wrote itself and nobody has changed since makes way; all else stays."""
        def names(folder):
            return set(os.listdir(self.path(folder)))
        self.passes("explore", "yard.campus.yaml", "--write-walks", "walks")
        first = names("walks")
        stage = next(name for name in first if "stage" in name)
        trap = next(name for name in first if "-traps-" in name)
        self.write("walks/" + trap, re.sub("(?m)^status: .*\n", "", self.read("walks/" + trap).decode()))  # mended
        for name, text in (("01-unreached-desk.walk.yaml", "campus: ../yard.campus.yaml\navatar: adult\nsteps: []\n"),
                           ("notes.txt", "# Finding 1 of `campuswalk explore`. \n"),
                           ("other.walk.yaml", self.read("walks/" + stage).decode().replace("yard", "garden"))):
            self.write("walks/" + name, text)
        os.symlink(self.path("walks/" + stage), self.path("walks/link.walk.yaml"))
        self.write("yard.campus.yaml", YARD.replace("spawns:", box("ramp", (3.4, -0.1, 4), (4, 0.2, 9.8)) + "spawns:"))
        self.passes("explore", "yard.campus.yaml", "--write-walks", "later")
        later = names("later")
        self.assertFalse(any("stage" in name for name in later))
        self.assertNotIn(trap, later)  # it has another number
        os.remove(self.path("walks/link.walk.yaml"))
        self.passes("explore", "yard.campus.yaml", "--write-walks", "walks")
        self.assertEqual(later | {trap, "01-unreached-desk.walk.yaml", "notes.txt", "other.walk.yaml"}, names("walks"))

    def test_a_walk_that_somebody_has_changed_is_kept(self):
        self.passes("explore", "yard.campus.yaml", "--write-walks", "walks")
        name = "walks/" + sorted(os.listdir(self.path("walks")))[0]
        mine = re.sub("(?m)^status: .*\n", "", self.read(name).decode())
        self.write(name, mine)
        done = self.passes("explore", "yard.campus.yaml", "--write-walks", "walks")
        self.assertIn("kept       %s: " % name, done.out)
        self.assertEqual(self.read(name).decode(), mine)

    def test_plans_of_an_earlier_run(self):
        gallery = "".join(box("tread-%d" % i, (-6, -0.1, 5.5 - 0.5 * i), (-4.5, 0.25 * i, 6 - 0.5 * i))
                          for i in range(1, 13)) + box("gallery", (-6, 2.8, -6), (2, 3, -0.5))
        campus = ("scenes: [{file: floor.obj}]\ncolliders:\n"
                  "  - {id: ground, nodes: floor, shape: mesh, mode: solid}\n%sspawns: {start: {at: [0, 0, 3]}}\n")
        self.write("yard.campus.yaml", campus % gallery)
        done = self.run_program("explore", "yard.campus.yaml", "--map", "plans")
        if done.code == 2:
            self.assertIn("no-rendering", done.err)
            return
        self.assertEqual({"storey-0.png", "storey-1.png"}, set(os.listdir(self.path("plans"))))
        self.write("plans/storey-7.png", "not a plan")
        shutil.copy(self.path("plans/storey-1.png"), self.path("plans/mine.png"))
        self.write("yard.campus.yaml", campus % "")
        self.passes("explore", "yard.campus.yaml", "--map", "plans")
        self.assertEqual({"storey-0.png", "storey-7.png", "mine.png"}, set(os.listdir(self.path("plans"))))

    def test_lists_have_commas(self):
        """Like the option repeated; that both are needed is shown by what one of them alone gives."""
        def explored(*arguments):
            done = self.run_program("explore", "yard.campus.yaml", *arguments)
            return done.code, done.out
        # A bar below which one crouches, to a sill that one jumps over.
        low = box("shed/gate-leaf", (4.4, 1.2, -6.2), (5.6, 2.2, -5)) + box("shed/sill", (2.2, -0.1, -6.8), (9.8, 0.5, -6.4))
        self.write("yard.campus.yaml", YARD.replace(box("shed/gate-leaf", (4.4, 0, -5.13), (5.05, 2.2, -5.07)), low)
                   .replace("{start: {at: [0, 0, 0]}}", "{start: {at: [0, 0, 0]}, top: {at: [7, 0.45, 7]}}"))
        for option, one, other, code in (("--allow", "crouch", "jump", 0), ("--from", "start", "top", 0),
                                         ("--disable", "stage", "shed/*", 0), ("--require", "corner", "shed", 1),
                                         ("--fail-on", "hot", "traps", 1)):
            listed = explored(option, one + "," + other)
            self.assertEqual(code, listed[0], listed)
            self.assertEqual(listed, explored(option, one, option, other))
            self.assertNotEqual(listed, explored(option, one))
        done = self.run_program("explore", "yard.campus.yaml", "--allow", "run,fly")
        self.assertEqual((2, ""), (done.code, done.out), done.err)
        self.assertIn("'fly' is not one of run|jump|crouch", done.err)

    def test_its_walks_fail_until_the_campus_is_mended(self):
        self.passes("explore", "yard.campus.yaml", "--write-walks", "walks")
        names = sorted(os.listdir(self.path("walks")))
        kinds = {re.sub(r"^\d+-([a-z]+)-.*", r"\1", name) for name in names}
        self.assertLessEqual({"unreached", "traps", "holes"}, kinds)
        self.passes("run", "walks", "--strict", "--rendering-backend", "none")
        # A ramp of two steps before the stage: the walk passes, which an xfail may not.
        self.write("yard.campus.yaml", YARD.replace("spawns:", box("ramp", (3.4, -0.1, 4), (4, 0.2, 9.8)) + "spawns:"))
        stage = next(name for name in names if "stage" in name)
        done = self.run_program("run", "walks/" + stage, "--rendering-backend", "none")
        self.assertEqual(1, done.code, done.out)
        self.assertIn("expected to fail", done.out + done.err)

    def assert_walks_show_their_findings(self, folder):
        """Without its status, each walk fails with the codes that its status states. Returns the kinds of walks."""
        kinds = set()
        for name in sorted(os.listdir(self.path(folder))):
            path = folder + "/" + name
            walk = self.read(path).decode()
            status = re.search(r"^status: .* failures: \[(.*)\]}\n", walk, re.MULTILINE)
            self.write(path, walk.replace(status.group(0), ""))
            done = self.run_program("run", path, "--rendering-backend", "none")
            self.assertEqual(1, done.code, walk + done.out)
            codes = set(re.findall(r"walk\.yaml(?::\d+)*: error ([a-z-]+): ", done.out + done.err))
            self.assertEqual(set(status.group(1).split(", ")), codes, walk + done.out)
            kinds.add(re.sub(r"^\d+-([a-z]+)-.*", r"\1", name))
        return kinds

    def test_each_kind_of_walk_shows_its_finding(self):
        """Also above a deep abyss, into which one falls for longer than a walk_to waits."""
        self.write("yard.campus.yaml", YARD.replace(box("shed/gate-leaf", (4.4, 0, -5.13), (5.05, 2.2, -5.07)), "").replace(
            "spawns:", box("deep", (40, -60, 0), (42, -59, 2)) + box("desk", (-3, 0, 3), (-1, 0.5, 5)) + "spawns:"))
        self.passes("explore", "yard.campus.yaml", "--min-width", "1.3", "--write-walks", "walks")
        kinds = self.assert_walks_show_their_findings("walks")
        self.assertLessEqual({"unreached", "islands", "traps", "holes", "narrow"}, kinds)

    def test_a_trigger_that_reaches_through_a_floor(self):
        """A gallery above the yard, up to which stairs of 0.25 m lead; its trigger reaches 0.2 m into those below."""
        gallery = "".join(box("tread-%d" % i, (-6, -0.1, 5.5 - 0.5 * i), (-4.5, 0.25 * i, 6 - 0.5 * i))
                          for i in range(1, 13)) + box("gallery", (-6, 2.8, -6), (2, 3, -0.5))
        campus = ("scenes: [{file: floor.obj}]\ncolliders:\n"
                  "  - {id: ground, nodes: floor, shape: mesh, mode: solid}\n" + gallery
                  + box("below", (-2, 0, -5), (2, 1.5, -1), "trigger") + "%s"
                  + "spawns: {start: {at: [0, 0, 3]}}\n")
        self.write("yard.campus.yaml", campus % box("upstairs", (-1, 1.6, -4), (1, 5, -2), "trigger"))
        report = self.report("--fail-on", "triggers", "--write-walks", "walks", code=1)
        overhang, = report["overhangs"]
        self.assertEqual(("upstairs", 0, "head", ["below"]),
                         tuple(overhang[key] for key in ("trigger", "storey", "part", "also_in")))
        self.assertAlmostEqual(0.2, overhang["depth"], delta=0.01)
        self.assertRegex(self.finding(report, "trigger upstairs")["text"],
                         r"on storey 0 one is in it with the head only, 0\.\d+ m deep, and at once in below$")
        walk, = [name for name in os.listdir(self.path("walks")) if "upstairs" in name]
        self.passes("run", "walks/" + walk, "--rendering-backend", "none")
        shutil.copytree(self.path("walks"), self.path("bare"))
        self.assertIn("triggers", self.assert_walks_show_their_findings("bare"))
        self.write("yard.campus.yaml", campus % box("upstairs", (-1, 3, -4), (1, 5, -2), "trigger"))
        self.assertEqual([], self.report("--fail-on", "triggers")["overhangs"])
        done = self.run_program("run", "walks/" + walk, "--rendering-backend", "none")
        self.assertIn("expected to fail", done.out + done.err)


if __name__ == "__main__":
    main()
