"""Small intact models, one or more of each format that the program reads."""

import base64
import json
import struct

VERTICES = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
FACES = [(0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1), (2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4),
         (1, 5, 7), (1, 7, 3)]
PNG = base64.b64decode("iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8z8DwHwAFBQIAX8jx0gAAAABJRU5ErkJggg==")


def gltf_parts():
    """A textured box, an instanced and a sparse one, as JSON and its buffer."""
    positions = b"".join(struct.pack("<3f", *c) for c in VERTICES)
    uvs = b"".join(struct.pack("<2f", c[0], c[2]) for c in VERTICES)
    indices = b"".join(struct.pack("<3H", *f) for f in FACES)
    places = struct.pack("<6f", 5, 0, 0, 10, 0, 0)
    sparse = struct.pack("<H2x3f", 7, 2, 2, 2)
    views, data = [], b""
    for part in (positions, uvs, indices, places, sparse, PNG):
        data += b"\0" * (-len(data) % 4)
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": len(part)})
        data += part
    document = {
        "asset": {"version": "2.0"}, "scene": 0,
        "extensionsUsed": ["CESIUM_RTC"],
        "extensions": {"CESIUM_RTC": {"center": [3919000.0, 332000.0, 5006000.0]}},
        "scenes": [{"nodes": [0, 1]}],
        "nodes": [
            {"name": "house", "mesh": 0, "children": [2], "rotation": [0, 0.7071068, 0, 0.7071068]},
            {"name": "lamps", "mesh": 1,
             "extensions": {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": 3}}}},
            {"name": "roof", "mesh": 1, "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 3, 0, 1]}],
        "meshes": [
            {"name": "box", "primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]},
            {"primitives": [{"attributes": {"POSITION": 4}, "indices": 2}, {"attributes": {"POSITION": 0}, "mode": 5}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3"},
            {"bufferView": 1, "componentType": 5126, "count": 8, "type": "VEC2"},
            {"bufferView": 2, "componentType": 5123, "count": 36, "type": "SCALAR"},
            {"bufferView": 3, "componentType": 5126, "count": 2, "type": "VEC3"},
            {"bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3",
             "sparse": {"count": 1, "indices": {"bufferView": 4, "componentType": 5123},
                        "values": {"bufferView": 4, "byteOffset": 4}}}],
        "bufferViews": views,
        "materials": [{"name": "wall", "alphaMode": "MASK", "pbrMetallicRoughness": {"baseColorTexture": {
            "index": 0, "extensions": {"KHR_texture_transform": {"scale": [2, 2], "rotation": 0.5}}}}}],
        "textures": [{"source": 0}], "images": [{"bufferView": 5, "mimeType": "image/png"}],
    }
    return document, data


def glb():
    document, data = gltf_parts()
    document["buffers"] = [{"byteLength": len(data)}]
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    data += b"\0" * (-len(data) % 4)
    return (struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(data)) + struct.pack("<I4s", len(text), b"JSON") + text
            + struct.pack("<I4s", len(data), b"BIN\0") + data)


def gltf():
    document, data = gltf_parts()
    document["buffers"] = [{"byteLength": len(data), "uri": "data:application/octet-stream;base64,"
                            + base64.b64encode(data).decode()}]
    return json.dumps(document, indent=1).encode()


def obj():
    lines = ["mtllib box.mtl", "o box", "usemtl wall"]
    lines += ["v %d %d %d" % c for c in VERTICES] + ["vt %d %d" % (c[0], c[2]) for c in VERTICES] + ["vn 0 1 0"]
    lines += ["f " + " ".join("%d/%d/1" % (i + 1, i + 1) for i in face) for face in FACES]
    return "\n".join(lines + ["g more", "s 1", "f -8 -7 -5 -6", "l 1 2 3", "p 1", ""]).encode()


def off():
    return ("OFF\n8 12 0\n" + "".join("%d %d %d\n" % c for c in VERTICES)
            + "".join("3 %d %d %d\n" % f for f in FACES)).encode()


def ply(binary):
    head = ("ply\nformat %s 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n"
            "element face 12\nproperty list uchar int vertex_indices\nend_header\n"
            % ("binary_little_endian" if binary else "ascii")).encode()
    if binary:
        return (head + b"".join(struct.pack("<3f", *c) for c in VERTICES)
                + b"".join(struct.pack("<B3i", 3, *f) for f in FACES))
    return head + ("".join("%d %d %d\n" % c for c in VERTICES) + "".join("3 %d %d %d\n" % f for f in FACES)).encode()


def stl(binary):
    if binary:
        return b"box".ljust(80) + struct.pack("<I", len(FACES)) + b"".join(
            struct.pack("<12fH", 0, 1, 0, *(x for i in f for x in VERTICES[i]), 0) for f in FACES)
    facets = "".join("facet normal 0 1 0\nouter loop\n%sendloop\nendfacet\n"
                     % "".join("vertex %d %d %d\n" % VERTICES[i] for i in f) for f in FACES)
    return ("solid box\n" + facets + "endsolid box\n").encode()


def dae():
    numbers = " ".join(str(x) for c in VERTICES for x in c)
    indices = " ".join(str(i) for f in FACES for i in f)
    return """<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><coverage><geographic_location><longitude>4.37</longitude><latitude>+52.0</latitude><altitude>3</altitude>
</geographic_location></coverage><unit meter="0.5"/><up_axis>Z_UP</up_axis></asset>
<library_effects><effect id="e"><profile_COMMON><technique sid="t"><phong><diffuse><color>1 0 0 1</color></diffuse>
<shininess><float> 20</float></shininess></phong></technique></profile_COMMON></effect></library_effects>
<library_materials><material id="m" name="red"><instance_effect url="#e"/></material></library_materials>
<library_geometries><geometry id="g" name="box"><mesh><source id="s"><float_array id="a" count="24">%s</float_array>
<technique_common><accessor source="#a" count="8" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#s"/></vertices>
<triangles count="12" material="m"><input semantic="VERTEX" source="#v" offset="0"/><p>%s</p></triangles>
<polylist count="1"><input semantic="VERTEX" source="#v" offset="0"/><vcount>4</vcount><p>0 1 3 2</p></polylist>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="vs"><node id="n" name="house"><matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</matrix>
<instance_geometry url="#g"><bind_material><technique_common><instance_material symbol="m" target="#m"/>
</technique_common></bind_material></instance_geometry><node id="o"><rotate>0 1 0 90</rotate>
<instance_geometry url="#g"/></node></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#vs"/></scene></COLLADA>
""".encode().replace(b"%s", numbers.encode(), 1).replace(b"%s", indices.encode(), 1)


def fbx():
    """FBX 7.3 as text."""
    vertices = ",".join(str(100 * x) for c in VERTICES for x in c)
    indices = ",".join("%d,%d,%d" % (a, b, -c - 1) for a, b, c in FACES)
    axes = "".join('  P: "%s", "int", "Integer", "",%d\n' % pair for pair in
                   [("UpAxis", 1), ("UpAxisSign", 1), ("FrontAxis", 2), ("FrontAxisSign", 1), ("CoordAxis", 0),
                    ("CoordAxisSign", 1)])
    return ("; FBX 7.3.0 project file\nFBXHeaderExtension:  {\n FBXHeaderVersion: 1003\n FBXVersion: 7300\n}\n"
            "GlobalSettings:  {\n Version: 1000\n Properties70:  {\n" + axes +
            '  P: "UnitScaleFactor", "double", "Number", "",1\n }\n}\n'
            'Objects:  {\n Geometry: 1000, "Geometry::box", "Mesh" {\n  Vertices: *24 {\n   a: ' + vertices +
            "\n  }\n  PolygonVertexIndex: *36 {\n   a: " + indices + "\n  }\n  GeometryVersion: 124\n }\n"
            ' Model: 2000, "Model::house", "Mesh" {\n  Version: 232\n  Properties70:  {\n'
            '   P: "Lcl Translation", "Lcl Translation", "", "A",1,2,3\n  }\n }\n}\n'
            'Connections:  {\n C: "OO",2000,0\n C: "OO",1000,2000\n}\n').encode()


def chunk_3ds(number, *parts):
    body = b"".join(parts)
    return struct.pack("<HI", number, 6 + len(body)) + body


def three_ds():
    vertices = struct.pack("<H", len(VERTICES)) + b"".join(struct.pack("<3f", *c) for c in VERTICES)
    faces = struct.pack("<H", len(FACES)) + b"".join(struct.pack("<4H", *f, 7) for f in FACES)
    mesh = chunk_3ds(0x4100, chunk_3ds(0x4110, vertices), chunk_3ds(0x4120, faces))
    return chunk_3ds(0x4D4D, chunk_3ds(0x0002, struct.pack("<I", 3)),
                     chunk_3ds(0x3D3D, chunk_3ds(0x4000, b"house\0", mesh)))


def seeds():
    """Per format, the files by name."""
    return {
        "glb": {"box.glb": glb()},
        "gltf": {"box.gltf": gltf()},
        "obj": {"box.obj": obj()},
        "fbx": {"box.fbx": fbx()},
        "dae": {"box.dae": dae()},
        "stl": {"text.stl": stl(False), "binary.stl": stl(True)},
        "ply": {"text.ply": ply(False), "binary.ply": ply(True)},
        "off": {"box.off": off()},
        "3ds": {"box.3ds": three_ds()},
    }


COMPANIONS = {"box.mtl": b"newmtl wall\nKd 0.5 0.5 0.5\nmap_Kd wall.png\nd 0.5\n", "wall.png": PNG}
