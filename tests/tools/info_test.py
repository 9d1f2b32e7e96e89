#!/usr/bin/env python3
"""`campuswalk info`: its JSON conforms to the schema, and its texts and images agree with it."""

import copy
import glob
import json
import os
import re
import struct
import unittest

import jsonschema

from program import ProgramCase, main

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
SHARED = os.path.join(ROOT, "..", "shared", "data")
ENDINGS = (".glb", ".gltf", ".obj", ".dae", ".stl", ".ply", ".off")

with open(os.path.join(ROOT, "config", "schema", "info.schema.json"), encoding="utf-8") as schema_file:
    SCHEMA = json.load(schema_file)
VALIDATOR = jsonschema.Draft7Validator(SCHEMA)


def box(name, first, x0, y0, z0, x1, y1, z1):
    """OBJ text of a box; `first` is the number of its first vertex."""
    vertices = ["v %g %g %g" % (x, y, z) for z in (z0, z1) for y in (y0, y1) for x in (x0, x1)]
    faces = [(1, 3, 4, 2), (5, 6, 8, 7), (1, 2, 6, 5), (3, 7, 8, 4), (1, 5, 7, 3), (2, 4, 8, 6)]
    return "\n".join(["o " + name] + vertices + ["f %d %d %d %d" % tuple(first + i - 1 for i in f) for f in faces]) + "\n"


# A floor, which is there twice, and a wall with a doorway that a door leaf closes.
HOUSE = (box("floor", 1, -5, -0.2, -5, 5, 0, 5) + box("wall_left", 9, -5, 0, -0.1, -0.5, 3, 0.1) +
         box("wall_right", 17, 0.5, 0, -0.1, 5, 3, 0.1) + box("lintel", 25, -0.5, 2.1, -0.1, 0.5, 3, 0.1) +
         box("Haustür", 33, -0.48, 0, -0.03, 0.48, 2.08, 0.03) + box("carpet", 41, -5, -0.2, -5, 5, 0, 5))


def third_party_models():
    """The models in ../shared/data, except for most of the corpus that corpus_test.py reads."""
    found = []
    for folder, _, names in os.walk(SHARED):
        for name in names:
            path = os.path.join(folder, name)
            corpus = "gltf_validator" in path and not re.search(r"valid|mesh", name)
            if name.lower().endswith(ENDINGS) and not corpus:
                found.append(path)
    return sorted(found)


