"""Administration, science block, dormitory and sports hall: large houses seen from outside."""

from ..mesh import Mesh
from ..polygon import rect
from ..roofs import barrel, cone, cornice, flat, gable, hip
from ..shapes import band, prism
from ..stairs import front_steps
from ..walls import Opening, WallStyle, row
from .base import Building, Trigger


def _storeys(length, count, width, height, sill, pitch, storeys, style, skip=()):
    """Rows of windows, one a storey."""
    out = []
    for k in range(storeys):
        bottom = sill + pitch * k
        out += row(length, count, width, bottom, bottom + height, style,
                   skip=skip if k == 0 else ())
    return out


def admin():
    """A three-winged brick house around a court, with a stone door case and a small turret."""
    house = Building("admin")
    outline = [(-20, 14), (-10, 14), (-10, -2), (10, -2), (10, 14), (20, 14), (20, -14), (-20, -14)]
    style = WallStyle("brick_red", None, "stone", 0.3)
    storey, top = 3.5, 11.0
    house.voids = [rect(-19.9, -13.9, 19.9, -2.05), rect(-19.9, -2.1, -10.05, 13.9),
                   rect(10.05, -2.1, 19.9, 13.9)]

    def windows(length, count, skip=()):
        return _storeys(length, count, 1.1, 1.9, 1.1, storey, 3, "sash", skip)
    court = windows(20.0, 7, (3,)) + [Opening(10.0, 1.6, 0.35, 2.85, "door")]
    openings = {0: windows(10.0, 3), 1: windows(16.0, 5), 2: court, 3: windows(16.0, 5),
                4: windows(10.0, 3), 5: windows(28.0, 8), 6: windows(40.0, 11),
                7: windows(28.0, 8)}
    band(house.part("plinth"), "stone", outline, -0.3, 0.75, 0.07, bottom=False)
    house.shell(style, outline, 0.0, top, openings)
    walls, roof = house.part("walls"), house.part("roof")
    for y in (storey + 0.15, 2 * storey + 0.15):
        band(walls, "stone", outline, y, y + 0.22, 0.06)
    for x, z in outline:  # rusticated corners
        for k in range(13):
            half = 0.34 if k % 2 else 0.26
            prism(walls, "stone", rect(x - half, z - half, x + half, z + half),
                  0.75 + 0.76 * k, 0.75 + 0.76 * k + 0.38, bottom=True)
    cornice(roof, "stone", outline, top)
    hip(roof, "slate", (-20, -14, 20, -2), top, 3.8, 0.5, "stone")
    hip(roof, "slate", (-20, -14, -10, 14), top, 3.5, 0.5, "stone")
    hip(roof, "slate", (10, -14, 20, 14), top, 3.5, 0.5, "stone")
    for x, z in ((-15, -6), (15, -6), (-6, -10), (6, -10)):
        prism(roof, "brick_red", rect(x - 0.5, z - 0.8, x + 0.5, z + 0.8), top + 1.0, top + 5.2)
        band(roof, "stone", rect(x - 0.5, z - 0.8, x + 0.5, z + 0.8), top + 4.8, top + 5.25, 0.1)
    _turret(roof, top + 3.2)
    porch = house.part("steps")
    prism(porch, "stone", rect(-2.0, -2.0, 2.0, -0.6), -0.3, 0.34)
    front_steps(porch, -2.0, 2.0, -0.6, 0.34, 2)
    house.door_trigger(0.0, 0.34, -1.2)
    house.triggers.append(Trigger("court", (0.0, 1.5, 6.0), (19.0, 3.0, 15.0)))
    house.points = {"admin-court": (0.0, 0.06, 8.0), "admin-door": (0.0, 0.34, -1.2)}
    return house


def _turret(mesh, y):
    """A ridge turret with louvres and a copper cap."""
    body = rect(-1.3, -9.3, 1.3, -6.7)
    prism(mesh, "frame_white", body, y, y + 2.6, top=False)
    band(mesh, "frame_white", body, y + 2.3, y + 2.6, 0.15)
    for k in range(5):
        band(mesh, "frame_dark", rect(-0.8, -8.8, 0.8, -7.2), y + 1.0 + 0.22 * k,
             y + 1.08 + 0.22 * k, 0.54)
    cone(mesh, "copper", body, y + 2.6, 2.4, 0.3)


