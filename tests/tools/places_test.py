#!/usr/bin/env python3
"""Places from GeoJSON files: walks go to them, `explore` lists them, what it writes is read again, and they count as inputs."""

import json
import math
import os
import re

from program import ROOM, CheckoutCase, ProgramCase, main

# A house of two floors (0 and 3 m) on a meadow, with a ramp to the upper one.
HOUSE = """scenes: [{file: room.obj}]
%scolliders:
  - {id: meadow, shape: box, center: [0, -0.5, 0], size: [60, 1, 60], mode: solid}
  - {id: upper, shape: box, center: [0, 2.9, -10], size: [8, 0.2, 8], mode: solid}
  - {id: roof, shape: box, center: [0, 6, -10], size: [8, 0.2, 8], mode: solid}
  - {id: hedge, shape: box, center: [20, 1, 0], size: [0.5, 2, 8], mode: solid}
%sspawns: {start: {at: [0, 0, 10]}}
places:
  desk: [3, 0, 3]
  from: %s
"""
STEPS = "".join("  - {id: step-%d, shape: box, center: [%g, %g, -10], size: [0.5, %g, 2], mode: solid}\n"
                % (i, -4 - 0.5 * (12 - i), 0.125 * i, 0.25 * i) for i in range(1, 13))
ORIGIN = "origin: {latitude_deg: 48.15, longitude_deg: 11.57}\n"


def feature(name, *at, **properties):
    return {"type": "Feature", "properties": {"name": name, **properties}, "geometry": {"type": "Point", "coordinates": at}}


def collection(*features, **members):
    return json.dumps({"type": "FeatureCollection", **members, "features": features}, ensure_ascii=False)


METRES = {"coordinates": "metres: x, -z, height"}


def on_earth(x, z):
    """Longitude and latitude by the radii of curvature at the origin: good for millimetres at 20 m."""
    latitude = math.radians(48.15)
    e2 = 0.00669437999014
    w = math.sqrt(1 - e2 * math.sin(latitude) ** 2)
    return (11.57 + math.degrees(x / (6378137.0 / w * math.cos(latitude))),
            48.15 + math.degrees(-z / (6378137.0 * (1 - e2) / w ** 3)))


