#!/usr/bin/env python3
"""What a build without rendering says when it is asked for pictures."""

from program import WALK, ProgramCase, main


class NoPictures(ProgramCase):
    """Walks run as ever; only pictures are missing."""

    def test_walk_logs_its_snapshots(self):
        self.write("short.walk.yaml", WALK.replace("turn: 180", "snapshot: a"))
        before = self.contents()
        outcome = self.passes("run", "short.walk.yaml")
        self.assertEqual(outcome.complaints[0], "this build has no rendering: snapshots are logged but not drawn")
        self.assertIn(" snapshot.take ", outcome.out)
        self.assertEqual(self.contents(), before)
        self.assertEqual(len(self.passes("run", "short.walk.yaml", "--rendering-backend", "none").complaints), 1)

    def test_walk_without_snapshots_is_not_talked_about(self):
        self.assertEqual(len(self.passes("run", "short.walk.yaml").complaints), 1)

    def test_asking_for_pictures(self):
        outcome = self.run_program("run", "short.walk.yaml", "--rendering-backend", "osmesa")
        self.assertEqual((outcome.code, outcome.complaints),
                         (2, ["--rendering-backend: error bad-value: this build has no rendering: use none"]))
        outcome = self.run_program("snapshot", "small.campus.yaml", "-o", "a.png")
        self.assertEqual((outcome.code, outcome.complaints),
                         (3, ["error: this build has no rendering: configure with CAMPUSWALK_RENDER=ON"]))


if __name__ == "__main__":
    main()
