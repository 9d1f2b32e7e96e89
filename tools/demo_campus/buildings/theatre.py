"""The lecture theatre: an octagon with a foyer, a stage and rising rows."""

from .. import furnishing as furn
from ..exact import cos_deg
from ..layout import FLOOR_ABOVE_PAD as FLOOR
from ..polygon import bounds, clip, offset, rect
from ..roofs import EAVES_THICKNESS, cone, cornice
from ..shapes import band, ngon, prism
from ..stairs import RISER
from ..walls import Opening, WallStyle, partition
from .base import Building, Trigger, inside

APOTHEM = 12.0
SIDE = 2 * APOTHEM * 0.414213562
WALL_TOP, CEILING = 6.6, 6.2
FOYER_Z = 6.5                     # the wall between foyer and hall
ROWS, ROW_DEPTH, FIRST_ROW_Z = 9, 0.95, 0.6
AISLE = 0.9                       # half width of the middle aisle
WALLS = WallStyle("brick_buff", "plaster_inside", "concrete", 0.30)


def _outline():
    return ngon(8, APOTHEM / cos_deg(22.5), start_deg=22.5)


def _front_edge(poly):
    """Index of the edge that faces the front."""
    return max(range(len(poly)), key=lambda i: poly[i][1] + poly[(i + 1) % len(poly)][1])


def _openings(front):
    slots = [Opening(SIDE * k / 4, 0.8, 1.6, 5.4, "slot_lit") for k in (1, 2, 3)]
    holes = {i: slots for i in range(8) if i not in (front, (front + 4) % 8)}
    holes[front] = [Opening(SIDE / 2, 1.6, 0.0, 2.5, "open"),
                    Opening(SIDE / 2, 2.4, 3.6, 5.4, "clerestory")]
    holes[front] += [Opening(SIDE / 2 + s * 3.0, 1.8, 0.5, 2.7, "shop") for s in (-1, 1)]
    return holes


def _hall(theatre, room):
    mesh = theatre.part("tiers")
    for k in range(ROWS):
        z0 = FIRST_ROW_Z - ROW_DEPTH * k
        z1 = z0 - ROW_DEPTH if k + 1 < ROWS else -APOTHEM
        top = FLOOR + RISER * (k + 1)
        step = clip(rect(-APOTHEM, z1, APOTHEM, z0), room)
        prism(mesh, "carpet", step, top - RISER, top)
        _, _, reach, _ = bounds(clip(rect(-APOTHEM, z0 - 0.4, APOTHEM, z0 - 0.3), room))
        for side in (-1, 1):
            x0, x1 = sorted((side * AISLE, side * (reach - 1.6)))
            mesh.box("wood", (x0, top + 0.66, z0 - 0.36), (x1, top + 0.70, z0 - 0.02))
            mesh.box("wood_dark", (x0, top, z0 - 0.06), (x1, top + 0.66, z0 - 0.02), "yY")
            mesh.box("fabric_red", (x0, top + 0.02, z0 - 0.88), (x1, top + 0.44, z0 - 0.56), "y")
    _panelling(theatre, room)
    stage = theatre.part("stage")
    prism(stage, "wood", rect(-4.4, 3.4, 4.4, FOYER_Z - 0.14), FLOOR, FLOOR + 2 * RISER)
    prism(stage, "wood", rect(-4.4, 3.1, 4.4, 3.4), FLOOR, FLOOR + RISER)
    stage.box("screen", (-3.4, 2.0, FOYER_Z - 0.22), (3.4, 5.2, FOYER_Z - 0.16), "Z")
    theatre.prop("lectern", furn.counter(0.8, 0.5, 1.15), (3.2, FLOOR + 2 * RISER, 4.6), 180.0)


