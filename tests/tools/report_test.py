#!/usr/bin/env python3
"""HTML reports as files: `run --reporter html`, `run --record report`, `report`. A browser's part is tests/viewer/'s."""

import base64
import csv
import gzip
import hashlib
import json
import os
import re
import resource
import shutil
import struct

import jsonschema

from program import WALK, ProgramCase, main, png

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
CHUNK = re.compile(r'<script type="application/x-campuswalk" data-chunk="(\w+)"(?: data-type="([^"]*)")?>([^<]*)</script>')
FAILING = WALK.replace('never: "collision.enter hut/wall"', "never: popup.open hut")


def schema_of(name):
    with open(os.path.join(ROOT, "config", "schema", name), encoding="utf-8") as file:
        return json.load(file)


class Page:
    """A report, unpacked."""

    def __init__(self, html):
        self.html = html
        self.chunks = {}
        for number, media_type, text in CHUNK.findall(html):
            data = base64.b64decode(text, validate=True)
            self.chunks[number] = data if media_type else gzip.decompress(data)
        self.index = json.loads(self.chunks["index"])

    def details(self, row):
        return json.loads(self.chunks[str(row["chunk"])].split(b"\n")[row["line"]])

    def geometry(self, campus=0):
        """The GLB's JSON; None without one."""
        geometry = self.index["campuses"][campus]["geometry"]
        if geometry is None:
            return None
        data = self.chunks[str(geometry["chunk"])]
        size, = struct.unpack("<I", data[12:16])
        return json.loads(data[20:20 + size])


class ReportCase(ProgramCase):
    def page(self, name):
        return Page(self.read(name).decode())

    def run_walks(self, *arguments):
        return self.run_program("run", "--rendering-backend", "none", *arguments)


