#!/usr/bin/env python3
"""`campuswalk info --suggest`: what it writes holds, and walks."""

import os
import unittest

from program import ROOM, ProgramCase, main

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
SHARED = os.path.join(ROOT, "..", "shared", "data")
WILD = [
    "delft_3dfier/testarea.obj",
    "gazebo/cafe/meshes/cafe.dae",
    "gazebo/nist_stairs_120/meshes/nist_stairs_120.dae",
    "gazebo/office_building/meshes/office_building.dae",
    "gazebo/parking_garage/meshes/parking_garage.dae",
    "gazebo/willowgarage/meshes/willowgarage_collision.dae",
    "gazebo/willowgarage/meshes/willowgarage_visual.dae",
    "recast/dungeon.obj",
    "recast/nav_test.obj",
    "recast/undulating.obj",
    "small_house/small_house_collision.glb",
    "small_house/small_house_visual.glb",
    "ufaz/after153/outdoor_campus.obj",
    "ufaz/after153/ufaz.obj",
]


# The room's wall as a hut of 4 m x 3 m x 4 m.
HUT = ROOM.replace("o wall", "o Hut_1").replace("v -1 ", "v -2 ").replace("v 1 ", "v 2 ").replace(" -5\n", " -8\n")


class Suggest(ProgramCase):
    def setUp(self):
        super().setUp()
        self.write("hut.obj", HUT)

    def suggest(self, model, *arguments):
        self.passes("info", model, "--suggest", "new.campus.yaml", *arguments)
        self.passes("validate", "new.campus.yaml", "new.walk.yaml")
        log = self.passes("run", "new.walk.yaml").out
        return self.read("new.campus.yaml").decode(), log

    def test_a_hut(self):
        campus, log = self.suggest("hut.obj")
        self.assertIn('{id: "hut-1", nodes: "Hut_1", title: "Hut_1"}', campus)
        self.assertRegex(campus, r'"hut-1/around", .* center: \[0\.000, 1\.500, -6\.000\], size: \[7\.000, 4\.000, 7\.000\]')
        self.assertRegex(log, r"trigger\.enter +hut-1/around")
        self.assertRegex(log, r"popup\.open +hut-1")
        self.assertNotIn("collision.enter", log)

    def test_a_model_on_edge_and_far_away_is_put_right(self):
        def moved(line):
            kind, *numbers = line.split()
            if kind != "v":
                return line
            x, y, z = map(float, numbers)
            return "v %g %g %g" % (x + 85000, 446000 - z, y)
        self.write("hut.obj", "\n".join(map(moved, HUT.splitlines())))
        campus, log = self.suggest("hut.obj")
        self.assertIn("up: z, position: [-85000", campus)
        self.assertRegex(log, r"trigger\.enter +hut-1/around")

    def test_nothing_is_overwritten_unasked(self):
        for taken in ("new.campus.yaml", "new.walk.yaml"):
            self.write(taken, "mine")
            outcome = self.run_program("info", "hut.obj", "--suggest", "new.campus.yaml")
            self.assertEqual((outcome.code, outcome.complaints),
                             (2, [taken + ": error file-exists: it is there already; name another, or say --overwrite"]))
            self.assertEqual(self.read(taken), b"mine")
            os.remove(self.path(taken))
        self.write("new.walk.yaml", "mine")
        self.suggest("hut.obj", "--overwrite")

    def test_the_name_of_a_campus(self):
        outcome = self.run_program("info", "hut.obj", "--suggest", "new.yaml")
        self.assertEqual(outcome.code, 2)
        self.assertIn("new.yaml: error file-name: a campus file is called NAME.campus.yaml", outcome.err)

    def test_no_ground(self):
        self.write("wall.obj", "v 0 0 0\nv 5 0 0\nv 0 5 3\nf 1 2 3\n")
        before = sorted(self.contents())
        outcome = self.run_program("info", "wall.obj", "--suggest", "new.campus.yaml")
        self.assertEqual(outcome.code, 2)
        self.assertIn("wall.obj: error no-ground", outcome.err)
        self.assertEqual(sorted(self.contents()), before)

    def test_the_demo_campus(self):
        model = os.path.join(ROOT, "campus_assets", "demo", "ground.glb")
        self.assertIn("avatar.arrive", self.suggest(model)[1])

    def test_models_that_nobody_here_wrote(self):
        if not os.path.isdir(SHARED):
            raise unittest.SkipTest("no " + SHARED)
        models = [os.path.join(SHARED, name) for name in WILD]
        for model in models:
            with self.subTest(model=os.path.relpath(model, SHARED)):
                self.suggest(model, "--overwrite")


if __name__ == "__main__":
    main()