def _panelling(theatre, room):
    """Wooden boards along the hall's walls, and acoustic ribs under its ceiling."""
    mesh, inner = theatre.part("panelling"), offset(room, -0.05)
    for i, (ax, az) in enumerate(inner):
        bx, bz = inner[(i + 1) % len(inner)]
        if az + bz > 12.0:
            continue
        low, high = FLOOR, FLOOR + 1.45 + RISER * max(0.0, -(az + bz) / 2 / ROW_DEPTH)
        az2, bz2 = min(az, FOYER_Z - 0.2), min(bz, FOYER_Z - 0.2)
        if az2 != az:
            ax = ax + (bx - ax) * (az2 - az) / (bz - az)
        if bz2 != bz:
            bx = bx + (ax - bx) * (bz2 - bz) / (az - bz)
        mesh.quad("wood_dark", (bx, low, bz2), (ax, low, az2), (ax, min(high, 1.55), az2),
                  (bx, min(high, 1.55), bz2))
    for k in range(6):
        z = 4.6 - 2.6 * k
        reach = clip(rect(-APOTHEM, z - 0.1, APOTHEM, z + 0.1), room)
        x0, _, x1, _ = bounds(reach)
        mesh.box("wood", (x0 + 0.3, CEILING - 0.55, z - 0.08), (x1 - 0.3, CEILING, z + 0.08), "Y")


def _roof(theatre, outline):
    roof = theatre.part("roof")
    cornice(roof, "concrete", outline, WALL_TOP)
    rim, top = cone(roof, "metal_roof", outline, WALL_TOP, 3.6, 0.7, "frame_dark", 0.24)
    drum = offset(rim, -0.25)
    prism(roof, "curtain_glass", drum, top - 0.4, top + 1.3, top=False)
    for x, z in drum:
        roof.box("frame_dark", (x - 0.08, top - 0.4, z - 0.08), (x + 0.08, top + 1.3, z + 0.08),
                 "yY")
    cone(roof, "metal_roof", drum, top + 1.3, 1.2, 0.35, "frame_dark")
    return top + 1.3 + EAVES_THICKNESS


def build():
    """The whole lecture theatre."""
    theatre = Building("theatre")
    outline = _outline()
    room = inside(outline, WALLS.thickness)
    theatre.voids = [inside(outline, 0.05)]
    band(theatre.part("plinth"), "concrete", outline, -0.3, FLOOR - 0.02, 0.06, bottom=False)
    theatre.shell(WALLS, outline, FLOOR, WALL_TOP, _openings(_front_edge(outline)))
    band(theatre.part("walls"), "concrete", outline, 5.6, 5.9, 0.08)
    theatre.floor("floor_tiles", room, FLOOR)
    theatre.ceiling("plaster_inside", room, CEILING)
    for x, z in outline:  # concrete buttresses at the corners
        prism(theatre.part("walls"), "concrete", ngon(8, 0.45, (x, z), 22.5), -0.3, WALL_TOP - 0.5)
    partition(theatre.part("partitions"), "plaster_inside", (-10.3, FOYER_Z), (10.3, FOYER_Z),
              FLOOR, CEILING, [Opening(10.3 + x, 1.4, 0.0, 2.3) for x in (-6.6, 6.6)])
    _hall(theatre, room)
    _roof(theatre, outline)
    for x in (-2.6, 2.6):
        theatre.prop("armchair", furn.armchair("fabric_blue"), (x, FLOOR, 7.3), 0.0)
    theatre.door_trigger(0.0, FLOOR, APOTHEM)
    theatre.triggers.append(Trigger("hall", (0.0, 2.3, -2.6), (21.0, 4.2, 17.4)))
    theatre.points = {
        "theatre-door": (0.0, FLOOR, APOTHEM), "theatre-foyer": (0.0, FLOOR, 9.0),
        "theatre-foyer-right": (6.6, FLOOR, 7.8), "theatre-hall": (6.6, FLOOR, 2.2),
        "theatre-stage": (0.0, FLOOR + 2 * RISER, 4.6), "theatre-aisle": (0.0, FLOOR, 1.6),
        "theatre-top-row": (0.0, FLOOR + ROWS * RISER, FIRST_ROW_Z - ROW_DEPTH * (ROWS - 1) - 1.3)}
    return theatre
