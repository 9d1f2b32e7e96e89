"""Gatehouse, clock tower, observatory, greenhouse and pavilion: the small, telling buildings."""

from ..exact import cos_deg, sin_deg
from ..mesh import Mesh
from ..polygon import offset, rect
from ..roofs import cone, cornice, gable, hip
from ..shapes import band, beam, lathe, ngon, prism, ring, sphere_net
from ..walls import Opening, WallStyle
from .base import Building, Trigger

PASSAGE = 3.0        # half width of the gate's archway
ARCH_SPRING, ARCH_RISE, ARCH_STEPS = 2.6, 1.6, 12


def _arch_line():
    """Half an ellipse over the passage, from left to right: (x, y)."""
    return [(-PASSAGE * cos_deg(180.0 * i / ARCH_STEPS),
             ARCH_SPRING + ARCH_RISE * sin_deg(180.0 * i / ARCH_STEPS))
            for i in range(ARCH_STEPS + 1)]


def gatehouse():
    """Two lodges and a room over the archway between them."""
    gate = Building("gatehouse")
    depth, lodge_top, middle_top = 3.5, 4.6, 7.6
    style = WallStyle("ashlar", None, "stone")
    lodges = [rect(-10.0, -depth, -PASSAGE, depth), rect(PASSAGE, -depth, 10.0, depth)]
    gate.voids = [offset(lodge, -0.05) for lodge in lodges]
    for i, lodge in enumerate(lodges):
        band(gate.part("plinth"), "stone", lodge, -0.3, 0.6, 0.07, bottom=False)
        front = [Opening(2.0, 1.1, 1.2, 3.0, "stone"), Opening(5.0, 1.1, 1.2, 3.0, "stone")]
        outer = {0: front, 2: front, 1 if i else 3: [Opening(3.5, 1.1, 1.2, 3.0, "stone")]}
        outer[3 if i else 1] = [Opening(3.5, 1.1, 0.1, 2.3, "door")]
        gate.shell(style, lodge, 0.0, lodge_top, outer)
        x0, x1 = (PASSAGE + 1.0, 10.0) if i else (-10.0, -PASSAGE - 1.0)
        cornice(gate.part("roof"), "stone", rect(x0, -depth, x1, depth), lodge_top)
        hip(gate.part("roof"), "slate", (x0, -depth, x1, depth), lodge_top, 2.6, 0.45, "stone")
    _archway(gate, depth, lodge_top, middle_top)
    gate.triggers.append(Trigger("arch", (0.0, 1.5, 0.0), (5.6, 3.0, 7.4)))
    gate.points = {"gate-arch": (0.0, 0.06, 0.0)}
    return gate


def _archway(gate, depth, lodge_top, top):
    mesh, half = gate.part("arch"), PASSAGE + 1.0
    line = _arch_line()
    for (xa, ya), (xb, yb) in zip(line, line[1:]):
        for z, flip in ((depth, False), (-depth, True)):
            face = [(xa, ya, z), (xb, yb, z), (xb, lodge_top, z), (xa, lodge_top, z)]
            mesh.poly("ashlar", face[::-1] if flip else face)
        mesh.quad("ashlar", (xa, ya, -depth), (xb, yb, -depth), (xb, yb, depth), (xa, ya, depth))
        for z0, z1, skip in ((depth, depth + 0.08, "z"), (-depth - 0.08, -depth, "Z")):
            _voussoir(mesh, (xa, ya), (xb, yb), z0, z1, skip)
    body = rect(-half, -depth, half, depth)
    windows = {k: [Opening(half + dx, 0.9, 0.8, 2.3, "stone") for dx in (-2.2, 0.0, 2.2)]
               for k in (0, 2)}
    gate.shell(WallStyle("ashlar", None, "stone"), body, lodge_top, top, windows, "arch",
               footing=0.0)
    band(mesh, "stone", body, lodge_top - 0.1, lodge_top + 0.15, 0.09)
    cornice(gate.part("roof"), "stone", body, top)
    gable(gate.part("roof"), "slate", "ashlar", (-half, -depth, half, depth), top, 3.0, "z", 0.4,
          0.35, "stone")
    mesh.box("signs", (-1.9, 5.0, depth + 0.16), (1.9, 5.4, depth + 0.18), "xXyYzZ")


