#!/usr/bin/env python3
"""`--sandbox`: every command that imports models does so in a process that can only read them."""

import sys

from program import SKIPPED, ProgramCase, main


class Sandbox(ProgramCase):
    def setUp(self):
        super().setUp()
        self.passes("run", "short.walk.yaml", "--jsonl", "log.jsonl", "--no-cache")
        self.write("other.jsonl", self.read("log.jsonl").replace(b'"yaw":0', b'"yaw":1'))

    def test_required(self):
        if "no-sandbox" in self.run_program("info", "room.obj", "--no-cache", "--sandbox", "require").err:
            sys.exit(SKIPPED)
        self.passes("run", "short.walk.yaml", "--no-cache", "--sandbox", "require")
        self.passes("validate", "short.walk.yaml", "--no-cache", "--sandbox", "require")
        self.passes("info", "room.obj", "--no-cache", "--sandbox", "require")
        self.passes("replay", "log.jsonl", "--walk", "short.walk.yaml", "--no-cache", "--sandbox", "require")
        self.assertEqual(self.run_program("collide", "room.obj", "room.obj", "--no-cache", "--sandbox", "require").code, 1)
        self.assertIn(self.run_program("diff", "log.jsonl", "other.jsonl", "--no-cache", "--sandbox", "require").code, (0, 1))
        self.assertIn(self.run_program("snapshot", "small.campus.yaml", "-o", "a.png", "--width", "64", "--height", "48",
                                       "--no-cache", "--sandbox", "require").code, (0, 3))

    def test_other_modes(self):
        for mode in ("auto", "off"):
            self.passes("run", "short.walk.yaml", "--no-cache", "--sandbox", mode)
        self.assertEqual(self.run_program("run", "short.walk.yaml", "--sandbox", "perhaps").code, 2)


if __name__ == "__main__":
    main()
