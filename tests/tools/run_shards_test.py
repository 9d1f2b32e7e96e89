#!/usr/bin/env python3
"""The merged shards of a run equal the whole run: `run --shard`, `merge-reports`."""

import os
import shutil

from program import WALK, ProgramCase, main

FAILING = WALK.replace('never: "collision.enter hut/wall"', "never: popup.open hut")


class Shards(ProgramCase):
    """Walks in two projects, some with mistakes: every report of the whole run, and of its merged parts."""

    REPORTERS = ("json", "jsonl", "junit", "tap", "dot", "list", "github", "markdown")

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
        self.refused("none.jsonl", expected="none.jsonl: error missing-file:")
        self.refused("room.obj", expected="room.obj:1:1: error bad-report: --reporter")
        self.refused("avatars", expected="avatars: error bad-report: --reporter")
        self.write("empty.jsonl", "")
        self.refused("empty.jsonl", expected="empty.jsonl:1:1: error bad-report: --reporter")
        self.write("b.jsonl", self.read("a.jsonl") + b'{"id":\n')
        self.refused("b.jsonl", expected="b.jsonl:6:1: error bad-report:")
        self.write("b.jsonl", '{"campuswalk_results":1,"cases":3}\n')
        self.refused("b.jsonl", expected="b.jsonl:1:1: error bad-report: version")

    def shards(self, count, *arguments):
        """The names of their reports. All walks pass."""
        names = [f"{i}-of-{count}.jsonl" for i in range(1, count + 1)]
        for i, name in enumerate(names, 1):
            self.assertEqual(self.run_walks(f"--shard={i}/{count}", "--reporter", f"jsonl={name}", "-g", "w[03]",
                                            *arguments).code, 0)
        return names

    def assert_fails(self, reports, *expected):
        outcome = self.run_program("merge-reports", *reports)
        self.assertEqual(outcome.code, 1, outcome.err)
        self.assert_diagnostics(outcome.err_lines, *expected)
        self.assertIn(" passed", outcome.out)

    def test_a_run_whose_shards_are_not_all_there_once_does_not_pass(self):
        one, two, three = self.shards(3)
        self.assertEqual(self.run_program("merge-reports", three, one, two).code, 0)
        self.assert_fails([one, three], one + ": error missing-shard: 3 2")
        self.assert_fails([two], two + ": error missing-shard: 3 1, 3")
        self.assert_fails([one, two, two, three], two + ": error duplicate-shard: " + two + " 2")
        self.write("twice.jsonl", self.read(two) + self.read(two).split(b"\n", 1)[1])
        self.assert_fails([one, "twice.jsonl", three], "twice.jsonl: error incomplete-report: 4 2 2")
        self.write("foreign.jsonl", self.read(two).replace(b"w0.walk.yaml", b"w9.walk.yaml")
                   .replace(b"w3.walk.yaml", b"w9.walk.yaml"))
        self.assert_fails([one, "foreign.jsonl", three], one + ": error other-plan:")

    def test_a_report_that_is_cut_anywhere_does_not_pass(self):
        one, two = self.shards(2)
        whole = self.read(two)
        ends = [i + 1 for i, byte in enumerate(whole) if byte == ord("\n")]
        for end in sorted({at + by for at in ends for by in (-40, -1, 0, 1)} - {len(whole), len(whole) + 1}):
            self.write("cut.jsonl", whole[:end])
            outcome = self.run_program("merge-reports", one, "cut.jsonl")
            self.assertEqual(outcome.code, 1 if end >= ends[0] else 2, end)
            self.assertRegex(outcome.err, r"cut.jsonl(:1:1)?: error (incomplete-report|bad-report): ")

    def test_reports_of_runs_that_differ_are_not_merged(self):
        one, two = self.shards(2)
        (whole,) = self.shards(1)
        self.assert_fails([one, whole], whole + ": error other-plan:", one + ": error missing-shard: 2 2")
        before = self.read("w3.walk.yaml")
        for change in (lambda: self.write("w3.walk.yaml", before + b"# changed\n"),
                       lambda: self.write("avatars/adult.avatar.yaml", "height: 1.81\nradius: 0.3\n"),
                       lambda: self.write("small.campus.yaml", self.read("small.campus.yaml") + b"# changed\n")):
            earlier = self.read(one)
            change()
            _, later = self.shards(2)
            self.write("earlier.jsonl", earlier)
            self.assert_fails(["earlier.jsonl", later], later + ": error other-plan:",
                              "earlier.jsonl: error missing-shard: 2 2")

    def test_a_header_cannot_claim_any_number_of_shards(self):
        (whole,) = self.shards(1)
        self.write("huge.jsonl", self.read(whole).replace(b'"shards":1', b'"shards":2147483647'))
        self.assert_fails(["huge.jsonl"], "huge.jsonl: error missing-shard: 2147483647 2, 3")
        self.write("none.jsonl", self.read(whole).replace(b'"shards":1', b'"shards":-1'))
        outcome = self.run_program("merge-reports", "none.jsonl")
        self.assertEqual(outcome.code, 1)
        self.assert_diagnostics(outcome.err_lines, "none.jsonl: error other-plan:")

    def test_a_run_that_ended_early_does_not_pass(self):
        self.run_walks("--reporter", "jsonl=a.jsonl", "-g", "w[01]", "-x")
        outcome = self.run_program("merge-reports", "a.jsonl")
        self.assertEqual(outcome.code, 1)
        self.assertRegex(outcome.err, r"^a.jsonl: error incomplete-report: ")


