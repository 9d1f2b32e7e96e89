"""Reads a binary glTF file back, independently of the writer, and looks for faults in it."""

import json
import os
import struct

UNIT_TOLERANCE = 1e-3
SOFTLY_LIT = ("leaves_", "blossom")   # foliage is lit from its crown's middle, cards from above


class Glb:
    """A file's JSON and binary chunk."""

    def __init__(self, path):
        self._folder = os.path.dirname(path)
        with open(path, "rb") as source:
            data = source.read()
        magic, version, length = struct.unpack_from("<III", data)
        assert (magic, version, length) == (0x46546C67, 2, len(data)), path
        size = struct.unpack_from("<I", data, 12)[0]
        self.json = json.loads(data[20:20 + size])
        self._binary = data[20 + size + 8:]

    def root_names(self):
        """Names of the scene's root nodes."""
        return [self.json["nodes"][i]["name"] for i in self.json["scenes"][0]["nodes"]]

    def names(self):
        """Names of all nodes."""
        return [node["name"] for node in self.json["nodes"]]

    def drawn(self, name=None):
        """Triangles drawn by all nodes, or by those of one name."""
        meshes = [sum(self.json["accessors"][p["indices"]]["count"] // 3 for p in m["primitives"])
                  for m in self.json["meshes"]]
        return sum(meshes[n["mesh"]] for n in self.json["nodes"]
                   if "mesh" in n and name in (None, n["name"]))

    def _read(self, index):
        accessor = self.json["accessors"][index]
        view = self.json["bufferViews"][accessor["bufferView"]]
        width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3}[accessor["type"]]
        code = {5126: "f", 5123: "H", 5125: "I"}[accessor["componentType"]]
        flat = struct.unpack_from("<%d%s" % (accessor["count"] * width, code), self._binary,
                                  view["byteOffset"] + accessor["byteOffset"])
        return flat if width == 1 else [flat[i:i + width] for i in range(0, len(flat), width)]

    def mesh_triangles(self, mesh):
        """[(material name, [three corners])] of a mesh, in its own frame; cut-outs left out."""
        for primitive in self.json["meshes"][mesh]["primitives"]:
            material = self.json["materials"][primitive["material"]]
            if material.get("alphaMode") == "MASK":
                continue
            corners = self._read(primitive["attributes"]["POSITION"])
            indices = self._read(primitive["indices"])
            yield material["name"], [[corners[k] for k in indices[i:i + 3]]
                                     for i in range(0, len(indices), 3)]

    def faults(self):
        """Messages about everything that is wrong."""
        content = self.json
        if content.get("extensionsUsed"):
            yield "uses extensions %s" % content["extensionsUsed"]
        if len(content["scenes"]) != 1:
            yield "has %d scenes" % len(content["scenes"])
        for image in content["images"]:
            if not os.path.exists(os.path.join(self._folder, image["uri"])):
                yield "lacks the image %s" % image["uri"]
        for material in content["materials"]:
            if "baseColorTexture" not in material["pbrMetallicRoughness"]:
                yield "material %s has no texture" % material["name"]
        for node in content["nodes"]:
            if min(node.get("scale", [1.0])) <= 0.0 or "matrix" in node:
                yield "node %s may mirror" % node["name"]
        names = self.names()
        if len(names) != len(set(names)):
            yield "two nodes share a name"
        for mesh in content["meshes"]:
            for primitive in mesh["primitives"]:
                yield from self._primitive_faults(mesh["name"], primitive)

    def _primitive_faults(self, name, primitive):
        positions = self._read(primitive["attributes"]["POSITION"])
        normals = self._read(primitive["attributes"]["NORMAL"])
        indices = self._read(primitive["indices"])
        if len(self._read(primitive["attributes"]["TEXCOORD_0"])) != len(positions):
            yield "%s: not every vertex has texture coordinates" % name
        if max(indices) >= len(positions):
            yield "%s: an index is out of range" % name
        if any(abs(sum(v * v for v in n) - 1.0) > UNIT_TOLERANCE for n in normals):
            yield "%s: a normal is not of length one" % name
        material = self.json["materials"][primitive["material"]]
        if material.get("alphaMode") or material["name"].startswith(SOFTLY_LIT):
            return
        flipped = 0
        for i in range(0, len(indices), 3):
            a, b, c = (positions[k] for k in indices[i:i + 3])
            u, v = [q - p for p, q in zip(a, b)], [q - p for p, q in zip(a, c)]
            face = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
            if face == (0.0, 0.0, 0.0):
                yield "%s: a triangle has no area" % name
            if all(sum(f * n for f, n in zip(face, normals[k])) < 0.0 for k in indices[i:i + 3]):
                flipped += 1
        if flipped:
            yield "%s (%s): %d triangles face against their normals" % (
                name, material["name"], flipped)