def science():
    """Four glazed floors between concrete slabs and fins, a stair tower at one end."""
    block = Building("science")
    body = rect(-15.0, -7.0, 15.0, 7.0)
    block.voids = [rect(-16.0, -8.0, 16.0, 8.0)]
    storey, floors = 3.5, 4
    top = storey * floors + 0.5
    walls = block.part("walls")
    prism(walls, "curtain_glass", body, 0.4, top, top=False)
    band(block.part("plinth"), "concrete", body, -0.3, 0.5, 0.35, bottom=False)
    for k in range(1, floors + 1):
        band(walls, "concrete", body, storey * k + 0.1, storey * k + 0.55, 0.55)
    fin = Mesh()
    fin.box("frame_dark", (-0.05, 0.5, 0.0), (0.05, top - 0.4, 0.42), "yYz")
    for z, yaw in ((7.0, 0.0), (-7.0, 180.0)):
        for k in range(16):
            if not (yaw == 0.0 and k in (7, 8)):
                block.prop("fin", fin, (-15.0 + 2.0 * k, 0.0, z), yaw)
    for x, yaw in ((15.0, 90.0), (-15.0, -90.0)):
        for k in range(8):
            block.prop("fin", fin, (x, 0.0, -7.0 + 2.0 * k), yaw)
    tower = rect(11.0, 4.0, 16.0, 8.0)
    prism(walls, "concrete", tower, -0.3, top + 3.2)
    band(walls, "concrete", tower, top + 2.9, top + 3.3, 0.12)
    for k in range(4):
        walls.box("frame_dark", (12.2, 1.2 + storey * k, 8.0), (14.8, 2.6 + storey * k, 8.03), "z")
        walls.box("glass", (12.3, 1.3 + storey * k, 8.03), (14.7, 2.5 + storey * k, 8.04), "z")
    flat(block.part("roof"), body, [body], top, 0.6, "concrete", "metal")
    block.part("roof").box("cladding", (-9.0, top, -4.0), (5.0, top + 2.4, 3.0), "y")
    for k in range(4):
        prism(block.part("roof"), "metal", rect(-12.6 + 0.9 * k, -2.0, -12.0 + 0.9 * k, 2.0),
              top, top + 1.1)
    _canopy(block)
    block.door_trigger(0.0, 0.06, 7.6, 4.0)
    block.points = {"science-door": (0.0, 0.06, 8.6)}
    return block


def _canopy(block):
    """The entrance: sliding doors under a thin roof on two posts."""
    door = block.part("entrance")
    door.box("frame_dark", (-2.2, -0.1, 7.0), (2.2, 3.2, 7.75), "yz")
    for x in (-1.9, 0.05):
        door.box("glass", (x, 0.1, 7.75), (x + 1.85, 2.6, 7.78), "z")
    door.box("signs", (-1.5, 2.75, 7.75), (1.5, 3.05, 7.77), "xXyYzZ")
    prism(door, "concrete", rect(-3.4, 7.3, 3.4, 10.2), 3.2, 3.5, bottom=True)
    for x in (-3.0, 3.0):
        door.box("frame_dark", (x - 0.08, -0.2, 9.7), (x + 0.08, 3.2, 9.86), "yY")


