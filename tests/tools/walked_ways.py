"""How much of a map's paths the adult walks in a campus made from it. An oracle of its own: it reads the map, projects
and clips it without the program's code, and has the program walk along every way that is open to walkers.

Usage: walked_ways.py PROGRAM MAP.osm CAMPUS_FOLDER [--list]
"""

import collections
import json
import math
import os
import struct
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

WALKABLE = {"footway", "path", "pedestrian", "steps", "living_street", "residential", "service", "unclassified", "tertiary",
            "secondary", "primary", "track", "cycleway", "road", "corridor", "tertiary_link", "secondary_link",
            "primary_link", "platform"}
PIECE = 5.0  # metres: what a walk fails to get along counts as blocked as a whole

Piece = collections.namedtuple("Piece", "way start end length")


def geocentric(latitude, longitude):
    """Earth-centred coordinates of a point on the WGS 84 ellipsoid, in metres."""
    a, f = 6378137.0, 1 / 298.257223563
    e2 = f * (2 - f)
    sin, cos = math.sin(math.radians(latitude)), math.cos(math.radians(latitude))
    n = a / math.sqrt(1 - e2 * sin * sin)
    return (n * cos * math.cos(math.radians(longitude)), n * cos * math.sin(math.radians(longitude)), n * (1 - e2) * sin)


class Map:
    """The ways of an OpenStreetMap file, in metres east and north of the middle of its bounds."""

    def __init__(self, file):
        root = xml.etree.ElementTree.parse(file).getroot()
        bounds = root.find("bounds")
        self.south, self.west, self.north, self.east = (float(bounds.get(k)) for k in ("minlat", "minlon", "maxlat", "maxlon"))
        self.middle = ((self.south + self.north) / 2, (self.west + self.east) / 2)
        self.origin = geocentric(*self.middle)
        self.nodes = {n.get("id"): self.project(float(n.get("lat")), float(n.get("lon"))) for n in root.iter("node")
                      if n.get("lat")}
        self.closed_gates = [self.nodes[n.get("id")] for n in root.iter("node") if n.get("lat") and is_closed_gate(
            {t.get("k"): t.get("v") for t in n.findall("tag")})]
        self.above = set()  # nodes of bridges and of what leads to them
        for way in root.iter("way"):
            tags = {t.get("k"): t.get("v") for t in way.findall("tag")}
            if "highway" in tags and (tags.get("bridge", "no") != "no" or tags.get("layer", "0")[0] not in "-0"):
                self.above.update(self.nodes[n.get("ref")] for n in way.findall("nd") if n.get("ref") in self.nodes)
        self.ways = [(int(w.get("id")), {t.get("k"): t.get("v") for t in w.findall("tag")},
                      [self.nodes[n.get("ref")] for n in w.findall("nd") if n.get("ref") in self.nodes])
                     for w in root.iter("way")]
        points = {way: points for way, _, points in self.ways}
        self.buildings = [points for _, tags, points in self.ways if is_building(tags)]
        for relation in root.iter("relation"):
            if is_building({t.get("k"): t.get("v") for t in relation.findall("tag")}):
                self.buildings += [points[int(m.get("ref"))] for m in relation.findall("member")
                                   if m.get("type") == "way" and int(m.get("ref")) in points and m.get("role") != "inner"]
        low, high = self.project(self.south, self.west), self.project(self.north, self.east)
        other = self.project(self.south, self.east), self.project(self.north, self.west)
        margin = 0.5  # the avatar's own breadth, and some
        self.box = (max(low[0], other[1][0]) + margin, max(low[1], other[0][1]) + margin,
                    min(high[0], other[0][0]) - margin, min(high[1], other[1][1]) - margin)

    def project(self, latitude, longitude):
        """East and north of the middle, in the plane that touches the Earth there."""
        d = [p - o for p, o in zip(geocentric(latitude, longitude), self.origin)]
        lat, lon = (math.radians(v) for v in self.middle)
        return (-math.sin(lon) * d[0] + math.cos(lon) * d[1],
                -math.sin(lat) * math.cos(lon) * d[0] - math.sin(lat) * math.sin(lon) * d[1] + math.cos(lat) * d[2])


