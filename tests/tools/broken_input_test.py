#!/usr/bin/env python3
"""Broken input of every kind: the diagnostics, the exit code, and that nothing was written."""

import base64
import json
import struct

from program import CAMPUS, ROOM, WALK, ProgramCase, main

PNG = base64.b64decode("iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==")


def triangle_gltf(texture=None, vertices=((-10, 0, -10), (-10, 0, 30), (30, 0, -10))):
    """A glTF file with one triangle in a node called floor, and its buffer in the file itself."""
    data = b"".join(struct.pack("<3f", *vertex) for vertex in vertices)
    data += b"".join(struct.pack("<2f", *uv) for uv in ((0, 0), (1, 0), (0, 1)))
    finite = [[c for c in column if c == c] for column in zip(*vertices)]
    scene = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"name": "floor", "mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
             "min": [min(column) for column in finite], "max": [max(column) for column in finite]},
            {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 36},
                        {"buffer": 0, "byteOffset": 36, "byteLength": 24}],
        "buffers": [{"byteLength": len(data),
                     "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}],
    }
    if texture:
        scene["materials"] = [{"name": "grass", "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}]
        scene["textures"] = [{"source": 0}]
        scene["images"] = [{"uri": texture}]
        scene["meshes"][0]["primitives"][0]["material"] = 0
    return json.dumps(scene)


FIELD = """\
scenes: [{file: field.gltf}]
colliders: [{id: ground, nodes: floor, shape: mesh, mode: solid}]
spawns: {start: {at: [0, 0, 0]}}
places: {end: [1, 0, 0]}
"""

FIELD_WALK = ("campus: field.campus.yaml\navatar: adult\nsteps: [{spawn: start}, {walk_to: end}]\n"
              "expect: [{never: avatar.fell}]\n")


class BrokenInput(ProgramCase):
    """Each test breaks one thing in a campus that works."""

    def refused(self, *arguments, expected, code=2):
        """Runs the walk, or the program with these arguments: the expected diagnostic, or a list of them, on standard
        error, nothing on standard output, nothing written."""
        before = self.contents()
        outcome = self.run_program(*(arguments or ("run", "short.walk.yaml")))
        self.assert_refused(outcome, *([expected] if isinstance(expected, str) else expected), code=code)
        self.assertEqual(outcome.out, "")
        self.assertEqual(self.contents(), before)

    def refused_model(self, place_and_code, *names, arguments=("run", "short.walk.yaml")):
        """One diagnostic with this place and code and these names; nothing else is written."""
        before = self.contents()
        outcome = self.run_program(*arguments)
        self.assertEqual((len(outcome.err_lines), outcome.code, outcome.out), (1, 2, ""), outcome.err_lines)
        self.assertTrue(outcome.err_lines[0].startswith(place_and_code + ": "), outcome.err_lines)
        for name in names:
            self.assertIn(name, outcome.err_lines[0])
        self.assertEqual(self.contents(), before)

    def campus(self, old, new):
        self.assertEqual(CAMPUS.count(old), 1)
        self.write("small.campus.yaml", CAMPUS.replace(old, new))

    def walk(self, old, new):
        self.assertEqual(WALK.count(old), 1)
        self.write("short.walk.yaml", WALK.replace(old, new))

    def field(self, gltf):
        self.write("field.gltf", gltf)
        self.write("field.campus.yaml", FIELD)
        self.write("field.walk.yaml", FIELD_WALK)

    def test_unbroken_input_works(self):
        self.passes("run", "short.walk.yaml")
        self.write("grass.png", PNG)
        self.field(triangle_gltf("grass.png"))
        self.passes("run", "field.walk.yaml")

    # ---- missing files

    def test_missing_walk(self):
        self.refused("run", "shrot.walk.yaml", expected="shrot.walk.yaml: error missing-file:")

    def test_missing_campus(self):
        self.walk("small.campus.yaml", "smal.campus.yaml")
        self.refused(expected="short.walk.yaml:1:9: error missing-file: 'smal.campus.yaml'")

    def test_missing_avatar(self):
        self.walk("avatar: adult", "avatar: adlt")
        self.refused(expected="short.walk.yaml:2:9: error unknown-name: adlt.avatar.yaml 'avatars' 'config/avatars' 'adult'")

    def test_missing_scene(self):
        self.campus("room.obj", "models/room.obj")
        self.refused(expected="small.campus.yaml:2:11: error missing-file: 'models/room.obj'")

    def test_missing_scene_of_a_campus_elsewhere(self):
        self.write("north/small.campus.yaml", CAMPUS)
        self.walk("small.campus.yaml", "north/small.campus.yaml")
        self.refused(expected="north/small.campus.yaml:2:11: error missing-file: 'north/room.obj'")

    def test_campus_given_as_a_walk(self):
        self.refused("run", "small.campus.yaml",
                     expected="small.campus.yaml: error file-name: 'small.campus.yaml' NAME.walk.yaml")

    # ---- YAML

    def test_bad_yaml(self):
        self.walk("  - walk_to: end\n", "   - walk_to: end\n")
        self.refused(expected="short.walk.yaml:5:4: error yaml-syntax:")

    def test_wrong_type(self):
        self.walk("turn: 180", "turn: around")
        self.refused(expected="short.walk.yaml:6:11: error wrong-type: 'turn' 'around'")

    def test_unknown_key(self):
        self.walk("walk_to:", "walkto:")
        self.refused(expected="short.walk.yaml:5:5: error unknown-key: 'walkto' 'walk_to'")

    # ---- steps of other files, objects by name

    def test_steps_file_that_is_missing_or_includes_itself(self):
        self.walk("turn: 180", "include: lap.steps.yaml")
        self.refused(expected="short.walk.yaml:6:14: error missing-file: 'lap.steps.yaml'")
        self.write("short.walk.yaml", WALK.replace("turn: 180", "include: short.walk.yaml"))
        self.refused(expected="short.walk.yaml:6:14: error include-cycle: short.walk.yaml")

    def test_mistake_in_a_steps_file(self):
        self.walk("turn: 180", "repeat: {times: 2, steps: [{include: parts/lap.steps.yaml}]}")
        self.write("parts/lap.steps.yaml", "steps:\n  - wait: 1\n  - crouch: down\n")
        self.refused(expected="parts/lap.steps.yaml:3:13: error bad-value: 'crouch' on off 'down'")

    def test_unknown_object(self):
        self.walk("turn: 180", "disable: [gate, hut/wal]")
        self.refused(expected="short.walk.yaml:6:21: error unknown-name: 'hut/wal' 'hut/wall'")

    def test_waiting_for_an_impossible_event(self):
        self.walk("turn: 180", "wait_until: {event: trigger.enter hut/wall}")
        self.refused(expected="short.walk.yaml:6:25: error unknown-name: 'trigger.enter hut/wall'")

    def test_all_mistakes_at_once(self):
        self.walk("turn: 180\nexpect", "turm: 180\nexpct")
        self.campus("mode: trigger", "mode: triger")
        self.refused(expected=["short.walk.yaml:6:5: error unknown-key: 'turm' 'turn'",
                               "short.walk.yaml:7:1: error unknown-key: 'expct' 'expect'",
                               "small.campus.yaml:12:70: error bad-value: 'mode' solid trigger ray 'triger' 'trigger'"])

    # ---- models

    def test_glob_that_matches_nothing(self):
        self.campus("nodes: floor", "nodes: [flor, 'gravel_*']")
        self.refused(expected=["small.campus.yaml:10:26: error no-node: 'flor' 'floor'",
                               "small.campus.yaml:10:32: error no-node: 'gravel_*' 'floor' 'room.obj' 'wall'"])

    def test_collider_without_a_triangle(self):
        self.write("room.obj", ROOM + "o rail\nv 0 0 0\nv 1 0 0\nl 13 14\n")
        self.campus("nodes: floor", "nodes: rail")
        self.refused_model("small.campus.yaml:10:5: error empty-mesh", "'ground'")

    def test_scene_without_a_triangle(self):
        self.write("room.obj", "o floor\nv 0 0 0\nv 1 0 0\nv 0 0 1\n# the faces were not exported\n")
        self.refused_model("small.campus.yaml:2:11: error empty-mesh", "'room.obj'")

    def test_nan_vertex(self):
        self.write("room.obj", ROOM.replace("v -1 3 -5", "v -1 nan -5"))
        self.refused_model("small.campus.yaml:2:11: error bad-vertex", "room.obj: ", "'wall'")

    def test_infinite_vertex_in_gltf(self):
        self.field(triangle_gltf(vertices=((0, 0, 0), (0, float("nan"), 1), (1, 0, 0))))
        self.refused_model("field.campus.yaml:1:17: error bad-vertex", "field.gltf: ", "'floor'",
                           arguments=("run", "field.walk.yaml"))

    def test_file_that_is_not_a_model(self):
        self.write("room.obj", "%PDF-1.7 this is not a model, and it is longer than any header of one\n" * 4)
        self.refused_model("small.campus.yaml:2:11: error empty-mesh", "'room.obj'")

    def warned_of_its_texture(self, reason):
        """A walk needs no textures; only with --strict, or if pictures are evaluated, they must be right."""
        self.field(triangle_gltf("grass.png"))
        arguments = ("run", "field.walk.yaml", "--rendering-backend", "none")
        lines = self.passes(*arguments).err_lines
        self.assertEqual(len(lines), 2, lines)
        self.assertTrue(lines[0].startswith("field.campus.yaml:1:17: warning bad-texture: field.gltf: "), lines)
        for name in ("'grass'", "'grass.png'", reason):
            self.assertIn(name, lines[0])
        strict = self.run_program(*arguments, "--strict")
        self.assertEqual((strict.code, strict.out), (2, ""))
        self.assertEqual(strict.err_lines[-1], lines[0].replace(" warning ", " error "))

    def test_missing_texture(self):
        self.warned_of_its_texture("missing")

    def test_unreadable_texture(self):
        self.write("grass.png", PNG[:30])
        self.warned_of_its_texture("decoded")

    # ---- places

    def test_spawn_deep_inside_a_wall(self):
        self.campus("at: [0, 0, 5]", "at: [0, 0, -4.5]")
        self.refused(expected="short.walk.yaml:4:12: error spawn-blocked: start 0.000,0.000,-4.500 hut/wall")

    # ---- output that can't be written

    def test_log_that_is_a_folder(self):
        self.refused("run", "short.walk.yaml", "--log", "avatars", expected="avatars: error log-unwritable: folder")

    def test_log_below_a_file(self):
        self.refused("run", "short.walk.yaml", "--log", "a.log", "--jsonl", "room.obj/a.log",
                     expected="room.obj/a.log: error log-unwritable: 'room.obj'")

    def test_log_over_a_walk(self):
        self.write("other.walk.yaml", WALK)
        self.refused("run", "--log", "other.walk.yaml", "short.walk.yaml",
                     expected="other.walk.yaml: error log-unwritable: overwrite YAML")

    def test_one_file_for_both_logs(self):
        self.refused("run", "short.walk.yaml", "--log", "a.log", "--jsonl", "./a.log",
                     expected="./a.log: error log-unwritable: another here already")

    def test_log_on_a_full_disk(self):
        for option in ("--log", "--jsonl"):
            self.refused("run", "-q", "short.walk.yaml", option, "/dev/full", expected="error: /dev/full", code=3)


if __name__ == "__main__":
    main()
