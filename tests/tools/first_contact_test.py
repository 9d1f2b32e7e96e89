#!/usr/bin/env python3
"""What a stranger's model is taken for: the small models of ../shared/data/first_contact, and what is typed stays."""

import json
import os
import re
import unittest

from program import ProgramCase, main
from suggest_test import boxes_obj

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
MODELS = os.path.join(ROOT, "..", "shared", "data", "first_contact")


def school(scale):
    """Ground, a hall, ten steps and two doors; +Y is up."""
    boxes = [("ground", -40, -0.3, -30, 40, 0, 30), ("hall", -15, 0, -25, 15, 8, -5),
             ("door_west", -10, 0, -5, -9, 2.1, -4.95), ("door_east", 9, 0, -5, 10, 2.1, -4.95)]
    boxes += [("step", 0, 0, 5 + 0.29 * i, 1.5, 0.17 * (i + 1), 5 + 0.29 * (i + 1)) for i in range(10)]
    return boxes_obj([(name, *(scale * number for number in numbers)) for name, *numbers in boxes])


class TypedFrame(ProgramCase):
    def info(self, *arguments):
        return json.loads(self.passes("info", *arguments, "--json").out)

    def test_what_is_sure_is_used_and_said(self):
        self.write("school.obj", school(100))
        found = self.info("school.obj")
        self.assertEqual((found["frame"]["scale"], found["frame"]["scaled"]), (0.01, True))
        self.assertAlmostEqual(found["bounds"]["max"][0], 40, 3)
        self.assertEqual([], [warning for warning in found["warnings"] if warning["code"] == "odd-scale"])
        self.assertRegex(self.passes("info", "--strict", "school.obj").out,
                         r"it is read with `scale: 0\.01`, so that \d+ risers are 0\.17 m high, 2 doors are 2\.1 m high")
        said = self.passes("info", "school.obj", "--suggest", "new.campus.yaml").out
        self.assertIn("it is read with `scale: 0.01`", said)
        self.assertIn("scale: 0.01", self.read("new.campus.yaml").decode())

    def test_what_is_typed_is_never_changed(self):
        self.write("school.obj", school(100))
        for scale in ("1", "0.2"):
            with self.subTest(scale=scale):
                found = self.info("school.obj", "--scale", scale)
                self.assertEqual((found["frame"]["scale"], found["frame"]["scaled"]), (float(scale), False))
                warning, = [warning for warning in found["warnings"] if warning["code"] == "odd-scale"]
                self.assertIn("with `scale: ", warning["message"])
                self.assertIn("it is read with " + scale, warning["message"])
                self.assertEqual(self.run_program("info", "--strict", "school.obj", "--scale", scale).code, 1)
                said = self.passes("info", "school.obj", "--scale", scale, "--suggest", "new.campus.yaml", "--overwrite").out
                self.assertIn("odd-scale", said)
                scene = re.search(r"(?m)^  - \{?file: .*school\.obj.*$", self.read("new.campus.yaml").decode())[0]
                self.assertEqual(re.findall(r"scale: [0-9.]+", scene), [] if scale == "1" else ["scale: " + scale])
        self.write("back.obj", re.sub(r"(?m)^v (\S+) (\S+) (\S+)$", lambda m: "v %s %g %s" % (m[1], -float(m[3]), m[2]), school(1)))
        self.assertEqual(self.info("back.obj")["frame"]["up"], "z")
        typed = self.info("back.obj", "--up", "y")
        self.assertEqual((typed["frame"]["up"], typed["frame"]["turned"]), ("y", False))
        self.assertIn("z-up", [warning["code"] for warning in typed["warnings"]])


