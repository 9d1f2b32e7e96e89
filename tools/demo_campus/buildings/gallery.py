"""The art gallery: dark brick under a saw-tooth roof with north lights."""

from .. import furnishing as furn
from ..layout import FLOOR_ABOVE_PAD as FLOOR
from ..polygon import rect
from ..shapes import band
from ..walls import Opening, WallStyle, partition
from .base import Building, Trigger, inside

HALF_X, HALF_Z = 12.0, 8.0
WALL_TOP, CEILING = 5.0, 4.6
TEETH, TOOTH_RISE = 4, 2.2
WALLS = WallStyle("brick_dark", "frame_white", "frame_dark", 0.30)


def _roof(gallery):
    """Teeth along x: a long slope up to the north light, which looks towards -z."""
    roof = gallery.part("roof")
    depth = 2 * HALF_Z / TEETH
    xa, xb = -HALF_X, HALF_X
    for i in range(TEETH):
        north, south = -HALF_Z + depth * i, -HALF_Z + depth * (i + 1)
        low, high = WALL_TOP, WALL_TOP + TOOTH_RISE
        roof.quad("zinc", (xa, low, south), (xb, low, south), (xb, high, north), (xa, high, north))
        roof.quad("curtain_glass", (xb, low, north), (xa, low, north), (xa, high, north),
                  (xb, high, north))
        for k in range(13):
            x = xa + 2 * HALF_X * k / 12
            roof.box("frame_dark", (x - 0.05, low, north - 0.06), (x + 0.05, high, north), "yYZ")
        roof.box("zinc", (xa - 0.2, high - 0.05, north - 0.25), (xb + 0.2, high + 0.12, north + 0.1))
        roof.poly("brick_dark", [(xb, low, south), (xb, low, north), (xb, high, north)])
        roof.poly("brick_dark", [(xa, low, north), (xa, low, south), (xa, high, north)])
    gallery.ceiling("plaster_inside", rect(xa, -HALF_Z, xb, HALF_Z), WALL_TOP, part="roof")


def _exhibits(gallery):
    pictures = [furn.painting(i) for i in range(4)]
    for i, x in enumerate((-10.0, -7.4, -4.8, -2.2, 2.2, 4.8, 7.4, 10.0)):
        gallery.prop("painting", pictures[i % 4], (x, FLOOR, -7.7), 0.0)
    for i, z in enumerate((-5.0, -1.6, 4.6)):
        gallery.prop("painting", pictures[(i + 1) % 4], (-11.7, FLOOR, z), 90.0)
        gallery.prop("painting", pictures[(i + 2) % 4], (11.7, FLOOR, z), -90.0)
    for i, x in enumerate((2.6, 4.6, 10.4)):  # both sides of the long partition
        gallery.prop("painting", pictures[i], (x, FLOOR, 1.25))
        gallery.prop("painting", pictures[(i + 2) % 4], (x, FLOOR, 1.0), 180.0)
    for i, z in enumerate((-0.4, -6.6)):
        gallery.prop("painting", pictures[i + 1], (-0.13, FLOOR, z), -90.0)
        gallery.prop("painting", pictures[i], (0.13, FLOOR, z), 90.0)
    for i, (x, z) in enumerate(((-8.5, -3.0), (-4.5, -3.0), (4.0, -3.4), (8.5, -3.4), (8.5, 3.4))):
        gallery.prop("exhibit", furn.plinth_with_figure(i % 3), (x, FLOOR, z))
    gallery.prop("desk", furn.counter(2.0), (-4.2, FLOOR, 4.6), 90.0)


def build():
    """The whole gallery."""
    gallery = Building("gallery")
    outline = rect(-HALF_X, -HALF_Z, HALF_X, HALF_Z)
    gallery.voids = [inside(outline, 0.05)]
    band(gallery.part("plinth"), "concrete", outline, -0.3, FLOOR - 0.02, 0.05, bottom=False)
    front = [Opening(12.0, 1.6, 0.0, 2.5, "open"), Opening(8.6, 2.6, 0.4, 3.2, "shop"),
             Opening(5.2, 2.6, 0.4, 3.2, "shop"), Opening(17.0, 2.6, 0.4, 3.2, "shop"),
             Opening(20.4, 2.6, 0.4, 3.2, "shop")]
    gallery.shell(WALLS, outline, FLOOR, WALL_TOP, {0: front})
    band(gallery.part("walls"), "frame_dark", outline, WALL_TOP - 0.3, WALL_TOP + 0.05, 0.08)
    _roof(gallery)
    room = inside(outline, WALLS.thickness)
    gallery.floor("parquet", room, FLOOR)
    gallery.ceiling("plaster_inside", room, CEILING)
    partition(gallery.part("partitions"), "plaster_inside", (0.0, 1.0), (0.0, -7.7), FLOOR,
              CEILING, [Opening(3.0, 1.4, 0.0, 2.4)])
    partition(gallery.part("partitions"), "plaster_inside", (1.6, 1.125), (11.7, 1.125), FLOOR,
              CEILING, [Opening(6.0, 1.4, 0.0, 2.4)])
    _exhibits(gallery)
    gallery.door_trigger(0.0, FLOOR, HALF_Z)
    gallery.triggers.append(Trigger("east-room", (6.0, 1.5, -3.2), (11.0, 2.6, 8.4)))
    gallery.points = {
        "gallery-door": (0.0, FLOOR, HALF_Z), "gallery-hall": (-0.9, FLOOR, 4.5),
        "gallery-west-room": (-2.5, FLOOR, -2.0), "gallery-east-room": (2.0, FLOOR, -2.0)}
    return gallery