class Places(ProgramCase):
    def setUp(self):
        super().setUp()
        self.write("room.obj", ROOM)

    def campus(self, places="p.geojson", origin=""):
        self.write("a.campus.yaml", HOUSE % (origin, STEPS, places))

    def walk(self, *steps, expect=""):
        self.write("a.walk.yaml", "campus: a.campus.yaml\navatar: adult\nsteps:\n  - spawn: start\n" +
                   "".join("  - %s\n" % step for step in steps) + (expect or "expect: [{never: avatar.fell}]\n"))
        return self.run_program("run", "a.walk.yaml", "--rendering-backend", "none")

    def arrival(self, outcome):
        line = [line for line in outcome.out.splitlines() if "avatar.arrive" in line][-1]
        return [float(number) for number in line.split("pos=")[1].split()[0].split(",")]

    def test_walks_go_to_points_of_the_earth(self):
        self.campus(origin=ORIGIN)
        self.write("p.geojson", collection(feature("Bench", *on_earth(5, 2)), feature("图文信息中心", *on_earth(-12, -20), 0.0)))
        for name, x, z in (("bench", 5, 2), ("图文信息中心", -12, -20), ("desk", 3, 3)):
            outcome = self.walk("go_to: " + ("Bench" if name == "bench" else name))
            self.assertEqual(outcome.code, 0, outcome.out + outcome.err)
            at = self.arrival(outcome)
            self.assertLess(math.hypot(at[0] - x, at[2] - z), 0.06, name)

    def test_a_height_says_which_storey(self):
        self.campus()
        self.write("p.geojson", collection(feature("upstairs", 0, 10, 3.0), feature("somewhere", 0, 10), **METRES))
        outcome = self.walk("go_to: upstairs")
        self.assertEqual(outcome.code, 0, outcome.out + outcome.err)
        self.assertAlmostEqual(self.arrival(outcome)[1], 3.0, delta=0.05)
        outcome = self.walk("go_to: somewhere")
        self.assertEqual(outcome.code, 0, outcome.out + outcome.err)
        self.assertAlmostEqual(self.arrival(outcome)[1], 0.0, delta=0.05)
        self.campus("{file: p.geojson, height: 3}")
        self.assertAlmostEqual(self.arrival(self.walk("go_to: somewhere"))[1], 3.0, delta=0.05)

    def test_a_place_behind_a_hedge_turns_the_walk_red(self):
        self.campus()
        self.write("p.geojson", collection(feature("inside", 20, 0), **METRES))
        outcome = self.walk("go_to: inside")
        self.assertEqual(outcome.code, 1, outcome.out + outcome.err)
        self.assertIn("unreachable", outcome.out)
        self.assertIn("hedge", outcome.out)

    def test_explore_lists_them_and_its_map_is_read_again(self):
        for origin in ("", ORIGIN):
            self.campus(origin=origin)
            points = [feature("Café Ä", *(on_earth(5, 2) if origin else (5, -2))), feature("door", *(on_earth(-3, 1) if origin else (-3, -1))),
                      feature("door", *(on_earth(-4, 1) if origin else (-4, -1))), feature("in-the-hedge", *(on_earth(20, 0) if origin else (20, 0)))]
            self.write("p.geojson", collection(*points, **({} if origin else METRES)))
            self.passes("explore", "a.campus.yaml", "--json", "first.json", "--geojson", "map.geojson")
            first = {s["name"]: s for s in json.loads(self.read("first.json"))["subjects"] if s["kind"] == "place"}
            self.assertEqual({name: s["reached"] for name, s in first.items()},
                             {"desk": True, "café-ä": True, "door": True, "door-2": True, "in-the-hedge": False})
            self.assertAlmostEqual(first["door-2"]["at"][0], -4.0, delta=1e-3)
            self.assertAlmostEqual(first["door-2"]["at"][2], 1.0, delta=1e-3)
            self.write("b.campus.yaml", (HOUSE % (origin, STEPS, "{file: map.geojson, where: {kind: place}}")).replace("  desk: [3, 0, 3]\n", ""))
            self.passes("explore", "b.campus.yaml", "--json", "second.json")
            second = {s["name"]: s for s in json.loads(self.read("second.json"))["subjects"] if s["kind"] == "place"}
            self.assertEqual(list(first), list(second))
            for name, subject in first.items():
                self.assertEqual(subject["reached"], second[name]["reached"], name)
                for a, b in zip(subject["at"], second[name]["at"]):
                    self.assertAlmostEqual(a, b, delta=2e-4, msg=name)

    def test_they_are_counted_and_bad_ones_reported(self):
        self.campus()
        self.write("p.geojson", collection(feature("a", 1, 1), feature("b", 2, 2), **METRES))
        self.assertIn("3 places", self.passes("validate", "a.campus.yaml").out)
        self.write("p.geojson", collection(feature("a", 1, 1), feature("far", 500, 2), {"type": "Feature", "properties": {"name": "Hall"}, "geometry": {
            "type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 1], [0, 0]]]}}, **METRES))
        outcome = self.run_program("validate", "a.campus.yaml")
        self.assertEqual(outcome.code, 0, outcome.err)
        self.assertRegex(outcome.err, r"p\.geojson:1:\d+: warning not-a-point: the feature 'Hall' is left out")
        self.assertRegex(outcome.err, r"p\.geojson:1:\d+: warning no-ground-below: .*'far'")
        self.write("p.geojson", '{"type": "FeatureCollection",\n "features": [}')
        outcome = self.run_program("validate", "a.campus.yaml")
        self.assert_refused(outcome, "p.geojson:2:15: error json-syntax: ")
        self.write("p.geojson", collection(feature("a", 1, 1)))
        self.assert_refused(self.run_program("validate", "a.campus.yaml"), "a.campus.yaml:22:9: error no-origin: latitude_deg")

    def test_points_without_a_name_are_reported(self):
        nothing = {"type": "Feature", "properties": None, "geometry": {"type": "Point", "coordinates": [3, 3]}}
        unnamed = [feature(None, 2, 2, kind="room"), feature("", 4, 4, kind="tree"), nothing]
        self.write("p.geojson", collection(feature("a", 1, 1, kind="room"), *unnamed, **METRES))
        self.campus()
        outcome = self.passes("validate", "a.campus.yaml")
        self.assert_diagnostics(outcome.err_lines, "p.geojson:1:%d: warning unnamed-feature: 3 features are left out 'name'" % self.column(2))
        self.campus("{file: p.geojson, where: {kind: room}}")  # nobody wants the others
        outcome = self.passes("validate", "a.campus.yaml")
        self.assert_diagnostics(outcome.err_lines, "p.geojson:1:%d: warning unnamed-feature: 1 feature is left out 'name'" % self.column(2))
        self.campus("{file: p.geojson, name: kind}")
        outcome = self.passes("validate", "a.campus.yaml")
        self.assert_diagnostics(outcome.err_lines, "p.geojson:1:%d: warning unnamed-feature: 1 feature is left out 'kind'" % self.column(4))

    def column(self, number):
        """Where p.geojson's feature of that number begins."""
        text = self.read("p.geojson").decode()
        return [match.start() for match in re.finditer(r'\{"type": "Feature",', text)][number - 1] + 1

    def test_a_changed_file_changes_what_is_found(self):
        self.campus()
        self.write("p.geojson", collection(feature("a", 1, 1), **METRES))
        self.passes("explore", "a.campus.yaml", "--json", "first.json")
        self.write("p.geojson", collection(feature("a", 20, 0), **METRES))  # in the hedge
        self.passes("explore", "a.campus.yaml", "--json", "second.json")
        reached = [next(s["reached"] for s in json.loads(self.read(name))["subjects"] if s["name"] == "a")
                   for name in ("first.json", "second.json")]
        self.assertEqual(reached, [True, False])

    def test_no_report_replaces_them(self):
        self.campus()
        self.write("p.geojson", collection(feature("a", 1, 1), **METRES))
        self.write("a.walk.yaml", "campus: a.campus.yaml\nsteps: [{spawn: start}]\n")
        outcome = self.run_program("run", "a.walk.yaml", "--reporter", "json=p.geojson")
        self.assertEqual(outcome.code, 2, outcome.out + outcome.err)
        self.assertIn("report-unwritable", outcome.err)

    def test_suggested_walks_visit_them(self):
        self.write("p.geojson", collection(feature("Notice Board", 6, -6), feature("out there", 500, 0), **METRES))
        out = self.passes("info", "room.obj", "--suggest", "new.campus.yaml", "--places", "p.geojson").out
        self.assertIn("played", out)
        self.assertIn('places:\n  from: "p.geojson"\n', self.read("new.campus.yaml").decode())
        walk = self.read("new.walk.yaml").decode()
        self.assertIn('go_to: "notice-board"', walk)
        self.assertNotIn("out-there", walk)
        self.passes("run", "new.walk.yaml")
        # The walk notices that the place can't be got to any more.
        campus = self.read("new.campus.yaml").decode()
        self.write("new.campus.yaml", campus.replace("colliders:\n", "colliders:\n  - {id: kiosk, shape: box, center: [6, 1, 6], size: [2, 2, 2], mode: solid}\n"))
        closed = self.run_program("run", "new.walk.yaml")
        self.assertEqual(closed.code, 1, closed.out)
        self.assertIn("kiosk", closed.out)

    def test_suggestions_need_to_know_where_they_are(self):
        self.write("p.geojson", collection(feature("a", *on_earth(6, 6))))
        arguments = ("info", "room.obj", "--suggest", "new.campus.yaml", "--places", "p.geojson")
        self.assert_refused(self.run_program(*arguments), "p.geojson: error no-origin: --origin LAT,LON")
        self.passes(*arguments, "--origin", "48.15,11.57")
        self.assertIn("origin: {latitude_deg: 48.150000000, longitude_deg: 11.570000000}", self.read("new.campus.yaml").decode())
        self.assertIn('go_to: "a"', self.read("new.walk.yaml").decode())
        for bad in (("--origin", "95,0"), ("--origin", "1"), ("--places", "gone.geojson")):
            outcome = self.run_program("info", "room.obj", "--suggest", "other.campus.yaml", *bad)
            self.assertEqual(outcome.code, 2, bad)
            self.assertFalse("other.campus.yaml" in self.contents(), bad)
        self.assertEqual(self.run_program("info", "room.obj", "--origin", "48.15,11.57").code, 2)

    def test_another_property_names_them(self):
        points = collection(*({"type": "Feature", "properties": {"title": title}, "geometry": {"type": "Point", "coordinates": at}}
                              for title, at in (("公告栏", (6, -6)), ("Out There", (500, 0)))), **METRES)
        self.write("p.geojson", points)
        arguments = ("info", "room.obj", "--suggest", "new.campus.yaml", "--places", "p.geojson")
        self.assert_refused(self.run_program(*arguments), "p.geojson: error no-places: ")
        self.passes(*arguments, "--places-name", "title")
        self.assertIn('places:\n  from: {file: "p.geojson", name: "title"}\n', self.read("new.campus.yaml").decode())
        self.assertIn('go_to: "公告栏"', self.read("new.walk.yaml").decode())
        self.passes("run", "new.walk.yaml")
        self.assertEqual(self.run_program("info", "room.obj", "--places-name", "title").code, 2)

    def test_info_counts_them(self):
        self.write("p.geojson", collection(feature("a", 6, -6), feature("b", 5, -5), feature("out there", 500, 0), **METRES))
        self.assertIn("places     3, 2 of them within its bounds", self.passes("info", "room.obj", "--places", "p.geojson").out)
        counted = json.loads(self.passes("info", "room.obj", "--places", "p.geojson", "--json").out)["places"]
        self.assertEqual(counted, {"named": 3, "within_bounds": 2})
        self.assertIsNone(json.loads(self.passes("info", "room.obj", "--json").out)["places"])
        self.write("p.geojson", collection(feature("a", *on_earth(6, 6))))
        self.assert_refused(self.run_program("info", "room.obj", "--places", "p.geojson"), "p.geojson: error no-origin: --origin LAT,LON")
        self.assertIn("places     1, 1 of them", self.passes("info", "room.obj", "--places", "p.geojson", "--origin", "48.15,11.57").out)


class ConfinedPlaces(CheckoutCase):
    def test_files_outside_the_checkout_are_not_read(self):
        self.write("room.obj", ROOM)
        self.write("../elsewhere/p.geojson", '{"password": "hunter2"')
        os.symlink("../elsewhere/p.geojson", self.path("link.geojson"))
        self.write(".hidden/p.geojson", "{}")
        for place in ("../elsewhere/p.geojson", self.path("../elsewhere/p.geojson"), "link.geojson", ".hidden/p.geojson"):
            self.write("a.campus.yaml", HOUSE % ("", STEPS, place))
            outcome = self.run_program("validate", "a.campus.yaml")
            self.assertEqual(outcome.code, 2, outcome.out)
            self.assertIn("error outside-project", outcome.err, place)
            self.assertNotIn("hunter2", outcome.out + outcome.err)


if __name__ == "__main__":
    main()
