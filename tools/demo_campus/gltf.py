"""A small glTF 2.0 binary writer: one scene, one buffer, external textures.

Layout is kept to what every importer reads: separate arrays for each attribute, one view for
each attribute kind, 16-bit indices where they fit.
"""

import json
import struct
from dataclasses import dataclass, field
from math import sqrt

from .exact import cos_deg, sin_deg
from .materials import MATERIALS, TEXTURE_FOLDER
from .mesh import LATTICE, Mesh

GLB_MAGIC, GLB_VERSION = 0x46546C67, 2
CHUNK_JSON, CHUNK_BINARY = 0x4E4F534A, 0x004E4942
FLOAT, USHORT, UINT = 5126, 5123, 5125
ARRAY_BUFFER, ELEMENT_BUFFER = 34962, 34963
POSITION, NORMAL, TEXCOORD, SHORT_INDEX, LONG_INDEX = range(5)


@dataclass
class Node:
    """A named node: an upright pose (metres, degrees about +Y, uniform scale) and its children."""

    name: str
    mesh: Mesh = None
    at: tuple = (0.0, 0.0, 0.0)
    yaw_deg: float = 0.0
    scale: float = 1.0
    children: list = field(default_factory=list)


def drawn_triangles(nodes):
    """Triangles as drawn: a mesh counts once for each node that shows it."""
    return sum((node.mesh.triangles() if node.mesh else 0) + drawn_triangles(node.children)
               for node in nodes)


def _single(value):
    """The nearest float32, as JSON will hold it."""
    return struct.unpack("<f", struct.pack("<f", value))[0]