class Reports(ReportCase):
    def setUp(self):
        super().setUp()
        self.write("fails.walk.yaml", FAILING)
        self.write("walks/bad.walk.yaml", WALK.replace("campus: ", "campus: ../").replace("walk_to: end", "walk_to: nowhere"))

    def test_a_run_writes_a_report(self):
        self.assertEqual(self.run_walks("--reporter", "html=r.html", "--reporter", "jsonl=r.jsonl").code, 2)
        page = self.page("r.html")
        index = page.index
        self.assertTrue(index["complete"])
        self.assertEqual([(row["name"], row["outcome"]) for row in index["walks"]],
                         [("fails", "failed"), ("short", "passed"), ("bad", "bad_input")])
        lines = [json.loads(line) for line in self.read("r.jsonl").splitlines()[1:]]
        for row, line in zip(index["walks"], lines):
            self.assertEqual(page.details(row)["result"], line)
        self.assertEqual(page.details(index["walks"][0])["source"]["fails.walk.yaml"], FAILING)
        self.assertEqual(len(index["campuses"]), 1)
        campus = index["campuses"][0]
        self.assertEqual([each["id"] for each in campus["objects"]], ["ground", "hut/wall", "gate"])
        self.assertEqual(campus["objects"][2]["size"], [2, 2, 2])
        self.assertEqual(campus["buildings"][0]["title"], "The Hut")
        tags = {tuple(node["extras"]["objects"]) for node in page.geometry()["nodes"]}
        self.assertEqual(tags, {(0,), (1,)})

    def test_the_policy_allows_the_viewer_and_nothing_else(self):
        self.run_walks("--reporter", "html=r.html")
        html = self.read("r.html").decode()
        policy = re.search(r'http-equiv="Content-Security-Policy" content="([^"]*)"', html)[1]
        self.assertIn("default-src 'none'", policy)
        scripts = re.findall(r"<script>(.*?)</script>", html, re.S)
        styles = re.findall(r"<style>(.*?)</style>", html, re.S)
        self.assertEqual((len(scripts), len(styles)), (1, 1))
        for text in scripts + styles:
            digest = base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()
            self.assertIn(f"'sha256-{digest}'", policy)
        self.assertNotIn("unsafe-inline", policy)
        self.assertIsNone(re.search(r'<(?:link|img|iframe|object)\b|\bsrc=|\bhref=', CHUNK.sub("", html.split("<script>")[0])))

    def test_bytes_are_the_same_for_any_number_of_workers(self):
        for workers in ("1", "3"):
            self.run_walks("-j", workers, "--repeat-each", "3", "--reporter", f"html={workers}.html", "--output", "out")
        self.assertEqual(self.read("1.html"), self.read("3.html"))

    def test_hostile_file_names_stay_text(self):
        name = "<img src=x onerror=alert(1)>&\u202e"
        self.write(name + ".walk.yaml", FAILING)
        self.run_walks("--reporter", "html=r.html", name + ".walk.yaml")
        page = self.page("r.html")
        self.assertNotIn("<img", page.html)
        self.assertEqual(page.index["walks"][0]["name"], name)
        self.assertIn(name, page.index["title"])

    def test_strangers_pictures_are_left_out_with_a_warning(self):
        """Only PNG files are decoded, none of too many pixels, and not in this process."""
        def blank(width, height):
            return png(width, height, (bytes(width * 4 + 1) for _ in range(height)), color_type=6)
        pictures = {"good.png": blank(40, 30), "bomb.png": blank(16384, 16384), "cut.png": blank(40, 30)[:-20],
                    "tga.png": struct.pack("<BBBHHBHHHHBB", 0, 0, 2, 0, 0, 0, 0, 0, 8, 8, 24, 0) + bytes(192)}
        self.write("other.walk.yaml", WALK)
        self.passes("run", "short.walk.yaml", "other.walk.yaml", "-q", "--rendering-backend", "none", "--reporter", "jsonl=r.jsonl")
        artifacts = [{"name": "x", "path": name, "media_type": "image/png"} for name in pictures]
        self.write("r.jsonl", self.read("r.jsonl").replace(b'"artifacts":[]', b'"artifacts":' + json.dumps(artifacts).encode(), 1))
        for name, content in pictures.items():
            self.write("out/" + name, content)
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
        outcome = self.passes("report", "r.jsonl", "-o", "report.html")
        page = self.page("report.html")
        self.assertEqual([list(page.details(row)["pictures"]) for row in page.index["walks"]], [["good.png"], []])
        for name in ("bomb.png", "cut.png", "tga.png"):
            self.assertIn(name + ": warning bad-picture: ", outcome.err)
        self.assertNotIn("good.png", outcome.err)
        self.assertLess(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss, max(before, 400_000), "kilobytes")

    def test_the_title_is_what_was_named(self):
        for named, title in (("short.walk.yaml", "short.walk.yaml"), (".", "campuswalk"), ("", "campuswalk")):
            self.run_walks("--reporter", "html=r.html", *([named] if named else []))
            self.assertEqual(self.page("r.html").index["title"], title)

    def test_a_configured_report_is_written_again(self):
        self.write("walks.config.yaml", "reporters: [{html: r.html}]\n")
        for _ in range(2):
            self.assertNotIn("isn't a report of this kind", self.run_walks().err)
            self.assertEqual(len(self.page("r.html").index["walks"]), 3)
        self.write("r.html", "<!doctype html>My own page")
        self.assertIn("isn't a report of this kind", self.run_walks().err)
        self.assertEqual(self.read("r.html"), b"<!doctype html>My own page")

    def test_a_run_can_leave_the_models_out(self):
        self.run_walks("--reporter", "html=r.html", "--report-geometry", "boxes")
        campus = self.page("r.html").index["campuses"][0]
        self.assertEqual((campus["geometry"], len(campus["objects"])), (None, 3))
        self.assertFalse([name for name in os.listdir(self.path("out/campuses")) if name.endswith(".glb.gz")])

    def test_an_html_report_needs_a_file(self):
        self.assert_refused(self.run_walks("--reporter", "html"), "--reporter: error bad-value: html=report.html")

    def test_a_recording_conforms_to_its_schema(self):
        self.run_walks("--record", "report", "short.walk.yaml")
        recording = json.loads(self.read("out/recordings/short.recording.json"))
        described = schema_of("recording.schema.json")
        check = jsonschema.Draft7Validator(described)
        check.validate(recording)
        for place, schema in (((), described), (("way",), described["properties"]["way"]),
                              (("steps", 0), described["properties"]["steps"]["items"]),
                              (("popups", 0), described["properties"]["popups"]["items"])):
            for key in schema["required"]:
                less = json.loads(json.dumps(recording))
                part = less
                for step in place:
                    part = part[step]
                del part[key]
                self.assertFalse(check.is_valid(less), (place, key))
                part[key], part["unknown"] = recording, 1
                self.assertFalse(check.is_valid(less), (place, key))


