#!/usr/bin/env python3
"""`campuswalk collide`: every pair of kinds, against results worked out by hand."""

import itertools
import json
import math

from program import ProgramCase, main


def obj(name, points, triangles):
    return "\n".join(["o " + name] + ["v %.9g %.9g %.9g" % tuple(point) for point in points]
                     + ["f %d %d %d" % tuple(i + 1 for i in triangle) for triangle in triangles]) + "\n"


CUBE = [(0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1), (2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4),
        (1, 5, 7), (1, 7, 3)]


def cube(name, low, high, at=(0, 0, 0)):
    """A cube whose triangles 0 and 1 are at the least x, and 2 and 3 at the greatest."""
    return obj(name, itertools.product(*((low + middle, high + middle) for middle in at)), CUBE)


def strip(count):
    """Squares of a metre on the ground along +x from the origin. Of square i, triangle 2 i has the greater z."""
    points = [(x, 0, z) for x in range(count + 1) for z in (0, 1)]
    halves = [((2 * i, 2 * i + 1, 2 * i + 3), (2 * i, 2 * i + 3, 2 * i + 2)) for i in range(count)]
    return obj("strip", points, [triangle for half in halves for triangle in half])


# Sizes that are exact binary fractions, so that touching bodies touch exactly. How far each reaches along x:
REACH = {"unit.obj": 0.5, "box:0.5,0.5,0.5": 0.25, "sphere:0.5": 0.5, "capsule:0.25,0.75": 0.25, "wheel:0.25,0.5": 0.25}
FACE = {"a": [2, 3], "b": [0, 1]}  # the triangles of a cube that face the other body


class Collide(ProgramCase):
    def setUp(self):
        super().setUp()
        self.write("unit.obj", cube("unit", -0.5, 0.5))
        self.write("half.obj", cube("half", -0.25, 0.25))
        self.write("strip.obj", strip(4))
        self.write("flag.obj", obj("flag\"x\"", [(0.5, -1, 0.1), (0.5, 1, 0.1), (0.5, 0, 0.9)], [(0, 1, 2)]))

    def collide(self, *arguments):
        outcome = self.run_program("collide", *arguments)
        self.assertEqual(outcome.err, "")
        self.assertIn(outcome.code, (0, 1))
        return outcome

    def found(self, *arguments):
        outcome = self.collide(*arguments, "--json")
        found = json.loads(outcome.out)
        self.assertEqual(outcome.code, 1 if found["overlapping"] else 0)
        return found

    def refused(self, *arguments, expected):
        outcome = self.run_program("collide", *arguments)
        self.assertEqual(outcome.out, "")
        self.assert_refused(outcome, expected)


class EveryPairOfKinds(Collide):
    """Side by side along x: apart, touching and a little inside of each other."""

    def pairs(self):
        for a, b in itertools.product(REACH, repeat=2):
            with self.subTest(a=a, b=b):
                yield a, b, REACH[a] + REACH[b]

    def test_separate_shapes_exit_with_0(self):
        for a, b, reach in self.pairs():
            outcome = self.collide(a, b, "--pose", "%r,0,0" % (reach + 0.25))
            solids = "obj" not in a + b
            self.assertEqual((outcome.code, outcome.lines[1:]), (0, ["apart: 0.250000 m" if solids else "apart"]))
            self.assertEqual(self.collide(a, b, "--count", "--pose", "%r,0,0" % (reach + 1e-9)).out, "0\n")

    def test_touching(self):
        for a, b, reach in self.pairs():
            self.assertEqual(self.collide(a, b, "--pose", "%r,0,0" % reach).code, 1)

    def test_overlapping(self):
        for a, b, reach in self.pairs():
            found = self.found(a, b, "--pose", "%r,0,0" % (reach - 1 / 64))
            self.assertTrue(found["overlapping"])
            if "obj" not in a + b:
                self.assertEqual((found["distance"], found["count"]), (0, 1))
            elif a != b:
                side = "a" if "obj" in a else "b"
                self.assertEqual([t[side] for t in found["triangles"]], FACE[side])

    def test_enclosing_solids_overlap_and_meshes_do_not(self):
        for solid in list(REACH)[1:]:
            self.assertEqual(self.found(solid, "box:9,9,9", "--pose", "1,2,3")["overlapping"], True)
            self.assertEqual(self.found("unit.obj", solid, "--scale", "9", "--pose", "1,2,3")["overlapping"], False)


