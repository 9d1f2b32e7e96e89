"""Puts the whole campus together."""

from dataclasses import dataclass, field

from . import pond
from .buildings import academic, cafeteria, gallery, landmarks, library, theatre
from .gltf import Node
from .outfitting import Outfitting
from .paving import Paving
from .planting import Planting
from .terrain import Terrain
from .tour import TOUR_LEGS

BUILDERS = (landmarks.gatehouse, library.build, theatre.build, cafeteria.build, academic.admin,
            academic.science, gallery.build, landmarks.clock_tower, academic.dorm,
            academic.sports_hall, landmarks.greenhouse, landmarks.observatory, landmarks.pavilion)


@dataclass
class Campus:
    """Everything that is written to files."""

    terrain: Terrain
    paving: Paving
    buildings: list
    furniture: Outfitting
    scenes: dict = field(default_factory=dict)  # file name -> root nodes


def build():
    """Builds the campus."""
    terrain = Terrain()
    buildings = [make() for make in BUILDERS]
    voids = [b.place.outline(poly) for b in buildings for poly in b.voids]
    paving = Paving(terrain, voids)
    ground = [Node("terrain", terrain.mesh())]
    ground += [Node(name, mesh) for name, mesh in paving.meshes()]
    ground += [Node("pond_basin", pond.basin()), Node("pond_water", pond.water())]
    planting = Planting(terrain, paving, TOUR_LEGS)
    planting.plant()
    planting.hedges()
    furniture = Outfitting(terrain, paving)
    furniture.furnish()
    furniture.enclose()
    return Campus(terrain, paving, buildings, furniture, {
        "ground.glb": ground, "buildings.glb": [b.node() for b in buildings],
        "vegetation.glb": planting.nodes, "furniture.glb": furniture.nodes})
