#!/usr/bin/env python3
"""Pictures from the command line. `pictures_test.py PROGRAM [--without-rendering]`."""

import os
import stat
import struct
import sys

from program import SKIPPED, WALK, ProgramCase, main


class Pictures(ProgramCase):
    """PNG files of `snapshot` and of a walk's snapshot steps."""

    def size_of(self, name):
        """Width and height from the PNG's first chunk."""
        data = self.read(name)
        self.assertEqual(data[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(data[12:16], b"IHDR")
        self.assertEqual(data[-8:-4], b"IEND")
        return struct.unpack(">II", data[16:24])

    def test_plan(self):
        outcome = self.passes("snapshot", "small.campus.yaml", "--camera", "top", "-o", "maps/plan.png", "--width", "320",
                              "--height", "200")
        self.assertEqual(outcome.out, "")
        self.assertEqual(self.size_of("maps/plan.png"), (320, 200))

    def test_view_from_a_spawn(self):
        self.passes("snapshot", "small.campus.yaml", "--camera", "start", "-o", "view.png", "--width", "64", "--height", "48")
        self.passes("snapshot", "small.campus.yaml", "-o", "plan.png", "--width", "64", "--height", "48")
        self.assertEqual(self.size_of("view.png"), (64, 48))
        self.assertNotEqual(self.read("view.png"), self.read("plan.png"))

    def test_unknown_camera(self):
        before = self.contents()
        outcome = self.run_program("snapshot", "small.campus.yaml", "--camera", "strat", "-o", "a.png")
        self.assertEqual(outcome.complaints, ["--camera: error unknown-name: 'strat' is neither 'top' nor a spawn of "
                                              "small (did you mean 'start'?)"])
        self.assertEqual(outcome.code, 2)
        self.assertEqual(self.contents(), before)

    def test_picture_that_cannot_be_written(self):
        for name in ("avatars", "room.obj/a.png"):
            outcome = self.run_program("snapshot", "small.campus.yaml", "-o", name)
            self.assertEqual(outcome.code, 2)
            self.assertRegex(outcome.err, f"^{name}: error output-unwritable: the picture can't be written here: ")

    def test_picture_in_the_place_of_a_pipe(self):
        os.mkfifo(self.path("pipe"))
        outcome = self.run_program("snapshot", "small.campus.yaml", "-o", "pipe", "--width", "64", "--height", "64")
        self.assertEqual(outcome.code, 3)
        self.assertRegex(outcome.err, "^error: .*pipe.*: it is not a regular file")
        self.assertTrue(stat.S_ISFIFO(os.stat(self.path("pipe")).st_mode))

    def test_walk_takes_the_same_pictures_every_time(self):
        self.write("short.walk.yaml", WALK.replace(
            "  - turn: 180", "  - snapshot: {name: gate, width: 80, height: 60}\n  - turn: 180\n"
                             "  - snapshot: {name: from-above, view: top, width: 60, height: 80}"))
        pictures = []
        for folder in ("out", "elsewhere"):
            outcome = self.passes("run", "short.walk.yaml", "--output", folder)
            self.assertEqual([line.split()[3] for line in outcome.lines if " snapshot.take " in line],
                             ["gate", "from-above"])
            self.assertEqual(self.size_of(f"{folder}/short/gate.png"), (80, 60))
            self.assertEqual(self.size_of(f"{folder}/short/from-above.png"), (60, 80))
            pictures.append((self.read(f"{folder}/short/gate.png"), self.read(f"{folder}/short/from-above.png")))
        self.assertEqual(pictures[0], pictures[1])

    def test_pictures_do_not_change_the_log(self):
        self.write("short.walk.yaml", WALK.replace("turn: 180", "snapshot: {name: a, width: 64, height: 64}"))
        drawn = self.passes("run", "short.walk.yaml").out
        self.assertEqual(self.passes("run", "short.walk.yaml", "--rendering-backend", "none", "--output", "none").out, drawn)
        self.assertIn("out/short/a.png", self.contents())
        self.assertNotIn("none", self.contents())

    def test_output_below_a_file(self):
        self.write("short.walk.yaml", WALK.replace("turn: 180", "snapshot: a"))
        before = self.contents()
        outcome = self.run_program("run", "short.walk.yaml", "--output", "room.obj", "--log", "a.log")
        self.assertEqual((outcome.code, outcome.out), (2, ""))
        self.assertEqual(outcome.complaints, ["room.obj/short: error output-unwritable: pictures can't be saved here: "
                                              "'room.obj' is not a folder"])
        self.assertEqual(self.contents(), before)


if __name__ == "__main__":
    if "--without-rendering" in sys.argv:
        print("skipped: built with CAMPUSWALK_RENDER=OFF")
        sys.exit(SKIPPED)
    main()
