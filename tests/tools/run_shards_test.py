#!/usr/bin/env python3
"""The merged shards of a run equal the whole run: `run --shard`, `merge-reports`."""

import os

from program import WALK, ProgramCase, main

FAILING = WALK.replace('never: "collision.enter hut/wall"', "never: popup.open hut")


class Shards(ProgramCase):
    """Walks in two projects, some with mistakes: every report of the whole run, and of its merged parts."""

    REPORTERS = ("json", "jsonl", "junit", "tap", "dot", "list", "github")

    def setUp(self):
        super().setUp()
        os.remove(self.path("short.walk.yaml"))
        for i, text in enumerate((WALK, FAILING, WALK.replace("walk_to: end", "walk_to: nowhere"), WALK)):
            self.write(f"w{i}.walk.yaml", text)
        self.write("sub/w0.walk.yaml", WALK.replace("campus: small", "campus: ../small"))
        self.write("walks.config.yaml", "projects: {plain: , near: {spawn: {at: [0, 0, 3]}}}\n")

    def run_walks(self, *arguments):
        return self.run_program("run", "--rendering-backend", "none", *arguments)

    def reports(self, folder):
        return [argument for name in self.REPORTERS for argument in ("--reporter", f"{name}={folder}/{name}")]

    def test_merged_reports_equal_those_of_the_whole_run(self):
        whole = self.run_walks(*self.reports("whole"))
        self.assertEqual(whole.code, 2)
        for count in range(1, 8):
            folder = f"parts-{count}"
            codes = [self.run_walks(f"--shard={i}/{count}", "--output", f"o{i}", "--reporter",
                                    f"jsonl={folder}/{i}.jsonl").code for i in range(1, count + 1)]
            self.assertEqual(max(codes), 2)
            merged = self.run_program("merge-reports", folder, *self.reports("merged"))
            self.assertEqual((merged.code, merged.out, merged.err), (whole.code, "", ""))
            for name in self.REPORTERS:
                self.assertEqual(self.read(f"merged/{name}"), self.read(f"whole/{name}"), (count, name))

    def test_more_shards_than_walks(self):
        outcome = self.run_walks("--shard=20/20", "--reporter", "jsonl=last.jsonl", "-g", "w0")
        self.assertEqual(outcome.code, 0)
        self.run_walks("--shard=1/20", "--reporter", "jsonl=first.jsonl", "-g", "w0")
        empty = self.passes("run", "--shard=1/20", "-g", "w0", "--list").lines
        self.assertEqual(empty, [])

    def test_list_of_the_merged_report(self):
        self.run_walks("--reporter", "jsonl=a.jsonl", "-g", "w[01]")
        outcome = self.run_program("merge-reports", "a.jsonl", "--color", "never", "--output", "elsewhere")
        self.assertEqual(outcome.code, 1)
        self.assertIn("4 passed, 2 failed", outcome.out)

    def refused(self, *arguments, expected):
        outcome = self.run_program("merge-reports", *arguments)
        self.assertEqual(outcome.out, "")
        self.assert_refused(outcome, expected)

    def test_files_that_are_not_reports_are_refused(self):
        self.run_walks("--reporter", "jsonl=a.jsonl", "-g", "w0")
        self.write("b.jsonl", self.read("a.jsonl"))
        self.refused("none.jsonl", expected="none.jsonl: error missing-file:")
        self.refused("room.obj", expected="room.obj:1:1: error bad-report: --reporter")
        self.refused("avatars", expected="avatars: error bad-report: --reporter")
        self.refused("a.jsonl", "b.jsonl", expected="b.jsonl: error bad-report: 'sub/w0.walk.yaml near'")
        self.write("b.jsonl", self.read("a.jsonl") + b'{"id":')
        outcome = self.run_program("merge-reports", "b.jsonl")
        self.assertEqual((outcome.code, outcome.out), (2, ""))
        self.assertRegex(outcome.err, r"^b.jsonl:6:1: error bad-report: ")


if __name__ == "__main__":
    main()