class TwoMeshes(Collide):
    """Pairs of triangles."""

    def test_text(self):
        outcome = self.collide("strip.obj", "flag.obj", "--pose", "2,0,0")
        self.assertEqual(outcome.lines, ["# a strip.obj (8 triangles), b flag.obj (1 triangle)",
                                         r'a 4 b 0 "strip" "flag\"x\""', r'a 5 b 0 "strip" "flag\"x\""',
                                         "overlapping: 2 triangle pairs"])
        self.assertEqual(outcome.code, 1)

    def test_pairs_along_the_strip(self):
        for x in range(-1, 5):
            found = self.found("strip.obj", "flag.obj", "--pose", "%d,0,0" % x)
            on_it = 0 <= x < 4
            self.assertEqual([(p["a"], p["b"]) for p in found["pairs"]], [(2 * x, 0), (2 * x + 1, 0)] if on_it else [])
            self.assertEqual(found["count"], 2 if on_it else 0)
        # Farther along z the flag overlaps one half of the square only; at its end it touches the edge.
        self.assertEqual([p["a"] for p in self.found("strip.obj", "flag.obj", "--pose", "1,0,0.5")["pairs"]], [2])
        self.assertEqual(self.collide("strip.obj", "flag.obj", "--pose", "1,1,0").code, 1)
        self.assertEqual(self.collide("strip.obj", "flag.obj", "--pose", "1,1.000000001,0").code, 0)

    def test_a_cube_in_the_face_of_another(self):
        found = self.found("unit.obj", "half.obj", "--pose", "%r,0,0" % (0.75 - 1 / 64))
        self.assertEqual({p["a"] for p in found["pairs"]}, set(FACE["a"]))
        self.assertEqual({p["b"] for p in found["pairs"]}, set(range(4, 12)))
        order = [(p["a"], p["b"]) for p in found["pairs"]]
        self.assertEqual(order, sorted(set(order)))
        self.assertEqual({p["a_node"] for p in found["pairs"]} | {p["b_node"] for p in found["pairs"]}, {"unit", "half"})

    def test_nodes(self):
        found = self.found("room.obj", "sphere:0.5", "--pose", "0,0,-4")
        names = {t["a"]: t["a_node"] for t in found["triangles"]}
        self.assertEqual(set(names.values()), {"floor", "wall"})
        self.assertEqual({t for t, name in names.items() if name == "floor"}, {t for t in names if t < 2})

    def test_the_files_numbers_are_used_exactly(self):
        """0.2 in float32 is 0.20000000298."""
        self.write("fifth.obj", cube("fifth", 0, 0.2))
        for x, code in (("0.2", 1), ("0.20000000298023224", 1), ("0.20000000298023227", 0)):
            self.assertEqual(self.collide("fifth.obj", "fifth.obj", "--pose", x + ",0.1,0.05").code, code)

    def test_thin_triangles_are_included(self):
        self.write("thin.obj", obj("thin", [(0, 0, 0), (1, 0, 0), (0.5, 0, 0), (0, 1, 0)], [(0, 1, 2), (0, 1, 3)]))
        found = self.found("thin.obj", "sphere:0.25", "--pose", "0.5,-0.25,0")
        self.assertEqual([t["a"] for t in found["triangles"]], [0, 1])

    def test_far_away_meshes(self):
        self.write("far.obj", cube("far", 450000, 450001))
        self.assertEqual(self.collide("far.obj", "far.obj", "--pose", "1,0,0").code, 1)
        self.assertEqual(self.collide("far.obj", "far.obj", "--pose", "1.000001,0,0").code, 0)
        self.assertEqual(self.collide("far.obj", "unit.obj", "--pose", "450001.5,450000.5,450000.5").code, 1)


