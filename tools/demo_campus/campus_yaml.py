"""Writes config/demo.campus.yaml: the description that belongs to the models."""

from . import furniture, outfitting
from .layout import FOUNTAIN, FOUNTAIN_RADIUS, POND_CENTRE, POND_LEVEL, POND_RADII, ROAD_Z
from .records import RECORDS
from .vegetation import SPECIES, TREE_COLLIDER_HEIGHT

MODEL_FOLDER = "../campus_assets/demo"
HEADER = """\
# yaml-language-server: $schema=schema/campus.schema.json
# The demo campus: a gate, an avenue, a square, thirteen buildings and a pond.
# Written by tools/make-demo-campus together with the models, so that the numbers agree;
# change tools/demo_campus/ and run it again.
# Frame: metres, +Y up, +X east, +Z south; yaw 0 looks north (-Z), positive turns left.

"""
GROUND_NODES = ["terrain", "road_*", "path_*", "kerb_*", "square", "pond_basin", "pond_coping"]


def _number(value):
    text = "%.3f" % (value + 0.0)
    text = text.rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


def _vector(values):
    return "[%s]" % ", ".join(_number(v) for v in values)


def _text(value):
    """A double-quoted YAML scalar."""
    return '"%s"' % value.replace("\\", "\\\\").replace('"', '\\"')


def _names(values):
    return "[%s]" % ", ".join(_text(v) for v in values)


class _Colliders:
    """The collider list, one entry at a time."""

    def __init__(self):
        self.lines = ["colliders:"]

    def add(self, name, **fields):
        self.lines.append("  - id: %s" % name)
        self.lines += ["    %s: %s" % (key, value) for key, value in fields.items()]

    def each(self, name, glob, shape, layer="furniture", **fields):
        self.add(name, nodes=_names([glob]), each="true", shape=shape, mode="solid", layer=layer,
                 **fields)

    def note(self, text):
        self.lines.append("  # " + text)


def _buildings(campus):
    lines = ["buildings:"]
    for building in campus.buildings:
        record, node = RECORDS[building.id], building.node_name
        lines += ["  - id: %s" % building.id, "    nodes: %s" % _names([node, node + "_*"]),
                  "    title: %s" % _text(record.title), "    kind: %s" % record.kind,
                  "    text: %s" % _text(record.text), "    hours: %s" % _text(record.hours),
                  "    floors: %d" % record.floors]
    return lines


def _building_colliders(out, campus):
    out.note("Buildings: their walls, and trigger boxes at doors and in rooms.")
    for building in campus.buildings:
        out.add(building.id + "/walls", building=building.id, shape="mesh", mode="[solid, ray]",
                layer="buildings")
        for trigger in building.triggers:
            fields = {"building": building.id, "shape": "box",
                      "center": _vector(building.place.point(*trigger.centre)),
                      "size": _vector(trigger.size)}
            if building.place.yaw_deg:
                fields["yaw_deg"] = _number(building.place.yaw_deg)
            out.add("%s/%s" % (building.id, trigger.name), mode="trigger", layer="buildings",
                    **fields)
    tower = next(b for b in campus.buildings if b.id == "clock-tower")
    out.add("clock-tower/face", building="clock-tower", shape="box",
            center=_vector(tower.place.point(0.0, 19.2, 3.05)), size="[3.6, 3.6, 0.3]", mode="ray",
            layer="buildings")


def _furniture_colliders(out, campus):
    out.note("Street furniture. Notice boards are seen by rays only: one may walk through them.\n"
             "  # Name boards are meshes: who is small passes between their posts.")
    out.each("flower-bed", "flower_bed_*", "box")
    out.each("planter", "planter_*", "box")
    out.each("bench", "bench_*", "box")
    out.each("lamp", "lamp_*", "capsule", radius="0.16", height="3.9")
    out.each("bin", "bin_*", "capsule", radius="0.28", height="0.95")
    out.each("bicycle-stand", "bicycle_stand_*", "box")
    out.each("sign", "sign_*", "mesh")
    out.each("boundary", "boundary_wall_*", "box")
    out.each("fence", "fence_*", "box")
    out.add("notice-board", nodes=_names(["notice_board_*"]), each="true", shape="box", mode="ray",
            layer="furniture")
    x, z = FOUNTAIN
    y = campus.paving.top(x, z)
    out.add("fountain", shape="wheel", center=_vector((x, y + 0.26, z)),
            radius=_number(FOUNTAIN_RADIUS + 0.06), width="0.52", axis="y", mode="[solid, ray]",
            layer="furniture")
    out.add("fountain/jet", shape="capsule", base=_vector((x, y, z)), radius="0.9", height="2.3",
            mode="[solid, ray]", layer="furniture")
    for i, (x, z) in enumerate(outfitting.BOLLARDS):
        y = campus.paving.top(x, z)
        out.add("bollard/%d" % (i + 1), shape="wheel", center=_vector((x, y + 0.4, z)), radius="0.18",
                width="1.0", axis="y", mode="solid", layer="furniture")
    x, z = outfitting.SCULPTURE
    y = campus.paving.top(x, z)
    out.add("sculpture/sphere", shape="sphere",
            center=_vector((x, y + furniture.SCULPTURE_HEIGHT, z)),
            radius=_number(furniture.SCULPTURE_RADIUS), mode="[solid, ray]", layer="furniture")
    out.add("sculpture/plinth", shape="box", center=_vector((x, y + 0.5, z)),
            size="[1.56, 1.0, 1.56]", mode="[solid, ray]", layer="furniture")