def is_building(tags):
    """Whether tags are those of a building with walls."""
    return tags.get("building", "no") not in ("no", "roof")


def is_closed_gate(tags):
    """Whether tags are those of a gate that lets no walkers through."""
    refused = tags.get("foot", tags.get("access")) in ("no", "private")
    return "gate" in tags.get("barrier", "") and (refused or (tags.get("locked") == "yes" and "foot" not in tags))


def is_open(tags):
    """Whether the tags let people walk along a way."""
    if tags.get("highway") not in WALKABLE or tags.get("area") == "yes":
        return False
    if "foot" in tags:
        return tags["foot"] not in ("no", "private", "use_sidepath")
    return tags.get("access") not in ("no", "private")


def clipped(a, b, box):
    """The part of a segment inside a box (Liang and Barsky), or None."""
    t0, t1 = 0.0, 1.0
    for axis in (0, 1):
        d = b[axis] - a[axis]
        for low, sign in ((box[axis], 1), (box[axis + 2], -1)):
            p, q = sign * d, sign * (a[axis] - low)
            if p == 0:
                if q < 0:
                    return None
            elif p > 0:
                t0 = max(t0, -q / p)
            else:
                t1 = min(t1, -q / p)
    if t0 >= t1:
        return None
    at = lambda t: (a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]))
    return at(t0), at(t1)


def pieces_of(the_map):
    """The open ways inside the box, cut into pieces."""
    for way, tags, points in the_map.ways:
        if not is_open(tags):
            continue
        for a, b in zip(points, points[1:]):
            inside = clipped(a, b, the_map.box)
            length = math.dist(*inside) if inside else 0.0
            count = math.ceil(length / PIECE)
            for i in range(count):
                at = lambda t: tuple(inside[0][k] + t * (inside[1][k] - inside[0][k]) for k in (0, 1))
                yield Piece(way, at(i / count), at((i + 1) / count), length / count)


class Ground:
    """The heights of a campus' ground: of the triangles of a GLB that face up and belong to no building or thing."""

    CELL = 8.0
    OTHERS = ("building", "door", "tree", "shrub", "bench", "lamp", "wall", "fence", "hedge", "gate", "bollard")

    def __init__(self, glb, bridges=True):
        with open(glb, "rb") as file:
            data = file.read()
        length = struct.unpack_from("<I", data, 12)[0]
        document, self.bin = json.loads(data[20:20 + length]), data[28 + length:]
        self.cells = collections.defaultdict(list)
        for node in document["nodes"]:
            kind = node["name"].split("/")[0]
            if kind in self.OTHERS or (kind == "bridge" and not bridges):
                continue
            for primitive in document["meshes"][node["mesh"]]["primitives"]:
                points = self.read(document, primitive["attributes"]["POSITION"])
                indices = self.read(document, primitive["indices"])
                for i in range(0, len(indices), 3):
                    self.add([points[k] for k in indices[i:i + 3]])

    def read(self, document, number):
        """The values of an accessor."""
        accessor = document["accessors"][number]
        offset = document["bufferViews"][accessor["bufferView"]]["byteOffset"] + accessor["byteOffset"]
        if accessor["type"] == "VEC3":
            values = struct.unpack_from("<%df" % (3 * accessor["count"]), self.bin, offset)
            return list(zip(values[0::3], values[1::3], values[2::3]))
        return struct.unpack_from("<%d%s" % (accessor["count"], {5123: "H", 5125: "I"}[accessor["componentType"]]), self.bin,
                                  offset)

    def add(self, corners):
        """Keeps a triangle, in the plan counter-clockwise, under every cell that it touches."""
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = ((x, -z, y) for x, y, z in corners)
        area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
        if area <= 1e-9:
            return
        triangle = (ax, ay, az, bx, by, bz, cx, cy, cz, area)
        for i in range(math.floor(min(ax, bx, cx) / self.CELL), math.floor(max(ax, bx, cx) / self.CELL) + 1):
            for j in range(math.floor(min(ay, by, cy) / self.CELL), math.floor(max(ay, by, cy) / self.CELL) + 1):
                self.cells[i, j].append(triangle)

    def height(self, p):
        """Of the highest triangle there, or a little beside: positions are rounded to 32 bits. 0 for none."""
        beside = 0.02
        near = ((0, 0), (beside, 0), (-beside, 0), (0, beside), (0, -beside))
        return max((h for dx, dy in near for h in self.heights((p[0] + dx, p[1] + dy))), default=0.0)

    def heights(self, p):
        """Of all triangles there."""
        heights = []
        for ax, ay, az, bx, by, bz, cx, cy, cz, area in self.cells.get((math.floor(p[0] / self.CELL),
                                                                       math.floor(p[1] / self.CELL)), ()):
            u = ((bx - p[0]) * (cy - p[1]) - (cx - p[0]) * (by - p[1])) / area
            v = ((cx - p[0]) * (ay - p[1]) - (ax - p[0]) * (cy - p[1])) / area
            if u >= -1e-6 and v >= -1e-6 and u + v <= 1 + 1e-6:
                heights.append(u * az + v * bz + (1 - u - v) * cz)
        return heights


