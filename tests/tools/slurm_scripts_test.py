#!/usr/bin/env python3
"""`run --slurm` as far as no Slurm is needed: its scripts, run by hand as Slurm would, and what their merge says.

With a real Slurm: cluster/slurm_test.py.
"""

import json
import os
import re
import shutil
import stat
import subprocess

import jsonschema

from program import WALK, ProgramCase, main

FAILING = WALK.replace('never: "collision.enter hut/wall"', "never: popup.open hut")
SCHEMAS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "config", "schema", "")
REPORTERS = ("json", "jsonl", "junit", "tap", "list", "markdown")


def reports(folder):
    return [argument for name in REPORTERS for argument in ("--reporter", f"{name}={folder}/{name}")]


class SlurmCase(ProgramCase):
    def setUp(self):
        super().setUp()
        os.remove(self.path("short.walk.yaml"))
        os.mkdir(self.path("my walks"))
        for i in range(9):
            walk = FAILING if i == 3 else WALK.replace("turn: 180", f"wait: {1 + i}")
            self.write(f"my walks/w{i}.walk.yaml", walk.replace("small.campus", "../small.campus"))
        self.no_slurm = dict(os.environ, PATH=self.path_without_slurm())

    def path_without_slurm(self):
        """A folder with the programs that the scripts use, and none of Slurm's."""
        tools = os.path.join(self.folder, "tools")
        os.mkdir(tools)
        for name in ("bash", "mv", "rm", "sleep"):
            os.symlink(shutil.which(name), os.path.join(tools, name))
        return tools

    def run_walks(self, *arguments):
        return self.run_program("run", "my walks", "--rendering-backend", "none", *arguments, env=self.no_slurm)

    def write_scripts(self, *arguments, shards=4):
        outcome = self.run_walks("--slurm=script", "--shards", str(shards), *reports("merged"), *arguments)
        self.assertEqual((outcome.code, outcome.err), (0, ""))
        self.assertEqual(outcome.lines, ["job=$(sbatch --parsable out/slurm/shard.sh)",
                                         'sbatch --dependency=afterany:"$job" out/slurm/merge.sh "$job"'])

    def run_script(self, name, *arguments, **variables):
        return subprocess.run(["bash", self.path("out/slurm/" + name), *arguments], cwd=self.folder, check=False,
                              env=dict(self.no_slurm, **variables), capture_output=True, text=True, timeout=120)

    def run_task(self, task):
        return self.run_script("shard.sh", SLURM_ARRAY_TASK_ID=str(task), SLURM_ARRAY_JOB_ID="7").returncode

    def merge(self):
        return self.run_script("merge.sh", "7")

    def results(self, task):
        return [json.loads(line) for line in self.read(f"out/slurm/results/{task}.jsonl").splitlines()[1:]]

    def assert_merged_as_whole(self):
        for name in REPORTERS:
            self.assertEqual(self.read(f"merged/{name}"), self.read(f"whole/{name}"), name)