def _voussoir(mesh, a, b, z0, z1, skip):
    """One stone of the arch's ring, standing out a little from the wall."""
    def out(p):
        dx, dy = p[0] / PASSAGE, (p[1] - ARCH_SPRING) / ARCH_RISE
        return p[0] + 0.4 * dx, p[1] + 0.4 * dy
    (ax, ay), (bx, by), (cx, cy), (dx, dy) = a, b, out(b), out(a)
    z = z1 if skip == "z" else z0
    face = [(ax, ay, z), (bx, by, z), (cx, cy, z), (dx, dy, z)]
    mesh.poly("stone", face if skip == "z" else face[::-1])
    mesh.quad("stone", (dx, dy, z0), (dx, dy, z1), (cx, cy, z1), (cx, cy, z0))
    mesh.quad("stone", (ax, ay, z0), (bx, by, z0), (bx, by, z1), (ax, ay, z1))


def clock_tower():
    """Twenty-nine metres of brick with stone bands, four clock faces and a copper spire."""
    tower = Building("clock-tower")
    base, shaft = rect(-3.2, -3.2, 3.2, 3.2), rect(-2.8, -2.8, 2.8, 2.8)
    tower.voids = [rect(-3.1, -3.1, 3.1, 3.1)]
    walls = tower.part("walls")
    band(tower.part("plinth"), "stone", base, -0.3, 0.9, 0.1, bottom=False)
    tower.shell(WallStyle("ashlar", None, "stone"), base, 0.0, 4.4,
                {0: [Opening(3.2, 1.3, 0.1, 2.5, "door")]})
    band(walls, "stone", base, 4.2, 4.6, 0.15)
    walls.poly("stone", [(x, 4.6, z) for x, z in base])
    slots = [Opening(2.8, 0.7, y, y + 1.7, "stone") for y in (1.4, 5.2, 9.0)]
    tower.shell(WallStyle("brick_red", None, "stone"), shaft, 4.5, 17.0,
                {k: slots for k in range(4)}, footing=0.0)
    for y in (8.4, 12.4, 16.6):
        band(walls, "stone", shaft, y, y + 0.35, 0.1)
    for x in (-2.8, 2.8):
        for z in (-2.8, 2.8):
            prism(walls, "brick_red", rect(x - 0.35, z - 0.35, x + 0.35, z + 0.35), 4.5, 17.0)
    stage = rect(-3.0, -3.0, 3.0, 3.0)
    prism(walls, "ashlar", stage, 16.9, 21.6, bottom=True)
    cornice(walls, "stone", stage, 21.8)
    _clock_faces(tower, 3.0, 19.2)
    belfry = rect(-2.5, -2.5, 2.5, 2.5)
    arches = [Opening(x, 1.3, 0.5, 3.0, "slot") for x in (1.5, 3.5)]
    tower.shell(WallStyle("ashlar", None, "stone"), belfry, 21.7, 25.6, {k: arches for k in range(4)},
                footing=0.0)
    cornice(tower.part("roof"), "stone", belfry, 25.8)
    cone(tower.part("roof"), "copper", belfry, 25.8, 6.4, 0.4, "stone")
    lathe(tower.part("roof"), "brass", [(0.05, 31.9), (0.05, 33.0), (0.22, 33.2), (0.0, 33.5)], 8)
    tower.door_trigger(0.0, 0.1, 3.4)
    tower.points = {"clock-tower-door": (0.0, 0.06, 4.4), "clock-face": (0.0, 19.2, 3.1)}
    return tower


def _clock_faces(tower, half, y):
    face = Mesh()
    rim = ngon(24, 1.7)
    points = [(x, z) for x, z in rim]
    face.poly("clock", [(x, -z, 0.10) for x, z in points],
              [(0.5 + x / 3.4, 0.5 + z / 3.4) for x, z in points])
    for i, (ax, az) in enumerate(points):
        bx, bz = points[(i + 1) % len(points)]
        face.quad("stone", (ax * 1.12, -az * 1.12, 0.0), (bx * 1.12, -bz * 1.12, 0.0),
                  (bx, -bz, 0.16), (ax, -az, 0.16))
        face.quad("stone", (ax, -az, 0.16), (bx, -bz, 0.16), (bx, -bz, 0.10), (ax, -az, 0.10))
    for yaw in (0.0, 90.0, 180.0, 270.0):
        tower.prop("clock", face, (half * sin_deg(yaw), y, half * cos_deg(yaw)), yaw)