class TwoShards(ProgramCase):
    """The first plays on room.obj, the second on other.obj."""

    KEY = "0123456789abcdef0123"

    def setUp(self):
        super().setUp()
        self.write("other.obj", self.read("room.obj"))
        self.write("other.campus.yaml", self.read("small.campus.yaml").replace(b"room.obj", b"other.obj"))
        self.write("a.walk.yaml", WALK)
        self.write("b.walk.yaml", WALK.replace("small", "other"))
        os.remove(self.path("short.walk.yaml"))

    def environment(self, key):
        others = {name: value for name, value in os.environ.items() if name != "CAMPUSWALK_RUN_KEY"}
        return {**others, "CAMPUSWALK_RUN_KEY": key} if key else others

    def shard(self, number, *arguments, key=""):
        self.passes("run", "-q", "--rendering-backend", "none", f"--shard={number}/2", "--reporter", f"jsonl={number}.jsonl",
                    *arguments, env=self.environment(key))

    def merged(self, *arguments, key=""):
        return self.run_program("merge-reports", "1.jsonl", "2.jsonl", *arguments, env=self.environment(key))


class Fingerprints(TwoShards):
    """What shards must have in common: whatever their results depend on. What they may differ in."""

    def assert_refused_because(self, words):
        outcome = self.merged()
        self.assertEqual(outcome.code, 1, outcome.out)
        self.assertIn("2.jsonl: error other-run: ", outcome.err)
        self.assertIn(words, outcome.err)

    def test_shards_that_differ_in_what_may_differ_merge(self):
        self.shard(1, "--output", "here", "-j1")
        self.shard(2, "--output", "there", "-j2", "--reporter", "junit=j.xml")
        self.assertEqual(self.merged().code, 0)

    def test_every_file_that_any_shard_reads_counts(self):
        """A change of either's is seen by both."""
        material = b"mtllib room.mtl\n"
        self.write("room.mtl", "newmtl a\nKd 1 0 0\n")
        self.write("room.obj", material + self.read("room.obj"))
        for name in ("room.obj", "other.obj", "room.mtl", "a.walk.yaml-snapshots/log.jsonl", "b.walk.yaml-snapshots/far.png"):
            for cached in ((), ("--no-cache",)):
                with self.subTest(name=name, cached=cached):
                    self.shard(1, *cached)
                    before = self.read(name) if os.path.exists(self.path(name)) else b""
                    self.write(name, before + b"# changed\n")
                    self.shard(2, *cached)
                    self.assert_refused_because("on other files")
                    self.shard(1, *cached)
                    self.assertEqual(self.merged().code, 0)

    def test_a_file_that_only_includes_counts(self):
        self.write("inner.steps.yaml", "steps: [{wait: 0.1}]\n")
        self.write("outer.steps.yaml", "steps: [{include: inner.steps.yaml}]\n")
        self.write("a.walk.yaml", WALK.replace("  - turn: 180", "  - turn: 180\n  - include: outer.steps.yaml"))
        self.shard(1)
        self.write("outer.steps.yaml", "steps: [{include: inner.steps.yaml}, {include: inner.steps.yaml}]\n")
        self.shard(2)
        outcome = self.merged()
        self.assertEqual(outcome.code, 1)
        self.assertIn("2.jsonl: error other-plan: ", outcome.err)

    def test_whose_golden_file_it_is_counts(self):
        self.write("a.walk.yaml-snapshots/far.png", "golden\n")
        self.shard(1)
        os.rename(self.path("a.walk.yaml-snapshots"), self.path("b.walk.yaml-snapshots"))
        self.shard(2)
        self.assert_refused_because("on other files")

    def test_every_option_that_results_depend_on_counts(self):
        for options in (("--strict",), ("--require-identical",), ("--record", "csv")):
            with self.subTest(options=options):
                self.shard(1)
                self.shard(2, *options)
                self.assert_refused_because("with other options")
        self.shard(2, "--timeout", "7")
        self.assertIn("error other-plan: ", self.merged().err)

    def test_another_version_counts(self):
        self.shard(1)
        self.shard(2)
        self.write("2.jsonl", self.read("2.jsonl").replace(b'{"program":"', b'{"program":"9.'))
        self.assert_refused_because("by another version")

    def test_a_campus_that_another_shard_cannot_read_is_in_both(self):
        self.write("other.obj", "v 0 0\nf 1 2 3\n")
        for cached in ((), ("--no-cache",)):
            for number in (1, 2):
                self.run_program("run", "-q", f"--shard={number}/2", "--reporter", f"jsonl={number}.jsonl", *cached)
            self.assertNotIn("other-run", self.merged().err)
            self.assertEqual(self.merged().code, 2)

    def test_what_was_not_evaluated_does_not_pass(self):
        for name in ("a", "b"):
            self.write(f"{name}.walk.yaml", WALK.replace("  - turn: 180", "  - snapshot: far") + "  - snapshot: far\n")
            self.shard(1)
        self.shard(2)
        outcome = self.merged()
        self.assertEqual(outcome.code, 1, outcome.out)
        self.assert_diagnostics(outcome.err_lines, "1.jsonl: error unevaluated-walks: 1", "2.jsonl: error unevaluated-walks: 2")


