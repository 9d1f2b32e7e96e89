#!/usr/bin/env python3
"""What a few lines from a stranger can ask for ends in a message: memory, triangles, ticks, log, time."""

import json
import os
import re
import struct
import subprocess
import time

from program import CAMPUS, WALK, ProgramCase, main

TRIANGLE = struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 0, 1)


def glb(document, data):
    document["buffers"] = [{"byteLength": len(data)}]
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    return (struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(data)) + struct.pack("<I4s", len(text), b"JSON") + text
            + struct.pack("<I4s", len(data), b"BIN\0") + data)


def model(nodes, accessors=(), data=TRIANGLE, primitive=None, roots=None):
    return glb({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(roots or len(nodes)))}], "nodes": nodes,
                "meshes": [{"primitives": [primitive or {"attributes": {"POSITION": 0}}]}],
                "bufferViews": [{"buffer": 0, "byteLength": len(data)}],
                "accessors": [{"bufferView": 0, "componentType": 5126, "count": len(data) // 12, "type": "VEC3"},
                              *accessors]}, data)


class Models(ProgramCase):
    def assert_too_much(self, name, expected):
        start = time.monotonic()
        self.write("small.campus.yaml", CAMPUS.replace("room.obj", name))
        for arguments in (("info", name), ("run", "short.walk.yaml")):
            outcome = self.run_program(*arguments, "--no-cache")
            self.assertEqual(outcome.code, 2, outcome.err)
            self.assertRegex(outcome.err, expected)
        self.assertLess(time.monotonic() - start, 60)

    def test_a_kilobyte_that_instances_itself_into_millions(self):
        bomb = model([{"mesh": 0, "extensions": {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": 1}}}}],
                     [{"componentType": 5126, "count": 9_000_000, "type": "VEC3"}])
        self.assertLess(len(bomb), 1024)
        self.write("bomb.glb", bomb)
        self.assert_too_much("bomb.glb", "places 9000000 instances; a model may have 1000000")

    def test_instances_of_several_nodes_count_together(self):
        node = {"mesh": 0, "extensions": {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": 1}}}}
        self.write("bomb.glb", model([node] * 4, [{"componentType": 5126, "count": 300_000, "type": "VEC3"}]))
        self.assert_too_much("bomb.glb", "more than 1000000 nodes and instances")

    def test_elements_without_data(self):
        self.write("bomb.glb", model([{"mesh": 0}], [{"componentType": 5125, "count": 900_000_000, "type": "SCALAR"}],
                                     primitive={"attributes": {"POSITION": 0}, "indices": 1}))
        self.assert_too_much("bomb.glb", "accessors/1 has an implausible count of 900000000")

    def test_many_placements_of_a_large_mesh(self):
        data = b"".join(struct.pack("<9f", i, 0, 0, i + 1, 0, 0, i, 0, 1) for i in range(60_000))
        self.write("bomb.glb", model([{"mesh": 0}] * 1000, data=data))
        self.assert_too_much("bomb.glb", "place 60000000 triangles; a model may have 50000000")

    def test_colliders_of_the_same_nodes(self):
        data = b"".join(struct.pack("<9f", i, 0, 0, i + 1, 0, 0, i, 0, 1) for i in range(20_000))
        self.write("large.glb", model([{"mesh": 0}] * 1500, data=data))
        self.write("a.campus.yaml", "scenes: [{file: large.glb}]\ncolliders:\n" + "".join(
            "  - {id: c%d, nodes: '*', shape: box, mode: solid}\n" % i for i in range(3)))
        outcome = self.run_program("validate", "a.campus.yaml")
        self.assertEqual(outcome.code, 2)
        self.assertIn("a.campus.yaml:4:5: error too-many-triangles: ", outcome.err)

    def test_the_size_of_the_world(self):
        self.write("far.glb", model([{"mesh": 0}], data=struct.pack("<9f", 0, 0, 0, 1e30, 0, 0, 0, 0, 1)))
        self.write("a.campus.yaml", "scenes: [{file: far.glb}]\ncolliders:\n"
                   "  - {id: all, nodes: '*', shape: mesh, mode: solid}\n")
        self.assert_refused(self.run_program("validate", "a.campus.yaml"), "a.campus.yaml:1:17: error bad-size: nodes[0]")

    def test_a_chain_of_nodes(self):
        """As deep as there are nodes: no recursion, and no work that grows with its square."""
        nodes = 100_000
        chain = [{"mesh": 0, "children": [i + 1]} for i in range(nodes - 1)] + [{"mesh": 0}]
        self.write("chain.glb", model(chain, roots=1))
        self.assertIn("nodes      %d" % nodes, self.passes("info", "chain.glb", "--no-cache").out)
        self.assertEqual(len(json.loads(self.passes("info", "--json", "chain.glb", "--no-cache").out)["nodes"]), nodes)

    def test_scenes(self):
        self.write("a.campus.yaml", "scenes: [%s]\ncolliders: []\n" % ", ".join(["{file: room.obj}"] * 1001))
        self.assertIn("error too-many-scenes: 1001 ", self.run_program("validate", "a.campus.yaml").err)


class Walks(ProgramCase):
    def test_ticks(self):
        start = time.monotonic()
        self.write("short.walk.yaml", WALK.replace("steps:", "sim: {ticks_per_second: 10000}\nsteps:").replace(
            "  - turn: 180", "  - repeat: {times: 99000, steps: [{wait: 86400}]}"))
        outcome = self.run_program("run", "short.walk.yaml")
        self.assert_refused(outcome, "short.walk.yaml: error too-many-ticks: 100000000 ")
        self.assertLess(time.monotonic() - start, 30)

    def test_timeout_is_a_ceiling(self):
        for own in ("", "timeout: 1000\n"):
            self.write("short.walk.yaml", own + WALK.replace("turn: 180", "wait: 900"))
            outcome = self.run_program("run", "short.walk.yaml", "--timeout", "5")
            self.assertEqual(outcome.code, 1)
            self.assertIn("after 5.000 s, its timeout", outcome.out + outcome.err)

    def test_a_log(self):
        boxes = "".join("  - {id: t%d-%s, shape: box, center: [0, 1, 0], size: [40, 4, 40], mode: trigger}\n" % (i, 90 * "x")
                        for i in range(200))
        self.write("small.campus.yaml", CAMPUS.replace("spawns:", boxes + "spawns:"))
        self.write("short.walk.yaml", WALK.replace("steps:", "sim: {stay_every: 0}\nsteps:").replace(
            "turn: 180", "wait: 1000"))
        for arguments in (("--log", "/dev/null", "--quiet"), ("--jsonl", "/dev/null", "--quiet")):
            outcome = self.run_program("run", "short.walk.yaml", *arguments)
            self.assertEqual(outcome.code, 3, outcome.err)
            self.assertIn("its log has more than 256 MB", outcome.err)

    def test_wall_clock(self):
        self.assertIn('"kill_after": 3600', self.passes("run", "--print-config").out)
        self.write("short.walk.yaml", WALK.replace("turn: 180", "wait: 80000"))
        self.write("walks.config.yaml", "kill_after: 0.2\n")
        outcome = self.run_program("run", "short.walk.yaml", "--quiet")
        self.assertEqual(outcome.code, 3)
        self.assertIn("stopped: it took more than 0.2 s", outcome.err)

    def test_memory_of_workers(self):
        self.write("short.walk.yaml", WALK.replace("turn: 180", "wait: 80000"))
        process = subprocess.Popen([self.program, "run", "short.walk.yaml", "--quiet"], cwd=self.folder,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        until = time.monotonic() + 20
        limit = None
        while limit in (None, "unlimited") and time.monotonic() < until:
            with open("/proc/%d/task/%d/children" % (process.pid, process.pid), encoding="ascii") as children:
                for child in children.read().split():
                    try:
                        with open("/proc/%s/limits" % child, encoding="ascii") as limits:
                            limit = re.search(r"Max data size +(\S+)", limits.read()).group(1)
                    except OSError:
                        pass
            time.sleep(0.01)
        self.assertRegex(str(limit), r"^\d+$")
        memory = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
        self.assertTrue(memory <= int(limit) <= memory + (1 << 30), limit)

    def test_files_that_are_included_again_and_again(self):
        self.write("short.walk.yaml", WALK.replace("turn: 180", "include: a.steps.yaml"))
        self.write("a.steps.yaml", "steps:\n" + "  - include: b.steps.yaml\n" * 200)
        self.write("b.steps.yaml", "steps:\n" + "  - include: c.steps.yaml\n" * 200)
        self.write("c.steps.yaml", "steps:\n  - wait: 1\n" + "# padding\n" * 190_000)
        start = time.monotonic()
        outcome = self.run_program("run", "short.walk.yaml")
        self.assertEqual(outcome.code, 2)
        self.assertIn("error too-many-steps: ", outcome.err)
        self.assertLess(time.monotonic() - start, 60)

    def test_projects(self):
        self.write("walks.config.yaml", "projects:\n" + "".join("  p%d:\n" % i for i in range(101)))
        self.assertIn("error bad-value: there may be 100 projects", self.run_program("run").err)


if __name__ == "__main__":
    main()