class Scripts(SlurmCase):
    def test_scripts_are_complete(self):
        self.write_scripts("--partition=long", "--account", "campus", "--time=10", "--mem=2G", "--sbatch=--qos=low",
                           "-j3", "-g", "w0|'\"$x")
        shard = self.read("out/slurm/shard.sh").decode()
        for line in ("#!/bin/bash", "#SBATCH --array=1-1", "#SBATCH --requeue", "#SBATCH --partition=long",
                     "#SBATCH --account=campus", "#SBATCH --time=10", "#SBATCH --mem=2G", "#SBATCH --qos=low",
                     "#SBATCH --cpus-per-task=3"):
            self.assertIn(line + "\n", shard)
        self.assertIn("'--grep=w0|'\\''\"$x'", shard)
        for name in ("shard.sh", "merge.sh"):
            self.assertEqual(subprocess.run(["bash", "-n", self.path("out/slurm/" + name)], check=False).returncode, 0)
            self.assertTrue(os.stat(self.path("out/slurm/" + name)).st_mode & stat.S_IXUSR)

    def test_tasks_and_their_merge_equal_the_whole_run(self):
        whole = self.run_walks(*reports("whole"))
        self.assertEqual(whole.code, 1)
        for times in ("unknown", "known"):  # the second time they are balanced
            self.write_scripts()
            self.assertEqual(b"" != self.read("out/slurm/times.jsonl"), True)  # the whole run has left some
            self.assertEqual(sorted(self.run_task(task) for task in (3, 1, 4, 2)), [0, 0, 0, 1])
            merged = self.merge()
            self.assertEqual((merged.returncode, merged.stdout), (1, ""), merged.stderr)
            self.assertEqual(self.read("out/slurm/merged"), b"1\n", times)
            self.assert_merged_as_whole()

    def test_a_cluster_without_any_times_gets_consecutive_shards(self):
        self.write_scripts()
        self.assertEqual(self.read("out/slurm/times.jsonl"), b"")
        for task in range(1, 5):
            self.run_task(task)
        self.assertEqual([[each["name"] for each in self.results(task)] for task in range(1, 5)],
                         [["w0", "w1"], ["w2", "w3"], ["w4", "w5"], ["w6", "w7", "w8"]])
        # Their times divide the next run, in any order of the shards.
        self.write_scripts()
        times = [json.loads(line) for line in self.read("out/slurm/times.jsonl").splitlines()]
        self.assertEqual(len(times), 9)

    def test_shards_are_balanced_by_times(self):
        for i, microseconds in enumerate((900, 100, 100, 100, 500, 100, 100, 100, 100)):
            with open(self.path("times.jsonl"), "a", encoding="utf-8") as file:
                file.write(json.dumps({"id": f"my walks/w{i}.walk.yaml", "microseconds": microseconds}) + "\n")
        lists = [self.run_walks("--list", "--shard", f"{i}/3", "--shard-times", "times.jsonl").lines for i in (1, 2, 3)]
        self.assertEqual([[re.search(r"\d", line)[0] for line in lines] for lines in lists],
                         [["0"], ["4", "7"], ["1", "2", "3", "5", "6", "8"]])
        self.assertEqual(self.run_walks("--list", "--shard-times", "none").code, 2)

    def test_shards_of_two_divisions_are_not_merged(self):
        self.write("times.jsonl", '{"id":"my walks/w8.walk.yaml","microseconds":5000}\n'
                                  '{"id":"my walks/w0.walk.yaml","microseconds":1}\n')
        self.run_walks("--shard", "1/2", "--reporter", "jsonl=1.jsonl", "--output", "o1")
        self.run_walks("--shard", "2/2", "--reporter", "jsonl=2.jsonl", "--output", "o2", "--shard-times", "times.jsonl")
        outcome = self.run_program("merge-reports", "1.jsonl", "2.jsonl")
        self.assertEqual(outcome.code, 1)
        self.assert_diagnostics(outcome.err_lines, "2.jsonl: error other-plan:", "1.jsonl: error missing-shard: 2 2")

    def test_a_task_goes_on_where_it_was_killed(self):
        self.run_walks(*reports("whole"))
        self.write_scripts()
        for task in range(1, 5):
            self.run_task(task)
        before = self.read("out/slurm/results/4.jsonl")
        saved = self.read("out/slurm/saved/4.jsonl").splitlines(keepends=True)
        # One result is whole, the next was being written; its report had got less far.
        self.write("out/slurm/saved/4.jsonl", b"".join(saved[:2]) + saved[2][:100])
        self.write("out/slurm/results/4.jsonl", before[:len(before) // 3])
        os.remove(self.path("out/slurm/ended/4"))
        self.assertIn(self.run_task(4), (0, 1))
        self.assertEqual(self.read("out/slurm/saved/4.jsonl").splitlines()[1], saved[1].strip(), "it was played again")
        self.assertEqual(self.read("out/slurm/results/4.jsonl"), before)
        self.assertEqual(self.merge().returncode, 1)
        self.assert_merged_as_whole()

    def test_a_task_that_was_killed_before_its_first_result_starts_anew(self):
        self.write_scripts()
        self.run_task(1)
        before = self.read("out/slurm/results/1.jsonl")
        for cut in (b"", self.read("out/slurm/saved/1.jsonl")[:30]):
            self.write("out/slurm/saved/1.jsonl", cut)
            self.run_task(1)
            self.assertEqual(self.read("out/slurm/results/1.jsonl"), before)

    def test_tasks_without_an_end_are_named_and_nothing_passes(self):
        self.write_scripts("-g", "w[0-2]", shards=3)
        for task in (1, 2, 3):
            self.assertEqual(self.run_task(task), 0)
        passed = self.merge()
        self.assertEqual((passed.returncode, passed.stderr), (0, ""))
        direct = self.run_program("merge-reports", "out/slurm", "--slurm", "7", "--quiet", env=self.no_slurm)
        self.assertEqual((direct.code, len(direct.lines)), (0, 1), direct.err)
        self.assert_refused(self.run_program("merge-reports", "out", "out/slurm", "--slurm=7"), "--slurm: error bad-value:")
        for lose in (("results/2.jsonl",), ("ended/2",), ("results/2.jsonl", "ended/2")):
            kept = {name: self.read("out/slurm/" + name) for name in lose}
            for name in lose:
                os.remove(self.path("out/slurm/" + name))
            lost = self.merge()
            self.assertEqual((lost.returncode, self.read("out/slurm/merged")), (3, b"3\n"), lose)
            code = "task-lost" if "ended/2" in lose else "task-failed"
            self.assertTrue(lost.stderr.startswith(f"task 7_2: error {code}: "), lost.stderr)
            self.assertEqual("error missing-shard: " in lost.stderr, "results/2.jsonl" in lose)
            for name, contents in kept.items():
                self.write("out/slurm/" + name, contents)
        shutil.rmtree(self.path("out/slurm/results"))
        shutil.rmtree(self.path("out/slurm/ended"))
        nothing = self.merge()
        self.assertEqual(nothing.returncode, 3)
        self.assertEqual(nothing.stderr.count("error task-lost: "), 3)

    def test_a_cancelled_task_is_named_even_if_it_noted_an_interruption(self):
        self.write_scripts("-g", "w[0-2]", shards=3)
        for task in (1, 2, 3):
            self.assertEqual(self.run_task(task), 0)
        os.remove(self.path("out/slurm/ended/2"))
        passed = self.read("out/slurm/results/2.jsonl")
        self.assertEqual(passed.count(b'"outcome":"passed"'), 1)
        self.write("out/slurm/results/2.jsonl", passed.replace(b'"outcome":"passed"', b'"outcome":"interrupted"'))
        merged = self.merge()
        self.assertEqual((merged.returncode, self.read("out/slurm/merged")), (3, b"3\n"), merged.stderr)
        self.assertTrue(merged.stderr.startswith("task 7_2: error task-lost: "), merged.stderr)

    def test_another_run_cannot_be_resumed(self):
        self.assertEqual(self.run_walks("--slurm=script", "--resume").code, 2)
        self.write_scripts()
        self.run_task(1)
        saved = self.read("out/slurm/saved/1.jsonl")
        self.write_scripts("--resume")
        self.assertEqual(self.read("out/slurm/saved/1.jsonl"), saved)
        refused = self.run_walks("--slurm=script", "--resume", "--shards=5")
        self.assert_refused(refused, "--shards: error bad-value: 4")
        self.write("my walks/w0.walk.yaml", self.read("my walks/w0.walk.yaml") + b"# changed\n")
        self.assert_refused(self.run_walks("--slurm=script", "--resume"), "out/slurm: error other-run:")
        self.write_scripts()
        self.assertFalse(os.path.exists(self.path("out/slurm/saved/1.jsonl")))

    def test_what_does_not_go_together_is_refused(self):
        for arguments, error in ((("--shards=3",), "--shards: error bad-value: --slurm"), (("--mem=1G",), "--slurm: error bad-value: --mem"),
                                 (("--slurm", "--log", "a.log"), "--slurm: error bad-value: --log"),
                                 (("--slurm", "--shard=1/2"), "--slurm: error bad-value: --shard"),
                                 (("--slurm", "--save", "saved.jsonl"), "--slurm: error bad-value: --save"),
                                 (("--slurm", "--last-failed"), "--last-failed: error bad-value: --slurm"),
                                 (("--slurm", "--sbatch=qos"), "--sbatch: error bad-value: 'qos'"),
                                 (("--slurm", "--output", 'a"b'), 'a"b/slurm: error bad-value: --output'),
                                 (("--slurm", "--min-cases=100"), "--min-cases: error too-few-cases: 9 100")):
            self.assert_refused(self.run_walks(*arguments), error)
        self.assertFalse(os.path.exists(self.path("out/slurm/job")))
        self.assertEqual(self.run_walks("--slurm", "-g", "no such walk").code, 5)
        single = self.run_program("run", "my walks/w0.walk.yaml", "--slurm")
        self.assert_refused(single, "--slurm: error bad-value:")

    def test_without_slurm_the_error_says_so(self):
        outcome = self.run_walks("--slurm")
        self.assertEqual(outcome.code, 3)
        self.assertIn("sbatch: No such file or directory", outcome.err)


class Explorations(SlurmCase):
    """Campuses with avatars: one after the other, and as tasks."""

    def setUp(self):
        super().setUp()
        self.write("avatars/child.avatar.yaml", "height: 1.2\nradius: 0.2\neye_height: 1.1\n")
        self.write("other.campus.yaml", self.read("small.campus.yaml").replace(b"[0, 0, -2]", b"[0, 0, -8]"))
        self.arguments = ("small.campus.yaml", "other.campus.yaml", "--avatar=adult", "--avatar", "child")

    def explore(self, *arguments):
        return self.run_program("explore", *self.arguments, *arguments, env=self.no_slurm)

    def alone(self, campus, avatar, *arguments):
        outcome = self.run_program("explore", campus, "--avatar", avatar, "--json", "alone.json", *arguments)
        return outcome.code, outcome.out, json.loads(self.read("alone.json"))

    def write_explore_scripts(self, *arguments):
        outcome = self.explore("--slurm=script", *arguments)
        self.assertEqual((outcome.code, outcome.err), (0, ""))

    def run_script(self, name, *arguments, **variables):
        return subprocess.run(["bash", self.path("out/slurm-explore/" + name), *arguments], cwd=self.folder,
                              check=False, env=dict(self.no_slurm, **variables), capture_output=True, text=True,
                              timeout=120)

    def test_several_are_each_as_it_is_alone(self):
        outcome = self.explore("--json", "all.json", "--fail-on", "islands")
        parts = [part.split("\n", 1) for part in re.split("^=== ", outcome.out, flags=re.MULTILINE)[1:]]
        all_json = json.loads(self.read("all.json"))
        with open(SCHEMAS + "explorations.schema.json", encoding="utf-8") as schema:
            jsonschema.validate(all_json, json.load(schema), resolver=jsonschema.RefResolver("file://" + SCHEMAS, {}))
        all_json = all_json["explorations"]
        worst = 0
        pairs = [(campus, avatar) for campus in self.arguments[:2] for avatar in ("adult", "child")]
        self.assertEqual([head for head, _ in parts], ["%s, avatar %s" % pair for pair in pairs])
        for (campus, avatar), (_, text), entry in zip(pairs, parts, all_json, strict=True):
            code, out, report = self.alone(campus, avatar, "--fail-on", "islands")
            self.assertEqual((text, entry), (out, {"campus": campus, "avatar": avatar, "exit_code": code,
                                                   "report": report}))
            worst = max(worst, code)
        self.assertEqual(outcome.code, worst)

    def test_tasks_and_their_merge_equal_them(self):
        whole = self.explore("--json", "whole.json")
        self.write_explore_scripts("--json", "merged.json", "--partition=long", "--account=campus", "--time=5", "--mem=1G",
                                   "--sbatch=--qos=low")
        script = self.read("out/slurm-explore/shard.sh").decode()
        for option in ("array=1-4", "partition=long", "account=campus", "time=5", "mem=1G", "qos=low"):
            self.assertIn(f"#SBATCH --{option}\n", script)
        for task in (4, 2, 1, 3):
            self.assertEqual(self.run_task(task), 0)
        merged = self.merge()
        self.assertEqual((merged.returncode, merged.stdout, merged.stderr), (whole.code, whole.out, ""))
        self.assertEqual(self.read("merged.json"), self.read("whole.json"))
        again = self.explore("--merge", "7")
        self.assertEqual((again.code, again.out), (whole.code, whole.out))
        self.assertEqual(self.explore("--merge", "seven").code, 2)

    def test_a_task_without_an_end_is_named(self):
        self.write_explore_scripts("--json", "merged.json")
        for task in (1, 2, 4):
            self.run_task(task)
        lost = self.merge()
        self.assertEqual(lost.returncode, 3)
        self.assertTrue(lost.stderr.startswith("task 7_3: error task-lost: "), lost.stderr)
        self.assertEqual([each["report"] is None for each in json.loads(self.read("merged.json"))["explorations"]],
                         [False, False, True, False])

    def test_names_are_looked_up_before_anything_is_explored(self):
        for last in (("--avatar", "wheelchair"), ("--require", "nowhere"), ("--from", "nowhere")):
            for slurm in ((), ("--slurm=script",)):
                with self.subTest(last=last, slurm=slurm):
                    outcome = self.explore("--json", "all.json", *last, *slurm)
                    self.assertEqual((outcome.code, outcome.out), (2, ""))
                    self.assertIn(last[0] + ":1:1: error unknown-name: ", outcome.err)
                    self.assertNotIn("all.json", self.contents())

    def test_files_of_one_campus_need_one(self):
        self.assert_refused(self.explore("--geojson", "a.geojson"), "explore: error bad-value: --geojson")
        self.assert_refused(self.explore("--only", "5"), "--only: error bad-value: 4")


if __name__ == "__main__":
    main()