def observatory():
    """A round brick drum under a copper dome with an open slit, and a low annex."""
    house = Building("observatory")
    drum, annex = ngon(20, 6.2), rect(-3.2, 3.0, 3.2, 9.6)
    house.voids = [ngon(20, 6.1), rect(-3.1, 3.0, 3.1, 9.5)]
    band(house.part("plinth"), "stone", drum, -0.3, 0.7, 0.08, bottom=False)
    side = 2 * 6.2 * sin_deg(9.0)
    slots = {k: [Opening(side / 2, 0.8, 3.4, 5.4, "stone")] for k in range(0, 20, 2)}
    house.shell(WallStyle("brick_buff", None, "stone"), drum, 0.0, 6.6, slots)
    walls, dome = house.part("walls"), house.part("dome")
    band(walls, "stone", drum, 2.6, 2.85, 0.07)
    band(walls, "stone", drum, 6.4, 6.75, 0.45)
    walls.poly("stone", [(x, 6.75, z) for x, z in drum])
    for x, z in offset(drum, 0.36):
        walls.box("iron", (x - 0.025, 6.75, z - 0.025), (x + 0.025, 7.7, z + 0.025), "y")
    rail = offset(drum, 0.36)
    for i, (ax, az) in enumerate(rail):
        bx, bz = rail[(i + 1) % len(rail)]
        beam(walls, "iron", (ax, 7.66, az), (bx, 7.66, bz), 0.05, 0.04)
    profile = [(5.9, 6.7), (5.9, 7.3)] + [(5.9 * cos_deg(a), 7.3 + 5.9 * sin_deg(a))
                                         for a in (10, 20, 30, 40, 50, 60, 70, 80, 90)]
    lathe(dome, "copper", profile[:-1] + [(0.0, profile[-1][1])], 28, uv_around=10.0)
    for k in range(9):  # the slit: dark strips over the dome, flanked by two rails
        a0, a1 = 12.0 + 9.0 * k, 12.0 + 9.0 * (k + 1)
        for x0, x1, out, material in ((-0.8, 0.8, 0.06, "iron"), (-0.95, -0.8, 0.16, "metal"),
                                      (0.8, 0.95, 0.16, "metal")):
            _dome_strip(dome, material, x0, x1, 5.9 + out, 7.3, a0, a1)
    band(house.part("plinth"), "stone", annex, -0.3, 0.5, 0.06, bottom=False)
    house.shell(WallStyle("brick_buff", None, "stone"), annex, 0.0, 3.4,
                {0: [Opening(3.2, 1.3, 0.1, 2.4, "door")],
                 1: [Opening(2.4, 1.1, 1.0, 2.5, "sash")], 3: [Opening(4.2, 1.1, 1.0, 2.5, "sash")]},
                "annex")
    gable(house.part("annex"), "copper", "brick_buff", (-3.2, 3.0, 3.2, 9.6), 3.4, 1.6, "z", 0.4,
          0.3, "stone")
    house.door_trigger(0.0, 0.1, 9.9)
    house.points = {"observatory-door": (0.0, 0.06, 10.6)}
    return house


def _dome_strip(mesh, material, x0, x1, radius, y, a0, a1):
    """A piece of a band over the dome, in the plane x = 0, towards +z."""
    def at(x, angle, r):
        return x, y + r * sin_deg(angle), r * cos_deg(angle)
    mesh.quad(material, at(x0, a0, radius), at(x1, a0, radius), at(x1, a1, radius),
              at(x0, a1, radius))
    low = radius - 0.4
    mesh.quad(material, at(x1, a0, radius), at(x1, a0, low), at(x1, a1, low), at(x1, a1, radius))
    mesh.quad(material, at(x0, a0, low), at(x0, a0, radius), at(x0, a1, radius), at(x0, a1, low))


