#!/usr/bin/env python3
"""What `campuswalk-bench` prints and writes, with as few rounds as possible."""

import csv
import io
import json
import os
import shutil
import sys

from program import ProgramCase, main

PAIRS = [31, 142, 238, 347, 429, 666, 815, 961, 1081, 1295]
COLUMNS = "case,pairs,engine,query,us_min,us_median,nv,np,set_equal".split(",")
WALK_COLUMNS = ("triangles,controller,us_mean,us_p50,us_p99,us_max,goals,reached,forbidden,max_penetration_mm,"
                "crossings").split(",")
EXPLORE_COLUMNS = ("campus,triangles,engine,threads,s_least,s_median,s_processor,reachable_m2,nodes,ticks,bytes_per_m2,"
                   "m2_of_it_alone,walks_outside,steered_walks_outside,routes,us_route_median,us_route_p99,"
                   "route_length_ratio").split(",")
DRAWN_LOOKS = ["no-aa", "fxaa", "msaa4", "shadows+fxaa", "shadows+msaa4", "default"]
OF_THE_PAPER = ["paper", "obb", "sphere"]
CASES = ["table1", "million", "nested", "build", "memory", "rays", "probes", "avatars", "points", "import"]
HAS_NO_RENDERING = "this build has no rendering"


def is_ours(row):
    """Whether the engine is one of the project's."""
    return row["engine"] in OF_THE_PAPER + ["mixed"] or row["engine"].startswith("wide")


