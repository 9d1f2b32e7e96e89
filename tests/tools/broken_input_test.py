#!/usr/bin/env python3
"""Broken input of every kind: the message that a user sees, the exit code, and that nothing was written."""

import base64
import json
import struct

from program import CAMPUS, ROOM, WALK, ProgramCase, main

PNG = base64.b64decode("iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==")


def triangle_gltf(texture=None, corners=((-10, 0, -10), (-10, 0, 30), (30, 0, -10))):
    """A glTF file with one triangle in a node called floor, and its buffer in the file itself."""
    data = b"".join(struct.pack("<3f", *corner) for corner in corners)
    data += b"".join(struct.pack("<2f", *uv) for uv in ((0, 0), (1, 0), (0, 1)))
    finite = [[c for c in column if c == c] for column in zip(*corners)]
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

FIELD_WALK = "campus: field.campus.yaml\navatar: adult\nsteps: [{spawn: start}, {walk_to: end}]\n"


class BrokenInput(ProgramCase):
    """Each test breaks one thing of a campus that works."""

    def refused(self, *complaints, arguments=("run", "short.walk.yaml"), code=2):
        """Runs the program: these lines on standard error, nothing on standard output, nothing written."""
        before = self.contents()
        outcome = self.run_program(*arguments)
        self.assertEqual(outcome.complaints, list(complaints))
        self.assertEqual(outcome.code, code)
        self.assertEqual(outcome.out, "")
        self.assertEqual(self.contents(), before)

    def refused_model(self, place_and_code, *names, arguments=("run", "short.walk.yaml")):
        """One line that begins with the place and the code and contains these names; nothing else is written."""
        before = self.contents()
        outcome = self.run_program(*arguments)
        self.assertEqual((len(outcome.complaints), outcome.code, outcome.out), (1, 2, ""), outcome.complaints)
        self.assertTrue(outcome.complaints[0].startswith(place_and_code + ": "), outcome.complaints)
        for name in names:
            self.assertIn(name, outcome.complaints[0])
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

    def test_what_is_not_broken_works(self):
        self.passes("run", "short.walk.yaml")
        self.write("grass.png", PNG)
        self.field(triangle_gltf("grass.png"))
        self.passes("run", "field.walk.yaml")

    # ---- missing files

    def test_missing_walk(self):
        self.refused("shrot.walk.yaml: error missing-file: no such file; check the path",
                     arguments=("run", "shrot.walk.yaml"))

    def test_missing_campus(self):
        self.walk("small.campus.yaml", "smal.campus.yaml")
        self.refused("short.walk.yaml:1:9: error missing-file: 'smal.campus.yaml': no such file; check the path")

    def test_missing_avatar(self):
        self.walk("avatar: adult", "avatar: adlt")
        self.refused("short.walk.yaml:2:9: error unknown-name: there is no adlt.avatar.yaml in 'avatars' or "
                     "'config/avatars' next to the walk or above it, nor among the program's own (did you mean 'adult'?)")

    def test_missing_scene(self):
        self.campus("room.obj", "models/room.obj")
        self.refused("small.campus.yaml:2:11: error missing-file: 'models/room.obj': no such file; check the path")

    def test_missing_scene_of_a_campus_elsewhere(self):
        self.write("north/small.campus.yaml", CAMPUS)
        self.walk("small.campus.yaml", "north/small.campus.yaml")
        self.refused("north/small.campus.yaml:2:11: error missing-file: 'north/room.obj': no such file; check the "
                     "path")

    def test_other_file_for_a_walk(self):
        self.refused("small.campus.yaml: error file-name: 'small.campus.yaml' must be named NAME.walk.yaml; "
                     "rename it, or name another file", arguments=("run", "small.campus.yaml"))

    # ---- YAML

    def test_bad_yaml(self):
        self.walk("  - walk_to: end\n", "   - walk_to: end\n")
        self.refused("short.walk.yaml:5:4: error yaml-syntax: this line doesn't fit the lines above: check its "
                     "indentation, '-' and ':'")

    def test_wrong_type(self):
        self.walk("turn: 180", "turn: around")
        self.refused("short.walk.yaml:6:11: error wrong-type: 'turn' must be a number, not 'around'")

    def test_unknown_key(self):
        self.walk("walk_to:", "walkto:")
        self.refused("short.walk.yaml:5:5: error unknown-key: unknown key 'walkto' for a step (did you mean "
                     "'walk_to'?)")

    # ---- steps of other files, objects by name

    def test_steps_file_that_is_missing_or_another_thing(self):
        self.walk("turn: 180", "include: lap.steps.yaml")
        self.refused("short.walk.yaml:6:14: error missing-file: 'lap.steps.yaml': no such file; check the path")
        self.write("short.walk.yaml", WALK.replace("turn: 180", "include: short.walk.yaml"))
        self.refused("short.walk.yaml:6:14: error include-cycle: short.walk.yaml includes itself through this line")

    def test_mistake_in_a_steps_file(self):
        self.walk("turn: 180", "repeat: {times: 2, steps: [{include: parts/lap.steps.yaml}]}")
        self.write("parts/lap.steps.yaml", "steps:\n  - wait: 1\n  - crouch: down\n")
        self.refused("parts/lap.steps.yaml:3:13: error bad-value: 'crouch' must be one of on, off, not 'down'")

    def test_object_that_is_not_there(self):
        self.walk("turn: 180", "disable: [gate, hut/wal]")
        self.refused("short.walk.yaml:6:21: error unknown-name: the campus has no object 'hut/wal' (did you mean "
                     "'hut/wall'?)")

    def test_waiting_for_what_can_not_happen(self):
        self.walk("turn: 180", "wait_until: {event: trigger.enter hut/wall}")
        self.refused("short.walk.yaml:6:25: error unknown-name: 'trigger.enter hut/wall' can't happen: nothing of "
                     "that name has such events")

    def test_all_mistakes_at_once(self):
        self.walk("turn: 180\nexpect", "turm: 180\nexpct")
        self.campus("mode: trigger", "mode: triger")
        self.refused("short.walk.yaml:6:5: error unknown-key: unknown key 'turm' for a step (did you mean 'turn'?)",
                     "short.walk.yaml:7:1: error unknown-key: unknown key 'expct' in a walk (did you mean "
                     "'expect'?)",
                     "small.campus.yaml:12:70: error bad-value: 'mode' must be one of solid, trigger, ray, not "
                     "'triger' (did you mean 'trigger'?)")

    # ---- models

    def test_glob_that_matches_nothing(self):
        self.campus("nodes: floor", "nodes: [flor, 'gravel_*']")
        self.refused("small.campus.yaml:10:26: error no-node: no node is named 'flor'; did you mean 'floor'?",
                     "small.campus.yaml:10:32: error no-node: no node is named 'gravel_*'; the scenes contain "
                     "'floor', 'room.obj', 'wall'")

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
        self.field(triangle_gltf(corners=((0, 0, 0), (0, float("nan"), 1), (1, 0, 0))))
        self.refused_model("field.campus.yaml:1:17: error bad-vertex", "field.gltf: ", "'floor'",
                           arguments=("run", "field.walk.yaml"))

    def test_no_model_at_all(self):
        self.write("room.obj", "%PDF-1.7 this is not a model, and it is longer than any header of one\n" * 4)
        self.refused_model("small.campus.yaml:2:11: error empty-mesh", "'room.obj'")

    def test_missing_texture(self):
        self.field(triangle_gltf("grass.png"))
        self.refused_model("field.campus.yaml:1:17: error bad-texture", "field.gltf: ", "'grass'", "'grass.png'",
                           "missing", arguments=("run", "field.walk.yaml"))

    def test_unreadable_texture(self):
        self.write("grass.png", PNG[:30])
        self.field(triangle_gltf("grass.png"))
        self.refused_model("field.campus.yaml:1:17: error bad-texture", "field.gltf: ", "'grass'", "'grass.png'",
                           "decoded", arguments=("run", "field.walk.yaml"))

    # ---- places

    def test_spawn_deep_inside_a_wall(self):
        self.campus("at: [0, 0, 5]", "at: [0, 0, -4.5]")
        self.refused("short.walk.yaml:4:12: error spawn-blocked: start at 0.000,0.000,-4.500 is inside hut/wall: put "
                     "it where a capsule of 0.30 m radius and 1.80 m height fits")

    # ---- what can't be written

    def test_log_that_is_a_folder(self):
        self.refused("avatars: error log-unwritable: the log can't be written here: it is a folder; name a file",
                     arguments=("run", "short.walk.yaml", "--log", "avatars"))

    def test_log_below_a_file(self):
        self.refused("room.obj/a.log: error log-unwritable: the log can't be written here: 'room.obj' is not a folder",
                     arguments=("run", "short.walk.yaml", "--log", "a.log", "--jsonl", "room.obj/a.log"))

    def test_log_over_a_walk(self):
        self.write("other.walk.yaml", WALK)
        self.refused("other.walk.yaml: error log-unwritable: a log would overwrite this YAML file; name another",
                     arguments=("run", "--log", "other.walk.yaml", "short.walk.yaml"))

    def test_one_file_for_both_logs(self):
        self.refused("./a.log: error log-unwritable: another log or report goes here already; each needs a file of its "
                     "own",
                     arguments=("run", "short.walk.yaml", "--log", "a.log", "--jsonl", "./a.log"))

    def test_log_on_a_full_disk(self):
        for option in ("--log", "--jsonl"):
            self.refused("error: Failed flush to file /dev/full: No space left on device",
                         arguments=("run", "-q", "short.walk.yaml", option, "/dev/full"), code=3)


if __name__ == "__main__":
    main()