class Info(ProgramCase):
    def info(self, model):
        return self.checked(self.passes("info", model, "--json").out)

    def checked(self, out):
        found = json.loads(out)
        self.assertEqual([error.message for error in VALIDATOR.iter_errors(found)], [])
        self.agrees_with_itself(found)
        return found

    def agrees_with_itself(self, found):
        nodes = found["nodes"]
        self.assertEqual(sum(node["triangles"] for node in nodes), found["triangles"])
        self.assertEqual(sum(material["triangles"] for material in found["materials"]), found["triangles"])
        for i, node in enumerate(nodes):
            if node["parent"] is None:
                self.assertEqual(node["depth"], 0)
                continue
            self.assertLess(node["parent"], i)
            parent = nodes[node["parent"]]
            self.assertEqual(node["depth"], parent["depth"] + 1)
            if node["bounds"]:
                for low, high, outer_low, outer_high in zip(node["bounds"]["min"], node["bounds"]["max"],
                                                            parent["bounds"]["min"], parent["bounds"]["max"]):
                    self.assertTrue(outer_low <= low <= high <= outer_high, node)

    def test_the_schema_accepts_nothing_else(self):
        jsonschema.Draft7Validator.check_schema(SCHEMA)
        self.write("house.obj", HOUSE)
        found = self.info("house.obj")
        for path in ((), ("nodes", 0), ("materials", 0), ("warnings", 0), ("doors", 0), ("bounds",), ("ground",), ("warnings", 0, "places", 0)):
            other = copy.deepcopy(found)
            part = other
            for key in path:
                part = part[key]
            part["unknown_key"] = 1
            self.assertFalse(VALIDATOR.is_valid(other), path)
            del part["unknown_key"]
            del part[next(iter(part))]
            self.assertFalse(VALIDATOR.is_valid(other), path)

    def test_maps_have_an_origin_and_a_geographic_place(self):
        self.write("map.obj", box("floor", 1, 84100, 447100, -0.2, 84300, 447300, 0))
        found = self.checked(self.passes("info", "map.obj", "--up", "y", "--json").out)
        self.assertEqual((found["origin_near"], found["geographic"]), ([84000, 447000, 0], None))
        self.assertEqual(self.info("map.obj")["origin_near"], [84000, 0, -447000])  # +Z is up
        self.assertIn("origin     84000.000,0.000,-447000.000 m, with `origin: {at: near}`\n",
                      self.passes("info", "map.obj").out)
        self.write("near.obj", HOUSE)
        self.assertEqual(self.info("near.obj")["origin_near"], [0, 0, 0])
        self.assertNotIn("origin  ", self.passes("info", "near.obj").out)
        # The north pole, as CESIUM_RTC's axes have it: half the Earth's axis along the third.
        positions = struct.pack("<9f", 0, 0, 0, 0, 1, 0, 1, 0, 0)
        with open(self.path("pole.bin"), "wb") as file:
            file.write(positions)
        self.write("pole.gltf", json.dumps({
            "asset": {"version": "2.0"}, "extensionsUsed": ["CESIUM_RTC"], "extensionsRequired": ["CESIUM_RTC"],
            "extensions": {"CESIUM_RTC": {"center": [0, 0, 6356752.314245 + 25]}},
            "buffers": [{"uri": "pole.bin", "byteLength": 36}], "bufferViews": [{"buffer": 0, "byteLength": 36}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                           "min": [0, 0, 0], "max": [1, 1, 0]}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}], "nodes": [{"mesh": 0, "name": "mark"}],
            "scenes": [{"nodes": [0]}], "scene": 0}))
        place = self.info("pole.gltf")["geographic"]
        self.assertEqual((place["latitude_deg"], place["at"]), (90, [0, 0, 0]))
        self.assertAlmostEqual(place["height"], 25, 5)
        self.assertIn("on Earth   latitude 90.00000000, longitude 0.00000000, height 25.000 m, at 0.000,0.000,0.000\n",
                      self.passes("info", "pole.gltf").out)

    def test_model_lints_have_places(self):
        self.write("house.obj", HOUSE)
        found = {warning["code"]: warning for warning in self.info("house.obj")["warnings"]}
        self.assertEqual(set(found), {"duplicate-faces", "solid-door"})
        self.assertEqual(found["solid-door"]["places"], [{"node": "Haustür", "at": [0, 0, 0]}])
        self.assertEqual(found["duplicate-faces"]["places"][0]["node"], "carpet")
        self.assertIn("12 triangles", found["duplicate-faces"]["message"])
        text = self.passes("info", "house.obj").out
        for warning in found.values():
            self.assertIn("  %s: %s\n" % (warning["code"], warning["message"]), text)
        self.assertIn("    'Haustür' at 0.000,0.000,0.000\n", text)

    def test_tells_how_much_ground_there_is(self):
        self.write("floor.obj", box("floor", 1, 0, -0.2, 0, 8, 0, 6) + box("table", 9, 3, 0, 2, 4, 0.7, 4))
        found = self.info("floor.obj")
        self.assertAlmostEqual(0, found["ground"]["height"], delta=0.001)
        self.assertEqual([], found["warnings"])
        self.assertIn("ground     %s%.1f m² at 0.00 m\n" % ("about " * (not found["ground"]["complete"]), found["ground"]["seen"]),
                      self.passes("info", "floor.obj").out)
        self.write("field.obj", box("field", 1, 0, -0.2, 0, 300, 0, 200))
        self.assertIn("ground     about 6.0 ha at 0.00 m\n", self.passes("info", "field.obj").out)
        self.write("tower.obj", box("tower", 1, 0, 0, 0, 6, 20, 6))
        warning, = self.info("tower.obj")["warnings"]
        self.assertEqual("no-ground", warning["code"])
        self.assertIn("a roof, ", warning["message"])
        self.write("chair.obj", box("chair", 1, 0, 0, 0, 1, 1, 1))
        self.assertIsNone(self.info("chair.obj")["ground"])

    def test_which_third_party_models_lack_ground(self):
        if not os.path.isdir(SHARED):
            raise unittest.SkipTest("no " + SHARED)
        for model, lacks in (("recast/dungeon.obj", False), ("recast/undulating.obj", False),
                             ("gazebo/parking_garage/meshes/parking_garage.dae", False),
                             ("gazebo/willowgarage/meshes/willowgarage_visual.dae", False),
                             ("gazebo/willowgarage/meshes/willowgarage_collision.dae", True),  # walls only
                             ("small_house/small_house_collision.glb", False), ("delft_3dfier/testarea.obj", False),
                             ("ufaz/after153/outdoor_campus.obj", False)):
            with self.subTest(model=model):
                arguments = ("--up", "z") if "delft" in model else ()
                found = self.checked(self.passes("info", os.path.join(SHARED, model), "--json", *arguments).out)
                self.assertEqual(lacks, "no-ground" in [warning["code"] for warning in found["warnings"]])

    def test_long_lists_of_places_are_cut_in_the_text(self):
        self.write("doors.obj", "".join(box("door_%d" % i, 1 + 8 * i, i, 0, 0, i + 0.9, 0.05, 0.05) for i in range(8)))
        found = {warning["code"]: warning for warning in self.info("doors.obj")["warnings"]}
        self.assertEqual(len(found["door-size"]["places"]), 8)
        self.assertIn("'door_0' of 0.05 m", found["door-size"]["message"])
        text = self.passes("info", "doors.obj").out
        self.assertEqual(text.count("    'door_"), 5)
        self.assertIn("    and 3 more: see --json\n", text)

    def test_long_lists_of_nodes_are_cut_in_the_text(self):
        def word(i):
            return "house-" + "".join(chr(ord("a") + i // 26 ** k % 26) for k in range(3))

        def house(i):  # the later, the larger
            return box(word(i), 1 + 8 * i, 9 * i, 0, 0, 9 * i + 5, 4 + i / 100, 5)
        self.write("town.obj", "".join(house(i) for i in range(250)))
        self.assertEqual(len(self.info("town.obj")["nodes"]), 251)  # with the root
        text = self.passes("info", "town.obj").out
        nodes = text[text.index("\nnodes      251\n"):]
        self.assertEqual(nodes.count("    house-"), 199)
        self.assertIn("    %s  5.0 x 6.5 x 5.0 m  12 triangles  " % word(249), nodes)
        self.assertNotIn(word(0), nodes)
        self.assertIn("\n  and 51 more: see --json\nwarnings ", text)

    def test_numbered_siblings_are_one_line(self):
        trees = "".join(box("tree_%03d" % i, 1 + 8 * i, 9 * i, 0, 0, 9 * i + 1, 4 + i % 3, 1) for i in range(250))
        self.write("wood.obj", trees + box("hut", 2001, 0, 0, 9, 3, 3, 12))
        text = self.passes("info", "wood.obj").out
        nodes = text[text.index("\nnodes      252\n"):text.index("\nwarnings ")]
        self.assertEqual(len(nodes.splitlines()), 5)
        self.assertRegex(nodes, r"    tree_\* \(250 nodes\)  1\.0 x 6\.0 x 1\.0 m  3000 triangles  ")
        self.assertRegex(nodes, r"    hut  3\.0 x 3\.0 x 3\.0 m  12 triangles  ")

    def test_buildings_doors_and_stairs_come_first(self):
        steps = "".join(box("step_%d" % i, 49 + 8 * i, 6, 0, 0.3 * i, 7.2, 0.17 * (i + 1), 0.3 * (i + 1)) for i in range(6))
        self.write("house.obj", HOUSE + steps + box("Bibliothek", 97, 20, 0, 0, 30, 8, 12) + box("lawn", 105, -20, -0.3, -20, 40, -0.01, 20))
        found = self.info("house.obj")
        library, = [building for building in found["buildings"] if building["title"] == "Bibliothek"]
        self.assertEqual((library["size"], library["center"]), ([10, 8, 12], [25, 4, 6]))
        door, = found["doors"]
        self.assertEqual((found["nodes"][door["node"]]["name"], door["closed"]), ("Haustür", True))
        self.assertAlmostEqual(door["width"], 0.96, 6)
        flight, = found["flights"]
        self.assertEqual(len(flight["risers"]), 6)
        for first, riser in enumerate(flight["risers"]):
            self.assertAlmostEqual(riser, 0.17 if first else 0.18, 6)  # from the lawn
        text = self.passes("info", "house.obj").out
        self.assertRegex(text, r"\n  Bibliothek +10\.0 x 12\.0 m, 8\.0 m high, at 25\.000,0\.000,6\.000\n")
        self.assertRegex(text, r"\ndoors      1, 1 closed\n  Haustür +0\.96 m wide, 2\.08 m high, closed, at 0\.000,0\.000,0\.000\n")
        self.assertRegex(text, r"\nstairs     1\n  step_0 +6 risers of 0\.170 m, treads of 0\.30 m, 1\.20 m wide, from 6\.600,0\.170,0\.150\n")
        order = [text.index("\n" + word + " ") for word in ("size", "ground", "buildings", "doors", "stairs", "meshes", "materials", "nodes", "warnings")]
        self.assertEqual(order, sorted(order))

    def test_the_map_of_a_model_on_its_side_is_drawn_upright(self):
        self.write("town.obj", box("town", 1, 0, 0, 0, 80, 60, 4))
        turned = self.run_program("info", "town.obj", "--map", "turned.png")
        if turned.code == 3 or "no OpenGL" in turned.err:
            self.skipTest("no pictures here")
        self.assertEqual(turned.code, 0, turned.err)
        self.assertRegex(turned.out, r"\nframe      \+Z is up, so it is read with `up: z`: 90 % of its faces, by area, face Z")
        upright = self.passes("info", "town.obj", "--up", "z", "--map", "upright.png")
        self.assertEqual(upright.err, "")
        self.assertEqual(self.read("turned.png"), self.read("upright.png"))

    def test_obj_files_have_the_expected_triangles_and_bounds(self):
        self.write("house.obj", HOUSE)
        self.assertEqual(self.info("house.obj")["triangles"], 6 * 12)
        bottom = struct.unpack("f", struct.pack("f", -0.2))[0]  # in float32
        self.assertEqual(self.info("house.obj")["bounds"], {"min": [-5, bottom, -5], "max": [5, 3, 5]})

    def test_the_demo_campus_conforms(self):
        for model in sorted(glob.glob(os.path.join(ROOT, "campus_assets", "demo", "*.glb"))):
            with self.subTest(model=os.path.basename(model)):
                self.assertGreater(self.info(model)["triangles"], 0)

    def test_third_party_models_conform(self):
        if not os.path.isdir(SHARED):
            raise unittest.SkipTest("no " + SHARED)
        loaded = 0
        for model in third_party_models():
            with self.subTest(model=os.path.relpath(model, SHARED)):
                outcome = self.run_program("info", model, "--json")
                self.assertIn(outcome.code, (0, 2), outcome.err)
                if outcome.code == 0:
                    self.checked(outcome.out)
                    loaded += 1
        self.assertGreater(loaded, 150)


if __name__ == "__main__":
    main()