class TwoShapes(Collide):
    """Distances, and the order of rotations."""

    def expect_distance(self, distance, *arguments):
        self.assertAlmostEqual(self.found(*arguments)["distance"], distance, delta=1e-12)

    def test_distances(self):
        self.expect_distance(1.5 - math.sqrt(0.5), "box:1,1,1", "box:1,1,1", "--pose", "2,0,0,45")
        self.expect_distance(5, "box:1,2,3", "box:1,2,3", "--pose", "4,6,0.5")
        self.expect_distance(0.4, "wheel:0.3,0.2", "wheel:0.3,0.2", "--pose", "0,0.8,-0.6")
        self.expect_distance(math.sqrt(3) - 1, "sphere:0.5", "sphere:0.5", "--pose", "1,1,1")
        self.expect_distance(math.hypot(0.4, 0.7) - 0.5, "wheel:0.3,0.2", "sphere:0.5", "--pose", "0.5,1,0")

    def test_turns(self):
        for turns, reach in (("", 0.25), (",0,0,90", 1), (",0,90", 0.25), (",90,90", 1), (",0,90,90", 1),
                             (",45,0,90", math.sqrt(0.5) * 0.75 + 0.25), (",-90,-90", 1), (",450,90", 1)):
            self.expect_distance(2.5 - reach, "box:1,9,9", "capsule:0.25,2", "--pose", "3,0,0" + turns)

    def test_signs_of_rotations(self):
        """Yaw takes +z to +x, pitch +y to +z, roll +x to +y: right-handed about y, x and z."""
        x, y, z = (2, 0, 0), (0, 2, 0), (0, 0, 2)
        for start, turns, end in ((z, "90", x), (x, "-90", z), (y, "0,90", z), (z, "0,-90", y), (x, "0,0,90", y),
                                  (y, "0,0,-90", x), (y, "90,90", x), (x, "0,90,90", z)):
            self.write("start.obj", cube("start", -0.125, 0.125, start))
            self.write("end.obj", cube("end", -0.0625, 0.125, end))
            self.assertEqual(self.collide("end.obj", "start.obj", "--pose", "0,0,0," + turns).code, 1, turns)
            self.assertEqual(self.collide("end.obj", "start.obj", "--pose", "0.5,0,0," + turns).code, 0, turns)

    def test_a_matrix_and_angles_agree(self):
        c, s = math.cos(0.5), math.sin(0.5)
        rows = "%r,0,%r,1, 0,1,0,0.25, %r,0,%r,0".replace(" ", "") % (c, s, -s, c)
        for a, b in (("unit.obj", "half.obj"), ("wheel:0.5,0.25", "unit.obj"), ("box:1,1,1", "capsule:0.25,2")):
            turned = self.found(a, b, "--pose", "1,0.25,0,%r" % math.degrees(0.5))
            by_rows = self.found(a, b, "--pose-matrix", rows)
            self.assertAlmostEqual(turned.pop("distance", 0), by_rows.pop("distance", 0), delta=1e-12)
            self.assertEqual(turned, by_rows)


class Output(Collide):
    """--first, --count, --json, --up and --scale."""

    def test_first_prints_one_pair(self):
        everything = self.collide("unit.obj", "half.obj", "--pose", "0.7,0,0").lines
        first = self.collide("unit.obj", "half.obj", "--pose", "0.7,0,0", "--first").lines
        self.assertEqual((len(first), first[2]), (3, "overlapping"))
        self.assertIn(first[1], everything[1:-1])
        self.assertEqual(self.collide("unit.obj", "sphere:0.5", "--first", "--pose", "0.9,0,0").lines[1:],
                         ['a 2 "unit"', "overlapping"])
        self.assertNotIn("count", self.found("unit.obj", "sphere:0.5", "--first"))

    def test_count_prints_only_the_number(self):
        for arguments in (("unit.obj", "half.obj", "--pose", "0.7,0,0"), ("sphere:0.5", "unit.obj", "--pose", "0.9,0,0"),
                          ("sphere:0.5", "box:1,1,1")):
            count = self.found(*arguments)["count"]
            self.assertGreater(count, 0)
            outcome = self.collide(*arguments, "--count")
            self.assertEqual((outcome.out, outcome.code), ("%d\n" % count, 1))
            self.assertEqual(set(self.found(*arguments, "--count")) & {"pairs", "triangles"}, set())

    def test_text_of_shapes(self):
        self.assertEqual(self.collide("box:1,1,1", "sphere:0.5", "--pose", "0.5,0,0").lines,
                         ["# a box:1,1,1, b sphere:0.5", "overlapping"])
        self.assertEqual(self.collide("sphere:0.5", "unit.obj", "--pose", "0.9,0,0").lines,
                         ["# a sphere:0.5, b unit.obj (12 triangles)", 'b 0 "unit"', 'b 1 "unit"',
                          "overlapping: 2 triangles"])

    def test_axes_and_scale(self):
        self.assertEqual(self.collide("unit.obj", "half.obj", "--pose", "1.4,0,0").code, 0)
        self.assertEqual(self.collide("unit.obj", "half.obj", "--pose", "1.4,0,0", "--scale", "2").code, 1)
        self.write("tall.obj", obj("tall", [(0, 0, 0), (1, 0, 0), (0, 0, 9)], [(0, 1, 2)]))
        self.assertEqual(self.collide("tall.obj", "sphere:0.5", "--pose", "0,8,0").code, 0)
        self.assertEqual(self.collide("tall.obj", "sphere:0.5", "--pose", "0,8,0", "--up", "z").code, 1)


