"""The materials: which texture, how large one repeat is in metres, and its tint."""

from dataclasses import dataclass

TEXTURE_FOLDER = "textures"


@dataclass(frozen=True)
class Material:
    """A textured surface. tile: metres covered by one repeat of the texture (u, v)."""

    texture: str
    tile: tuple = (1.0, 1.0)
    factor: tuple = (1.0, 1.0, 1.0, 1.0)
    alpha: str = "OPAQUE"
    double_sided: bool = False
    metallic: float = 0.0
    roughness: float = 0.9
    glow: tuple = ()  # linear colour that it sends out, as bright as it looks beside the day's sun
    glow_texture: str = ""


def _tint(red, green, blue, alpha=1.0):
    """A linear base colour factor."""
    return (red, green, blue, alpha)


# Behind a pane: nothing beside the day's light, bright to an eye used to the dark.
_WINDOW = (0.055, 0.040, 0.020)

MATERIALS = {
    # ground
    "grass": Material("grass", (9.0, 9.0)),
    "road": Material("road", (7.0, 7.0)),
    "asphalt": Material("asphalt", (4.0, 4.0)),
    "slabs": Material("slabs", (3.6, 3.6)),
    "setts": Material("setts", (2.0, 2.0)),
    "gravel": Material("gravel", (2.5, 2.5)),
    "granite": Material("granite", (1.2, 1.2)),
    "soil": Material("soil", (1.5, 1.5)),
    "pond_bed": Material("gravel", (2.5, 2.5), _tint(0.42, 0.47, 0.36)),
    "water": Material("water", (7.0, 7.0), _tint(0.8, 0.9, 0.9, 0.72), "BLEND", roughness=0.1),
    # walls
    "brick_red": Material("brick_red", (1.8, 1.8)),
    "brick_buff": Material("brick_buff", (1.8, 1.8)),
    "brick_dark": Material("brick_red", (1.8, 1.8), _tint(0.50, 0.46, 0.50)),
    "ashlar": Material("ashlar", (2.4, 2.4)),
    "ashlar_grey": Material("ashlar", (2.4, 2.4), _tint(0.62, 0.68, 0.75)),
    "stone": Material("granite", (1.6, 1.6), _tint(1.0, 0.95, 0.84)),
    "plaster": Material("plaster", (3.0, 3.0)),
    "plaster_ochre": Material("plaster", (3.0, 3.0), _tint(0.90, 0.66, 0.34)),
    "plaster_teal": Material("plaster", (3.0, 3.0), _tint(0.34, 0.55, 0.55)),
    "plaster_rose": Material("plaster", (3.0, 3.0), _tint(0.78, 0.42, 0.33)),
    "plaster_inside": Material("plaster", (3.0, 3.0), _tint(0.95, 0.92, 0.85)),
    "concrete": Material("concrete", (3.0, 3.0)),
    "cladding": Material("metal_seam", (2.0, 2.0), _tint(0.75, 0.78, 0.82), roughness=0.5),
    "wood_cladding": Material("planks", (2.0, 2.0)),
    # roofs
    "roof_tiles": Material("roof_tiles", (2.4, 2.4)),
    "roof_tiles_brown": Material("roof_tiles", (2.4, 2.4), _tint(0.62, 0.60, 0.62)),
    "slate": Material("slate", (2.4, 2.4)),
    "metal_roof": Material("metal_seam", (2.0, 2.0), _tint(0.48, 0.56, 0.62), roughness=0.5),
    "zinc": Material("metal_seam", (2.0, 2.0), roughness=0.5),
    "copper": Material("copper", (2.0, 2.0), roughness=0.6),
    "roof_gravel": Material("gravel", (2.5, 2.5), _tint(0.7, 0.7, 0.7)),
    # glass and joinery
    "glass": Material("glass", (3.0, 3.0), roughness=0.15, glow=_WINDOW, glow_texture="lit_room"),
    "curtain_glass": Material("curtain_glass", (6.0, 3.5), roughness=0.15, glow=_WINDOW,
                              glow_texture="lit_front"),
    "clear_glass": Material("glass", (3.0, 3.0), _tint(0.9, 1.0, 1.0, 0.28), "BLEND", True,
                            roughness=0.1),
    "frame_white": Material("plaster", (3.0, 3.0), _tint(0.95, 0.95, 0.92)),
    "frame_dark": Material("metal", (1.0, 1.0), _tint(0.16, 0.17, 0.18), roughness=0.6),
    "frame_green": Material("metal", (1.0, 1.0), _tint(0.10, 0.22, 0.15), roughness=0.6),
    "metal": Material("metal", (1.0, 1.0), roughness=0.5),
    "iron": Material("metal", (1.0, 1.0), _tint(0.10, 0.11, 0.12), roughness=0.6),
    "brass": Material("metal", (1.0, 1.0), _tint(0.91, 0.70, 0.32), metallic=1.0, roughness=0.4),
    "bronze": Material("copper", (2.0, 2.0), _tint(0.80, 0.55, 0.38), roughness=0.5),
    "door_wood": Material("door", (1.0, 1.0)),
    "wood": Material("planks", (1.2, 1.2), _tint(1.0, 0.82, 0.62)),
    "wood_dark": Material("planks", (1.2, 1.2), _tint(0.45, 0.33, 0.25)),
    "parquet": Material("parquet", (2.4, 2.4)),
    "floor_tiles": Material("floor_tiles", (2.4, 2.4)),
    "carpet": Material("plaster", (3.0, 3.0), _tint(0.22, 0.27, 0.36)),
    "books": Material("books", (1.8, 1.8)),
    "fabric_red": Material("plaster", (3.0, 3.0), _tint(0.50, 0.08, 0.08)),
    "fabric_blue": Material("plaster", (3.0, 3.0), _tint(0.08, 0.18, 0.40)),
    "canvas": Material("plaster", (3.0, 3.0), _tint(0.92, 0.85, 0.68), "OPAQUE", True),
    "bins": Material("metal", (1.0, 1.0), _tint(0.08, 0.22, 0.15)),
    "lamp_glass": Material("plaster", (3.0, 3.0), _tint(1.0, 0.96, 0.80), glow=(0.10, 0.085, 0.055)),
    "screen": Material("plaster", (3.0, 3.0), _tint(1.0, 1.0, 1.0)),
    "painting": Material("paintings", (1.0, 1.0)),
    "signs": Material("signs", (1.0, 1.0), roughness=0.7),
    "notices": Material("notices", (1.0, 1.0)),
    "clock": Material("clock", (1.0, 1.0), glow=(0.035, 0.032, 0.026), glow_texture="clock"),
    # plants
    "bark": Material("bark", (1.0, 2.0)),
    "bark_birch": Material("bark_birch", (0.8, 1.6)),
    "leaves_oak": Material("leaves", (2.2, 2.2), _tint(0.72, 0.80, 0.55)),
    "leaves_birch": Material("leaves", (1.8, 1.8), _tint(1.0, 1.0, 0.60)),
    "leaves_lime": Material("leaves", (2.0, 2.0), _tint(0.80, 1.0, 0.66)),
    "leaves_willow": Material("leaves", (1.8, 1.8), _tint(0.95, 1.0, 0.80)),
    "needles": Material("needles", (1.6, 1.6)),
    "blossom": Material("blossom", (2.0, 2.0)),
    "hedge": Material("leaves", (1.5, 1.5), _tint(0.50, 0.68, 0.42)),
    "card_oak": Material("leaf_card", (1.0, 1.0), _tint(0.72, 0.80, 0.55), "MASK", True),
    "card_birch": Material("leaf_card", (1.0, 1.0), _tint(1.0, 1.0, 0.60), "MASK", True),
    "card_lime": Material("leaf_card", (1.0, 1.0), _tint(0.80, 1.0, 0.66), "MASK", True),
    "card_willow": Material("leaf_card", (1.0, 1.0), _tint(0.95, 1.0, 0.80), "MASK", True),
    "card_blossom": Material("blossom_card", (1.0, 1.0), _tint(1.0, 1.0, 1.0), "MASK", True),
    "flowers": Material("flowers", (1.0, 1.0), _tint(1.0, 1.0, 1.0), "MASK", True),
}