class LaterReports(ReportCase):
    """`report`, after the run and elsewhere."""

    def setUp(self):
        super().setUp()
        self.write("fails.walk.yaml", FAILING)
        self.run_walks("--record", "report", "--reporter", "jsonl=r.jsonl")

    def hide(self, *names):
        for name in names:
            os.remove(self.path(name))

    def test_it_is_that_of_the_run(self):
        self.run_walks("--reporter", "html=run.html")
        self.passes("report", "r.jsonl", "-o", "later.html")
        run, later = self.page("run.html"), self.page("later.html")
        for key in ("walks", "campuses", "complete"):
            self.assertEqual(later.index[key], run.index[key])
        for number in run.chunks:
            if number != "index":
                self.assertEqual(later.chunks[number], run.chunks[number])

    def test_shards_make_one_report(self):
        self.run_walks("--reporter", "html=run.html")
        for i in ("1", "2"):
            self.run_walks(f"--shard={i}/2", "--record", "report", "--reporter", f"jsonl=parts/{i}.jsonl")
        self.passes("report", "parts", "-o", "parts.html")
        self.assertEqual(self.page("parts.html").index["walks"], self.page("run.html").index["walks"])

    def test_without_the_campus_there_is_its_bundle(self):
        self.hide("room.obj", "small.campus.yaml", "short.walk.yaml", "fails.walk.yaml")
        self.passes("report", "r.jsonl")
        page = self.page("report.html")
        self.assertEqual(len(page.index["campuses"][0]["objects"]), 3)
        self.assertTrue(page.geometry()["nodes"])
        self.assertIsNone(page.details(page.index["walks"][0])["source"])

    def test_without_the_bundle_there_is_the_campus(self):
        bundle = self.page_of_report()
        shutil.rmtree(self.path("out/campuses"))
        self.assertEqual(self.page_of_report().chunks, bundle.chunks)
        shutil.rmtree(self.path("out"))
        page = self.page_of_report()
        self.assertIsNone(page.details(page.index["walks"][0])["recording"])
        self.assertEqual(page.index["walks"][0]["campus"], 0)

    def test_models_are_imported_as_for_a_run(self):
        shutil.rmtree(self.path("out/campuses"))
        page = Page(self.report_bytes("--no-cache", "--sandbox", "off", "--title", "Nightly <b>").decode())
        self.assertEqual(page.index["title"], "Nightly <b>")
        self.assertIn("<title>Nightly &lt;b&gt;</title>", page.html)
        self.assertTrue(page.geometry()["nodes"])

    def report_bytes(self, *arguments):
        self.passes("report", "r.jsonl", "-o", "later.html", *arguments)
        return self.read("later.html")

    def test_without_either_there_are_the_results(self):
        shutil.rmtree(self.path("out/campuses"))
        self.hide("small.campus.yaml")
        page = self.page_of_report()
        self.assertEqual(page.index["campuses"], [])
        self.assertEqual([row["campus"] for row in page.index["walks"]], [-1, -1])
        self.assertTrue(page.details(page.index["walks"][0])["recording"]["log"])

    def page_of_report(self, *arguments):
        return Page(self.report_bytes(*arguments).decode())

    def test_geometry(self):
        simplified = self.page_of_report().index["campuses"][0]
        self.assertEqual((simplified["geometry"]["kind"], simplified["geometry"]["error"]), ("simplified", 0.05))
        exact = self.page_of_report("--report-geometry", "exact").index["campuses"][0]
        self.assertEqual((exact["geometry"]["kind"], exact["geometry"]["error"]), ("exact", 0))
        boxes = self.page_of_report("--report-geometry", "boxes").index["campuses"][0]
        self.assertIsNone(boxes["geometry"])
        self.assertEqual(len(boxes["objects"]), 3)
        none = self.page_of_report("--report-geometry", "none").index["campuses"][0]
        self.assertEqual((none["geometry"], none["objects"]), (None, []))

    def test_files_that_are_not_reports_are_refused(self):
        for name, text, expected in (("none.jsonl", None, "none.jsonl: error missing-file:"),
                                     ("empty.jsonl", "", "empty.jsonl:1:1: error bad-report: --reporter"),
                                     ("log.jsonl", '{"walk_log":1}\n', "log.jsonl:1:1: error bad-report: --reporter"),
                                     ("b.jsonl", self.read("r.jsonl").decode() + "{}\n", "b.jsonl:4:1: error bad-report:")):
            if text is not None:
                self.write(name, text)
            outcome = self.run_program("report", name, "-o", "no.html")
            self.assert_refused(outcome, expected)
            self.assertFalse(os.path.exists(self.path("no.html")))

    def test_a_truncated_file_is_reported(self):
        whole = self.read("r.jsonl")
        self.write("cut.jsonl", whole[:-20].decode())
        outcome = self.run_program("report", "cut.jsonl", "-o", "cut.html")
        self.assertEqual(outcome.code, 2)
        self.assertIn("cut.jsonl: error incomplete-report: it has 1 of 2 results", outcome.err)
        page = self.page("cut.html")
        self.assertFalse(page.index["complete"])
        self.assertEqual(len(page.index["walks"]), 1)
        self.assertIn("incomplete-report", page.index["problems"][0])

    def test_a_report_does_not_replace_what_it_is_made_from(self):
        outcome = self.run_program("report", "r.jsonl", "-o", "r.jsonl")
        self.assert_refused(outcome, "r.jsonl: error report-unwritable:")
        self.assertTrue(self.read("r.jsonl").startswith(b'{"campuswalk_results"'))
        self.passes("explore", "small.campus.yaml", "--json", "explored.json")
        shutil.copy(self.path("r.jsonl"), self.path("old.jsonl"))
        for name in ("old.jsonl", "explored.json"):
            before = self.read(name)
            outcome = self.run_program("report", "r.jsonl", "--against", "old.jsonl", "--findings", "explored.json", "-o", name)
            self.assert_refused(outcome, name + ": error report-unwritable:")
            self.assertEqual(self.read(name), before)

    def test_a_mistake_leaves_the_old_report(self):
        old = self.report_bytes()
        for mistake in (("--against", "gone.jsonl"), ("--findings", "gone.json")):
            self.assertEqual(self.run_program("report", "r.jsonl", "-o", "later.html", *mistake).code, 2)
            self.assertEqual(self.read("later.html"), old)

    def test_a_forged_bundle_counts_as_none(self):
        whole = self.page_of_report()
        [name] = [name for name in os.listdir(self.path("out/campuses")) if name.endswith(".json")]
        bundle = json.loads(self.read("out/campuses/" + name))
        deep = "[" * 100_000 + "]" * 100_000
        forged = [json.dumps({**bundle, "campus": campus}) for campus in ({}, {"name": "x"}, 7, {**bundle["campus"], "min": [0, 0]},
                                                                          {**bundle["campus"], "objects": [{}]})]
        for text in (*forged, '{"campuswalk_campus":1,"error":0,"campus":%s}' % deep):
            self.write("out/campuses/" + name, text)
            self.assertEqual(self.page_of_report().index["campuses"], whole.index["campuses"])

    def test_results_from_elsewhere_read_only_the_run_and_the_project(self):
        self.write("../secret.yaml", "secret: 1\n")
        self.addCleanup(os.remove, self.path("../secret.yaml"))
        lines = self.read("r.jsonl").decode().splitlines()
        result = json.loads(lines[1])
        outside = os.path.abspath(self.path("../secret.yaml"))
        for file in (outside, "../secret.yaml", "/etc/passwd"):
            result["file"] = file
            result["artifacts"] = [{"name": "recording", "path": file, "media_type": "application/json"},
                                   {"name": "x", "path": file, "media_type": "image/png"}]
            self.write("forged.jsonl", "\n".join([lines[0], json.dumps(result), lines[2]]) + "\n")
            outcome = self.run_program("report", "forged.jsonl", "-o", "forged.html")
            self.assert_refused(outcome, "forged.jsonl:2:1: error bad-report: artifacts[0].path")
            result["artifacts"] = []
            self.write("forged.jsonl", "\n".join([lines[0], json.dumps(result), lines[2]]) + "\n")
            self.run_program("report", "forged.jsonl", "-o", "forged.html")
            page = self.page("forged.html")
            self.assertNotIn(b"secret: 1", b"".join(page.chunks.values()))
            self.assertNotIn(b"root:", b"".join(page.chunks.values()))

    def test_comparing_two_runs(self):
        self.write("short.walk.yaml", WALK.replace("at: [0, 0, 5]", "at: [0, 0, 5]").replace("turn: 180", "turn: 90"))
        self.write("fails.walk.yaml", WALK)
        self.run_walks("--record", "report", "--reporter", "jsonl=new.jsonl", "--output", "new")
        self.run_program("report", "new.jsonl", "-o", "c.html", "--output", "new", "--against", "r.jsonl",
                         "--against-output", "out")
        page = self.page("c.html")
        against = page.index["against"]
        self.assertEqual(against["name"], "r.jsonl")
        self.assertEqual([(row["name"], row["outcome"], row["index"]) for row in against["walks"]],
                         [("fails", "failed", 0), ("short", "passed", 1)])
        self.assertIsNone(against["walks"][0]["parts_at"])
        self.assertTrue(page.details(against["walks"][0])["recording"])

    def test_findings_lie_over_their_campus(self):
        self.passes("explore", "small.campus.yaml", "--json", "explored.json")
        explored = self.read("explored.json")
        page = self.page_of_report("--findings", "explored.json")
        findings = json.loads(explored)["findings"]
        self.assertEqual(page.index["findings"], [{**each, "campus": 0} for each in findings])
        self.write("other.json", "{}")
        self.assert_refused(self.run_program("report", "r.jsonl", "--findings", "other.json"),
                            "other.json:1:1: error bad-report: explore")
        nowhere = {key: value for key, value in findings[0].items() if key != "at"}
        self.write("other.json", json.dumps({**json.loads(explored), "findings": [nowhere]}))
        self.assertEqual(self.page_of_report("--findings", "other.json").index["findings"], [{**nowhere, "campus": 0}])
        for forged in ([1], [{}], 5, [{**findings[0], "at": [0, 1]}]):
            self.write("other.json", json.dumps({**json.loads(explored), "findings": forged}))
            self.assert_refused(self.run_program("report", "r.jsonl", "--findings", "other.json"),
                                "other.json:1:1: error bad-report: explore")

    def test_memory_does_not_grow_with_the_walks(self):
        with open(self.program, "rb") as file:
            if b"__asan_init" in file.read():
                self.skipTest("AddressSanitizer delays the reuse of freed memory")
        header, first, *_ = self.read("r.jsonl").decode().splitlines()
        peaks = []
        for count in (100, 10_000):
            with open(self.path("many.jsonl"), "w", encoding="utf-8") as file:
                file.write(header + "\n")
                for i in range(count):
                    file.write(first.replace("fails.walk.yaml", f"walks/fails-{i}.walk.yaml") + "\n")
            peaks.append(self.peak_of("report", "many.jsonl", "-o", "many.html"))
            self.assertEqual(len(self.page("many.html").index["walks"]), count)
        self.assertLess(peaks[1] - peaks[0], 10_000 * 3 * 1024)  # rows of the index: text, and packed

    def peak_of(self, *arguments):
        """Of its memory, bytes."""
        pid = os.fork()
        if pid == 0:
            os.chdir(self.path("."))
            os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
            os.execv(self.program, [self.program, *arguments])
        _, status, usage = os.wait4(pid, 0)
        self.assertEqual(os.waitstatus_to_exitcode(status), 2)  # the header says two results
        return usage.ru_maxrss * 1024