class Bench(ProgramCase):
    """Exit codes, the tables, the CSV and the plot."""

    bench = ""

    def run_bench(self, *arguments, **options):
        return self.run_program(*arguments, **{"executable": self.bench, **options})

    def passes_bench(self, *arguments):
        outcome = self.run_bench(*arguments)
        self.assertEqual((outcome.code, outcome.err if outcome.code else ""), (0, ""))
        return outcome

    def refused(self, *arguments, expected, where=""):
        self.assert_bad_usage(self.run_bench(*arguments), f"campuswalk-bench {where}".strip(), expected)

    def test_bad_usage_is_refused(self):
        self.refused(expected="table1 million nested trees campus import walk explore draw all")
        self.refused("table2", expected="'table2' 'table1'")
        self.refused("table1", "--rounds", "0", expected="--rounds 0 1 100000", where="table1 ")
        self.refused("table1", "--plot", "a.jpg", expected="--plot 'a.jpg' .svg .png", where="table1 ")
        self.refused("table1", "--csv", expected="--csv FILE", where="table1 ")

    def test_every_case_takes_the_same_options(self):
        self.write("file", "")
        for case in ("million", "nested", "trees", "campus", "import", "walk", "explore", "draw"):
            self.refused(case, "--quick", "--rounds", "100001", expected="--rounds 100001 1 100000", where=case + " ")
            outcome = self.run_bench(case, "--quick", "--rounds", "1", "--csv", "file/a.csv")
            self.assertEqual((outcome.code, outcome.out), (2, ""))
            self.assertRegex(outcome.err, r"^file/a\.csv: error output-unwritable: ")

    def test_quick_cases_write_their_rows(self):
        for name, cases in (("trees", ["build", "memory"]), ("campus", ["rays", "probes", "avatars", "points"]),
                            ("import", ["import"])):
            self.passes_bench(name, "--quick", "--csv", name + ".csv")
            self.assertEqual(list(dict.fromkeys(row["case"] for row in self.rows(name + ".csv"))), cases)

    def test_given_models_are_imported_too(self):
        out = self.passes_bench("import", "--quick", "--model", "room.obj", "--model", "room.obj", "--csv", "m.csv").out
        self.assertEqual(out.count("room.obj: 14 triangles\n"), 2)
        self.assertEqual(out.count("room.obj, milliseconds\n"), 2)
        rows = [row for row in self.rows("m.csv") if row["query"] == "room.obj" and row["engine"] == "helper"]
        self.assertEqual(len(rows), 2)
        outcome = self.run_bench("import", "--quick", "--model", "gone.obj")
        self.assert_refused(outcome, "gone.obj: error missing-file: 'gone.obj'")

    def test_unwritable_output_is_refused_before_the_run(self):
        self.write("file", "")
        outcome = self.run_bench("table1", "--csv", "file/a.csv")
        self.assertEqual((outcome.code, outcome.out), (2, ""))
        self.assertRegex(outcome.err, r"^file/a\.csv: error output-unwritable: ")

    def rows(self, name):
        rows = list(csv.DictReader(io.StringIO(self.read(name).decode())))
        self.assertEqual(list(rows[0]), COLUMNS)
        for row in rows:
            self.assertLessEqual(0.0, float(row["us_min"]))
            self.assertLessEqual(float(row["us_min"]), float(row["us_median"]))
        return rows

    def test_table1(self):
        out = self.passes_bench("table1", "--rounds", "1", "--csv", "new/t.csv").out
        for heading in ("All pairs", "First pair", "paper: Cv = ", "obb: Cv = ", "sphere: Cv = ",
                        "What the sphere test does (paper)"):
            self.assertRegex(out, "(?m)^" + heading.replace("(", r"\(").replace(")", r"\)"))
        self.assertNotIn("mixed", out)
        for pairs in PAIRS:
            self.assertEqual(len([line for line in out.splitlines() if line.split()[:1] == [str(pairs)]]), 6)

        rows = self.rows("new/t.csv")
        ours = [row for row in rows if is_ours(row)]
        engines = list(dict.fromkeys(row["engine"] for row in ours))
        self.assertEqual(engines[:4], OF_THE_PAPER + ["wide_sse42"])
        self.assertEqual([(int(row["pairs"]), row["engine"], row["query"]) for row in ours],
                         [(pairs, engine, query) for pairs in PAIRS for engine in engines for query in ("all", "first")])
        self.assertEqual({row["case"] for row in rows}, {"table1"})
        for row in ours:
            self.assertEqual(row["set_equal"], "yes")
            self.assertGreater(int(row["nv"]), 0)
            self.assertGreaterEqual(int(row["np"]), int(row["pairs"]) if row["query"] == "all" else 1)

    def test_the_mixed_reading_and_a_plot(self):
        out = self.plots("new/fig4.png", b"\x89PNG\r\n\x1a\n", "--mixed", "--csv", "t.csv")
        if out:
            self.assertRegex(out, "(?m)^mixed: Cv = ")
            engines = list(dict.fromkeys(row["engine"] for row in self.rows("t.csv")))
            self.assertEqual(engines[:5], OF_THE_PAPER + ["mixed", "wide_sse42"])

    def test_a_quick_run_of_everything(self):
        out = self.passes_bench("all", "--quick", "--csv", "all.csv").out
        rows = self.rows("all.csv")
        self.assertEqual(list(dict.fromkeys(row["case"] for row in rows)), CASES)
        for row in rows:
            if is_ours(row) and row["case"] not in ("build", "memory"):
                self.assertEqual(row["set_equal"], "yes", row)
        found = {case: {row["pairs"] for row in rows if row["case"] == case} for case in CASES}
        self.assertEqual(found["nested"], {"0"})
        [pairs] = found["million"]
        self.assertGreater(int(pairs), 666)
        for case in CASES[3:]:
            self.assertEqual(found[case], {""})
        self.check_memory([row for row in rows if row["case"] == "memory"])
        summary = out[out.index("Compared with the targets"):].splitlines()[1:]
        self.assertEqual(len(summary), 16)
        for line in summary:
            self.assertRegex(line, r"^  \S.* (not measured|\d+\.\d\dx?  +\(must [0-9.]+(, aim [0-9.]+)?\)  "
                                   r"(MISSED|reached|aim reached))$")

    def check_memory(self, rows):
        sizes = {(row["engine"], row["query"]): float(row["us_min"]) for row in rows}
        for engine in ("wide", "paper"):
            self.assertGreater(sizes[engine, "tree_bytes"], 16.0)
            # Half a vertex of 12 bytes and three indices of 4.
            self.assertAlmostEqual(sizes[engine, "data_bytes"] - sizes[engine, "tree_bytes"], 18.0, delta=0.2)

    def test_a_single_case(self):
        out = self.passes_bench("nested", "--rounds", "1", "--csv", "n.csv").out
        self.assertEqual({row["case"] for row in self.rows("n.csv")}, {"nested"})
        self.assertEqual(len(out[out.index("Compared with the targets"):].splitlines()), 2)

    def test_a_walk(self):
        """On a campus of some thousand triangles; speed doesn't matter here."""
        outcome = self.run_bench("walk", "--quick", "--csv", "new/w.csv")
        self.assertEqual((outcome.code, outcome.err), (0, ""), outcome.out)
        rows = list(csv.DictReader(io.StringIO(self.read("new/w.csv").decode())))
        self.assertEqual(list(rows[0]), WALK_COLUMNS)
        ours = rows[0]
        self.assertEqual([ours[key] for key in ("controller", "goals", "reached", "forbidden", "crossings")],
                         ["ours", "23", "23", "0", "0"])
        self.assertLessEqual(float(ours["max_penetration_mm"]), 0.1)
        self.assertIn([row["controller"] for row in rows[1:]], ([], ["bullet", "bullet_default", "bullet_tuned"]))
        for row in rows:
            self.assertEqual((row["triangles"], row["goals"]), (ours["triangles"], "23"))
            self.assertLess(0.0, float(row["us_p50"]))
            self.assertLessEqual(float(row["us_p50"]), float(row["us_p99"]))
            self.assertLessEqual(float(row["us_p99"]), float(row["us_max"]))
        verdicts = outcome.out[outcome.out.index("Compared with the targets"):].splitlines()[1:]
        self.assertEqual(len(verdicts), 9)
        for line in verdicts:
            self.assertRegex(line, r"^  \S.* (not measured|[0-9.]+(x Bullet's| mm| bytes| us| ms)?  "
                                   r"\(must [0-9.]+(, aim [0-9.]+)?\)  (MISSED|reached|aim reached))$")
        for line in verdicts:
            if "MISSED" in line:
                self.assertRegex(line, "mean tick|worst tick|two minutes")

    def test_an_exploration(self):
        """Of a campus of some thousand triangles; speed doesn't matter here."""
        outcome = self.run_bench("explore", "--quick", "--csv", "new/e.csv")
        self.assertEqual((outcome.code, outcome.err), (0, ""), outcome.out)
        rows = list(csv.DictReader(io.StringIO(self.read("new/e.csv").decode())))
        self.assertEqual(list(rows[0]), EXPLORE_COLUMNS)
        self.assertIn([(row["engine"], row["threads"]) for row in rows],
                      [[(engine, threads) for engine in engines for threads in "12"]
                       for engines in (("ours", "report"), ("ours", "report", "recast"))])
        self.assertEqual({row["campus"] for row in rows}, {"small"})
        for row in rows:
            self.assertLess(0.0, float(row["s_least"]))
            self.assertLessEqual(float(row["s_least"]), float(row["s_median"]))
            self.assertNotIn(None, row.values(), "all columns are there")
            if row["engine"] == "report":
                self.assertEqual(row["reachable_m2"] + row["us_route_p99"], "")
            else:
                self.assertAlmostEqual(float(row["reachable_m2"]) / 72 ** 2, 1.0, delta=0.15)
        for row in rows[:2]:
            self.assertLessEqual(float(row["reachable_m2"]), int(row["nodes"]) / 16)  # some nodes hang over edges
            self.assertEqual((row["walks_outside"], row["steered_walks_outside"]), ("0", "0"))
            self.assertEqual(row["routes"], "20")
            self.assertLessEqual(float(row["us_route_median"]), float(row["us_route_p99"]))
        verdicts = outcome.out[outcome.out.index("Compared with the targets"):].splitlines()[1:]
        self.assertEqual(len(verdicts), 13)

    def test_models_that_are_missing_are_named(self):
        out = self.passes_bench("explore", "--campus", "dungeon", "--campus", "nav_test", "--data", self.path("")).out
        self.assertRegex(out, "absent: dungeon: no model at .*/recast/dungeon.obj")
        self.assertRegex(out, "absent: nav_test: ")
        self.assertNotIn("demo", out)

    def test_images(self):
        """Of two small campuses, beside a peer that only prints times; speed doesn't matter here."""
        self.write("peer.py", "import json, sys\n"
                   "views = json.load(open(sys.argv[1] + '/views.json'))\n"
                   "open(sys.argv[1] + '/campus.glb', 'rb').read(4) == b'glTF' or sys.exit(1)\n"
                   "print('# says hello')\n"
                   "[print('frame', 'no-aa', i, 1e6) for i in range(len(views['views']) * views['rounds'])]\n")
        peer = f"peer={sys.executable} {self.path('peer.py')}"
        outcome = self.run_bench("draw", "--quick", "--csv", "new/d.csv", "--folder", "scenes", "--peer", peer,
                                   "--peer", "broken=false", "--peer", "silent=true")
        if HAS_NO_RENDERING in outcome.err:
            self.assertEqual((outcome.code, outcome.out), (3, ""))
            return
        self.assertEqual((outcome.code, outcome.err), (0, ""), outcome.out)
        self.assertIn("  absent: broken: its command failed\n  absent: silent: it drew no image\n", outcome.out)
        rows = list(csv.DictReader(io.StringIO(self.read("new/d.csv").decode())))
        self.assertEqual([row["look"] for row in rows], 2 * (2 * DRAWN_LOOKS + ["no-aa"]))
        self.assertEqual([row["engine"] for row in rows], 2 * (6 * ["campuswalk"] + 6 * ["processes"] + ["peer"]))
        self.assertEqual([row["campus"] for row in rows], 13 * ["hills"] + 13 * ["houses"])
        for row in rows:
            self.assertLessEqual(0.0, float(row["ms_least"]))
            self.assertLessEqual(float(row["ms_least"]), float(row["ms_mean"]) + 0.01)
        self.assertGreater(float(rows[-1]["times_ours"]), 100.0)
        for row in (rows[0], rows[-1]):
            scene = f"scenes/{row['campus']}-{row['triangles']}"
            for look in DRAWN_LOOKS:
                self.assertTrue(self.read(f"{scene}/campuswalk-{look}.png").startswith(b"\x89PNG"))
            # Peers get the model that we draw.
            model = json.loads(self.passes("info", f"{scene}/campus.glb", "--json").out)
            self.assertEqual(str(model["triangles"]), row["triangles"])
            self.assertEqual(model["warnings"], [])

    def test_peers_have_a_name_and_a_command(self):
        for peer in ("three.js", "=node", "three.js="):
            self.refused("draw", "--peer", peer, expected=f"--peer '{peer}' NAME=COMMAND", where="draw ")

    def plots(self, name, start, *arguments, **options):
        """What table1 prints while it plots; nothing in a build without rendering."""
        outcome = self.run_bench("table1", "--rounds", "1", "--plot", name, *arguments, **options)
        if HAS_NO_RENDERING in outcome.err:
            self.assertEqual((outcome.code, outcome.out), (3, ""))
        else:
            self.assertEqual((outcome.code, outcome.err), (0, ""))
            self.assertTrue(self.read(name).startswith(start))
            self.assertGreater(len(self.read(name)), 5000)
        return outcome.out

    def test_a_plot_and_a_peer_that_cannot_be_opened(self):
        copy = self.path("campuswalk-bench")
        shutil.copy(self.bench, copy)
        self.write("peers/ode.so", "no library")
        out = self.plots("fig4.svg", b"<?xml", executable=copy)
        if out:
            self.assertRegex(out, r"(?m)^  absent: ode: .*peers/ode\.so: .+\n  absent: embree: not built$")


if __name__ == "__main__":
    Bench.bench = os.path.abspath(sys.argv.pop(2))  # PROGRAM BENCH [unittest's arguments]
    main()
