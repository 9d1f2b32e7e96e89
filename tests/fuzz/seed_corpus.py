#!/usr/bin/env python3
"""Writes small intact inputs for every target: `seed_corpus.py PROGRAM PACKED CORPUS`.

PACKED are the files of write_packed_models. libFuzzer starts from these.
"""

import base64
import glob
import json
import os
import struct
import subprocess
import sys
import tempfile

from seed_models import PNG, gltf_parts, seeds

HERE = os.path.dirname(os.path.abspath(__file__))
CONFIG = os.path.join(HERE, "..", "..", "config")
ARCHIVE_HEADER = 64


def write(corpus, target, name, data):
    folder = os.path.join(corpus, target)
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, name), "wb") as file:
        file.write(data)


def chunks(glb):
    length = struct.unpack_from("<I", glb, 12)[0]
    return glb[20:20 + length], glb[28 + length:]


def read(path):
    with open(path, "rb") as file:
        return file.read()


def write_models(packed, corpus):
    document, data = gltf_parts()
    document["buffers"] = [{"byteLength": len(data)}]
    glbs = {os.path.basename(path): read(path) for path in glob.glob(os.path.join(packed, "*.glb"))}
    text = json.dumps(document).encode()
    write(corpus, "gltf", "all-features", struct.pack("<H", len(text)) + text + data)
    for name, glb in glbs.items():
        json_text, binary = chunks(glb)
        write(corpus, "gltf", name, struct.pack("<H", len(json_text)) + json_text + binary)
        write(corpus, "glb", name, glb)
        write_compressed(corpus, name, json.loads(json_text), binary)
    for name, files in seeds().items():
        for file, data in files.items():
            if file.endswith((".glb", ".gltf")):
                write(corpus, "glb", "%s-%s" % (name, os.path.basename(file)), data)


def write_compressed(corpus, name, document, binary):
    modes = ["ATTRIBUTES", "TRIANGLES", "INDICES"]
    filters = ["NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL"]
    for i, view in enumerate(document.get("bufferViews", [])):
        packed = view.get("extensions", {}).get("EXT_meshopt_compression")
        if packed:
            at = packed.get("byteOffset", 0)
            header = struct.pack("<BBHH", modes.index(packed["mode"]), filters.index(packed.get("filter", "NONE")),
                                 packed["byteStride"], packed["count"])
            write(corpus, "meshopt", "%s-%d" % (name, i), header + binary[at:at + packed["byteLength"]])
    for mesh in document.get("meshes", []):
        for primitive in mesh["primitives"]:
            draco = primitive.get("extensions", {}).get("KHR_draco_mesh_compression")
            if draco:
                view = document["bufferViews"][draco["bufferView"]]
                ids = [draco["attributes"].get(key, 0) for key in ("POSITION", "NORMAL", "TEXCOORD_0", "COLOR_0")]
                at = view.get("byteOffset", 0)
                write(corpus, "draco", name, bytes(ids) + binary[at:at + view["byteLength"]])
    for i, image in enumerate(document.get("images", [])):
        if "bufferView" in image:
            view = document["bufferViews"][image["bufferView"]]
            at = view.get("byteOffset", 0)
            write(corpus, "texture", "%s-%d" % (name, i), binary[at:at + view["byteLength"]])


def write_textures(corpus):
    """One of each format; JPEG is the smallest baseline picture."""
    write(corpus, "texture", "png", PNG)
    write(corpus, "texture", "tga", bytes([0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 2, 0, 32, 0]) + bytes(range(16)))
    write(corpus, "texture", "tga-rle", bytes([0, 0, 10, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 2, 0, 24, 0, 0x83, 1, 2, 3]))
    write(corpus, "texture", "bmp", b"BM" + struct.pack("<IHHIIiiHHIIiiII", 70, 0, 0, 54, 40, 2, 2, 1, 24, 0, 16, 0, 0, 0, 0)
          + bytes(16))
    write(corpus, "texture", "gif", b"GIF89a" + bytes.fromhex("0200020080010000000000ffffff21f904000a0000002c00000000"
                                                             "0200020000020384510005003b"))
    write(corpus, "texture", "jpeg", bytes.fromhex(
        "ffd8ffdb004300" + "01" * 64 + "ffc0000b080008000801011100ffc4001f0000010501010101010100000000000000000102030405"
        "060708090a0bffc400b5100002010303020403050504040000017d01020300041105122131410613516107227114328191a1082342b1c1"
        "1552d1f02433627282090a161718191a25262728292a3435363738393a434445464748494a535455565758595a636465666768696a7374"
        "75767778797a838485868788898a92939495969798999aa2a3a4a5a6a7a8a9aab2b3b4b5b6b7b8b9bac2c3c4c5c6c7c8c9cad2d3d4d5d6"
        "d7d8d9dae1e2e3e4e5e6e7e8e9eaf1f2f3f4f5f6f7f8f9faffda0008010100003f00fbd3ffd9"))
    write(corpus, "texture", "webp", base64.b64decode("UklGRiIAAABXRUJQVlA4IBYAAAAwAQCdASoBAAEADsD+JaQAA3AAAAAA"))
    write(corpus, "texture", "webp-lossless", b"RIFF\x1a\0\0\0WEBPVP8L\x0d\0\0\0/\0\0\0\x10\x07\x10\x11\x11\x88\x88\xfe\x07\0")
    write(corpus, "texture", "psd", b"8BPS" + struct.pack(">HHIHIIHHIIIH", 1, 0, 0, 3, 2, 2, 8, 3, 0, 0, 0, 0) + bytes(12))