def backwards(piece):
    """The same from its end."""
    return Piece(piece.way, piece.end, piece.start, piece.length)


def box_of(points):
    """South-west and north-east."""
    return (min(p[0] for p in points), min(p[1] for p in points), max(p[0] for p in points), max(p[1] for p in points))


def distance_to(p, a, b):
    """From a point to a segment."""
    d = (b[0] - a[0], b[1] - a[1])
    length2 = d[0] * d[0] + d[1] * d[1]
    t = max(0.0, min(1.0, ((p[0] - a[0]) * d[0] + (p[1] - a[1]) * d[1]) / length2)) if length2 else 0.0
    return math.dist(p, (a[0] + t * d[0], a[1] + t * d[1]))


def is_inside(p, outlines):
    """Whether somebody at a point is inside of a ring or touches it."""
    touch = 0.35
    for ring, box in outlines:
        if not (box[0] - touch <= p[0] <= box[2] + touch and box[1] - touch <= p[1] <= box[3] + touch):
            continue
        inside = False
        for a, b in zip(ring, ring[1:] + ring[:1]):
            if (a[1] > p[1]) != (b[1] > p[1]) and p[0] < (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1]) + a[0]:
                inside = not inside
        if inside or any(distance_to(p, a, b) < touch for a, b in zip(ring, ring[1:])):
            return True
    return False


def heights_in(the_map, glb):
    """How high somebody stands who is at a point of a way: on the bridge if that way is one or leads to one, else below it."""
    with_bridges, without = Ground(glb), Ground(glb, bridges=False)
    led = {way for way, _, points in the_map.ways if any(p in the_map.above for p in points)}
    return lambda way, p: (with_bridges if way in led else without).height(p)


def walk_of(pieces, campus, height):
    """A walk along each of them, from its start."""
    steps = []
    for piece in pieces:
        x, y = piece.start
        at = "[%.4f, %.4f, %.4f]" % (x, height(piece.way, piece.start), -y)
        steps.append("  - %s: {at: %s}" % ("teleport" if steps else "spawn", at))
        steps.append("  - walk_to: {to: [%.4f, %.4f], if_blocked: continue}" % (piece.end[0], -piece.end[1]))
    return "campus: %s\navatar: adult\nsteps:\n%s\nexpect:\n  - not: {reaches: {place: [0, 9999, 0]}}\n" % (
        json.dumps(campus), "\n".join(steps))


