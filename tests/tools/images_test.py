#!/usr/bin/env python3
"""Images from the command line. `images_test.py PROGRAM [--without-rendering]`."""

import json
import os
import stat
import struct
import sys

from program import CAMPUS, SKIPPED, WALK, ProgramCase, main


class Images(ProgramCase):
    """PNG files of `snapshot` and of a walk's snapshot steps."""

    def size_of(self, name):
        """Width and height from the PNG's first chunk."""
        data = self.read(name)
        self.assertEqual(data[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(data[12:16], b"IHDR")
        self.assertEqual(data[-8:-4], b"IEND")
        return struct.unpack(">II", data[16:24])

    def refuses_camera(self, camera, *, expected):
        before = self.contents()
        outcome = self.run_program("snapshot", "small.campus.yaml", "--camera", camera, "-o", "a.png", "--no-cache")
        self.assert_refused(outcome, expected)
        self.assertEqual(self.contents(), before)

    def test_plan(self):
        outcome = self.passes("snapshot", "small.campus.yaml", "--camera", "top", "-o", "maps/plan.png", "--width", "320",
                              "--height", "200")
        self.assertEqual(outcome.out, "")
        self.assertEqual(self.size_of("maps/plan.png"), (320, 200))

    def test_map_of_a_model(self):
        plain = self.passes("info", "room.obj").out
        outcome = self.passes("info", "room.obj", "--map", "maps/room.png")
        self.assertEqual(outcome.out, plain)
        self.assertEqual(self.size_of("maps/room.png"), (1280, 720))
        # With a grid, unlike a campus' plan with --no-grid.
        self.write("room.campus.yaml", "scenes: [{file: room.obj}]\ncolliders: []\nspawns: {start: {at: [0, 0, 0]}}\n")
        self.passes("snapshot", "room.campus.yaml", "-o", "plan.png")
        self.assertEqual(self.read("plan.png"), self.read("maps/room.png"))
        # From above north is up: turned about x, the room shows another side.
        self.passes("info", "room.obj", "--up", "z", "--map", "side.png", "--rendering-backend", "osmesa")
        self.assertNotEqual(self.read("side.png"), self.read("maps/room.png"))

    def test_maps_that_cannot_be_drawn_are_refused(self):
        self.write("bare.gltf", '{"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"name": "bare"}]}')
        outcome = self.run_program("info", "bare.gltf", "--map", "bare.png")
        self.assert_refused(outcome, "bare.gltf: error empty-mesh: 'bare.gltf'")
        before = self.contents()
        outcome = self.run_program("info", "room.obj", "--map", "room.obj/map.png")
        self.assertEqual((outcome.code, outcome.out, self.contents()), (2, "", before))
        self.assertIn("error output-unwritable: ", outcome.err)

    def test_view_from_a_spawn(self):
        self.passes("snapshot", "small.campus.yaml", "--camera", "start", "-o", "view.png", "--width", "64", "--height", "48")
        self.passes("snapshot", "small.campus.yaml", "-o", "plan.png", "--width", "64", "--height", "48")
        self.assertEqual(self.size_of("view.png"), (64, 48))
        self.assertNotEqual(self.read("view.png"), self.read("plan.png"))

    def test_view_from_a_place(self):
        self.passes("snapshot", "small.campus.yaml", "--camera", "end", "-o", "end.png", "--width", "64", "--height", "48")
        self.passes("snapshot", "small.campus.yaml", "--camera", "start", "-o", "start.png", "--width", "64", "--height", "48")
        self.assertEqual(self.size_of("end.png"), (64, 48))
        self.assertNotEqual(self.read("end.png"), self.read("start.png"))

    def test_a_building_without_nodes_is_where_its_colliders_are(self):
        def drawn(camera):
            self.passes("snapshot", "small.campus.yaml", "--camera", camera, "-o", "a.png", "--width", "64", "--height", "48")
            return self.read("a.png")
        around = "{view: orbit, around: hut}"
        by_nodes = drawn(around)
        self.write("small.campus.yaml", CAMPUS.replace("    nodes: wall\n", "").replace(
            "building: hut, shape", "building: hut, nodes: wall, shape"))
        self.assertEqual(drawn(around), by_nodes)
        self.write("small.campus.yaml", CAMPUS.replace("buildings:\n", "buildings:\n  - {id: club, title: Club}\n"))
        self.refuses_camera("{view: orbit, around: club}", expected="--camera:1:23: error no-extent: 'club'")
        self.write("short.walk.yaml", WALK.replace("turn: 180", "look_at: club"))
        self.assert_refused(self.run_program("run", "short.walk.yaml"), "short.walk.yaml:6:14: error no-extent: 'club'")

    def test_an_unknown_camera_is_refused(self):
        self.refuses_camera("strat", expected="--camera: error unknown-name: 'strat' 'top' small 'start'")

    def test_view_by_a_cameras_keys(self):
        for camera in ("{view: orbit, around: hut}", "{view: fixed, position: [0, 30, 0], pitch_deg: -90, width: 80}"):
            self.passes("snapshot", "small.campus.yaml", "--camera", camera, "-o", "a.png", "--width", "64", "--height", "48")
            self.assertEqual(self.size_of("a.png"), (80 if "80" in camera else 64, 48))
        self.refuses_camera("{view: orbit}", expected="--camera:1:1: error bad-value:")
        self.refuses_camera("{view: orbit, around: htu}", expected="--camera:1:23: error unknown-name: 'htu' 'hut'")
        self.refuses_camera("{view: fixed, position: [0, 1, 0], width: 0}",
                            expected="--camera:1:43: error bad-value: 'width' 16 8192 '0'")

    def test_channels_are_files_beside_the_image(self):
        self.passes("snapshot", "small.campus.yaml", "--camera", "start", "-o", "out/view.png", "--width", "64", "--height",
                    "48", "--channels", "depth,ids,normals")
        self.assertEqual({name for name in self.contents() if name.startswith("out/")},
                         {"out/view.png", "out/view-depth.png", "out/view-ids.png", "out/view-ids.json", "out/view-normals.png"})
        for channel in ("depth", "ids", "normals"):
            self.assertEqual(self.size_of(f"out/view-{channel}.png"), (64, 48))
        self.assertEqual(self.read("out/view-depth.png")[24:26], b"\x10\x00")  # 16 bits, grey
        names = json.loads(self.read("out/view-ids.json"))
        self.assertEqual(sum(entry["pixels"] for entry in names["ids"]), 64 * 48)
        outcome = self.run_program("snapshot", "small.campus.yaml", "-o", "a.png", "--channels", "ids,colors")
        self.assertEqual(outcome.code, 2)
        self.assertRegex(outcome.err, "--channels: 'ids,colors' .*depth.*ids.*normals")

    def test_channels_of_a_walk(self):
        self.write("short.walk.yaml", WALK.replace(
            "turn: 180", "snapshot: {name: a, width: 64, height: 48, channels: [ids, depth]}"))
        self.passes("run", "short.walk.yaml", "--reporter", "json=report.json")
        self.assertEqual({name for name in self.contents() if name.startswith("out/short/")},
                         {"out/short/a.png", "out/short/a-depth.png", "out/short/a-ids.png", "out/short/a-ids.json"})
        report = self.read("report.json").decode()
        for name in ("a.png", "a-depth.png", "a-ids.png", "a-ids.json"):
            self.assertIn(f"short/{name}", report)

    def test_light_profiles_change_the_image(self):
        def drawn(*light):
            self.passes("snapshot", "small.campus.yaml", "--camera", "start", "-o", "a.png", "--width", "64", "--height", "48",
                        *light)
            return self.read("a.png")
        day = drawn()
        self.assertEqual(drawn("--light", "day"), day)
        self.assertEqual(len({day, drawn("--light", "night"), drawn("--light", "overcast"),
                              drawn("--light", "{profile: night, shadows: false}"),
                              drawn("--light", "{anti_aliasing: fxaa}")}), 5)
        outcome = self.run_program("snapshot", "small.campus.yaml", "-o", "b.png", "--light", "{sun: {disc: bright}}")
        self.assert_refused(outcome, "--light:1:14: error wrong-type: 'disc' 'bright'")
        outcome = self.run_program("snapshot", "small.campus.yaml", "-o", "b.png", "--light", "nihgt")
        self.assertEqual((outcome.code, len(outcome.err_lines)), (2, 1))
        self.assertRegex(outcome.err, "^--light.*: error .*'night'")

    def test_what_would_have_no_effect_is_refused(self):
        for arguments, code in ((("-o", "a.jpg", "--camera", "start"), "a.jpg: error file-name: a.png"),
                                (("-o", "a.png", "--overlay", "colliders"), "--overlay: error bad-value: --camera"),
                                (("-o", "a.png", "--camera", "top", "--tree-level", "2"),
                                 "--tree-level: error bad-value: --camera"),
                                (("-o", "a.png", "--camera", "start", "--overlay", "grid"),
                                 "--overlay: error bad-value: --camera top"),
                                (("-o", "a.png", "--camera", "start", "--no-grid"),
                                 "--no-grid: error bad-value: --camera top"),
                                (("-o", "a.png", "--overlay", "grid", "--no-grid"),
                                 "--no-grid: error bad-value: --overlay grid")):
            before = self.contents()
            outcome = self.run_program("snapshot", "small.campus.yaml", *arguments)
            self.assert_refused(outcome, code)
            self.assertEqual(self.contents(), before)

    def test_each_overlay_changes_the_image(self):
        def drawn(*overlays):
            self.passes("snapshot", "small.campus.yaml", "--camera", "start", "-o", "a.png", "--width", "160", "--height",
                        "120", *overlays)
            return self.read("a.png")
        self.assertEqual(len({drawn(), drawn("--overlay", "colliders"), drawn("--overlay", "triggers"),
                              drawn("--overlay", "labels"), drawn("--overlay", "compass"), drawn("--tree-level", "1"),
                              drawn("--overlay", "labels", "--overlay", "compass")}), 7)

    def test_a_plan_has_a_grid_unless_told_otherwise(self):
        def drawn(*arguments):
            self.passes("snapshot", "small.campus.yaml", "-o", "a.png", "--width", "320", "--height", "200", *arguments)
            return self.read("a.png")
        self.assertEqual(drawn("--overlay", "grid"), drawn())
        self.assertEqual(drawn("--overlay", "labels"), drawn(), "plans have them anyway")
        self.assertNotEqual(drawn("--no-grid"), drawn())

    def test_a_walk_draws_a_grid_if_told_to(self):
        for name, overlays in (("plain", ""), ("grid", ", overlays: grid")):
            self.write(f"{name}.walk.yaml", WALK.replace(
                "turn: 180", f"snapshot: {{name: a, view: top, width: 320, height: 200{overlays}}}"))
            self.passes("run", f"{name}.walk.yaml")
        self.assertNotEqual(self.read("out/plain/a.png"), self.read("out/grid/a.png"))

    def test_every_backend_draws_the_same_bytes(self):
        images = set()
        for backend in ("osmesa", "egl", "auto"):
            for threads in ("0", "2"):
                self.passes("snapshot", "small.campus.yaml", "--camera", "start", "-o", "a.png", "--width", "64", "--height",
                            "48", env=dict(os.environ, CAMPUSWALK_RENDERING_BACKEND=backend, LP_NUM_THREADS=threads))
                images.add(self.read("a.png"))
        self.assertEqual(len(images), 1)

    def test_missing_backends_are_reported(self):
        os.mkdir(self.path("no-osmesa"))
        os.mkdir(self.path("no-gl"))
        for name in ("no-osmesa/libOSMesa.so.8", "no-osmesa/libOSMesa.so", "no-gl/libOSMesa.so.8", "no-gl/libOSMesa.so",
                     "no-gl/libEGL.so.1", "no-gl/libEGL.so"):
            self.write(name, "")  # found first, and not a library
        arguments = ("snapshot", "small.campus.yaml", "-o", "a.png", "--width", "64", "--height", "48", "--rendering-backend")
        without = {folder: dict(os.environ, LD_LIBRARY_PATH=self.path(folder)) for folder in ("no-osmesa", "no-gl")}
        self.passes(*arguments, "auto", env=without["no-osmesa"])
        outcome = self.run_program(*arguments, "osmesa", env=without["no-osmesa"])
        self.assertEqual(outcome.code, 3)
        self.assertRegex(outcome.err, "^error: .*libOSMesa.so.8.*libosmesa6")
        outcome = self.run_program(*arguments, "auto", env=without["no-gl"])
        self.assertEqual(outcome.code, 3)
        self.assertRegex(outcome.err, "(?s)^error: .*OSMesa.*EGL.*libosmesa6"
                                      ".*libegl1 libgl1-mesa-dri.*--rendering-backend none")
        outcome = self.run_program(*arguments, "none")
        self.assert_refused(outcome, "--rendering-backend: error bad-value: 'none' auto osmesa egl")

    def test_unwritable_images_are_refused(self):
        for name in ("avatars", "room.obj/a.png"):
            outcome = self.run_program("snapshot", "small.campus.yaml", "-o", name)
            self.assertEqual(outcome.code, 2)
            self.assertRegex(outcome.err, f"^{name}: error output-unwritable: ")

    def test_an_image_does_not_replace_a_pipe(self):
        os.mkfifo(self.path("pipe"))
        outcome = self.run_program("snapshot", "small.campus.yaml", "-o", "pipe", "--width", "64", "--height", "64")
        self.assert_refused(outcome, "pipe: error output-unwritable:")
        self.assertTrue(stat.S_ISFIFO(os.stat(self.path("pipe")).st_mode))

    def test_walk_takes_the_same_images_every_time(self):
        self.write("short.walk.yaml", WALK.replace(
            "  - turn: 180", "  - snapshot: {name: gate, width: 80, height: 60}\n  - turn: 180\n"
                             "  - snapshot: {name: from-above, view: top, width: 60, height: 80}"))
        images = []
        for folder in ("out", "elsewhere"):
            outcome = self.passes("run", "short.walk.yaml", "--output", folder)
            self.assertEqual([line.split()[3] for line in outcome.lines if " snapshot.take " in line],
                             ["gate", "from-above"])
            self.assertEqual(self.size_of(f"{folder}/short/gate.png"), (80, 60))
            self.assertEqual(self.size_of(f"{folder}/short/from-above.png"), (60, 80))
            images.append((self.read(f"{folder}/short/gate.png"), self.read(f"{folder}/short/from-above.png")))
        self.assertEqual(images[0], images[1])

    def test_drawing_does_not_change_the_log(self):
        self.write("short.walk.yaml", WALK.replace("turn: 180", "snapshot: {name: a, width: 64, height: 64}"))
        drawn = self.passes("run", "short.walk.yaml").out
        self.assertEqual(self.passes("run", "short.walk.yaml", "--rendering-backend", "none", "--output", "none").out, drawn)
        self.assertIn("out/short/a.png", self.contents())
        self.assertNotIn("none", self.contents())

    def test_output_below_a_file_is_refused(self):
        self.write("short.walk.yaml", WALK.replace("turn: 180", "snapshot: a"))
        before = self.contents()
        outcome = self.run_program("run", "short.walk.yaml", "--output", "room.obj", "--log", "a.log")
        self.assertEqual(outcome.out, "")
        self.assert_refused(outcome, "room.obj/short: error output-unwritable: 'room.obj'")
        self.assertEqual(self.contents(), before)


if __name__ == "__main__":
    if "--without-rendering" in sys.argv:
        print("skipped: built with CAMPUSWALK_RENDER=OFF")
        sys.exit(SKIPPED)
    main()