class Ways(ReportCase):
    """Recordings of the demo's walks show every tick where it was."""

    WALKS = ("first-tour", "every-step", "robot-delivery")

    def test_every_tick_is_within_a_millimetre_of_the_log(self):
        found = [os.path.join(folder, name) for folder, _, names in os.walk(os.path.join(ROOT, "config", "walks"))
                 for name in names if name.endswith(".walk.yaml")]
        walks = [path for path in found if os.path.basename(path).split(".")[0] in self.WALKS or "fell" in path or
                 "grounded" in path]
        self.assertGreater(len(walks), 5)
        self.run_program("run", "--rendering-backend", "none", "--record", "report", "--record", "csv", "--root", ROOT, *walks)
        checked = 0
        recordings = self.path("out/recordings")
        for folder, _, names in os.walk(recordings):
            for name in names:
                walk = os.path.relpath(os.path.join(folder, name), recordings).removesuffix(".recording.json")
                checked += self.check(os.path.join(folder, name), self.path(f"out/{walk}"))
        self.assertGreater(checked, 20_000)

    def check(self, file, folder):
        with open(file, encoding="utf-8") as file:
            recording = json.load(file)
        with open(os.path.join(folder, "trajectory.csv"), encoding="utf-8", newline="") as file:
            exact = [[float(row[key]) for key in "xyz"] for row in csv.DictReader(file)]
        self.assertEqual(len(exact), recording["ticks"] + 1)
        shown = self.positions(recording)
        for tick, (there, here) in enumerate(zip(exact, shown)):
            for a, b in zip(there, here):
                self.assertLessEqual(abs(a - b / 1000), 0.000502, (folder, tick))
                self.assertLessEqual(abs(round(a, 3) - b / 1000), 0.001001, (folder, tick))
        if len(exact) > 1000:  # a fall needs every tick
            self.assertLess(len(recording["way"]["tick"]), len(exact) / 3)
        return len(exact)

    @staticmethod
    def positions(recording):
        """Of each tick, millimetres."""
        way = {key: [] for key in ("tick", "x", "y", "z")}
        for key, sums in way.items():
            total = 0
            for difference in recording["way"][key]:
                total += difference
                sums.append(total)
        cuts = set(recording["way"]["cut"])
        at = 0
        for tick in range(recording["ticks"] + 1):
            while at + 1 < len(way["tick"]) and way["tick"][at + 1] <= tick:
                at += 1
            here = [way[key][at] for key in "xyz"]
            if at + 1 < len(way["tick"]) and at + 1 not in cuts:
                share = (tick - way["tick"][at]) / (way["tick"][at + 1] - way["tick"][at])
                here = [a + share * (way[key][at + 1] - a) for a, key in zip(here, "xyz")]
            yield here


if __name__ == "__main__":
    main()
