#!/usr/bin/env python3
"""Tests `campuswalk import osm`: what it writes, that people walk where the map says so, and what it refuses."""

import json
import os
import re
import struct

import map_pbf
import walked_ways
from program import ProgramCase, main

MAPS = {"tum": 97.0, "brown": 97.0, "ajou": 97.0, "quito": 97.0}  # percent of the ways' length

NODES = {1: (0, 0), 2: (20, 0), 3: (20, 10), 4: (0, 10), 5: (10, 0), 6: (10, -30), 7: (-60, -30), 8: (60, -30)}
WAYS = {10: ((1, 5, 2, 3, 4, 1), {"building": "university", "name": "도서관", "height": "9", "name:en": "Library <b>"}),
        11: ((5, 6), {"highway": "footway"}),
        12: ((7, 6, 8), {"highway": "footway"})}


def map_xml(extra="", node_tags=None, ways=None, nodes=None):
    """A small map; metres are about those at the equator."""
    degree = 111319.49
    tags = lambda t: "".join('<tag k="%s" v="%s"/>' % (k, v.replace("&", "&amp;").replace("<", "&lt;")) for k, v in t.items())
    text = '<osm version="0.6"><bounds minlat="-0.0008" minlon="-0.0008" maxlat="0.0008" maxlon="0.0008"/>'
    for number, (x, y) in (nodes or NODES).items():
        text += '<node id="%d" lat="%.9f" lon="%.9f">%s</node>' % (number, y / 110574.0, x / degree,
                                                                   tags((node_tags or {5: {"entrance": "main"}}).get(number, {})))
    for number, (nodes, t) in (ways or WAYS).items():
        text += '<way id="%d">%s%s</way>' % (number, "".join('<nd ref="%d"/>' % n for n in nodes), tags(t))
    return text + extra + "</osm>"


