#!/usr/bin/env python3
"""A build without rendering runs walks and refuses to draw images."""

from program import WALK, ProgramCase, main


class NoImages(ProgramCase):
    """Walks run as usual; only the images are missing."""

    def test_walk_logs_its_snapshots(self):
        self.write("short.walk.yaml", WALK.replace("turn: 180", "snapshot: a"))
        before = self.contents()
        outcome = self.passes("run", "short.walk.yaml")
        self.assertEqual(len(outcome.err_lines), 2, outcome.err)
        self.assertIn("snapshots", outcome.err_lines[0])
        self.assertIn(" snapshot.take ", outcome.out)
        self.assertEqual(self.contents(), before)
        self.assertEqual(len(self.passes("run", "short.walk.yaml", "--rendering-backend", "none").err_lines), 1)

    def test_walk_without_snapshots_has_no_warning(self):
        self.assertEqual(len(self.passes("run", "short.walk.yaml").err_lines), 1)

    def test_requests_for_images_are_refused(self):
        outcome = self.run_program("run", "short.walk.yaml", "--rendering-backend", "osmesa")
        self.assert_refused(outcome, "--rendering-backend: error bad-value: none")
        outcome = self.run_program("snapshot", "small.campus.yaml", "-o", "a.png")
        self.assert_refused(outcome, "error: CAMPUSWALK_RENDER=ON", code=3)


if __name__ == "__main__":
    main()
