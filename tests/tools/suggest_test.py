#!/usr/bin/env python3
"""`campuswalk info --suggest`: its files validate, and its walk passes."""

import math
import os
import re
import unittest

from program import ROOM, ProgramCase, main

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
SHARED = os.path.join(ROOT, "..", "shared", "data")
THIRD_PARTY = [
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
    "ufaz/after153/cafeteria.obj",
    "ufaz/after153/lab.obj",
    "ufaz/after153/lecture.obj",
    "ufaz/after153/library.obj",
    "ufaz/after153/outdoor_campus.obj",
    "ufaz/after153/sports.obj",
    "ufaz/after153/student-center.obj",
    "ufaz/after153/ufaz-floor.obj",
    "ufaz/after153/ufaz.obj",
    "ufaz/before128/ufaz-floor.obj",
]


# Stairs, hills, a cave, and a hall without a roof that may as well be a fence.
WITHOUT_BUILDINGS = ("nist_stairs_120", "undulating", "dungeon", "sports.obj")


def box(x0, y0, z0, x1, y1, z1):
    """The lines of an OBJ file with one box."""
    vertices = ["v %g %g %g" % (x, y, z) for z in (z0, z1) for y in (y0, y1) for x in (x0, x1)]
    return vertices + ["f 1 3 4 2", "f 5 6 8 7", "f 1 2 6 5", "f 3 7 8 4", "f 1 5 7 3", "f 2 4 8 6"]


def boxes_obj(boxes):
    """An OBJ file of boxes: name and both corners of each."""
    lines = []
    for i, (name, *numbers) in enumerate(boxes):
        lines += ["o " + name]
        lines += [re.sub(r"\d+", lambda m, i=i: str(int(m[0]) + 8 * i), line) if line[0] == "f" else line
                  for line in box(*numbers)]
    return "\n".join(lines) + "\n"


# The room's wall as a hut of 4 m x 3 m x 4 m.
HUT = ROOM.replace("o wall", "o Hut_1").replace("v -1 ", "v -2 ").replace("v 1 ", "v 2 ").replace(" -5\n", " -8\n")