class ImportTest(ProgramCase):
    """On a library with an entrance and two footways."""

    def import_map(self, *arguments, name="a.osm", folder="out"):
        return self.run_program("import", "osm", self.path(name), "-o", self.path(folder), *arguments)

    def text(self, name):
        return self.read(name).decode("utf-8")

    def test_writes_a_campus_whose_walk_passes(self):
        self.write("a.osm", map_xml())
        outcome = self.import_map()
        self.assertEqual(outcome.code, 0, outcome.err)
        self.assertEqual(sorted(os.listdir(self.path("out"))),
                         ["ATTRIBUTION.md", "a.campus.yaml", "a.walk.yaml", "campus.glb"])
        campus = self.text("out/a.campus.yaml")
        self.assertIn("도서관", campus)
        self.assertRegex(campus, r"entrance-5: \[.*\]  # \S*도서관\n")
        self.assertIn("latitude_deg: 0,", campus)
        self.assertIn("OpenStreetMap contributors", self.text("out/ATTRIBUTION.md"))
        walk = self.text("out/a.walk.yaml")
        self.assertRegex(walk, r"go_to: entrance-5  # \S*도서관\n")
        self.assertEqual(self.run_program("run", self.path("out/a.walk.yaml")).code, 0)
        self.assertEqual(self.run_program("validate", self.path("out/a.campus.yaml")).code, 0)

    def test_fails_when_the_door_is_closed(self):
        self.write("a.osm", map_xml())
        self.assertEqual(self.import_map().code, 0)
        campus = self.text("out/a.campus.yaml")
        place = re.search(r"entrance-5: \[(.*), (.*), (.*)\]", campus)
        wall = "  - {id: closed, shape: box, center: [%s, 1, %s], size: [3, 2, 3], mode: solid}\n" % (place[1], place[3])
        self.write("out/a.campus.yaml", campus.replace("colliders:\n", "colliders:\n" + wall))
        self.assertEqual(self.run_program("run", self.path("out/a.walk.yaml")).code, 1)

    def test_is_deterministic_and_overwrites_only_when_asked(self):
        self.write("a.osm", map_xml())
        self.assertEqual(self.import_map().code, 0)
        before = self.contents()
        self.assertEqual(self.import_map().code, 2)
        self.assertEqual(self.contents(), before)
        self.assertEqual(self.import_map("--overwrite").code, 0)
        self.assertEqual(self.contents(), before)
        self.assertEqual(self.import_map("--overwrite", "--no-cache", "--sandbox", "off").code, 0)
        self.assertEqual(self.contents(), before)

    def test_reads_pbf(self):
        self.write("a.osm", map_xml())
        self.write("b.osm.pbf", map_pbf.pbf_of(map_xml()))
        self.assertEqual(self.import_map(folder="xml").code, 0)
        outcome = self.import_map(name="b.osm.pbf", folder="pbf")
        self.assertEqual(outcome.code, 0, outcome.err)
        self.assertEqual(self.read("xml/campus.glb"), self.read("pbf/campus.glb"))
        self.write("b.osm.pbf", self.read("b.osm.pbf")[:-20])
        self.assertEqual(self.import_map(name="b.osm.pbf", folder="none").code, 2)

    def test_cuts_a_section(self):
        self.write("a.osm", map_xml())
        self.assertEqual(self.import_map("--bbox", "-0.0004,-0.0007,0.0003,0.0003", "--name", "part").code, 0)
        self.assertIn("latitude_deg: -0.00005,", self.text("out/part.campus.yaml"))
        self.assertEqual(self.import_map("--center", "0,0", "--radius", "50", folder="square").code, 0)
        for bad in (("--bbox", "1,2,3"), ("--bbox", "3,0,1,1"), ("--center", "0,0"), ("--radius", "5"),
                    ("--bbox", "10,10,10.001,10.001")):
            self.assertEqual(self.import_map(*bad, folder="none").code, 2, bad)
            self.assertFalse(os.path.exists(self.path("none/campus.glb")), bad)

    def test_takes_maps_across_the_antimeridian(self):
        def turned(match):
            longitude = float(match[2]) + 180.0
            return '%s="%.9f"' % (match[1], longitude - 360.0 if longitude > 180.0 else longitude)
        text = re.sub(r'\b(lon|minlon|maxlon)="([^"]*)"', turned, map_xml())
        self.write("a.osm", text)
        self.write("b.osm.pbf", map_pbf.pbf_of(text))
        rows = "\n".join(" ".join("%.2f" % (0.5 * x) for x in range(41)) for _ in range(41))
        self.write("a.asc", "ncols 41\nnrows 41\nxllcenter 179.996\nyllcenter -0.004\ncellsize 0.0002\n" + rows)
        whole = ("--bbox", "-0.0008,179.9992,0.0008,-179.9992")
        for folder, name, arguments in (("xml", "a.osm", ()), ("pbf", "b.osm.pbf", ()), ("box", "a.osm", whole),
                                        ("square", "b.osm.pbf", ("--center", "0,-180", "--radius", "88")),
                                        ("high", "a.osm", ("--heights", self.path("a.asc")))):
            outcome = self.import_map(*arguments, name=name, folder=folder)
            self.assertEqual(outcome.code, 0, outcome.err)
            self.assertIn("1 building with a name", outcome.out, folder)
            self.assertIn("1 visit, played", outcome.out, folder)
        self.assertEqual(self.read("xml/campus.glb"), self.read("pbf/campus.glb"))
        self.assertEqual(self.read("xml/campus.glb"), self.read("box/campus.glb"))

    def test_lays_the_ground_on_heights(self):
        self.write("a.osm", map_xml())
        rows = "\n".join(" ".join("%.2f" % (0.5 * x) for x in range(41)) for _ in range(41))
        self.write("a.asc", "ncols 41\nnrows 41\nxllcenter -0.004\nyllcenter -0.004\ncellsize 0.0002\n" + rows)
        outcome = self.import_map("--heights", self.path("a.asc"))
        self.assertEqual(outcome.code, 0, outcome.err)
        ground = walked_ways.Ground(self.path("out/campus.glb"))
        slope = 0.5 / (0.0002 * 111319.49)
        for x in (-60.0, -10.0, 35.5, 60.0):
            self.assertAlmostEqual(ground.height((x, -30.0)), slope * x, delta=0.02)
        self.write("b.asc", "ncols 41\nnrows 41\nxllcenter 10\nyllcenter 10\ncellsize 0.0002\n" + rows)
        self.write("c.asc", "ncols 41\nnrows 41\nxllcenter -0.004\nyllcenter -0.004\ncellsize 0.0002\n1 2 x")
        self.write("d.hgt", "short")
        for name in ("b.asc", "c.asc", "d.hgt", "gone.asc"):
            self.assertEqual(self.import_map("--heights", self.path(name), folder="none").code, 2, name)

    def test_people_walk_over_a_bridge_below_it_and_down_its_stairs(self):
        nodes = {1: (-80, 0), 2: (80, 0), 3: (0, -75), 4: (0, -25), 5: (0, 25), 6: (0, 75), 7: (40, 12), 8: (40, -12),
                 9: (50, 12), 10: (50, -12)}
        ways = {20: ((1, 2), {"highway": "residential"}), 21: ((3, 4), {"highway": "footway"}),
                22: ((4, 5), {"highway": "footway", "bridge": "yes", "layer": "1"}), 23: ((5, 6), {"highway": "footway"}),
                24: ((7, 8), {"highway": "footway", "bridge": "yes", "layer": "1"}), 25: ((9, 7), {"highway": "steps"}),
                26: ((10, 8), {"highway": "steps"})}
        self.write("a.osm", map_xml(nodes=nodes, ways=ways))
        outcome = self.import_map()
        self.assertEqual(outcome.code, 0, outcome.err)
        deck = 4.5 + 0.4 + 0.02
        legs = (("[0, 0, 70]", ((0, 0, deck), (0, -70, 0.0))), ("[-70, -0.12, 0]", ((0, 0, -0.12), (70, 0, -0.12))),
                ("[52, 0, -12]", ((40, -12, deck), (40, 0, deck), (40, 12, deck), (52, 12, 0.0))))
        steps = ""
        for start, goals in legs:
            steps += "  - %s: {at: %s}\n" % ("teleport" if steps else "spawn", start)
            steps += "".join("  - walk_to: [%g, %g]\n" % (x, z) for x, z, _ in goals)
        self.write("out/over.walk.yaml", "campus: a.campus.yaml\navatar: adult\nsteps:\n" + steps)
        outcome = self.run_program("run", self.path("out/over.walk.yaml"))
        self.assertEqual(outcome.code, 0, outcome.out + outcome.err)
        heights = [float(at) for at in re.findall(r"avatar.arrive .*pos=[^,]*,([^,]*),", outcome.out)]
        self.assertEqual(len(heights), sum(len(goals) for _, goals in legs))
        for found, (x, z, height) in zip(heights, [goal for _, goals in legs for goal in goals]):
            self.assertAlmostEqual(found, height, delta=0.03, msg="%g, %g" % (x, z))

    def test_a_robot_crosses_only_where_the_kerb_is_lowered(self):
        for kerb, crosses in (("raised", False), ("lowered", True), ("flush", True)):
            nodes = {1: (-80, 0), 2: (0, 0), 3: (80, 0), 4: (0, -40), 5: (0, -3), 6: (0, 3), 7: (0, 40)}
            ways = {20: ((1, 2, 3), {"highway": "residential"}), 21: ((4, 5, 2, 6, 7), {"highway": "footway"})}
            self.write("a.osm", map_xml(nodes=nodes, ways=ways, node_tags={5: {"kerb": kerb}, 6: {"kerb": kerb}}))
            outcome = self.import_map("--overwrite")
            self.assertEqual(outcome.code, 0, outcome.err)
            self.write("out/cross.walk.yaml", "campus: a.campus.yaml\navatar: delivery-robot\nsteps:\n"
                       "  - spawn: {at: [0, 0, 20]}\n  - walk_to: [0, -20]\n")
            self.assertEqual(self.run_program("run", self.path("out/cross.walk.yaml")).code, 0 if crosses else 1, kerb)

    def test_changes_nothing_if_it_fails_and_takes_any_file_name(self):
        self.write("a.osm", map_xml())
        self.assertEqual(self.import_map().code, 0)
        before = self.contents()
        self.write("a.osm", "no map")
        self.assertEqual(self.import_map("--overwrite").code, 2)
        self.write("a.osm", map_xml())
        self.assertEqual(self.contents(), before)
        for name, folder in (("map (1).osm", "other"), (os.fsdecode(b"map\xff\xc3 1.osm"), "latin")):
            self.write(name, map_xml())
            outcome = self.import_map(name=name, folder=folder)
            self.assertEqual(outcome.code, 0, outcome.err)
            self.assertIn("map-1.walk.yaml", os.listdir(self.path(folder)))
        for name in ("../x", b"\xff", ""):
            self.assertEqual(self.import_map("--name", name, folder="third").code, 2)
        self.assertFalse(os.path.exists(self.path("third")))

    def test_says_when_its_walk_visits_nothing(self):
        self.write("a.osm", map_xml(ways={12: WAYS[12]}))
        outcome = self.import_map()
        self.assertEqual(outcome.code, 0, outcome.err)
        self.assertIn("warning no-visits", outcome.err)

    def test_says_what_is_in_the_way(self):
        nodes = {**NODES, 20: (-5, -5), 21: (25, -5), 22: (25, 15), 23: (-5, 15), 24: (0, -1), 25: (20, -1)}
        wall = {13: ((20, 21, 22, 23, 20), {"barrier": "wall"})}
        self.write("a.osm", map_xml(nodes=nodes, ways={10: WAYS[10], 12: WAYS[12], **wall}))
        outcome = self.import_map()
        self.assertEqual(outcome.code, 0, outcome.err)
        self.assertRegex(outcome.err, "(?m)warning no-visits: no door near the start can be reached; .*: .*wall-way-13 stands in the way at [-0-9., ]*$")
        hedge = {14: ((24, 25), {"barrier": "hedge"})}
        self.write("a.osm", map_xml(nodes=nodes, ways={10: WAYS[10], 12: WAYS[12], **hedge}))
        outcome = self.import_map("--overwrite")
        self.assertEqual(outcome.code, 0, outcome.err)
        self.assertIn("warning blocked-door: node 5 is an entrance of way-10", outcome.err)

    def test_takes_the_format_from_the_name_of_a_link(self):
        self.write("store/1a2b", map_xml())
        os.symlink("store/1a2b", self.path("linked.osm"))
        outcome = self.import_map(name="linked.osm")
        self.assertEqual(outcome.code, 0, outcome.err)
        self.assertIn("linked.osm", self.text("out/linked.campus.yaml"))
        self.assertNotIn("1a2b", self.text("out/linked.campus.yaml"))

    def test_the_model_is_a_sound_glb(self):
        """By a reader of the test's own: what the format's specification demands, and what the program printed."""
        self.write("a.osm", map_xml())
        outcome = self.import_map()
        self.assertEqual(outcome.code, 0, outcome.err)
        data = self.read("out/campus.glb")
        magic, version, length, json_length, json_kind = struct.unpack_from("<4sIII4s", data)
        self.assertEqual((magic, version, length, json_kind), (b"glTF", 2, len(data), b"JSON"))
        self.assertEqual(json_length % 4, 0)
        model = json.loads(data[20:20 + json_length])
        binary_length, binary_kind = struct.unpack_from("<I4s", data, 20 + json_length)
        self.assertEqual((binary_kind, 28 + json_length + binary_length), (b"BIN\0", len(data)))
        binary = data[28 + json_length:]
        self.assertLessEqual(model["buffers"][0]["byteLength"], binary_length)
        def values(index):
            accessor = model["accessors"][index]
            view = model["bufferViews"][accessor["bufferView"]]
            width = {"SCALAR": 1, "VEC3": 3}[accessor["type"]]
            form, size = {5123: ("H", 2), 5125: ("I", 4), 5126: ("f", 4)}[accessor["componentType"]]
            offset = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
            self.assertEqual(offset % size, 0)
            self.assertLessEqual(accessor.get("byteOffset", 0) + accessor["count"] * width * size, view["byteLength"])
            numbers = struct.unpack_from("<%d%s" % (accessor["count"] * width, form), binary, offset)
            return accessor, [numbers[i:i + width] for i in range(0, len(numbers), width)]
        names, triangles = [node["name"] for node in model["nodes"]], 0
        self.assertEqual(len(names), len(set(names)))
        self.assertEqual(sorted(model["scenes"][0]["nodes"]), list(range(len(names))))
        self.assertLessEqual({"ground", "building/way-10", "footway/way-12", "door/node-5"}, set(names))
        for mesh in model["meshes"]:
            for part in mesh["primitives"]:
                accessor, positions = values(part["attributes"]["POSITION"])
                for axis in range(3):
                    self.assertEqual(accessor["min"][axis], min(p[axis] for p in positions), mesh["name"])
                    self.assertEqual(accessor["max"][axis], max(p[axis] for p in positions), mesh["name"])
                _, normals = values(part["attributes"]["NORMAL"])
                self.assertEqual(len(normals), len(positions))
                self.assertTrue(all(abs(sum(x * x for x in n) - 1) < 1e-5 for n in normals), mesh["name"])
                _, indices = values(part["indices"])
                self.assertLess(max(i for (i,) in indices), len(positions))
                self.assertEqual(len(indices) % 3, 0)
                triangles += len(indices) // 3
                self.assertLess(part["material"], len(model["materials"]))
        self.assertIn(": %d triangles" % triangles, outcome.out)
        looks = [material["name"] for material in model["materials"]]
        self.assertEqual(len(looks), len(set(looks)))

    def test_refuses_what_is_no_map(self):
        good = map_xml()
        bad = {"empty.osm": "", "text.osm": "hello", "cut.osm": good[:len(good) // 2], "a.pbf": "no protobuf",
               "bomb.osm": '<!DOCTYPE a [<!ENTITY a "a"><!ENTITY b "&a;&a;">]><osm version="0.6"><node id="1" lat="&b;"/></osm>',
               "far.osm": good.replace('<bounds minlat="-0.0008" minlon="-0.0008" maxlat="0.0008" maxlon="0.0008"/>',
                                       '<node id="99" lat="80" lon="120"/>')}
        for name, text in bad.items():
            self.write(name, text)
            outcome = self.import_map(name=name, folder="none")
            self.assertEqual(outcome.code, 2, name)
            self.assertIn("error bad-", outcome.err, name)
            self.assertFalse(os.path.exists(self.path("none/campus.glb")), name)
        self.assertEqual(self.import_map(name="gone.osm", folder="none").code, 2)

    def test_words_of_a_map_stay_words(self):
        name = "x\"}\n- {id: evil}: &a *b {title} </script>\u202e\x07".replace("\n", " ").replace("\x07", "")
        ways = {10: (WAYS[10][0], {"building": "yes", "name": name.replace('"', "&quot;")}), 11: WAYS[11], 12: WAYS[12]}
        self.write("a.osm", map_xml(ways=ways).replace("&amp;quot;", "&quot;"))
        self.assertEqual(self.import_map().code, 0)
        self.assertEqual(self.run_program("validate", self.path("out/a.campus.yaml")).code, 0)
        self.assertNotIn("\u202e", self.text("out/a.campus.yaml"))

    def test_people_walk_where_the_map_says_so(self):
        data = os.path.join(os.path.dirname(__file__), "..", "..", "..", "shared", "data", "osm")
        if not os.path.isdir(data):
            self.skipTest("the maps aren't there")
        for name, least in MAPS.items():
            file = os.path.join(data, name + ".osm")
            outcome = self.run_program("import", "osm", file, "-o", self.path(name))
            self.assertEqual(outcome.code, 0, outcome.err)
            walked = walked_ways.walk_all(self.program, walked_ways.Map(file), self.path(name))
            good, total = walked_ways.share_of(walked)
            self.assertGreater(total, 2000.0)
            self.assertGreaterEqual(100.0 * good / total, least, name)


if __name__ == "__main__":
    main()
