#!/usr/bin/env python3
"""The demo campus: what is committed is what the generator writes, and it keeps its promises.

Regenerates everything into a temporary folder, compares bytes, then checks the models' numbers
and the committed description. Prints every broken promise; exits 1 if there is one.
"""

import filecmp
import os
import re
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
sys.path.insert(0, os.path.join(ROOT, "tools"))
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from demo_campus import site                                 # noqa: E402
from demo_campus.layout import FLOOR_ABOVE_PAD, PLACEMENTS   # noqa: E402
from demo_campus.polygon import bounds, contains             # noqa: E402
from coplanar import overlaps, world_faces                   # noqa: E402
from glb_reader import Glb                                   # noqa: E402

MODELS = ("ground.glb", "buildings.glb", "vegetation.glb", "furniture.glb")
MIN_TRIANGLES, MAX_TRIANGLES = 60_000, 220_000
MAX_TERRAIN_SHARE = 1.0 / 3.0
MAX_TOTAL, MAX_FILE, MAX_TEXTURES = 8_000_000, 5_000_000, 3_500_000   # bytes
MIN_BUILDINGS, MIN_TREES, MIN_SPECIES = 12, 90, 4
MIN_BELOW_FLOOR = 0.05   # metres between a floor and the terrain under it
MAX_THRESHOLD = 0.12     # metres from the ground in front of a door to its floor

failures = []


def check(condition, message):
    """Notes a broken promise."""
    if not condition:
        failures.append(message)


def files_under(folder):
    """Relative paths of all files, sorted."""
    return sorted(os.path.relpath(os.path.join(base, name), folder)
                  for base, _, names in os.walk(folder) for name in names)


def check_regeneration():
    """The generator writes exactly the committed bytes."""
    with tempfile.TemporaryDirectory() as fresh:
        subprocess.run([sys.executable, os.path.join(ROOT, "tools", "make-demo-campus"),
                        "--root", fresh], check=True, stdout=subprocess.DEVNULL)
        written = files_under(fresh)
        for name in written:
            committed = os.path.join(ROOT, name)
            check(os.path.exists(committed) and
                  filecmp.cmp(os.path.join(fresh, name), committed, shallow=False),
                  "%s differs from what tools/make-demo-campus writes" % name)
        demo = os.path.join("campus_assets", "demo")
        for name in files_under(os.path.join(ROOT, demo)):
            check(os.path.join(demo, name) in written, "%s is not written by the generator" % name)


def check_sizes():
    """The files stay small."""
    folder = os.path.join(ROOT, "campus_assets")
    sizes = {name: os.path.getsize(os.path.join(folder, name)) for name in files_under(folder)}
    check(sum(sizes.values()) < MAX_TOTAL, "campus_assets has %d bytes" % sum(sizes.values()))
    in_textures = os.path.join("demo", "textures") + os.sep  # not the README's pictures
    textures = sum(size for name, size in sizes.items() if name.startswith(in_textures))
    check(textures > 0, "there are no textures")
    check(textures < MAX_TEXTURES, "textures have %d bytes" % textures)
    for name, size in sizes.items():
        check(size < MAX_FILE, "%s has %d bytes" % (name, size))


def check_models():
    """Counts, names and the health of every mesh."""
    total, terrain, roots, faces = 0, 0, [], []
    for name in MODELS:
        glb = Glb(os.path.join(ROOT, "campus_assets", "demo", name))
        for fault in glb.faults():
            check(False, "%s: %s" % (name, fault))
        total += glb.drawn()
        terrain += glb.drawn("terrain")
        roots += glb.root_names()
        faces += world_faces(glb)
    for pair, area in overlaps(faces).items():
        check(False, "%s and %s flicker over %.2f m2" % (*pair, area))
    check(len(roots) == len(set(roots)), "root nodes share a name")
    check(MIN_TRIANGLES <= total <= MAX_TRIANGLES, "%d triangles are drawn" % total)
    check(terrain <= total * MAX_TERRAIN_SHARE, "terrain has %d of %d triangles" % (terrain, total))
    trees = [n for n in roots if n.startswith("tree_")]
    check(len(trees) >= MIN_TREES, "%d trees" % len(trees))
    check(len({n.split("_")[1] for n in trees}) >= MIN_SPECIES, "too few species")
    check(len(PLACEMENTS) >= MIN_BUILDINGS, "%d buildings" % len(PLACEMENTS))
    for name in ("terrain", "road_main", "square", "library", "pond_basin", "pond_water", "bench_01",
                 "lamp_01", "sign_01", "flower_bed_01", "fountain"):
        check(name in roots, "no node named %s" % name)


def check_ground(campus):
    """The terrain keeps clear of floors, and doors are met by the ground."""
    for building in campus.buildings:
        place = building.place
        for void in building.voids:
            x0, z0, x1, z1 = bounds(void)
            for i in range(13):
                for k in range(13):
                    x, z = x0 + (x1 - x0) * i / 12, z0 + (z1 - z0) * k / 12
                    if not contains(void, (x, z)):
                        continue
                    ground = campus.terrain.height(*place.world(x, z))
                    check(ground <= place.level + FLOOR_ABOVE_PAD - MIN_BELOW_FLOOR,
                          "%s: terrain %.3f at own %.1f, %.1f" % (building.id, ground, x, z))
    for building_id, x, z in (("cafeteria", 0.0, 7.3), ("theatre", 0.0, 12.3), ("gallery", 0.0, 8.3)):
        place = PLACEMENTS[building_id]
        front = campus.paving.top(*place.world(x, z))
        rise = place.level + FLOOR_ABOVE_PAD - front
        check(0.0 <= rise <= MAX_THRESHOLD, "%s: threshold of %.3f m" % (building_id, rise))


def check_description():
    """The YAML names every building and no node glob is empty."""
    with open(os.path.join(ROOT, "config", "demo.campus.yaml"), encoding="utf-8") as source:
        text = source.read()
    for name in PLACEMENTS:
        check("- id: %s\n" % name in text, "no building %s in the description" % name)
        check("- id: %s/walls\n" % name in text, "no collider %s/walls" % name)
    names = set()
    for model in MODELS:
        names |= set(Glb(os.path.join(ROOT, "campus_assets", "demo", model)).names())
    for line in re.findall(r"nodes: \[(.*)\]", text):
        for glob in re.findall(r'"([^"]+)"', line):
            pattern = re.compile(re.escape(glob).replace(r"\*", ".*") + "$")
            check(glob.endswith("_*") or any(pattern.match(n) for n in names),
                  "no node matches %s" % glob)
    ids = re.findall(r"^  - id: (\S+)$", text, re.MULTILINE)
    check(len(ids) == len(set(ids)), "an id is used twice")
    with open(os.path.join(ROOT, "config", "walks", "first-tour.walk.yaml"), encoding="utf-8") as source:
        walk = source.read()
    for place in re.findall(r"(?:walk_to|look_at|to|place): ([a-z][a-z-]*)", walk):
        check("\n  %s: " % place in text, "the first tour names an unknown place: %s" % place)


def main():
    """Runs every check."""
    check_sizes()
    check_models()
    check_ground(site.build())
    check_description()
    check_regeneration()
    for failure in failures[:40]:
        print("FAIL", failure)
    print("%d broken promises" % len(failures) if failures else "demo campus: all promises kept")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
