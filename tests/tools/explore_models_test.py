#!/usr/bin/env python3
"""`campuswalk explore` on models that others made: what is known of them, see ../shared/data/README.md."""

import json
import os
import unittest

from program import ProgramCase, main

DATA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "shared", "data")


@unittest.skipUnless(os.path.isdir(DATA), "needs ../shared/data")
class ExploreModels(ProgramCase):
    def explore(self, model, start, step, places=""):
        """With a body of radius 0.3 m on slopes up to 46 degrees."""
        path = os.path.join(DATA, model)
        self.write("model.campus.yaml", "scenes: [{file: %s}]\ncolliders: [{id: floor, nodes: '*', shape: mesh, "
                   "mode: solid}]\nspawns: {start: {at: %s}}\n%s" % (json.dumps(path), start, places))
        done = self.run_program("explore", "model.campus.yaml", "--root", os.path.dirname(path), "--json", "report.json",
                                "--avatar", "{profile: adult, step_height: %g, max_slope_deg: 46}" % step)
        self.assertEqual(0, done.code, done.err)
        return done.out, json.loads(self.read("report.json"))

    def test_the_known_faults_of_a_stair(self):
        """Two versions of a campus game's stair."""
        for version, step, expected in (("before128", 0.46, r"riser of 0\.50 m at floor \(platform_14\)"),
                                        ("before128", 0.4, r"riser of 0\.45 m at floor \(platform_0\)"),
                                        ("after150", 0.4, r"riser of 0\.45 m at floor \(platform_0\)"),
                                        ("after150", 0.46, None)):
            text, _ = self.explore("ufaz/%s/ufaz-floor.obj" % version, [0, 0.1, 0], step,
                                   "places: {landing: [10, 4.55, -20]}\n")
            if expected:
                self.assertRegex(text, expected)
                self.assertIn("places     0 of 1", text)
            else:
                self.assertIn("places     1 of 1", text)

    def test_a_landing_behind_a_riser_and_another_one(self):
        text, report = self.explore("ufaz/before128/ufaz-floor.obj", [0, 0.1, 0], 0.4)
        self.assertRegex(text, r"riser of 0\.45 m at floor \(platform_0\), [^;]*, "
                               r"then riser of 0\.50 m at floor \(platform_14\), [^;]*; the avatar steps 0\.40 m")
        barriers = [island["barrier"] for island in report["islands"] if island["barrier"]]
        parts = next(barrier["parts"] for barrier in barriers if barrier["kind"] == "sequence")
        self.assertEqual(["riser", "riser"], [part["kind"] for part in parts])

    def test_a_ring_below_an_island_is_reached_with_it(self):
        """Over an island that is a slope too steep; down from there one falls onto the ring."""
        _, report = self.explore("recast/dungeon.obj", [40, 10.1, 0], 0.4)
        ring = next(island for island in report["islands"] if 185 < island["area"] < 195 and not island["top"])
        self.assertEqual("slope", ring["barrier"]["kind"])
        self.assertAlmostEqual(48.9, ring["barrier"]["measured_deg"], delta=0.2)

    def test_a_dungeon_is_joined_from_its_cellar_to_its_upper_hall(self):
        _, report = self.explore("recast/dungeon.obj", [40, 10.1, 0], 0.4)
        self.assertLess(report["storeys"][0]["low"], 0.15)
        self.assertGreater(report["storeys"][-1]["high"], 20.5)
        self.assertGreater(report["area"], 1552)  # what a grid of 0.2 m found

    def test_a_garage_is_joined_by_its_ramps(self):
        text, report = self.explore("gazebo/parking_garage/meshes/parking_garage.dae", [-11.25, 0.25, 18.25], 0.4)
        self.assertEqual(8, len(report["storeys"]))
        self.assertLess(report["storeys"][0]["low"], 0.1)
        self.assertAlmostEqual(39.1, report["storeys"][-1]["main_height"], delta=0.1)
        self.assertGreater(report["area"], 12503)
        # Shafts and rooms without doors, as many on each storey.
        self.assertEqual(28, sum(island["hollow"] for island in report["islands"]))
        self.assertIn("hollows inside solids: 28, ", text)
        self.assertLess(len(report["findings"]), 10)


if __name__ == "__main__":
    main()