@unittest.skipUnless(os.path.isdir(MODELS), "no " + MODELS)
class FirstContact(ProgramCase):
    def info(self, name):
        return json.loads(self.passes("info", os.path.join(MODELS, name), "--json").out)

    def titles(self, name):
        return sorted(building["title"] for building in self.info(name)["buildings"])

    def suggested(self, name):
        model = os.path.join(MODELS, name)
        self.passes("info", model, "--suggest", "new.campus.yaml", "--overwrite")
        log = self.passes("run", "new.walk.yaml", "--root", os.path.dirname(MODELS)).out
        spawn = re.search(r"start: \{at: \[([^\]]*)\]", self.read("new.campus.yaml").decode())[1]
        return [float(number) for number in spawn.split(",")], log

    def test_buildings(self):
        self.assertEqual(self.titles("01-named-beside-generic.obj"), ["Elm_Hall", "Oak_Hall"])
        self.assertEqual(len(self.titles("02-one-mesh-six-houses.obj")), 6)
        self.assertNotIn("clock", self.titles("08-clock-on-tower.obj"))
        self.assertEqual(self.titles("13-rooms-with-signs.obj"),
                         ["Canteen", "EEE_Lab", "Gym", "Library", "Seminar_Hall", "Washroom"])

    def test_scale_and_axis(self):
        miniature = self.info("03-miniature.obj")
        warning, = [warning for warning in miniature["warnings"] if warning["code"] == "odd-scale"]
        self.assertRegex(warning["message"], r"houses are 0\.9 m high.*`scale: 10`")
        self.assertEqual(self.run_program("info", "--strict", os.path.join(MODELS, "03-miniature.obj")).code, 1)
        museum = self.info("12-museum-on-its-back.obj")["frame"]
        self.assertEqual((museum["up"], museum["turned"]), ("z", True))
        school = self.info("20-z-up-school-one-mesh.obj")  # which could be a long house, so that it is asked for
        self.assertEqual(school["frame"]["turned"], False)
        self.assertIn("z-up", [warning["code"] for warning in school["warnings"]])

    def test_doors_and_outliers(self):
        self.assertEqual(len(self.info("10-one-node-three-doors.obj")["doors"]), 3)
        codes = [warning["code"] for warning in self.info("11-zero-area-in-100.obj")["warnings"]]
        self.assertNotIn("outlier", codes)

    def test_skies_waters_and_cutters_are_left_out(self):
        for name, kind, node in (("09-lake-only-ground.obj", "water node", "Lake_Long"),
                                 ("14b-hall-with-door-and-cutter.obj", "box node", "CUTTER.001")):
            with self.subTest(name=name):
                lint, = [warning for warning in self.info(name)["warnings"] if warning["code"] == "not-solid"]
                self.assertIn("1 " + kind, lint["message"])
                self.assertEqual([place["node"] for place in lint["places"]], [node])
        spawn, _ = self.suggested("14b-hall-with-door-and-cutter.obj")
        self.assertRegex(self.read("new.walk.yaml").decode(), r"trigger\.enter [^\"]*/inside")
        self.assertIn("leaves no path of up to 100 m", self.read("new.walk.yaml").decode())
        spawn, _ = self.suggested("09-lake-only-ground.obj")
        self.assertLess(spawn[1], 1.0)  # on no roof
        self.assertIn("the model has no ground", self.read("new.walk.yaml").decode())
        domes = os.path.join(MODELS, "..", "wild", "13-skydome")
        for name in sorted(os.listdir(domes)):
            if name.endswith(".obj"):
                with self.subTest(name=name):
                    spawn, _ = self.suggested(os.path.join("..", "wild", "13-skydome", name))
                    self.assertAlmostEqual(spawn[1], 0.0, delta=0.2)
                    self.assertTrue(max(abs(spawn[0]), abs(spawn[2])) < 6.2, spawn)

    def test_spawns(self):
        spawn, _ = self.suggested("21-hollow-terrain-block.obj")
        self.assertGreater(spawn[1], -10.0)  # the top undulates; the bottom is at -56
        roofs = os.path.join(MODELS, "..", "wild", "15-roof-spawn")
        for name in sorted(os.listdir(roofs)):
            if name.endswith(".obj"):
                with self.subTest(name=name):
                    spawn, log = self.suggested(os.path.join("..", "wild", "15-roof-spawn", name))
                    self.assertLess(spawn[1], 1.0)
        (x, y, z), _ = self.suggested("05-fence-without-ground.obj")
        self.assertTrue(abs(x) < 30 and 0.4 < y < 1 and -20 < z < 28, (x, y, z))  # on the hall's floor
        (x, y, z), _ = self.suggested("06-closed-room.obj")
        self.assertTrue(abs(x) < 6 and abs(y) < 0.1 and abs(z) < 6, (x, y, z))  # its ceiling is at 4 m
        _, log = self.suggested("14a-hall-with-door.obj")
        self.assertRegex(log, r"trigger\.enter +\S+/inside")
        spawn, log = self.suggested("04-high-walls.obj")
        self.assertLess(spawn[1], 1.0)
        self.assertNotIn("avatar.fell", log)


if __name__ == "__main__":
    main()
