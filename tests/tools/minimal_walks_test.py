#!/usr/bin/env python3
"""The walks of `campuswalk explore --write-walks`: each fails where its finding is, and passes however that is mended."""

import os
import re

from explore_test import FLOOR, YARD, box
from program import ProgramCase, main

GATE = box("shed/gate-leaf", (4.4, 0, -5.13), (5.05, 2.2, -5.07))
OPEN_YARD = YARD.replace(GATE, "")


def with_more(campus, *objects):
    return campus.replace("spawns:", "".join(objects) + "spawns:")


def fence(name, low, high, y):
    """Four rails around a rectangle of x and z."""
    (x0, z0), (x1, z1) = low, high
    return (box(name + "/n", (x0, y, z0), (x1, y + 1.2, z0 + 0.1)) + box(name + "/s", (x0, y, z1 - 0.1), (x1, y + 1.2, z1))
            + box(name + "/w", (x0, y, z0), (x0 + 0.1, y + 1.2, z1)) + box(name + "/e", (x1 - 0.1, y, z0), (x1, y + 1.2, z1)))


FENCED_PEN = fence("fence", (-7.1, -7.1), (-4.9, -3.9), 1)
STEPS_IN_PEN = "".join(box("inner-%d" % i, (-7, -0.1, -7), (-5.35 - 0.4 * i, 0.25 * i, -4)) for i in range(1, 4))


class MinimalWalks(ProgramCase):
    def setUp(self):
        super().setUp()
        self.write("floor.obj", FLOOR)

    def walk_of(self, kind, campus, *arguments):
        """The text of the only walk of this kind; it is an xfail that fails as it says, without a warning."""
        self.write("yard.campus.yaml", campus)
        self.passes("explore", "yard.campus.yaml", "--write-walks", "walks", *arguments)
        name, = [name for name in os.listdir(self.path("walks")) if re.match(r"\d+-" + kind, name)]
        done = self.run_program("run", "walks/" + name, "--rendering-backend", "none")
        self.assertEqual(0, done.code, done.out + done.err)
        self.assertIn("fails as expected", done.err)
        self.assertNotIn("warning", done.err)
        return self.read("walks/" + name).decode()

    def assert_passes_on(self, walk, campus):
        """Its author has taken away its status."""
        self.write("yard.campus.yaml", campus)
        self.write("walks/mended.walk.yaml", re.sub(r"(?m)^status: .*\n", "", walk))
        done = self.run_program("run", "walks/mended.walk.yaml", "--rendering-backend", "none")
        self.assertEqual(0, done.code, walk + done.out + done.err)

    def spawn_of(self, walk):
        return [float(number) for number in re.search(r"spawn: {at: \[(.*)\]}", walk).group(1).split(", ")]

    def test_a_step_that_is_too_high(self):
        walk = self.walk_of("unreached-place-stage", YARD)
        self.assertLess(self.spawn_of(walk)[0], 3.2, "some strides before it, where a ramp may begin")
        self.assert_passes_on(walk, with_more(YARD, box("ramp", (3.4, -0.1, 4), (4, 0.2, 9.8))))
        self.assert_passes_on(walk, YARD.replace(box("stage", (4, -0.1, 4), (9.8, 0.45, 9.8)),
                                                 box("stage", (4, -0.1, 4), (9.8, 0.25, 9.8))).replace("0.45", "0.25"))

    def test_a_gate_that_is_in_the_way(self):
        walk = self.walk_of("unreached-place-shed", YARD)
        self.assert_passes_on(walk, OPEN_YARD)

    def test_an_island(self):
        desk = box("desk", (-3, 0, 3), (-1, 0.5, 5))
        walk = self.walk_of("islands-island", with_more(YARD, desk))
        self.assert_passes_on(walk, with_more(YARD, desk.replace("0.25", "0.1").replace("0.5,", "0.2,")))

    def test_a_narrow_passage(self):
        walk = self.walk_of("narrow", OPEN_YARD, "--min-width", "1.3")
        self.assert_passes_on(walk, OPEN_YARD.replace(box("shed/right", (5.6, 0, -5.2), (9.8, 2.5, -5)),
                                                      box("shed/right", (7.6, 0, -5.2), (9.8, 2.5, -5))))

    def test_a_trap_with_a_fence_or_with_steps_out_of_it(self):
        walk = self.walk_of("traps", YARD)
        self.assertGreater(self.spawn_of(walk)[1], 0.2, "on the steps before it, not in it")
        self.assertIn("failures: [unreachable]", walk)
        self.assert_passes_on(walk, with_more(YARD, FENCED_PEN))
        self.assert_passes_on(walk, with_more(YARD, STEPS_IN_PEN))

    def test_a_stuck_spot_with_a_cover_or_with_a_way_out(self):
        shaft = re.sub(r"(?m)^  - \{id: pen/.*\n", "", YARD)
        walls = (box("pen/south", (-8, -0.1, -5.2), (-4, 1, -3)) + box("pen/west", (-8, -0.1, -8), (-6.4, 1, -3)),
                 box("pen/east", (-5.6, -0.1, -8), (-4, 1, -3)), box("pen/north", (-8, -0.1, -8), (-4, 1, -6)))
        walk = self.walk_of("stuck", with_more(shaft, *walls))
        self.assertGreater(self.spawn_of(walk)[1], 0.2, "not in it")
        self.assert_passes_on(walk, with_more(shaft, *walls, box("cover", (-6.5, 0.9, -6.1), (-5.5, 1, -5.1))))
        self.assert_passes_on(walk, with_more(shaft, *walls[:-1], box("pen/north", (-8, -0.1, -8), (-6.4, 1, -6))))

    def test_a_hole_with_a_wall_or_with_a_floor_below(self):
        walk = self.walk_of("holes", YARD)
        self.assertGreater(self.spawn_of(walk)[0], -9.5, "well on the ground")
        self.assert_passes_on(walk, with_more(YARD, box("wall/gap", (-10.2, 0, 4), (-9.8, 1, 6))))
        self.assert_passes_on(walk, with_more(YARD, box("below", (-16, -2.2, 0), (-10, -2, 10))))

    def test_objects_that_were_left_out_are_left_out_of_the_walks(self):
        walk = self.walk_of("traps", with_more(YARD, FENCED_PEN), "--disable", "fence/*")
        self.assertIn('  - disable: ["fence/*"]\n', walk)


if __name__ == "__main__":
    main()