class _Document:
    def __init__(self):
        self.views = [bytearray() for _ in range(5)]
        self.accessors, self.meshes, self.nodes = [], [], []
        self.materials, self.textures, self.images = [], [], []
        self._mesh_ids, self._material_ids, self._image_ids = {}, {}, {}

    def accessor(self, view, data, component, kind, count, extra=None):
        entry = {"bufferView": view, "byteOffset": len(self.views[view]),
                 "componentType": component, "count": count, "type": kind}
        entry.update(extra or {})
        self.views[view] += data
        self.accessors.append(entry)
        return len(self.accessors) - 1

    def primitive(self, material, part):
        keys = list(part.vertices)
        count = len(keys)

        def pack(first, last):
            flat = [k / LATTICE for key in keys for k in key[first:last]]
            return struct.pack("<%df" % len(flat), *flat)
        low = [_single(min(k[i] for k in keys) / LATTICE) for i in range(3)]
        high = [_single(max(k[i] for k in keys) / LATTICE) for i in range(3)]
        attributes = {
            "POSITION": self.accessor(POSITION, pack(0, 3), FLOAT, "VEC3", count,
                                      {"min": low, "max": high}),
            "NORMAL": self.accessor(NORMAL, _unit_normals(keys), FLOAT, "VEC3", count),
            "TEXCOORD_0": self.accessor(TEXCOORD, pack(6, 8), FLOAT, "VEC2", count)}
        view, component, code = ((SHORT_INDEX, USHORT, "H") if count <= 65535
                                 else (LONG_INDEX, UINT, "I"))
        data = struct.pack("<%d%s" % (len(part.indices), code), *part.indices)
        return {"attributes": attributes, "material": self.material(material),
                "indices": self.accessor(view, data, component, "SCALAR", len(part.indices))}

    def mesh(self, mesh, name):
        if id(mesh) not in self._mesh_ids:
            parts = [(m, p) for m, p in mesh.parts.items() if p.indices]
            self.meshes.append({"name": name,
                                "primitives": [self.primitive(m, p) for m, p in parts]})
            self._mesh_ids[id(mesh)] = len(self.meshes) - 1
        return self._mesh_ids[id(mesh)]

    def material(self, name):
        if name not in self._material_ids:
            source = MATERIALS[name]
            surface = {"baseColorTexture": {"index": self.texture(source.texture)},
                       "metallicFactor": source.metallic, "roughnessFactor": source.roughness}
            if source.factor != (1.0, 1.0, 1.0, 1.0):
                surface["baseColorFactor"] = list(source.factor)
            entry = {"name": name, "pbrMetallicRoughness": surface}
            if source.glow:
                entry["emissiveFactor"] = list(source.glow)
            if source.glow_texture:
                entry["emissiveTexture"] = {"index": self.texture(source.glow_texture)}
            if source.alpha == "MASK":
                entry["alphaMode"], entry["alphaCutoff"] = "MASK", 0.5
            elif source.alpha == "BLEND":
                entry["alphaMode"] = "BLEND"
            if source.double_sided:
                entry["doubleSided"] = True
            self.materials.append(entry)
            self._material_ids[name] = len(self.materials) - 1
        return self._material_ids[name]

    def texture(self, image):
        if image not in self._image_ids:
            self.images.append({"name": image, "mimeType": "image/png",
                                "uri": "%s/%s.png" % (TEXTURE_FOLDER, image)})
            self.textures.append({"sampler": 0, "source": len(self.images) - 1})
            self._image_ids[image] = len(self.images) - 1
        return self._image_ids[image]

    def node(self, node):
        entry = {"name": node.name}
        if node.mesh is not None:
            entry["mesh"] = self.mesh(node.mesh, node.name)
        if any(node.at):
            entry["translation"] = [round(v, 4) for v in node.at]
        if node.yaw_deg % 360.0:
            half = node.yaw_deg / 2.0
            entry["rotation"] = [0.0, round(sin_deg(half), 7), 0.0, round(cos_deg(half), 7)]
        if node.scale != 1.0:
            entry["scale"] = [round(node.scale, 4)] * 3
        index = len(self.nodes)
        self.nodes.append(entry)
        if node.children:
            entry["children"] = [self.node(child) for child in node.children]
        return index

    def finish(self, roots):
        binary = bytearray()
        strides = {POSITION: 12, NORMAL: 12, TEXCOORD: 8}
        buffer_views, new_index = [], {}
        for view, data in enumerate(self.views):
            if not data:
                continue
            entry = {"buffer": 0, "byteOffset": len(binary), "byteLength": len(data)}
            if view in strides:
                entry["byteStride"] = strides[view]
            entry["target"] = ARRAY_BUFFER if view in strides else ELEMENT_BUFFER
            new_index[view] = len(buffer_views)
            buffer_views.append(entry)
            binary += data
            binary += b"\0" * (-len(binary) % 4)
        for accessor in self.accessors:
            accessor["bufferView"] = new_index[accessor["bufferView"]]
        return binary, {
            "asset": {"version": "2.0", "generator": "campuswalk tools/make-demo-campus",
                      "copyright": "the campuswalk authors, MIT licence"},
            "scene": 0, "scenes": [{"nodes": roots}], "nodes": self.nodes, "meshes": self.meshes,
            "materials": self.materials, "textures": self.textures, "images": self.images,
            "samplers": [{"magFilter": 9729, "minFilter": 9987, "wrapS": 10497, "wrapT": 10497}],
            "accessors": self.accessors, "bufferViews": buffer_views,
            "buffers": [{"byteLength": len(binary)}]}


def _unit_normals(keys):
    """Normals, made unit length again after their rounding to the lattice."""
    flat = []
    for key in keys:
        x, y, z = key[3:6]
        length = sqrt(x * x + y * y + z * z)
        flat += (x / length, y / length, z / length)
    return struct.pack("<%df" % len(flat), *flat)


def write_glb(path, nodes):
    """Writes the nodes (with their subtrees) as one binary glTF file."""
    document = _Document()
    roots = [document.node(node) for node in nodes]
    binary, content = document.finish(roots)
    text = json.dumps(content, separators=(",", ":")).encode("ascii")
    text += b" " * (-len(text) % 4)
    total = 12 + 8 + len(text) + 8 + len(binary)
    with open(path, "wb") as out:
        out.write(struct.pack("<III", GLB_MAGIC, GLB_VERSION, total))
        out.write(struct.pack("<II", len(text), CHUNK_JSON) + text)
        out.write(struct.pack("<II", len(binary), CHUNK_BINARY) + binary)