def play(program, pieces, folder, height):
    """How each piece ended: the events avatar.arrive and avatar.blocked."""
    folder = os.path.abspath(folder)
    campus = next(f for f in sorted(os.listdir(folder)) if f.endswith(".campus.yaml"))
    walk = os.path.join(folder, "walked-ways.walk.yaml")
    with tempfile.TemporaryDirectory() as scratch:
        log = os.path.join(scratch, "log.jsonl")
        try:
            with open(walk, "w", encoding="utf-8") as file:
                file.write(walk_of(pieces, campus, height))
            done = subprocess.run([program, "run", walk, "--jsonl", log, "--log", os.devnull, "--root", os.path.dirname(folder), "-j1",
                                   "--output", scratch], capture_output=True, text=True, check=False, cwd=folder)
        finally:
            os.remove(walk)
        if not os.path.exists(log):
            raise RuntimeError(done.stdout + done.stderr)
        with open(log, encoding="utf-8") as file:
            ends = [event for event in map(json.loads, file)
                    if event.get("event") in ("avatar.arrive", "avatar.blocked")]
    if len(ends) != len(pieces):
        raise RuntimeError("%d pieces, but %d ends: %s" % (len(pieces), len(ends), done.stdout[-1500:] + done.stderr[-800:]))
    return ends


def walk_all(program, the_map, folder):
    """All pieces, each with the length that was blocked, and why.

    Every walk starts outside of buildings, or where another arrived: who is put into a closed building walks there,
    too. After a piece that is blocked a walk starts anew; a piece that begins inside is walked backwards if need be.
    """
    height = heights_in(the_map, os.path.join(folder, "campus.glb"))
    outlines = [(points, box_of(points)) for points in the_map.buildings if len(points) > 1]
    walked = {}
    left = list(dict.fromkeys(pieces_of(the_map)))
    arrived = {p for piece in left for p in (piece.start, piece.end) if not is_inside(p, outlines)
               and all(math.dist(p, gate) > 0.5 for gate in the_map.closed_gates)}
    order = {piece: i for i, piece in enumerate(left)}
    while True:
        now = [piece if piece.start in arrived else backwards(piece) for piece in left
               if piece.start in arrived or piece.end in arrived]
        if not now:
            break
        for piece, end in zip(now, play(program, now, folder, height)):
            original = piece if piece in order else backwards(piece)
            if end["event"] == "avatar.arrive":
                walked[original] = (0.0, None)
                arrived.add(piece.end)
            else:
                rest = math.dist((end["pos"][0], -end["pos"][2]), piece.end)
                walked[original] = (min(piece.length, rest), end.get("why") or end.get("by") or "timeout")
        left = [piece for piece in left if piece not in walked]
    walked.update({piece: (piece.length, "it is inside of a building where no walk arrives") for piece in left})
    return [(piece, *walked[piece]) for piece in sorted(walked, key=order.get)]


def share_of(walked):
    """Walked length and all length, metres."""
    total = sum(piece.length for piece, _, _ in walked)
    return total - sum(blocked for _, blocked, _ in walked), total


def main():
    """Prints the share, and with --list what is blocked, by way."""
    program, file, folder = os.path.abspath(sys.argv[1]), *sys.argv[2:4]
    the_map = Map(file)
    walked = walk_all(program, the_map, folder)
    good, total = share_of(walked)
    print("%s: %.0f of %.0f m walked, %.2f %%" % (os.path.basename(file), good, total, 100 * good / total))
    if "--list" in sys.argv:
        tags = {way: tags for way, tags, _ in the_map.ways}
        blocked = collections.defaultdict(list)
        for piece, length, why in walked:
            if why:
                blocked[piece.way].append((length, why))
        for way, parts in sorted(blocked.items(), key=lambda item: -sum(length for length, _ in item[1])):
            shown = {k: v for k, v in tags[way].items() if k in ("highway", "layer", "tunnel", "indoor", "level", "covered",
                                                                 "foot", "access", "bridge", "footway")}
            print("  %6.1f m way %d %s: %s" % (sum(length for length, _ in parts), way, shown, parts[0][1][:110]))


if __name__ == "__main__":
    main()
