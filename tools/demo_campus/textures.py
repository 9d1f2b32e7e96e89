"""The list of textures: name, size in pixels, palette size, and what paints it."""

import os

from . import textures_built as built
from . import textures_grown as grown
from .png import write_png

_RED = [(150, 74, 56), (162, 84, 62), (138, 66, 52), (170, 96, 72), (128, 62, 54)]
_BUFF = [(194, 164, 116), (204, 176, 128), (182, 152, 106), (208, 186, 142)]
_GREENS = [(96, 132, 60), (84, 120, 54), (110, 142, 66), (76, 110, 52)]
_PINKS = [(232, 180, 190), (240, 200, 206), (222, 160, 176), (244, 220, 222)]
_DARK_LEAF = (40, 58, 30)
_DARK_PINK = (150, 96, 104)
_SOFT = [(4, 4, 2), (16, 16, 1), (64, 64, 1)]

TEXTURES = [
    ("grass", 512, 48, grown.grass),
    ("road", 512, 32, built.road),
    ("asphalt", 256, 32, lambda n: built.shaded(n, 41, (74, 75, 78), (104, 104, 104), _SOFT, 0.9)),
    ("slabs", 512, 40, built.slabs),
    ("setts", 512, 48, built.setts),
    ("gravel", 256, 40, grown.gravel),
    ("granite", 256, 40, lambda n: built.shaded(n, 42, (140, 138, 134), (190, 188, 182),
                                                [(8, 8, 1), (48, 48, 1), (128, 128, 1)], 0.7)),
    ("soil", 128, 24, lambda n: built.shaded(n, 43, (56, 42, 30), (98, 76, 54),
                                             [(16, 16, 1), (64, 64, 1)], 0.8)),
    ("water", 256, 40, grown.water),
    ("brick_red", 512, 48, lambda n: built.brick(n, _RED, 11)),
    ("brick_buff", 512, 48, lambda n: built.brick(n, _BUFF, 12)),
    ("ashlar", 512, 40, built.ashlar),
    ("plaster", 256, 24, lambda n: built.shaded(n, 44, (214, 212, 206), (240, 239, 235),
                                                _SOFT, 0.5)),
    ("concrete", 256, 32, built.concrete),
    ("metal_seam", 256, 32, built.metal_seam),
    ("planks", 256, 40, built.planks),
    ("roof_tiles", 512, 48, built.roof_tiles),
    ("slate", 512, 40, built.slate),
    ("copper", 256, 40, built.copper),
    ("glass", 128, 32, built.glass),
    ("curtain_glass", 256, 48, built.curtain_glass),
    ("lit_room", 64, 24, built.lit_room),
    ("lit_front", 128, 32, built.lit_front),
    ("metal", 64, 16, lambda n: built.shaded(n, 45, (190, 190, 190), (216, 216, 216), _SOFT, 0.5)),
    ("door", 256, 32, built.door),
    ("parquet", 512, 40, built.parquet),
    ("floor_tiles", 256, 24, built.floor_tiles),
    ("books", 256, 48, grown.books),
    ("notices", 256, 40, grown.notices),
    ("paintings", 256, 48, grown.paintings),
    ("clock", 256, 8, grown.clock),
    ("signs", 512, 12, grown.signs),
    ("bark", 256, 32, lambda n: grown.bark(n, (128, 104, 82), (52, 42, 34), 59)),
    ("bark_birch", 256, 24, lambda n: grown.bark(n, (0, 0, 0), (0, 0, 0), 66, True)),
    ("leaves", 256, 40, lambda n: grown.leaves(n, 56, _GREENS, _DARK_LEAF)),
    ("needles", 256, 32, lambda n: grown.needles(n)),
    ("blossom", 256, 40, lambda n: grown.leaves(n, 57, _PINKS, _DARK_PINK)),
    ("leaf_card", 256, 32, lambda n: grown.leaf_card(n, 67, _GREENS, _DARK_LEAF)),
    ("blossom_card", 256, 32, lambda n: grown.leaf_card(n, 68, _PINKS, _DARK_PINK)),
    ("flowers", 256, 40, grown.flowers),
]


def write_textures(folder, only=None):
    """Paints every texture (or the named ones) into a folder."""
    os.makedirs(folder, exist_ok=True)
    for name, size, colours, paint in TEXTURES:
        if only and name not in only:
            continue
        painted = paint(size)
        pixels, mask = painted if isinstance(painted, tuple) else (painted, None)
        write_png(os.path.join(folder, name + ".png"), size, size, pixels, colours, mask)