def greenhouse():
    """A glass house on a brick sill: white ribs, clear panes, beds of plants inside."""
    house = Building("greenhouse")
    half_x, half_z, sill, eaves, ridge = 11.0, 4.5, 0.7, 2.8, 5.0
    outline = rect(-half_x, -half_z, half_x, half_z)
    house.voids = [offset(outline, -0.05)]
    ring(house.part("walls"), "brick_red", outline, -0.3, sill, 0.25)
    house.floor("gravel", outline, 0.06)
    glass, frame = house.part("glass"), house.part("frame")
    for x in (-half_x, half_x):
        face = [(x, sill, half_z), (x, sill, -half_z), (x, eaves, -half_z), (x, ridge, 0.0),
                (x, eaves, half_z)]
        glass.poly("clear_glass", face if x > 0 else face[::-1])
    for z in (-half_z, half_z):
        side = [(-half_x, sill, z), (half_x, sill, z), (half_x, eaves, z), (-half_x, eaves, z)]
        slope = [(-half_x, eaves, z), (half_x, eaves, z), (half_x, ridge, 0.0),
                 (-half_x, ridge, 0.0)]
        for face in (side, slope):
            glass.poly("clear_glass", face if z > 0 else face[::-1])
    for k in range(12):
        x = -half_x + 2 * half_x * k / 11
        for z in (-half_z, half_z):
            frame.box("frame_white", (x - 0.05, sill, z - 0.05), (x + 0.05, eaves, z + 0.05), "yY")
            beam(frame, "frame_white", (x, eaves - 0.05, z * 1.01), (x, ridge - 0.05, 0.0), 0.08, 0.1)
    for y, z in ((sill, half_z), (sill, -half_z), (eaves, half_z), (eaves, -half_z), (ridge, 0.0)):
        frame.box("frame_white", (-half_x - 0.03, y - 0.04, z - 0.06),
                  (half_x + 0.03, y + 0.08, z + 0.06))
    for x in (-half_x, half_x):
        frame.box("frame_white", (x - 0.05, eaves - 0.04, -half_z - 0.03),
                  (x + 0.05, eaves + 0.06, half_z + 0.03))
    house.part("frame").box("door_wood", (-0.6, 0.0, half_z - 0.09), (0.6, 2.3, half_z + 0.09), "y")
    _beds(house, half_x)
    house.door_trigger(0.0, 0.06, half_z + 0.4)
    house.points = {"greenhouse-door": (0.0, 0.06, half_z + 1.3)}
    return house


def _beds(house, half_x):
    """Two raised beds with round shrubs."""
    points, faces = sphere_net(1)
    shrub = Mesh()
    for a, b, c in faces:
        shrub.poly("leaves_lime", [points[i] for i in (a, b, c)],
                   normals=[points[i] for i in (a, b, c)])
    beds = house.part("beds")
    for z in (-2.6, 2.6):
        beds.box("wood_dark", (-half_x + 1.0, 0.06, z - 1.1), (half_x - 1.0, 0.75, z + 1.1), "yY")
        beds.poly("soil", [(-half_x + 1.0, 0.7, z + 1.1), (half_x - 1.0, 0.7, z + 1.1),
                           (half_x - 1.0, 0.7, z - 1.1), (-half_x + 1.0, 0.7, z - 1.1)])
        for k in range(9):
            house.prop("shrub", shrub, (-half_x + 2.0 + 2.2 * k, 0.95, z), 40.0 * k,
                       0.5 + 0.13 * (k * 7 % 5))


def pavilion():
    """An open octagon by the pond: eight posts, a railing, a tiled tent roof."""
    house = Building("pavilion")
    floor, rim = ngon(8, 4.6, start_deg=22.5), ngon(8, 4.2, start_deg=22.5)
    house.voids = [floor]
    prism(house.part("floor"), "stone", floor, -0.3, 0.20, cap_material="slabs")
    frame = house.part("frame")
    for x, z in rim:
        frame.box("frame_white", (x - 0.11, 0.2, z - 0.11), (x + 0.11, 3.1, z + 0.11), "yY")
        frame.box("frame_white", (x - 0.17, 0.2, z - 0.17), (x + 0.17, 0.5, z + 0.17), "y")
    for i, (ax, az) in enumerate(rim):
        bx, bz = rim[(i + 1) % 8]
        beam(frame, "frame_white", (ax, 2.85, az), (bx, 2.85, bz), 0.14, 0.25)
        if abs(az + bz) < 6.0:  # open towards +z and -z
            beam(frame, "frame_white", (ax, 1.05, az), (bx, 1.05, bz), 0.08, 0.08)
            for k in range(1, 8):
                x, z = ax + (bx - ax) * k / 8, az + (bz - az) * k / 8
                frame.box("frame_white", (x - 0.02, 0.2, z - 0.02), (x + 0.02, 1.05, z + 0.02), "yY")
    cone(house.part("roof"), "roof_tiles_brown", rim, 3.1, 2.3, 0.6, "wood")
    lathe(house.part("roof"), "brass", [(0.06, 5.4), (0.16, 5.7), (0.0, 6.0)], 8)
    house.triggers.append(Trigger("inside", (0.0, 1.4, 0.0), (6.4, 2.4, 6.4)))
    house.points = {"pavilion-middle": (0.0, 0.2, 0.0)}
    return house