class Signatures(TwoShards):
    """With CAMPUSWALK_RUN_KEY."""

    def shard(self, number, *arguments, key=TwoShards.KEY):
        super().shard(number, *arguments, key=key)

    def assert_foreign(self, place):
        outcome = self.merged(key=self.KEY)
        self.assertEqual(outcome.out, "")
        self.assert_refused(outcome, place + ": error foreign-results: CAMPUSWALK_RUN_KEY")

    def test_signed_shards_merge_and_the_merged_report_is_signed(self):
        self.shard(1)
        self.shard(2)
        outcome = self.merged("--reporter", "jsonl=all.jsonl", key=self.KEY)
        self.assertEqual((outcome.code, outcome.err), (0, ""))
        self.assertEqual(self.run_program("merge-reports", "all.jsonl", env=self.environment(self.KEY)).code, 0)
        self.assertEqual(self.merged().code, 0)  # whoever has no key can read them: a fork's secret is empty

    def test_unsigned_shards_are_refused(self):
        self.shard(1)
        self.shard(2, key="")
        self.assert_foreign("2.jsonl:1:1")

    def test_shards_signed_with_another_key_are_refused(self):
        self.shard(1)
        self.shard(2, key="another key of 21 bytes")
        self.assert_foreign("2.jsonl:1:1")

    def test_only_signed_reports_are_replayed(self):
        self.shard(1)
        self.assertEqual(self.run_program("replay", "--verify", "1.jsonl", env=self.environment(self.KEY)).code, 0)
        self.assertEqual(self.run_program("replay", "--verify", "1.jsonl", env=self.environment("")).code, 0)
        genuine = self.read("1.jsonl")
        self.write("1.jsonl", genuine.replace(b'"outcome":"passed"', b'"outcome":"failed"'))
        self.assert_refused(self.run_program("replay", "--verify", "1.jsonl", env=self.environment(self.KEY)),
                            "1.jsonl:2:1: error foreign-results: CAMPUSWALK_RUN_KEY")
        self.shard(1, key="")
        self.assert_refused(self.run_program("replay", "--verify", "1.jsonl", env=self.environment(self.KEY)),
                            "1.jsonl:1:1: error foreign-results: CAMPUSWALK_RUN_KEY")

    def test_a_line_that_was_changed_or_moved_is_refused(self):
        self.shard(1)
        self.shard(2)
        genuine = self.read("2.jsonl")
        header, line = genuine.splitlines(keepends=True)
        for forged, number in ((genuine.replace(b'"outcome":"passed"', b'"outcome":"skipped"'), 2),
                               (genuine.replace(b'"shard":2', b'"shard":1'), 1),
                               (header + self.read("1.jsonl").splitlines(keepends=True)[1], 2),
                               (header + b"{" + line.split(b",", 1)[1], 2)):
            self.write("2.jsonl", forged)
            self.assert_foreign(f"2.jsonl:{number}:1")