def _colliders(campus):
    out = _Colliders()
    out.add("ground", nodes=_names(GROUND_NODES), shape="mesh", mode="[solid, ray]", layer="ground")
    _building_colliders(out, campus)
    out.note("Plants.")
    for species, (_, radius, _) in SPECIES.items():
        out.each("tree/" + species, "tree_%s_*" % species, "capsule", "trees",
                 radius=_number(radius), height=_number(TREE_COLLIDER_HEIGHT))
    out.each("hedge", "hedge_*", "box", "trees")
    _furniture_colliders(out, campus)
    out.note("Places that report who enters them.")
    out.add("pond/water", shape="box",
            center=_vector((POND_CENTRE[0], POND_LEVEL - 0.7, POND_CENTRE[1])),
            size=_vector((2 * POND_RADII[0] - 2.0, 0.6, 2 * POND_RADII[1] - 2.0)), mode="trigger",
            layer="water")
    out.add("square/centre", shape="wheel", center=_vector(_ground(campus, *FOUNTAIN, 1.0)),
            radius="9", width="2", axis="y", mode="trigger", layer="ground")
    return out.lines


def _ground(campus, x, z, lift=0.0):
    return x, campus.paving.top(x, z) + lift, z


SPAWNS = {"main-gate": (0.0, 89.0, 0.0), "square-south": (0.0, 26.0, 0.0),
          "pond-side": (90.5, 64.0, 90.0),
          "north": (22.0, -66.0, 180.0), "west-road": (-104.0, 0.0, 0.0)}
OUTDOOR_PLACES = {
    "avenue-south": (0.0, 66.0), "avenue-bench": (0.0, 62.0), "avenue-tree": (0.0, 58.0),
    "avenue": (0.0, 50.0), "avenue-north": (0.0, 34.0), "square": (0.0, 17.0),
    "square-north": (0.0, -6.0), "square-east": (7.5, 11.0), "square-west": (-7.5, 11.0),
    "bed-approach": (9.0, 32.0), "bed-side": (12.8, 23.2), "bed-east": (12.8, 17.0),
    "theatre-path": (-14.0, 50.0), "cafeteria-path": (16.0, 50.0),
    "admin-path": (-31.0, 8.0), "science-path": (34.0, 8.0), "pond-quay": (59.0, 64.0),
    "pond-beach": (88.5, 64.0), "pond-walk-north": (74.0, 49.5), "gallery-path": (-66.0, 74.0),
    "sports-path": (-60.0, -51.6), "dorm-path": (60.0, -46.0), "observatory-path": (22.0, -66.0),
    "greenhouse-path": (-25.7, -66.0), "road": (0.0, ROAD_Z),
    "library-sign-south": (-12.8, -9.5), "library-sign-north": (-12.8, -14.0),
}


def _places(campus):
    places = {name: _ground(campus, x, z) for name, (x, z) in OUTDOOR_PLACES.items()}
    x, z, _ = outfitting.BENCHES[0][:3]
    places["bench"] = _ground(campus, x, z)
    x, z = outfitting.BEDS[0][:2]
    places["flower-bed"] = _ground(campus, x, z)
    tree = min((n for n in campus.scenes["vegetation.glb"] if n.name.startswith("tree_")),
               key=lambda n: (n.at[0] + 4.7) ** 2 + (n.at[2] - 58.0) ** 2)
    places["tree"] = tree.at
    places["pond-middle"] = (POND_CENTRE[0], POND_LEVEL - 1.0, POND_CENTRE[1])
    for building in campus.buildings:
        for name, point in building.points.items():
            places[name] = building.place.point(*point)
    return places


def write_campus_yaml(path, campus):
    """Writes the description."""
    lines = ["scenes:"]
    lines += ["  - file: %s/%s" % (MODEL_FOLDER, name) for name in campus.scenes]
    lines += ["layers: [ground, buildings, trees, furniture, water]", ""]
    lines += _buildings(campus) + [""] + _colliders(campus) + ["", "spawns:"]
    for name, (x, z, yaw) in SPAWNS.items():
        lines.append("  %s: {at: %s, yaw_deg: %s}" % (name, _vector(_ground(campus, x, z)),
                                                      _number(yaw)))
    lines += ["", "places:  # floor height"]
    lines += ["  %s: %s" % (name, _vector(point)) for name, point in _places(campus).items()]
    with open(path, "w", encoding="utf-8", newline="\n") as out:
        out.write(HEADER + "\n".join(lines) + "\n")