def dorm():
    """An L of four rendered storeys with balconies under tiled roofs."""
    house = Building("dorm")
    outline = [(-18, 8), (18, 8), (18, -18), (6, -18), (6, -4), (-18, -4)]
    house.voids = [rect(-17.9, -3.9, 17.9, 7.9), rect(6.1, -17.9, 17.9, -3.8)]
    storey, storeys = 2.9, 4
    top = storey * storeys + 0.5
    style = WallStyle("plaster_ochre", None, "plaster", 0.3)

    def windows(length, count, skip=(), width=1.2):
        return _storeys(length, count, width, 1.4, 1.3, storey, storeys, "casement", skip)
    front = windows(36.0, 11, (5,)) + [Opening(18.0, 1.6, 0.12, 2.4, "door")]
    openings = {0: front, 1: windows(26.0, 8), 2: windows(12.0, 3), 3: windows(14.0, 4),
                4: windows(24.0, 7), 5: windows(12.0, 3)}
    band(house.part("plinth"), "plaster_teal", outline, -0.3, 0.9, 0.05, bottom=False)
    house.shell(style, outline, 0.0, top, openings)
    walls, roof = house.part("walls"), house.part("roof")
    band(walls, "plaster", outline, top - 0.3, top, 0.08)
    gable(roof, "roof_tiles", "plaster_ochre", (-18, -4, 18, 8), top, 3.6, "x", 0.6)
    gable(roof, "roof_tiles", "plaster_ochre", (6, -18, 18, 2), top, 3.5, "z", 0.6)
    balcony = Mesh()
    balcony.box("concrete", (-1.1, -0.15, 0.0), (1.1, 0.0, 1.2), "z")
    balcony.box("plaster_teal", (-1.1, 0.0, 1.14), (1.1, 0.95, 1.2), "y")
    for x in (-1.1, 1.04):
        balcony.box("plaster_teal", (x, 0.0, 0.0), (x + 0.06, 0.95, 1.14), "yzZ")
    pitch = (36.0 - 2.4) / 11
    for k in range(1, storeys):
        for i in (0, 2, 4, 6, 8, 10):
            house.prop("balcony", balcony, (-18 + 1.2 + pitch * (i + 0.5), 0.95 + storey * k, 8.0))
    prism(house.part("entrance"), "concrete", rect(-2.0, 8.02, 2.0, 9.8), 2.9, 3.1, bottom=True)
    prism(house.part("entrance"), "concrete", rect(-1.4, 8.0, 1.4, 9.4), -0.3, 0.10)
    for x, z in ((-9, 2), (9, 2), (12, -10)):
        prism(roof, "brick_red", rect(x - 0.4, z - 0.6, x + 0.4, z + 0.6), top + 1.0, top + 5.0)
    house.door_trigger(0.0, 0.1, 8.4)
    house.points = {"dorm-door": (0.0, 0.1, 8.9)}
    return house


def sports_hall():
    """A vaulted hall on brick, ribs between metal cladding, a low entrance block in front."""
    hall = Building("sports-hall")
    body, porch = rect(-18.0, -12.0, 18.0, 10.0), rect(-6.0, 10.0, 6.0, 13.0)
    hall.voids = [rect(-17.9, -11.9, 17.9, 9.9), rect(-5.9, 9.8, 5.9, 12.95)]
    top = 6.5
    band(hall.part("plinth"), "concrete", body, -0.3, 0.5, 0.06, bottom=False)
    lower, upper = WallStyle("brick_dark", None, "concrete"), WallStyle("cladding", None, "metal")
    hall.shell(lower, body, 0.0, 2.6, {})
    strip = {0: row(36.0, 9, 2.8, 1.6, 3.2, "casement"), 2: row(36.0, 9, 2.8, 1.6, 3.2, "casement"),
             1: row(22.0, 5, 2.8, 1.6, 3.2, "casement"), 3: row(22.0, 5, 2.8, 1.6, 3.2, "casement")}
    hall.shell(upper, body, 2.6, top, strip, footing=0.0)
    band(hall.part("walls"), "concrete", body, 2.45, 2.7, 0.08)
    barrel(hall.part("roof"), "metal_roof", "cladding", (-18, -12, 18, 10), top, 3.6)
    rib = Mesh()
    rib.box("concrete", (-0.25, -0.3, 0.0), (0.25, 6.4, 0.5), "yz")
    for k in range(10):
        x = -16.8 + 3.733 * k
        hall.prop("rib", rib, (x, 0.0, -12.0), 180.0)
        if abs(x) > 6.6:
            hall.prop("rib", rib, (x, 0.0, 10.0))
    band(hall.part("plinth"), "concrete", porch, -0.3, 0.08, 0.04, bottom=False)
    hall.shell(WallStyle("brick_dark", None, "concrete"), porch, 0.0, 3.4,
               {0: [Opening(6.0, 2.0, 0.1, 2.5, "door"), Opening(2.6, 2.2, 0.9, 2.5, "casement"),
                    Opening(9.4, 2.2, 0.9, 2.5, "casement")]}, "porch")
    flat(hall.part("porch"), porch, [porch], 3.4, 0.4, "brick_dark", "concrete")
    hall.door_trigger(0.0, 0.1, 13.2)
    hall.points = {"sports-hall-door": (0.0, 0.06, 13.8)}
    return hall