class BadInput(Collide):
    """Diagnostics say what is expected; nothing is on standard output."""

    def test_invalid_shapes_are_refused(self):
        for word, expected in (
                ("box", "bad-shape: 3 0 box:WIDTH,HEIGHT,DEPTH"),
                ("box:", "bad-shape: 3 0 box:WIDTH,HEIGHT,DEPTH"),
                ("box:1,1", "bad-shape: 3 2 box:WIDTH,HEIGHT,DEPTH"),
                ("box:1,1,1,", "bad-shape: 3 4 box:WIDTH,HEIGHT,DEPTH"),
                ("box:1,x,1", "bad-shape: height 'x' box:WIDTH,HEIGHT,DEPTH"),
                ("box:1,1,0", "bad-shape: depth 0 1000000 m '0' box:WIDTH,HEIGHT,DEPTH"),
                ("sphere:nan", "bad-shape: radius 'nan' sphere:RADIUS"),
                ("capsule:1,1.9", "bad-shape: height radius capsule:RADIUS,HEIGHT"),
                ("wheel:1", "bad-shape: 2 1 wheel:RADIUS,WIDTH"),
                ("spere:1", "unknown-shape: 'spere' 'sphere'")):
            with self.subTest(word=word):
                self.refused(word, "sphere:1", expected="%s: error %s" % (word, expected))
                self.refused("unit.obj", word, expected="%s: error %s" % (word, expected))

    def test_invalid_poses_are_refused(self):
        for word, names in (("1,2", "3 6 not 2;"), ("1,2,3,4,5,6,7", "3 6 not 7;"), ("1,,3", "y ''"),
                            ("0,0,0,1e9", "yaw -36000 36000 '1e9'")):
            self.refused("sphere:1", "sphere:1", "--pose", word,
                         expected="--pose %s: error bad-pose: %s" % (word, names))
        for word, names in (("1", "12 not 1;"), ("2,0,0,0,0,1,0,0,0,0,1,0", "matrix rotation"),
                            ("1,0,0,0,0,1,0,0,0,0,-1,0", "matrix mirror")):
            self.refused("sphere:1", "sphere:1", "--pose-matrix", word,
                         expected="--pose-matrix %s: error bad-pose: %s" % (word, names))

    def test_invalid_files_are_refused(self):
        self.write("broken.obj", "f 1 2 3\n")
        self.write("huge.obj", cube("huge", 0, 1e30))
        for name, code in (("none.obj", "missing-file"), ("broken.obj", None), ("huge.obj", "bad-size"),
                           ("c:/none.obj", "missing-file")):
            outcome = self.run_program("collide", "unit.obj", name)
            self.assertEqual((outcome.code, outcome.out), (2, ""), name)
            self.assertRegex(outcome.err, "^%s: error %s: " % (name, code or r"[a-z-]+"))

    def test_invalid_usage_is_refused(self):
        for arguments in ((), ("unit.obj",), ("a", "b", "c"), ("a", "b", "--first", "--count"),
                          ("a", "b", "--pose", "0,0,0", "--pose-matrix", "1")):
            outcome = self.run_program("collide", *arguments)
            self.assertEqual((outcome.code, outcome.out), (2, ""))
            self.assertIn("campuswalk collide --help", outcome.err_lines[-1])


if __name__ == "__main__":
    main()