def write_archives(program, corpus, folder):
    school = os.path.join(folder, "school")
    cache = os.path.join(folder, "cache")
    subprocess.run([program, "init", school], check=True, stdout=subprocess.DEVNULL)
    with open(os.path.join(school, "school.mtl"), "a", encoding="utf-8") as materials:
        materials.write("map_Kd small.png\n")
    with open(os.path.join(school, "small.png"), "wb") as image:
        image.write(PNG)
    cube = next(data for name, data in seeds()["obj"].items())
    write_file(os.path.join(school, "cube.obj"), cube)
    write_file(os.path.join(school, "cube.campus.yaml"),
               b"scenes: [{file: cube.obj}]\ncolliders: [{id: all, nodes: '*', shape: mesh, mode: solid}]\n")
    write_file(os.path.join(school, "shelves.campus.yaml"),
               b"scenes: [{file: cube.obj}]\ncolliders:\n"
               b"  - {id: floor, shape: box, center: [0, -0.5, 0], size: [2, 1, 2], mode: solid}\n"
               b"  - {id: shelf, shape: box, center: [0, 0.45, -0.8], size: [1.6, 0.9, 0.4], mode: solid}\n"
               b"  - {id: in, shape: box, center: [0, 1, 0], size: [1, 1, 1], mode: trigger}\n"
               b"spawns: {start: {at: [0, 0, 0]}}\nplaces: {top: [0, 0.9, -0.8]}\n")
    environment = {**os.environ, "CAMPUSWALK_CACHE_DIR": cache}
    for command in (["validate", "school.campus.yaml"], ["validate", "cube.campus.yaml"],
                    ["explore", "shelves.campus.yaml"]):
        subprocess.run([program, *command], cwd=school, env=environment, check=True, stdout=subprocess.DEVNULL)
    for path in glob.glob(os.path.join(cache, "*.campuswalk")):
        data = read(path)
        kind = path.split(".")[-2]
        name = "%s-%d" % (kind, len(data))
        for target in {"model": ["model-file", "import-answer"], "trees": ["tree-file"], "reach": ["walk-space"]}.get(kind, []):
            write(corpus, target, name, data[ARCHIVE_HEADER:])
        if kind in ("model", "trees"):
            write(corpus, "archive", name, data)
    return school


def write_file(path, data):
    with open(path, "wb") as file:
        file.write(data)


def write_texts(program, corpus, school):
    for target, pattern in (("walk", "walks/**/*.walk.yaml"), ("steps", "walks/**/*.steps.yaml"),
                            ("profiles", "avatars/*.yaml"), ("profiles", "lights/*.yaml")):
        for path in glob.glob(os.path.join(CONFIG, pattern), recursive=True):
            write(corpus, target, os.path.basename(path), read(path))
    for path in glob.glob(os.path.join(school, "**", "*.yaml"), recursive=True):
        target = {"walk": "walk", "campus": "campus", "config": "config"}.get(path.split(".")[-2])
        if target:
            write(corpus, target, "school-" + os.path.basename(path), read(path))
    write(corpus, "campus", "all-keys", b"""scenes: [{file: a.obj, up: z, unit: cm, scale: 2, position: [1, 2, 3]}]
origin: {at: near, latitude_deg: 52.0, longitude_deg: 4.37, height: 3}
layers: [ground, trees]
buildings:
  - {id: hut, nodes: [a/*, 'b[12]'], title: 'Hut {hours}', kind: hall, text: "a\\n{floors}", hours: 8-22, floors: 2,
     info: {door: south}, popup: {on: trigger, once: true, cooldown: 2, dwell: 1}}
colliders:
  - {id: ground, nodes: floor, except: [pond], shape: mesh, mode: [solid, ray], layer: ground, each: true}
  - {id: gate, shape: box, center: [0, 1, 0], size: [2, 2, 2], yaw_deg: 30, mode: trigger}
  - {id: ball, shape: sphere, center: [0, 1, 0], radius: 1, mode: solid}
  - {id: post, shape: capsule, from: [0, 0, 0], to: [0, 2, 0], radius: 0.2, mode: solid}
  - {id: tyre, shape: wheel, center: [0, 0, 0], axis: [1, 0, 0], radius: 1, width: 0.3, mode: solid}
spawns: {gate: {at: [1, 0, 5], yaw_deg: 90}}
places: {square: [2, 0, -3]}
""")
    write(corpus, "config", "all-keys", b"""walks: [walks, more]
output: results
reporters: [list, {junit: junit.xml}]
workers: 2
max_failures: 3
timeout: 60
kill_after: 100
forbid_only: true
strict: true
min_cases: 1
snapshots: {max_pixels: 3}
projects:
  night: {campus: a.campus.yaml, avatar: {profile: adult, speed: 2}, spawn: gate, grep: 'a|b', tags: [slow], timeout: 9}
""")
    for i, text in enumerate((b"trigger.enter gate", b"popup.open *", b"ray.enter hut/[a-z]*", b"collision.enter {a,b}")):
        write(corpus, "pattern", str(i), text)
    report, log = (os.path.join(school, name) for name in ("report.jsonl", "log.jsonl"))
    subprocess.run([program, "run", "--reporter", "jsonl=" + report, "--rendering-backend", "none"], cwd=school,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
    subprocess.run([program, "run", "walks/visit.walk.yaml", "--jsonl", log, "--quiet"], cwd=school, check=False)
    write(corpus, "report", "school", read(report))
    write(corpus, "logs", "school", read(log) + b"\n" + read(log).replace(b"visit", b"other"))
    write(corpus, "logs", "start", b"".join(read(log).splitlines(True)[:4]))


def main():
    program, packed, corpus = map(os.path.abspath, sys.argv[1:])
    with tempfile.TemporaryDirectory() as folder:
        write_models(packed, corpus)
        write_textures(corpus)
        write_texts(program, corpus, write_archives(program, corpus, folder))


if __name__ == "__main__":
    main()