class EmptyKeys(TwoShards):
    def test_an_empty_key_is_said_to_demand_nothing(self):
        self.shard(1)
        self.shard(2)
        outcome = self.run_program("merge-reports", "1.jsonl", "2.jsonl", env={**os.environ, "CAMPUSWALK_RUN_KEY": ""})
        self.assertEqual(outcome.code, 0)
        self.assert_diagnostics(outcome.err_lines, "warning unsigned-reports: CAMPUSWALK_RUN_KEY")


class Artifacts(TwoShards):
    """`merge-reports --artifacts`: each shard's results and files from its own artifact."""

    def shard(self, number, *arguments, key=""):
        super().shard(number, "--output", f"artifacts/walks-{number}", "--record", "csv", "--reporter",
                      f"jsonl=artifacts/walks-{number}/results-{number}.jsonl", *arguments, key=key)

    def merged(self, *arguments, key="", **variables):
        return self.run_program("merge-reports", "--artifacts", "artifacts", "--output", "all", *arguments,
                                env={**self.environment(key), **variables})

    def setUp(self):
        super().setUp()
        for number in (1, 2):
            self.shard(number)

    def test_what_results_name_is_copied_and_nothing_else(self):
        self.write("artifacts/walks-1/more.csv", "not named by any result\n")
        self.write("artifacts/notes/results-3.jsonl", "no artifact of a shard\n")
        self.write("artifacts/results-1.jsonl", self.read("artifacts/walks-1/results-1.jsonl"))
        outcome = self.merged("--reporter", "junit=all/junit.xml", CI="true")
        self.assertEqual((outcome.code, outcome.err), (0, ""))
        files = {name for name, content in self.contents().items() if name.startswith("all/") and content is not None}
        self.assertEqual(files, {"all/.written.json", "all/junit.xml", "all/a/trajectory.csv", "all/b/trajectory.csv"})
        self.assertEqual(self.read("all/b/trajectory.csv"), self.read("artifacts/walks-2/b/trajectory.csv"))
        self.assertEqual(self.merged(CI="true").code, 0)  # it knows its own output again

    def assert_merge_refused(self, *expected, **variables):
        outcome = self.merged(**variables)
        self.assertEqual(outcome.out, "")
        self.assert_refused(outcome, *expected)

    def test_results_come_from_their_own_artifact(self):
        first, second = (self.read(f"artifacts/walks-{number}/results-{number}.jsonl") for number in (1, 2))
        self.write("artifacts/walks-2/results-1.jsonl", first)
        self.assertEqual(self.merged().code, 0)
        self.write("artifacts/walks-2/results-2.jsonl", first)
        self.assert_merge_refused("artifacts/walks-2/results-2.jsonl: error foreign-results: 1 2")
        os.remove(self.path("artifacts/walks-2/results-2.jsonl"))
        outcome = self.merged()
        self.assertEqual(outcome.code, 1)
        self.assertIn("error missing-shard: ", outcome.err)
        self.write("elsewhere", second)
        os.symlink("../../elsewhere", self.path("artifacts/walks-2/results-2.jsonl"))
        self.assertEqual(self.merged().code, 1)
        os.rename(self.path("artifacts/walks-2"), self.path("shard"))
        self.write("shard/results-2.jsonl", second)
        os.symlink("../shard", self.path("artifacts/walks-2"))
        self.assertEqual(self.merged().code, 1)

    def test_files_are_copied_through_no_link_and_none_is_replaced(self):
        self.write("secret", "key\n")
        os.remove(self.path("artifacts/walks-1/a/trajectory.csv"))
        os.symlink("../../../secret", self.path("artifacts/walks-1/a/trajectory.csv"))
        outcome = self.merged()
        self.assertEqual((outcome.code, outcome.err_lines[0]), (0, "1 file that the results name isn't in the shards' artifacts"))
        self.assertFalse(os.path.exists(self.path("all/a/trajectory.csv")))
        results = self.read("artifacts/walks-2/results-2.jsonl")
        self.write("artifacts/walks-2/results-2.jsonl", results.replace(b'"path":"b/', b'"path":"a/'))
        os.remove(self.path("artifacts/walks-1/a/trajectory.csv"))
        self.write("artifacts/walks-1/a/trajectory.csv", "genuine\n")
        self.write("artifacts/walks-2/a/trajectory.csv", "forged\n")
        self.assert_merge_refused("artifacts/walks-2/a/trajectory.csv: error foreign-results:")

    def test_a_refused_merge_leaves_no_file(self):
        results = self.read("artifacts/walks-2/results-2.jsonl")
        for name in ("results.jsonl", "junit.xml", "report.html"):
            self.write("artifacts/walks-2/" + name, "planted\n")
            self.write("artifacts/walks-2/results-2.jsonl", results.replace(b'"path":"b/trajectory.csv"', f'"path":"{name}"'.encode()))
            self.assert_merge_refused(f"artifacts/walks-2/results-2.jsonl: error foreign-results: b.walk.yaml {name}")
            self.assertFalse(os.path.exists(self.path("all")))

    def test_of_the_folder_of_campuses_only_campuses_are_copied(self):
        names = ("school-0.json", "school-0.glb.gz", ".hidden.json", "run.sh", "page.html", "school.glb")
        for name in names:
            self.write("artifacts/walks-1/campuses/" + name, name)
        os.symlink("school-0.json", self.path("artifacts/walks-1/campuses/school-1.json"))
        outcome = self.merged()
        self.assertEqual((outcome.code, outcome.err), (0, ""))
        self.assertEqual(sorted(os.listdir(self.path("all/campuses"))), ["school-0.glb.gz", "school-0.json"])

    def test_the_output_has_no_links_nor_what_came_with_a_checkout(self):
        self.write("all/junit.xml", "planted\n")
        self.assert_merge_refused("all/junit.xml: error foreign-output:", CI="true")
        self.assert_merge_refused("all/junit.xml: error foreign-output:")  # nothing of anybody's is replaced, in CI or not
        os.remove(self.path("all/junit.xml"))
        os.symlink("..", self.path("all/a"))
        self.assert_merge_refused("all/a: error output-unwritable:")

    def test_results_name_nothing_hidden(self):
        results = self.read("artifacts/walks-2/results-2.jsonl")
        for path in (".git/config", "a/.git/config"):
            self.write("artifacts/walks-2/results-2.jsonl", results.replace(b'"path":"b/trajectory.csv"', f'"path":"{path}"'.encode()))
            self.assert_merge_refused("artifacts/walks-2/results-2.jsonl:2:1: error bad-report: ")

    def test_a_folder_without_artifacts_is_refused(self):
        shutil.rmtree(self.path("artifacts"))
        self.assert_merge_refused("artifacts: error missing-file:")
        os.makedirs(self.path("artifacts/walks-1"))
        self.assert_merge_refused("artifacts: error missing-file: NAME-N results-N.jsonl")


if __name__ == "__main__":
    main()
