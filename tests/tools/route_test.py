#!/usr/bin/env python3
"""`campuswalk route`: the way between two places, or why there is none, and steps that walk it."""

import json
import os

from program import ProgramCase, main

FLOOR = "o floor\nv -10 0 -10\nv 10 0 -10\nv 10 0 10\nv -10 0 10\nf 1 4 3\nf 1 3 2\n"
# A wall with a door of 1 m, shut by a gate, and a way round at its east end; a stage that is too high.
YARD = ("scenes: [{file: floor.obj}]\n"
        "colliders:\n"
        "  - {id: ground, nodes: floor, shape: mesh, mode: solid}\n"
        "  - {id: wall/west, shape: box, center: [-5.25, 1.5, 0], size: [9.5, 3, 0.2], mode: solid}\n"
        "  - {id: wall/east, shape: box, center: [3.5, 1.5, 0], size: [6, 3, 0.2], mode: solid}\n"
        "  - {id: gate, shape: box, center: [0, 1, 0], size: [1, 2, 0.06], mode: solid}\n"
        "  - {id: stage, shape: box, center: [-8, 0.2, -8], size: [3, 0.5, 3], mode: solid}\n"
        "spawns: {south: {at: [0, 0, 5]}}\n"
        "places: {north: [0, 0, -5], stage: [-8, 0.45, -8]}\n")


class Route(ProgramCase):
    def setUp(self):
        super().setUp()
        self.write("floor.obj", FLOOR)
        self.write("yard.campus.yaml", YARD)

    def route(self, *arguments, code=0):
        done = self.run_program("route", "yard.campus.yaml", *arguments)
        self.assertEqual(code, done.code, done.err)
        return done.out

    def json_route(self, *arguments, code=0):
        return json.loads(self.route(*arguments, "--json", code=code))

    def test_prints_the_way_and_its_narrowest_and_steepest_spot(self):
        out = self.route("south", "north")
        self.assertIn("route      south to north\n", out)
        self.assertRegex(out, r"length     1\d\.\d\d m, \d+\.\d s, climb 0\.00 m\n")
        self.assertIn("steepest   0.0 degrees", out)

    def test_is_longer_round_the_wall_than_through_the_open_gate(self):
        shut = self.json_route("south", "north")
        through = self.json_route("south", "north", "--disable", "gate")
        self.assertAlmostEqual(10.0, through["length"], delta=0.06)
        self.assertGreater(shut["length"], 15.0)
        self.assertAlmostEqual(1.0, through["narrowest"]["width"], delta=0.01)

    def test_a_wide_way_may_be_longer(self):
        """Through the open gate, 1 m wide, or round the end of the wall."""
        shortest = self.json_route("3,3", "3,-3", "--disable", "gate")
        wide = self.json_route("3,3", "3,-3", "--disable", "gate", "--prefer", "wide")
        self.assertAlmostEqual(1.0, shortest["narrowest"]["width"], delta=0.01)
        self.assertLess(shortest["length"], 9.0)
        self.assertGreater(wide["length"], 2 * (3 ** 2 + (6.5 + 0.3 - 3) ** 2) ** 0.5)
        self.assertTrue(any(x > 6.5 for x, _, z in wide["waypoints"]))

    def test_a_wide_way_goes_round_posts(self):
        """Two posts with 1 m between them, through which the straight way leads; stairs and lintels aren't tight."""
        posts = "".join("  - {id: post-%d, shape: box, center: [%g, 1, 5], size: [0.3, 2, 0.3], mode: solid}\n" % (i, x)
                        for i, x in enumerate((-0.65, 0.65)))
        self.write("yard.campus.yaml", YARD.replace("spawns:", posts + "spawns:"))
        self.assertAlmostEqual(6.0, self.json_route("0,8", "0,2")["length"], delta=0.06)
        wide = self.json_route("0,8", "0,2", "--prefer", "wide")
        self.assertTrue(any(abs(x) > 0.8 for x, _, z in wide["waypoints"]), wide)
        stairs = "".join("  - {id: tread-%d, shape: box, center: [0, %g, %g], size: [6, %g, 0.3], mode: solid}\n"
                         % (i, 0.085 * i, 8 - 0.3 * i, 0.17 * i) for i in range(1, 15))
        self.write("yard.campus.yaml", YARD.replace("spawns:", stairs + "spawns:"))
        narrow, wide = (self.json_route("0,9", "0,3.9", "--prefer", way) for way in ("shortest", "wide"))
        self.assertEqual(narrow["length"], wide["length"])

    def test_passes_places_on_the_way(self):
        there = self.json_route("south", "0,-5", "--through", "5,5", "--through", "8,-5")
        self.assertTrue(any(abs(x - 5) < 0.06 and abs(z - 5) < 0.06 for x, _, z in there["waypoints"]))

    def test_says_why_there_is_none(self):
        none = self.json_route("south", "stage", code=1)
        self.assertFalse(none["reachable"])
        self.assertIn("riser of 0.45 m at stage", none["reason"])
        self.assertIn("no route from south to stage: riser of 0.45 m", self.route("south", "stage", code=1))
        self.route("south", "stage", "--avatar", "{profile: adult, step_height: 0.46}")

    def test_the_steps_that_it_writes_arrive(self):
        self.route("south", "north", "--write", "way.steps.yaml")
        self.write("way.walk.yaml", "campus: yard.campus.yaml\nsteps:\n  - spawn: south\n"
                                    "  - include: way.steps.yaml\nexpect:\n  - near: {place: north, within: 0.06}\n")
        done = self.run_program("run", "way.walk.yaml")
        self.assertEqual(0, done.code, done.out + done.err)

    def test_draws_it(self):
        """In a build without rendering, that is refused instead."""
        done = self.run_program("route", "yard.campus.yaml", "south", "north", "--map", "route.png", "--no-cache",
                                "--sandbox", "auto", "--root", ".")
        if done.code != 2:
            self.assertEqual(0, done.code, done.err)
            self.assertTrue(self.read("route.png").startswith(b"\x89PNG"))

    def test_draws_what_is_in_the_way(self):
        """In a build without rendering, that is refused instead."""
        done = self.run_program("route", "yard.campus.yaml", "south", "stage", "--map", "none.png")
        if done.code != 2:
            self.assertEqual(1, done.code, done.err)
            self.assertTrue(self.read("none.png").startswith(b"\x89PNG"))

    def test_the_help_tells_every_exit_code(self):
        self.assertIn("3 it can't be drawn or written", " ".join(self.passes("route", "--help").out.split()))

    def test_is_the_same_each_time(self):
        self.assertEqual(self.route("south", "north", "--json"), self.route("south", "north", "--json"))

    def test_refuses_what_it_does_not_know(self):
        self.assertEqual(2, self.run_program("route", "yard.campus.yaml", "south", "nroth").code)
        self.assertEqual(2, self.run_program("route", "yard.campus.yaml", "1,2,3,4", "north").code)
        self.assertEqual(2, self.run_program("route", "yard.campus.yaml", "south", "north", "--disable", "door").code)
        self.assertEqual(2, self.run_program("route", "yard.campus.yaml", "south", "north", "--write", "way.yaml").code)
        self.assertFalse(os.path.exists(self.path("way.yaml")))


if __name__ == "__main__":
    main()
