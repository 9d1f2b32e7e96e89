#!/usr/bin/env python3
"""`campuswalk explore`: which doors one gets to, and which one walks through."""

import json
import os

import jsonschema

from program import ProgramCase, main

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
with open(os.path.join(ROOT, "config", "schema", "explore.schema.json"), encoding="utf-8") as schema_file:
    SCHEMA = json.load(schema_file)


class Obj:
    """Boxes as objects of an OBJ file."""

    def __init__(self):
        self.text = ""
        self.vertices = 0

    def box(self, name, low, high):
        """Without a name it is part of the last object."""
        self.text += "o %s\n" % name if name else ""
        for corner in range(8):
            self.text += "v %g %g %g\n" % tuple((high if corner >> axis & 1 else low)[axis] for axis in range(3))
        for face in ("1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"):
            self.text += "f %s\n" % " ".join(str(self.vertices + int(i)) for i in face.split())
        self.vertices += 8


class ExploredDoors(ProgramCase):
    def setUp(self):
        """A yard in front of a wall with two doorways, and an entrance whose stairs are missing; a terrace that is too high."""
        super().setUp()
        model = Obj()
        model.box("ground", (-10, -1, -10), (10, 0, 10))
        for name, left, right in (("west", -10, -6), ("middle", -5, 5), ("east", 6, 10)):
            model.box("wall_" + name, (left, 0, -0.1), (right, 3, 0.1))
        model.box("front_door", (-6, 0, -0.03), (-5, 2.1, 0.03))
        model.box("back_door", (5, 0, -0.03), (6, 2.1, 0.03))
        model.box("terrace", (-4, 0, 6), (4, 1.2, 10))
        model.box("terrace_door", (0, 1.2, 9), (1, 3.2, 9.06))
        model.box("entrance_door", (8, 1.2, 0.1), (9, 3.2, 0.16))
        model.box("attic_door", (0, 8, -0.03), (1, 10, 0.03))
        self.write("school.obj", model.text)

    def doors(self, left_out, *arguments):
        self.write("school.campus.yaml",
                   "scenes: [{file: school.obj}]\n"
                   "colliders: [{id: school, nodes: '*', except: [%s], shape: mesh, mode: solid}]\n"
                   "spawns: {start: {at: [0, 0, 3]}}\n" % left_out)
        self.text = self.passes("explore", "school.campus.yaml", "--json", "report.json", *arguments).out
        with open(self.path("report.json"), encoding="utf-8") as file:
            self.json = json.load(file)
        jsonschema.validate(self.json, SCHEMA)
        return {door["name"]: door for door in self.json["subjects"] if door["kind"] == "door"}

    def test_open_closed_and_out_of_reach(self):
        doors = self.doors("front_door", "--require", "all")
        self.assertEqual({"front_door": True, "back_door": True, "terrace_door": False,
                          "entrance_door": False, "attic_door": False},
                         {name: door["reached"] for name, door in doors.items()})
        self.assertEqual(["front_door"], [name for name, door in doors.items() if door["walked_through"]])
        self.assertEqual("terrace_door", next(name for name, door in doors.items() if "island" in door))
        island = self.json["islands"][doors["terrace_door"]["island"]]
        self.assertAlmostEqual(1.2, island["barrier"]["measured"], delta=0.01)
        self.assertEqual("nothing that is reached lies near it", doors["attic_door"]["reason"])
        self.assertIn("doors      2 of 5 that somebody gets to, 1 walked through\n"
                      "  nobody gets to terrace_door, entrance_door, attic_door\n", self.text)

    def test_bodies_of_any_width_walk_through_open_doors(self):
        for radius in (0.12, 0.15, 0.18, 0.3, 0.45):
            body = "{profile: adult, radius: %g, step_height: %g}" % (radius, min(radius, 0.3))
            doors = self.doors("front_door, back_door", "--avatar", body)
            self.assertTrue(doors["front_door"]["walked_through"] and doors["back_door"]["walked_through"], radius)
            self.assertFalse(self.doors("front_door", "--avatar", body)["back_door"]["walked_through"], radius)

    def test_who_stands_on_the_sill_of_a_closed_door_is_not_through(self):
        """Its middle plane, by its bounds, lies in front of the leaf."""
        for sill in (0.4, 0.6, 0.8):
            model = Obj()
            model.box("ground", (-10, -1, -10), (10, 0, 10))
            model.box("wall_west", (-10, 0, -0.1), (5, 3, 0.1))
            model.box("wall_east", (6, 0, -0.1), (10, 3, 0.1))
            model.box("back_door", (5, 0, -0.03), (6, 2.1, 0.03))
            model.box("", (5, 0, -0.03), (6, 0.02, sill))
            self.write("school.obj", model.text)
            door = self.doors("")["back_door"]
            self.assertTrue(door["reached"])
            self.assertFalse(door["walked_through"], sill)
            self.assertTrue(self.doors("back_door")["back_door"]["walked_through"], sill)

    def test_a_wall_across_a_corridor_is_named(self):
        """However wide it is; what can't be walked through is one node of many in a mesh."""
        for half in (1, 2, 4, 6):
            model = Obj()
            model.box("ground", (-half, -1, -10), (half, 0, 10))
            model.box("west", (-half - 0.2, 0, -10), (-half, 3, 10))
            model.box("east", (half, 0, -10), (half + 0.2, 3, 10))
            model.box("barrier", (-half, 0, -0.1), (half, 3, 0.1))
            self.write("school.obj", model.text)
            self.doors("")
            island, = [island for island in self.json["islands"] if not island["top"]]
            self.assertEqual(("object", "barrier"), (island["barrier"]["kind"], island["barrier"]["node"]), half)

    def test_a_gate_keeps_visitors_in_a_pit(self):
        """From a deck one falls into it. What one stands on outside is no gate, however small it is."""
        for gate, out in ((((-1.6, 0, 8.5), (-1.4, 2, 9.5)), ("object", "pit_gate")),
                          (((-2, -0.1, 8.5), (-1, 1.5, 9.5)), ("ledge", "deck_north"))):
            model = Obj()
            model.box("ground", (-10, -1, -10), (10, 0, 14))
            for i in range(1, 6):
                model.box("tread_%d" % i, (-2, -0.1, 7 - 0.5 * i), (2, 1.5 - 0.25 * i, 7.5 - 0.5 * i))
            for name, low, high in (("south", (-2, 7), (2, 8)), ("south_west", (-2, 8), (-1, 8.5)),
                                    ("north_west", (-2, 9.5), (-1, 11)), ("east", (1, 8), (2, 11)), ("north", (-1, 10.5), (1, 11))):
                model.box("deck_" + name, (low[0], -0.1, low[1]), (high[0], 1.5, high[1]))
            model.box("mast", (8, 0, 0), (8.2, 4, 0.2))  # higher than all that one stands on, in the same mesh
            model.box("pit_gate", *gate)
            self.write("school.obj", model.text)
            self.doors("")
            trap, = self.json["traps"]
            self.assertEqual(out, (trap["out"]["kind"], trap["out"].get("node")))

    def test_a_closed_door_parts_the_yard(self):
        doors = self.doors("")
        self.assertEqual([], [name for name, door in doors.items() if door["walked_through"]])
        self.assertTrue(doors["back_door"]["reached"])
        self.assertAlmostEqual(5.5, doors["back_door"]["at"][0], delta=0.01)
        self.assertLess(5.0, doors["back_door"]["distance"])

    def test_a_campus_without_doors_says_nothing_of_them(self):
        self.write("school.obj", "o ground\nv -5 0 -5\nv -5 0 5\nv 5 0 5\nv 5 0 -5\nf 1 2 3 4\n")
        self.assertEqual({}, self.doors(""))
        self.assertNotIn("doors", self.text)


if __name__ == "__main__":
    main()
