#!/usr/bin/env python3
"""`campuswalk explore --min-width`: narrow passages behind one another and beside wider ones."""

import json

import jsonschema

from explore_test import FLOOR, SCHEMA, box
from program import ProgramCase, main

GAPS = ((-4, [(-6, -5.3), (3, 5)]), (0, [(1, 1.9)]), (3, [(-2, -1.2)]), (6, [(2, 2.8)]))


def wall(x, gaps):
    ends = [-10] + [z for gap in gaps for z in gap] + [10]
    return "".join(box("wall-%d/%d" % (x, i), (x - 0.1, 0, ends[2 * i]), (x + 0.1, 3, ends[2 * i + 1]))
                   for i in range(len(gaps) + 1))


class NarrowPassages(ProgramCase):
    def setUp(self):
        """From west to east, a gap of 0.7 m beside one of 2 m, and doors of 0.9, 0.8 and 0.8 m one behind the other."""
        super().setUp()
        self.write("floor.obj", FLOOR)
        self.write("yard.campus.yaml", "scenes: [{file: floor.obj}]\ncolliders:\n"
                                       "  - {id: ground, nodes: floor, shape: mesh, mode: solid}\n"
                   + "".join(wall(x, gaps) for x, gaps in GAPS)
                   + "spawns: {start: {at: [-8, 0, 0]}}\nplaces: {end: [8, 0, 0]}\n")

    def report(self, *arguments, code=0):
        done = self.run_program("explore", "yard.campus.yaml", "--json", "report.json", *arguments)
        self.assertEqual(code, done.code, done.err)
        self.text = done.out
        with open(self.path("report.json"), encoding="utf-8") as file:
            report = json.load(file)
        jsonschema.validate(report, SCHEMA)
        return report

    def narrow(self, report):
        return [finding for finding in report["findings"] if finding["kind"] == "narrow"]

    def test_each_is_measured(self):
        report = self.report("--min-width", "1.2", "--fail-on", "narrow", code=1)
        passages = [(round(passage["width"], 3), round(passage["at"][0]), passage["only_path"])
                    for passage in report["bottlenecks"]]
        self.assertEqual([(0.7, -4, False), (0.8, 3, True), (0.8, 6, True), (0.9, 0, True)], sorted(passages))
        self.assertEqual({"wall--4/0", "wall--4/1"}, {side["object"] for side in report["bottlenecks"][0]["between"]})
        first, *behind = self.narrow(report)
        self.assertRegex(first["subject"], "^narrow passage to [0-9]+ m², place end$")
        self.assertRegex(first["text"], r" is 0\.90 m wide, the body needs 1\.20 m$")
        self.assertEqual(["0.80 m wide between wall-%d/0 and wall-%d/1" % (x, x) for x in (3, 6)],
                         sorted(finding["text"] for finding in behind))
        self.assertRegex(self.text, r"\nnarrow passages that one may go round by a wider way: 1, the narrowest 0\.70 m wide "
                                    r"between wall--4/0 and wall--4/1, at -4\.\d\d, 0\.00, -5\.\d\d\n")

    def test_those_of_one_object_share_a_finding(self):
        file = self.path("yard.campus.yaml")
        with open(file, encoding="utf-8") as campus:
            text = campus.read()
        model = FLOOR
        for i, line in enumerate(part for x, gaps in GAPS[2:] for part in wall(x, gaps).splitlines()):
            center, size = ([float(n) for n in line.split(key + ": [")[1].split("]")[0].split(", ")] for key in ("center", "size"))
            model += "o wall\n" + "".join(
                "v %g %g %g\n" % tuple(center[k] + (0.5 if corner >> k & 1 else -0.5) * size[k] for k in range(3))
                for corner in range(8))
            for face in ("1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"):
                model += "f %s\n" % " ".join(str(4 + 8 * i + int(vertex)) for vertex in face.split())
            text = text.replace(line + "\n", "")
        self.write("floor.obj", model)
        self.write("yard.campus.yaml", text.replace("spawns:", "  - {id: rooms, nodes: wall, shape: mesh, mode: solid}\nspawns:"))
        _, doors = self.narrow(self.report("--min-width", "1.2"))
        self.assertEqual("2 narrow passages", doors["subject"])
        self.assertRegex(doors["text"], r"^0\.80 m wide within rooms \(wall\); likewise at -?\d")
        self.assertRegex(self.text, r"2 narrow passages, the first at \d\.\d\d, 0\.00, -?\d\.\d\d: 0\.80 m wide within rooms \(wall\); ")

    def test_a_visitor_who_fits_through_finds_none(self):
        self.assertEqual([], self.report("--min-width", "0.69", "--fail-on", "narrow")["bottlenecks"])
        self.assertEqual([0.7], [round(p["width"], 3) for p in self.report("--min-width", "0.75")["bottlenecks"]])


if __name__ == "__main__":
    main()
