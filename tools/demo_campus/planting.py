"""Where trees and hedges stand."""

from . import vegetation
from .exact import Random, cos_deg, sin_deg
from .gltf import Node
from .layout import EAST, NORTH, PLACEMENTS, POND_CENTRE, POND_RADII, SOUTH, WEST
from .furniture import SOIL_HEIGHT
from .outfitting import PLANTERS
from .paving import PATH_TOP
from .vegetation import HEDGE_LENGTH, SPECIES

TRUNK_TO_PAVING = 0.9   # metres kept between a trunk and any paving
WALL_GAP = 1.6          # metres kept between a crown and a house
AVENUE_X, AVENUE_PITCH = 4.7, 8.0
SCATTERED = 46          # trees on the open lawns
BORDER = 6.0            # metres kept to the edge of the site


class Planting:
    """Trees and hedges on the ground between the paving."""

    def __init__(self, terrain, paving, keep_clear):
        self._terrain, self._paving = terrain, paving
        self._clear_lines = keep_clear      # [((x, z), (x, z))]: walks no trunk may stand on
        self._random = Random(4242)
        self._meshes = {name: [build(100 * i + k) for k in range(2 if name in ("oak", "lime") else 1)]
                        for i, (name, (build, _, _)) in enumerate(SPECIES.items())}
        self._hedges = [vegetation.hedge(k) for k in range(3)]
        self._spots = []                    # (x, z, clear radius)
        self._counts = {}
        self.nodes = []

    def _free(self, x, z, crown, gap):
        if not (WEST + BORDER < x < EAST - BORDER and NORTH + BORDER < z < SOUTH - BORDER):
            return False
        px = (x - POND_CENTRE[0]) / (POND_RADII[0] + 3.0)
        pz = (z - POND_CENTRE[1]) / (POND_RADII[1] + 3.0)
        if px * px + pz * pz < 1.0:
            return False
        for place in PLACEMENTS.values():
            lx, lz = place.local(x, z)
            x0, z0, x1, z1 = place.pad
            dx, dz = max(x0 - lx, 0.0, lx - x1), max(z0 - lz, 0.0, lz - z1)
            if dx * dx + dz * dz < (crown + WALL_GAP) ** 2:
                return False
        for ox, oz, other in self._spots:
            if (x - ox) ** 2 + (z - oz) ** 2 < ((crown + other) * gap) ** 2:
                return False
        if any(_line_distance2((x, z), line) < 1.2 for line in self._clear_lines):
            return False
        ring = [(0.0, 0.0)] + [(TRUNK_TO_PAVING * cos_deg(45 * k), TRUNK_TO_PAVING * sin_deg(45 * k))
                               for k in range(8)]
        return all(self._paving.lift(x + dx, z + dz) == 0.0 for dx, dz in ring)

    def tree(self, species, x, z, scale=None, gap=0.8, box_height=None):
        """Plants a tree if there is room, or in any case in a box of soil of some height."""
        crown = SPECIES[species][2]
        if box_height is None and not self._free(x, z, crown, gap):
            return
        random = self._random
        self._counts[species] = self._counts.get(species, 0) + 1
        self._spots.append((x, z, crown))
        self.nodes.append(Node("tree_%s_%03d" % (species, self._counts[species]),
                               random.pick(self._meshes[species]),
                               (x, self._terrain.height(x, z) + (box_height or 0.0), z),
                               round(random.between(0.0, 360.0), 1),
                               scale or round(random.between(0.85, 1.2), 3)))

    def plant(self):
        """All trees: avenue, streets, square, pond, then the open lawns."""
        for x, z in PLANTERS:
            self.tree("lime", x, z, 0.82, box_height=SOIL_HEIGHT + PATH_TOP)
        z = 34.0
        while z < 72.0:
            for x in (-AVENUE_X, AVENUE_X):
                self.tree("lime", x, z, round(self._random.between(0.92, 1.05), 3), 0.55)
            z += AVENUE_PITCH
        for k in range(12):
            self.tree("oak" if k % 3 else "lime", -110.0 + 20.0 * k, 83.6, gap=0.7)
            self.tree("poplar", -112.0 + 20.3 * k, 98.5 - 2.6, gap=0.6)
        for x, z in ((-31.0, -12.0), (-31.0, 26.0), (31.0, 26.0), (30.0, -3.0), (-30.0, 31.0),
                     (38.0, -12.0), (-12.0, 36.5), (12.0, 36.5), (-20.0, 36.5), (20.0, 36.5)):
            self.tree("cherry", x, z, gap=0.6)
        for k in range(7):
            angle = 51.0 * k + 18.0
            self.tree("willow", POND_CENTRE[0] + 21.5 * cos_deg(angle),
                      POND_CENTRE[1] + 18.5 * sin_deg(angle), gap=0.6)
        for k in range(11):
            self.tree("spruce", -95.0 + 18.3 * k + self._random.between(-2, 2),
                      -108.0 + 2.0 + self._random.between(0.0, 1.5), gap=0.6)
            self.tree("birch", 112.5, -90.0 + 16.0 * k + self._random.between(-2, 2), gap=0.6)
            self.tree("poplar", -112.5, -92.0 + 16.5 * k + self._random.between(-2, 2), gap=0.6)
        self._scatter()

    def _scatter(self):
        kinds = ["oak", "oak", "birch", "birch", "lime", "spruce", "cherry"]
        planted = len(self.nodes)
        for _ in range(SCATTERED * 10):
            if len(self.nodes) - planted >= SCATTERED:
                break
            x, z = self._random.between(-100.0, 100.0), self._random.between(-96.0, 82.0)
            self.tree(self._random.pick(kinds), x, z, gap=1.15)

    def hedge_row(self, start, end):
        """Clipped hedge along a line, in pieces of HEDGE_LENGTH."""
        dx, dz = end[0] - start[0], end[1] - start[1]
        along_x = abs(dx) > abs(dz)
        length = abs(dx) if along_x else abs(dz)
        count = int(length / HEDGE_LENGTH + 0.5)
        for k in range(count):
            t = (k + 0.5) / count
            x, z = start[0] + dx * t, start[1] + dz * t
            number = self._counts["hedge"] = self._counts.get("hedge", 0) + 1
            self.nodes.append(Node("hedge_%03d" % number, self._hedges[number % 3],
                                   (x, self._terrain.height(x, z), z), 0.0 if along_x else 90.0))

    def hedges(self):
        """Hedges along the avenue's lawns, the court and the library's front."""
        for side in (-1, 1):
            self.hedge_row((side * 11.5, 68.9), (side * 38.5, 68.9))
            self.hedge_row((side * 12.0, 83.0 - 2.2), (side * 48.0, 83.0 - 2.2))
            self.hedge_row((-35.0, side * 14.0 + 8.0 - side * 3.0),
                           (-29.0, side * 14.0 + 8.0 - side * 3.0))
        self.hedge_row((41.0, 26.2), (62.0, 26.2))
        self.hedge_row((-16.6, -17.1), (-8.8, -17.1))


def _line_distance2(point, line):
    (ax, az), (bx, bz) = line
    dx, dz = bx - ax, bz - az
    t = ((point[0] - ax) * dx + (point[1] - az) * dz) / (dx * dx + dz * dz)
    t = min(1.0, max(0.0, t))
    return (ax + dx * t - point[0]) ** 2 + (az + dz * t - point[1]) ** 2
