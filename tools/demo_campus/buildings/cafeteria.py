"""The cafeteria: one storey, white render and larch boards, a terrace under parasols."""

from .. import furnishing as furn
from ..furniture import parasol
from ..layout import FLOOR_ABOVE_PAD as FLOOR
from ..polygon import rect
from ..roofs import flat
from ..shapes import band, prism
from ..walls import Opening, WallStyle, partition
from .base import Building, Trigger, inside

HALF_X, HALF_Z = 10.0, 7.0
WALL_TOP, CEILING = 4.1, 3.6
WALLS = WallStyle("plaster", "plaster_inside", "frame_dark", 0.30)
CANOPY = 2.6      # depth of the roof over the entrance front


def _openings():
    front = [Opening(a, w, 0.25, 2.85, "shop") for a, w in
             ((1.9, 2.2), (4.6, 2.2), (7.3, 2.2), (12.3, 1.8))]
    front += [Opening(10.0, 1.5, 0.0, 2.4, "open")]
    front += [Opening(a, 1.6, 1.0, 2.5, "casement") for a in (15.8, 18.2)]
    kitchen = [Opening(a, 1.4, 1.1, 2.3, "casement") for a in (3.0, 7.0, 11.0)]
    back = [Opening(a, 1.4, 1.1, 2.3, "casement") for a in (2.0, 4.5)]
    back += [Opening(a, 2.2, 0.25, 2.85, "shop") for a in (9.0, 12.0, 15.0, 18.0)]
    side = [Opening(a, 2.2, 0.25, 2.85, "shop") for a in (2.4, 5.5, 8.5, 11.6)]
    return {0: front, 1: kitchen, 2: back, 3: side}


def _inside(cafe):
    room = inside(rect(-HALF_X, -HALF_Z, HALF_X, HALF_Z), WALLS.thickness)
    cafe.floor("floor_tiles", room, FLOOR)
    cafe.ceiling("plaster_inside", room, CEILING)
    mesh = cafe.part("partitions")
    partition(mesh, "plaster_inside", (4.0, 6.7), (4.0, -6.7), FLOOR, CEILING,
              [Opening(4.2, 1.2, 0.0, 2.3)])
    partition(mesh, "plaster_inside", (4.125, 0.0), (9.7, 0.0), FLOOR, CEILING,
              [Opening(1.4, 1.1, 0.0, 2.3)])
    table, chair = furn.round_table(), furn.chair("fabric_blue")
    for x, z in ((-7.6, -4.6), (-7.6, -1.4), (-7.6, 1.8), (-7.6, 5.0), (-4.4, -5.2), (-4.4, -1.4),
                 (-4.4, 1.8), (-4.4, 5.0)):
        _group(cafe, table, chair, (x, FLOOR, z))
    cafe.prop("counter", furn.counter(5.0, 0.8), (2.1, FLOOR, -3.6), -90.0)
    cafe.prop("stove", furn.stove(), (6.8, FLOOR, -6.2))
    cafe.prop("worktop", furn.counter(3.0, 0.8, 0.95, "metal", "metal"), (7.6, FLOOR, -3.0))
    cafe.prop("table", furn.table(), (7.6, FLOOR, 4.6))
    lamp = furn.pendant_lamp(0.6)
    for x in (-7.0, -3.5, 0.8):
        for z in (-4.0, 0.0, 4.0):
            cafe.prop("pendant", lamp, (x, CEILING, z))


def _group(building, table, chair, at, seats=((0.0, 0.72, 180.0), (0.0, -0.72, 0.0))):
    building.prop("table", table, at)
    for dx, dz, yaw in seats:
        building.prop("chair", chair, (at[0] + dx, at[1], at[2] + dz), yaw)


def _terrace(cafe):
    table, chair = furn.round_table(0.45, "metal"), furn.chair("wood")
    shade = parasol()
    for x, z in ((-7.5, 10.2), (-4.2, 11.8), (4.6, 10.4), (7.6, 12.2), (-7.4, 13.3)):
        _group(cafe, table, chair, (x, 0.06, z), ((0.7, 0.0, -90.0), (-0.7, 0.0, 90.0)))
        cafe.prop("parasol", shade, (x, 0.06, z + 0.55))


def build():
    """The whole cafeteria."""
    cafe = Building("cafeteria")
    outline = rect(-HALF_X, -HALF_Z, HALF_X, HALF_Z)
    cafe.voids = [inside(outline, 0.05)]
    band(cafe.part("plinth"), "concrete", outline, -0.3, FLOOR - 0.02, 0.05, bottom=False)
    cafe.shell(WALLS, outline, FLOOR, WALL_TOP, _openings(), top=False)
    band(cafe.part("walls"), "wood_cladding", outline, 2.98, 3.9, 0.06)
    roof = cafe.part("roof")
    flat(roof, outline, [outline], WALL_TOP, 0.45, "frame_dark", "metal")
    prism(roof, "frame_dark", rect(-HALF_X, HALF_Z + 0.02, HALF_X, HALF_Z + CANOPY), 3.15, 3.40,
          bottom=True, cap_material="wood_cladding")
    for x in (-9.6, -4.8, 4.8, 9.6):
        roof.box("frame_dark", (x - 0.06, 0.0, HALF_Z + CANOPY - 0.3),
                 (x + 0.06, 3.15, HALF_Z + CANOPY - 0.18), "yY")
    roof.box("cladding", (5.0, WALL_TOP, -5.0), (8.5, WALL_TOP + 1.5, -2.5), "y")
    _inside(cafe)
    _terrace(cafe)
    cafe.door_trigger(0.0, FLOOR, HALF_Z)
    cafe.triggers.append(Trigger("terrace", (0.0, 1.3, 11.0), (19.0, 2.6, 7.6)))
    cafe.triggers.append(Trigger("kitchen", (6.9, 1.5, -3.4), (5.2, 2.6, 6.2)))
    cafe.points = {
        "cafeteria-door": (0.0, FLOOR, HALF_Z), "cafeteria-terrace": (0.0, 0.06, 10.5),
        "cafeteria-hall": (0.0, FLOOR, 2.5), "cafeteria-counter": (0.9, FLOOR, -3.0),
        "cafeteria-back-room": (5.6, FLOOR, 2.5), "cafeteria-kitchen": (5.6, FLOOR, -1.5)}
    return cafe