class Suggest(ProgramCase):
    def setUp(self):
        super().setUp()
        self.write("hut.obj", HUT)

    def suggest(self, model, *arguments):
        said = self.passes("info", model, "--suggest", "new.campus.yaml", *arguments).out
        root = []
        if os.path.isabs(model):
            root = ["--root", os.path.dirname(model)]
            self.assertIn(" ".join(root), said, "the user must be told")
        self.passes("validate", "new.campus.yaml", "new.walk.yaml", *root)
        log = self.passes("run", "new.walk.yaml", *root).out
        return self.read("new.campus.yaml").decode(), log

    def test_a_hut_becomes_a_building(self):
        campus, log = self.suggest("hut.obj")
        self.assertIn('{id: "hut-1", nodes: "Hut_1", title: "Hut_1"}', campus)
        self.assertRegex(campus, r'"hut-1/around", .* center: \[0\.000, 1\.500, -6\.000\], size: \[7\.000, 4\.000, 7\.000\]')
        self.assertRegex(log, r"trigger\.enter +hut-1/around")
        self.assertRegex(log, r"popup\.open +hut-1")
        self.assertNotIn("collision.enter", log)

    def test_grounds_apart_have_a_spawn_each(self):
        self.write("two.obj", boxes_obj([("west", -40, -1, -10, -20, 0, 0), ("east", 0, -1, -10, 20, 0, 10)]))
        campus, log = self.suggest("two.obj")
        self.assertRegex(campus, r"(?s)start: \{at: \[\d\..*# On 200 m² of ground that isn't reached from `start`\.\n"
                                 r"  start-2: \{at: \[-[23]\d\.")
        self.write("other.walk.yaml", "campus: new.campus.yaml\navatar: adult\nsteps:\n  - spawn: start-2\n  - wait: 1\n"
                                      "expect:\n  - never: avatar.fell *\n")
        self.passes("run", "other.walk.yaml")
        self.assertIn("spawn start-2, too: 200 m² of ground that isn't reached from start",
                      self.passes("info", "two.obj", "--suggest", "new.campus.yaml", "--overwrite").out)

    def test_what_is_higher_than_buildings_and_of_no_known_unit_is_asked_about(self):
        self.write("tower.obj", boxes_obj([("a", 0, 0, 0, 300, 900, 300), ("b", 300, 0, 0, 600, 500, 300)]))
        said = self.run_program("info", "tower.obj", "--strict")
        self.assertEqual(said.code, 1)
        self.assertIn("odd-scale: it is 600 x 900 x 300 m large, higher than buildings are, and nothing tells its unit", said.out)

    def test_crowded_places_are_left_out_and_said(self):
        side = 280
        points = ["v %g %g %g" % (2 + 2 * i / side, 0.3 + 0.1 * ((i * 7 + k * 3) % 5), 2 + 2 * k / side)
                  for i in range(side) for k in range(side)]
        triangles = [(0, 1, side), (side, 1, side + 1), (0, 1, side + 1), (0, side + 1, side)]
        faces = ["f %d %d %d" % tuple(9 + i * side + k + each for each in triangle)
                 for i in range(side - 1) for k in range(side - 1) for triangle in triangles]
        self.write("hedge.obj", boxes_obj([("lawn", -20, -1, -20, 20, 0, 20)]) + "\n".join(["o hedge", *points, *faces]) + "\n")
        self.suggest("hedge.obj")
        self.assertIn("# To save time, crowded places, with over 1000 triangles within 2 m, weren't tried.", self.read("new.walk.yaml").decode())
        self.assertIn("to save time, crowded places, with over 1000 ", self.passes("info", "hedge.obj", "--suggest", "x.campus.yaml").out)

    def test_names_that_no_campus_file_may_have_are_globs_and_titles_without(self):
        for name, glob, title in ((b"Hut\x07\x08A", "Hut??A", "Hut A"), (b"H\xfctte 1", "H?tte 1", "H tte 1"), (b"Hut \x01", "Hut ?", "Hut ")):
            with self.subTest(name=name):
                self.write("odd.obj", HUT.encode().replace(b"Hut_1", name))
                campus, _ = self.suggest("odd.obj", "--overwrite")
                self.assertIn('nodes: "%s", title: "%s"}' % (glob, title), campus)

    def test_the_axis_and_the_origin_of_a_model_are_corrected(self):
        def moved(line):
            kind, *numbers = line.split()
            if kind != "v":
                return line
            x, y, z = map(float, numbers)
            return "v %g %g %g" % (x + 85000, 446000 - z, y)
        self.write("hut.obj", "\n".join(map(moved, HUT.splitlines())))
        campus, log = self.suggest("hut.obj")
        self.assertIn("up: z}\norigin: {at: [85000.000, 0.000, -44600", campus)
        self.assertRegex(log, r" origin=85000\.000,0\.000,-446000\.000")
        self.assertRegex(log, r"trigger\.enter +hut-1/around")

    def test_what_the_import_leaves_out_is_told_as_info_tells_it(self):
        self.write("plain.obj", boxes_obj([("meadow", -20, -1, -20, 20, 0, 20)]) + "l 1 2\n")
        warnings = self.passes("info", "plain.obj").out.split("\nwarnings ")[1].splitlines()[1:]
        self.assertRegex(warnings[0], "points-and-lines: .* 1 points and lines are ignored")
        told = self.passes("info", "plain.obj", "--suggest", "plain.campus.yaml").out.splitlines()
        self.assertEqual(told[told.index("1 warning about the model") + 1:], warnings)

    def test_centimetres_are_inferred_from_a_door_that_is_left_open(self):
        door = [[-0.5, 0, -4.04], [0.5, 2.1, -4.02]]
        # The hut with a doorway in its front, and a door in that.
        boxes = [("meadow", -20, -1, -20, 20, 0, 20), ("l", -3, 0, -8, -2.8, 3, -4), ("r", 2.8, 0, -8, 3, 3, -4),
                 ("back", -3, 0, -8, 3, 3, -7.8), ("roof", -3, 3, -8, 3, 3.2, -4), ("f1", -3, 0, -4.1, -0.5, 3, -4),
                 ("f2", 0.5, 0, -4.1, 3, 3, -4), ("Tür", *door[0], *door[1])]
        self.write("hut.obj", boxes_obj([(name, *(100 * number for number in numbers)) for name, *numbers in boxes]))
        out = self.passes("info", "hut.obj", "--suggest", "new.campus.yaml").out
        self.assertRegex(out, "(?m)^1 closed door .*\n0 warnings ")
        campus = self.read("new.campus.yaml").decode()
        self.assertIn('{file: "hut.obj", scale: 0.01}', campus)
        self.assertIn('{id: "hut", building: "hut", except: "Tür", each: true, shape: mesh, mode: solid', campus)
        # In through the door and out again; a solid door blocks the avatar.
        self.write("door.walk.yaml", "campus: new.campus.yaml\navatar: adult\nsteps:\n  - spawn: {at: [0, 0, -1]}\n"
                   "  - walk_to: [0, 0, -6]\n  - walk_to: [0, 0, -1]\n")
        self.passes("run", "door.walk.yaml")
        self.write("new.campus.yaml", campus.replace(', except: "Tür"', ""))
        stuck = self.run_program("run", "door.walk.yaml")
        self.assertEqual(stuck.code, 1, stuck.out)
        self.assertIn('why="hut/tür (Tür) stands in the way at 0.00, ', stuck.out)
        # So does the suggested walk tell that somebody closed the door.
        self.assertIn('sequence: ["trigger.enter hut/inside"]', self.read("new.walk.yaml").decode())
        closed = self.run_program("run", "new.walk.yaml")
        self.assertEqual(closed.code, 1, closed.out)
        self.assertIn("hut/tür", closed.out)

    def test_a_gate_of_two_metres_that_one_could_climb_over_stands_in_the_way_all_the_same(self):
        # A court without a roof, all of one mesh.
        self.write("court.obj", boxes_obj([
            ("meadow", -20, -1, -20, 20, 0, 20), ("court_n", -3, 0, -9, 3, 4, -8.8), ("court_w", -3, 0, -9, -2.8, 4, -4),
            ("court_e", 2.8, 0, -9, 3, 4, -4), ("court_s1", -3, 0, -4.2, -0.6, 4, -4), ("court_s2", 0.6, 0, -4.2, 3, 4, -4),
            ("gate_leaf", -0.6, 0, -4.15, 0.6, 2, -4.05)]))
        self.write("court.campus.yaml", "scenes: [{file: court.obj}]\nlayers: [ground]\ncolliders:\n"
                   '  - {id: world, nodes: "*", shape: mesh, mode: solid, layer: ground, popup: false}\n'
                   "spawns: {start: {at: [0, 0, 4]}}\nplaces: {court: [0, 0, -6.5]}\n")
        route = self.run_program("route", "court.campus.yaml", "start", "court")
        self.assertEqual(route.code, 1, route.out)
        self.assertIn("world (gate_leaf) stands in the way at ", route.out)

    def test_rooms_behind_doorways_become_triggers_that_the_walk_visits(self):
        # A house of 12 m x 8 m in two halves, with a doorway between.
        self.write("house.obj", boxes_obj([
            ("meadow", -30, -1, -30, 30, 0, 30), ("House_n", -6, 0, -12, 6, 3, -11.8), ("House_w", -6, 0, -12, -5.8, 3, -4),
            ("House_e", 5.8, 0, -12, 6, 3, -4), ("House_s1", -6, 0, -4.2, 3, 3, -4), ("House_s2", 4, 0, -4.2, 6, 3, -4),
            ("House_s3", 3, 2.1, -4.2, 4, 3, -4), ("House_roof", -6, 3, -12, 6, 3.2, -4),
            ("House_mid1", -0.1, 0, -12, 0.1, 3, -7), ("House_mid2", -0.1, 0, -6, 0.1, 3, -4),
            ("House_mid3", -0.1, 2.1, -7, 0.1, 3, -6)]))
        campus, log = self.suggest("house.obj")
        rooms = re.findall(r'"(house/room-\d)", building: "house", shape: box, center: \[(.*?)\], size: \[(.*?)\], '
                           'mode: trigger, popup: false', campus)
        self.assertEqual([name for name, _, _ in rooms], ["house/room-1", "house/room-2"])
        for (_, center, size), x in zip(rooms, (2.95, -2.95)):
            self.assertTrue(all(abs(float(a) - b) < 0.15 for a, b in zip(center.split(","), (x, 1, -8))), center)
            # A visitor's middle keeps 0.3 m off the walls.
            self.assertTrue(all(abs(float(a) - b) < 0.26 for a, b in zip(size.split(","), (5.1, 2, 7.0))), size)
        self.assertRegex(log, r"(?s)trigger\.enter +house/room-1.*trigger\.enter +house/room-2")
        # Somebody closes the inner doorway: the walk tells.
        self.assertIn('sequence: ["trigger.enter house/room-2"]', self.read("new.walk.yaml").decode())
        self.write("new.campus.yaml", campus.replace(
            "colliders:\n", "colliders:\n  - {id: leaf, shape: box, center: [0, 1, -6.5], size: [0.05, 2, 1], mode: solid}\n"))
        closed = self.run_program("run", "new.walk.yaml")
        self.assertEqual(closed.code, 1, closed.out)
        self.assertIn("leaf stands in the way", closed.out)

    def house_with(self, *walls):
        """A house of 12 m x 8 m with a front that has a doorway of 1 m, and a back that is `walls`."""
        self.write("house.obj", boxes_obj([
            ("meadow", -30, -1, -30, 30, 0, 30), ("House_w", -6, 0, -12, -5.8, 3, -4), ("House_e", 5.8, 0, -12, 6, 3, -4),
            ("House_s1", -6, 0, -4.2, 3, 3, -4), ("House_s2", 4, 0, -4.2, 6, 3, -4), ("House_roof", -6, 3, -12, 6, 3.2, -4),
            *walls]))

    def test_the_walk_says_what_a_closed_doorway_does_to_it(self):
        self.house_with(("House_n", -6, 0, -12, 6, 3, -11.8))
        self.suggest("house.obj")
        walk = self.read("new.walk.yaml").decode()
        self.assertRegex(walk, r"(?m)^  # Closing the doorway at \[3\.[3-6]\d\d, 0\.000, -4\.\d+\], 1\.0\d m wide, "
                               r"leaves no path of up to 100 m\.\n  - go_to: ")
        self.assertIn("  closing the doorway at ", self.passes("info", "house.obj", "--suggest", "b.campus.yaml").out)
        # With a second doorway, the walk takes that one, which is a detour.
        self.house_with(("House_n1", -6, 0, -12, 3, 3, -11.8), ("House_n2", 4, 0, -12, 6, 3, -11.8))
        campus, _ = self.suggest("house.obj", "--overwrite")
        x, z = re.search(r"Closing the doorway at \[(\S+), \S+, (\S+)\], .* leaves another path\.\n",
                         self.read("new.walk.yaml").decode()).groups()
        self.write("new.campus.yaml", campus.replace(
            "colliders:\n", "colliders:\n  - {id: leaf, shape: box, center: [%s, 1, %s], size: [1.2, 3, 0.3], mode: solid}\n" % (x, z)))
        closed = self.run_program("run", "new.walk.yaml")
        self.assertEqual(closed.code, 1, closed.out)
        self.assertIn("duration", closed.out)

    def test_a_closed_room_is_walked_about_in_and_not_on_top_of(self):
        self.write("hall.obj", boxes_obj([
            ("floor", -15, -0.2, -10, 15, 0, 10), ("ceiling", -15, 5, -10, 15, 5.2, 10), ("north", -15, 0, -10, 15, 5, -9.8),
            ("south", -15, 0, 9.8, 15, 5, 10), ("west", -15, 0, -10, -14.8, 5, 10), ("east", 14.8, 0, -10, 15, 5, 10)]))
        campus, log = self.suggest("hall.obj")
        self.assertNotIn("id: ground", campus)
        self.assertRegex(campus, r"start: \{at: \[-?[0-9.]+, 0\.000, ")
        self.assertIn("avatar.arrive", log)

    def test_nobody_starts_on_the_roof_of_what_is_full(self):
        self.write("store.obj", boxes_obj(
            [("Store_roof", -11, 5, -11, 11, 5.2, 11), ("Store_base", -11, 0, -11, 11, 2, 11)] +
            [("Store_shelf", x - 0.2, 2, -11, x + 0.2, 4, 11) for x in range(-10, 11)]))
        campus, log = self.suggest("store.obj")
        self.assertIn("id: ground", campus)
        self.assertRegex(campus, r"start: \{at: \[-?[0-9.]+, 0\.000, ")
        self.assertIn("avatar.arrive", log)

    def test_what_has_no_area_is_not_solid(self):
        self.write("hut.obj", HUT + "o path\nv 5 0 5\nv 6 0 5\nv 7 0 5\nf -1 -2 -3\n")
        self.suggest("hut.obj")

    def test_what_nobody_can_walk_about_in_is_said_with_its_size(self):
        self.write("toy.obj", boxes_obj([("floor", -0.1, -0.1, -0.1, 0.1, 0, 0.1)]))
        refused = self.run_program("info", "toy.obj", "--suggest", "toy.campus.yaml")
        self.assertIn("it is 0.200 x 0.100 x 0.200 m large, too small to walk about in, and nothing tells its unit", refused.err)
        self.assertEqual(self.run_program("info", "toy.obj", "--strict").code, 1)

    def test_without_doors_the_walk_goes_to_far_corners(self):
        # Two halves with 3 m between them are one room, and there is no ground outside.
        self.write("flat.obj", boxes_obj([
            ("Flat_floor", -10, -0.2, -3, 10, 0, 3), ("Flat_n", -10, 0, -3, 10, 3, -2.8), ("Flat_s", -10, 0, 2.8, 10, 3, 3),
            ("Flat_w", -10, 0, -3, -9.8, 3, 3), ("Flat_e", 9.8, 0, -3, 10, 3, 3), ("Flat_mid", -0.1, 0, -3, 0.1, 3, -0.2)]))
        campus, _ = self.suggest("flat.obj")
        visits = [[float(c) for c in visit.split(",")]
                  for visit in re.findall(r"go_to: \[(.*?)\]", self.read("new.walk.yaml").decode())]
        self.assertEqual(len(visits), 2, visits)
        self.assertIn("# It goes through no door: ", self.read("new.walk.yaml").decode())
        xs = sorted(x for x, _, _ in visits)
        self.assertTrue(xs[0] < -8 and xs[1] > 8, visits)
        self.write("new.campus.yaml", campus.replace(
            "colliders:\n", "colliders:\n  - {id: shelf, shape: box, center: [0, 1, 1.3], size: [0.3, 2, 3.2], mode: solid}\n"))
        closed = self.run_program("run", "new.walk.yaml")
        self.assertEqual(closed.code, 1, closed.out)
        self.assertIn("shelf stands in the way", closed.out)

    def test_nothing_is_overwritten_without_a_flag(self):
        for taken in ("new.campus.yaml", "new.walk.yaml"):
            self.write(taken, "mine")
            outcome = self.run_program("info", "hut.obj", "--suggest", "new.campus.yaml")
            self.assert_refused(outcome, taken + ": error file-exists: --overwrite")
            self.assertEqual(self.read(taken), b"mine")
            os.remove(self.path(taken))
        self.write("new.walk.yaml", "mine")
        self.suggest("hut.obj", "--overwrite")

    def test_a_suggestion_is_not_printed_as_json(self):
        outcome = self.run_program("info", "hut.obj", "--suggest", "new.campus.yaml", "--json")
        self.assert_refused(outcome, "--json: error bad-value: the campus and its walk are written")
        self.assertNotIn("new.campus.yaml", self.contents())

    def test_a_map_of_a_suggestion_shows_more_than_one_of_the_model(self):
        if self.run_program("info", "hut.obj", "--map", "plain.png").code == 2:
            self.skipTest("this build draws nothing")
        self.suggest("hut.obj", "--map", "map.png")
        plain, marked = self.read("plain.png"), self.read("map.png")
        self.assertTrue(marked.startswith(b"\x89PNG"))
        self.assertNotEqual(plain, marked)

    def test_what_is_unsure_fails_a_strict_suggestion_too(self):
        tall = [("meadow", -200, -1, -200, 200, 0, 200)]
        tall += [("step", 0, 0, 3 * i, 10, 1.7 * (i + 1), 3 * (i + 1)) for i in range(10)]
        self.write("tall.obj", boxes_obj(tall))
        outcome = self.run_program("info", "tall.obj", "--suggest", "new.campus.yaml", "--strict")
        self.assertEqual(outcome.code, 1, outcome.out)
        self.assertIn("odd-scale: 9 risers are 1.7 m high", outcome.out)
        self.assertIn("  # To be decided: 9 risers are 1.7 m high", self.read("new.campus.yaml").decode())

    def test_buildings_that_are_left_out_are_counted(self):
        self.write("town.obj", boxes_obj([("meadow", -100, -1, -100, 200, 0, 200)] + [
            ("%08d" % (10 * x + z), 15 * x, 0, 15 * z, 15 * x + 8, 6, 15 * z + 8) for x in range(9) for z in range(5)]))
        self.assertIn("\nbuildings  40, and 5 smaller ones without names\n", self.passes("info", "town.obj").out)
        said = self.passes("info", "town.obj", "--suggest", "new.campus.yaml").out
        self.assertIn("new.campus.yaml: 40 buildings, and 5 smaller ones without names left out\n", said)
        self.assertIn("buildings:\n  # And 5 smaller ones without names.\n", self.read("new.campus.yaml").decode())

    def test_a_campus_must_be_named_as_one(self):
        outcome = self.run_program("info", "hut.obj", "--suggest", "new.yaml")
        self.assertEqual(outcome.code, 2)
        self.assertRegex(outcome.err, "new.yaml: error file-name: .*NAME.campus.yaml")

    def test_a_model_without_ground_or_building_is_refused(self):
        self.write("wall.obj", "v 0 0 0\nv 0.05 0 0\nv 0 0.05 0.03\nf 1 2 3\n")
        self.write("new.campus.yaml", "mine")
        self.write("new.walk.yaml", "mine")
        before = sorted(self.contents())
        outcome = self.run_program("info", "wall.obj", "--suggest", "new.campus.yaml", "--overwrite")
        self.assertEqual(outcome.code, 2)
        self.assertIn("wall.obj: error no-ground", outcome.err)
        self.assertEqual(sorted(self.contents()), before)
        self.assertEqual((self.read("new.campus.yaml"), self.read("new.walk.yaml")), (b"mine", b"mine"))

    def test_a_building_without_ground_gets_some(self):
        self.write("hut.obj", "o Hut_1\n" + "\n".join(box(-2, 0, -8, 2, 3, -4)) + "\n")
        campus, log = self.suggest("hut.obj")
        self.assertRegex(campus, r"# The model has no ground.*\n  - \{id: ground, shape: box, center: "
                                 r"\[0\.000, -0\.250, -6\.000\], size: \[44\.000, 0\.500, 44\.000\], mode: solid\}")
        self.assertRegex(campus, r"start: \{at: \[-?[0-9.]+, 0\.000, ")
        self.assertIn("avatar.arrive", log)

    def test_ground_that_is_missing_is_made_at_the_height_of_the_doors(self):
        def part(name, number, *bounds):
            return "o %s\n" % name + re.sub("[1-8]", lambda m: str(8 * number + int(m[0])),
                                            "\n".join(line for line in box(*bounds) if line[0] == "f"))
        solids = (("Hut_1", (-2, -1, -8, 2, 3, -4)), ("Front_Door", (-0.5, 0.4, -4.02, 0.5, 2.5, -3.96)))
        vertices = "\n".join(line for _, bounds in solids for line in box(*bounds) if line[0] == "v")
        self.write("hut.obj", vertices + "\n" + "\n".join(part(name, i, *b) for i, (name, b) in enumerate(solids)) + "\n")
        campus, log = self.suggest("hut.obj")
        self.assertRegex(campus, r"\{id: ground, shape: box, center: \[0\.000, 0\.150, -5\.980\]")  # its top is at 0.4
        self.assertIn("\n# The visitor walks on the box `ground` of that file: the model has no ground.\n",
                      self.read("new.walk.yaml").decode())
        self.assertIn("avatar.arrive", log)
        self.assertIn(", played, on a box: the model has no ground; it goes through no door\n",
                      self.passes("info", "hut.obj", "--suggest", "new.campus.yaml", "--overwrite").out)

    def test_an_only_building_without_a_name_is_called_like_its_file(self):
        guid = "b31bcc29d-00ba-11e6-b420-2bdcc4ab5d7f"
        self.write("hut.obj", HUT.replace("Hut_1", guid))
        campus, log = self.suggest("hut.obj")
        self.assertIn('{id: "hut", nodes: "%s", title: "hut"}' % guid, campus)
        self.assertRegex(log, r"popup\.open +hut")

    def test_the_visitor_starts_outside_and_faces_the_building(self):
        campus, log = self.suggest("hut.obj")
        self.assertNotIn("popup.open", log.split("avatar.arrive")[0].splitlines()[1])
        x, z, yaw = map(float, re.search(r"at: \[(\S+), \S+, (\S+)\], yaw_deg: (\S+)\}", campus).groups())
        self.assertTrue(abs(x) > 2.3 or abs(z + 6) > 2.3, (x, z))
        ahead = (-math.sin(math.radians(yaw)), -math.cos(math.radians(yaw)))
        to_hut = (0 - x, -6 - z)
        cosine = (ahead[0] * to_hut[0] + ahead[1] * to_hut[1]) / math.hypot(*to_hut)
        self.assertGreater(cosine, 0.0)  # doesn't turn its back to it

    def test_each_building_of_the_demo_campus_is_found(self):
        campus, _ = self.suggest(os.path.join(ROOT, "campus_assets", "demo", "buildings.glb"))
        titles = re.findall(r'(?m)^  - \{id: .*title: "(.*)"\}$', campus)
        self.assertEqual(titles, ["gatehouse", "library", "theatre", "cafeteria", "admin", "science", "gallery",
                                  "clock_tower", "dorm", "sports_hall", "greenhouse", "observatory", "pavilion"])
        for name in ("furniture", "vegetation"):
            self.assertNotIn("buildings:", self.suggest(
                os.path.join(ROOT, "campus_assets", "demo", name + ".glb"), "--overwrite")[0])

    def test_the_walk_enters_the_school_that_init_writes(self):
        self.passes("init", "school")
        campus, log = self.suggest(os.path.join("school", "school.obj"))
        self.assertIn('{id: "library", nodes: ["library_walls", "library_desk"], title: "library"}', campus)
        self.assertRegex(log, r"trigger\.enter +library/inside")

    def test_suggestions_for_the_demo_campus_walk(self):
        for name in ("ground", "buildings", "furniture", "vegetation"):
            with self.subTest(model=name):
                model = os.path.join(ROOT, "campus_assets", "demo", name + ".glb")
                self.assertIn("avatar.arrive", self.suggest(model, "--overwrite")[1])

    def test_suggestions_for_third_party_models_walk(self):
        if not os.path.isdir(SHARED):
            raise unittest.SkipTest("no " + SHARED)
        models = [os.path.join(SHARED, name) for name in THIRD_PARTY]
        for model in models:
            with self.subTest(model=os.path.relpath(model, SHARED)):
                campus, log = self.suggest(model, "--overwrite")
                self.assertIn("avatar.arrive", log)
                self.assertNotIn("avatar.depenetrated", log)
                has_buildings = not any(name in model for name in WITHOUT_BUILDINGS)
                self.assertEqual("buildings:" in campus, has_buildings)



if __name__ == "__main__":
    main()
