"""The relief: a triangulated height field with flat pads for buildings."""

from math import sqrt

from .layout import (CELL, EAST, NORTH, PLACEMENTS, POND_CENTRE, POND_LEVEL, POND_RADII, POND_RIM,
                     SOUTH, SQUARE_LEVEL, WEST)
from .mesh import Mesh, unit
from .noise import Relief
from .polygon import bounds, subtract

PAD_MARGIN = 3.1      # a cell more than the footprint: every cell it touches is flat
BLEND_REACH = 16.0    # metres over which a pad runs out into the open relief
SLOPE_NORTH = 0.017   # the site rises gently to the north
WAVES = ((46.0, 0.9), (19.0, 0.22))  # (wavelength, height), metres


def _box_distance(x, z, box):
    dx = max(box[0] - x, 0.0, x - box[2])
    dz = max(box[1] - z, 0.0, z - box[3])
    return sqrt(dx * dx + dz * dz)


class Terrain:
    """Heights at the corners of a grid, linear on two triangles a cell."""

    def __init__(self):
        self._noise = Relief(7)
        self.columns = int((EAST - WEST) / CELL)
        self.rows = int((SOUTH - NORTH) / CELL)
        self._heights = [[round(self._relief(WEST + CELL * i, NORTH + CELL * j), 4)
                          for i in range(self.columns + 1)] for j in range(self.rows + 1)]

    def _pads(self, x, z):
        """(distance, level) of every pad."""
        for place in PLACEMENTS.values():
            px, pz = place.local(x, z)
            x0, z0, x1, z1 = place.pad
            grown = (x0 - PAD_MARGIN, z0 - PAD_MARGIN, x1 + PAD_MARGIN, z1 + PAD_MARGIN)
            yield _box_distance(px, pz, grown), place.level
        yield _box_distance(x, z, (-26.0, -14.0, 26.0, 27.0)), SQUARE_LEVEL
        reach_x, reach_z = POND_RADII[0] + PAD_MARGIN, POND_RADII[1] + PAD_MARGIN
        yield _box_distance(x, z, (POND_CENTRE[0] - reach_x, POND_CENTRE[1] - reach_z,
                                   POND_CENTRE[0] + reach_x, POND_CENTRE[1] + reach_z)), POND_LEVEL

    def _relief(self, x, z):
        base = -SLOPE_NORTH * z - 0.2
        for length, height in WAVES:
            base += height * self._noise.at(x / length + 20.0, z / length + 20.0)
        weight, total = 1.0 / BLEND_REACH ** 2, base / BLEND_REACH ** 2
        for distance, level in self._pads(x, z):
            if distance <= 1e-6:
                return level
            if distance < BLEND_REACH:
                share = 1.0 / distance ** 2 - 1.0 / BLEND_REACH ** 2
                weight += share
                total += level * share
        return total / weight

    def corner(self, i, j):
        """World point of a grid corner."""
        return WEST + CELL * i, self._heights[j][i], NORTH + CELL * j

    def triangles(self, i, j):
        """The two upward triangles of a cell, as grid corners."""
        nw, ne, sw, se = (i, j), (i + 1, j), (i, j + 1), (i + 1, j + 1)
        return (nw, sw, se), (nw, se, ne)

    def height(self, x, z):
        """Height of the triangulated surface."""
        i = min(max(int((x - WEST) / CELL), 0), self.columns - 1)
        j = min(max(int((z - NORTH) / CELL), 0), self.rows - 1)
        u, v = (x - WEST) / CELL - i, (z - NORTH) / CELL - j
        h = self._heights
        if v >= u:  # south-western triangle
            return h[j][i] + (h[j + 1][i] - h[j][i]) * v + (h[j + 1][i + 1] - h[j + 1][i]) * u
        return h[j][i] + (h[j][i + 1] - h[j][i]) * u + (h[j + 1][i + 1] - h[j][i + 1]) * v

    def _corner_normal(self, i, j):
        h = self._heights
        west, east = h[j][max(i - 1, 0)], h[j][min(i + 1, self.columns)]
        north, south = h[max(j - 1, 0)][i], h[min(j + 1, self.rows)][i]
        return unit(((west - east) / (2 * CELL), 1.0, (north - south) / (2 * CELL)))

    def normal(self, x, z):
        """Smooth normal for shading."""
        i = min(max(int((x - WEST) / CELL), 0), self.columns - 1)
        j = min(max(int((z - NORTH) / CELL), 0), self.rows - 1)
        u, v = (x - WEST) / CELL - i, (z - NORTH) / CELL - j
        corners = ((i, j, (1 - u) * (1 - v)), (i + 1, j, u * (1 - v)),
                   (i, j + 1, (1 - u) * v), (i + 1, j + 1, u * v))
        total = [0.0, 0.0, 0.0]
        for ci, cj, weight in corners:
            for axis, value in enumerate(self._corner_normal(ci, cj)):
                total[axis] += value * weight
        return unit(total)

    def cells(self, box):
        """Cells (i, j) that a bounding box (x0, z0, x1, z1) touches."""
        i0 = max(int((box[0] - WEST) / CELL), 0)
        i1 = min(int((box[2] - WEST) / CELL), self.columns - 1)
        j0 = max(int((box[1] - NORTH) / CELL), 0)
        j1 = min(int((box[3] - NORTH) / CELL), self.rows - 1)
        return [(i, j) for j in range(j0, j1 + 1) for i in range(i0, i1 + 1)]

    def mesh(self):
        """The whole surface, with a hole where the pond is."""
        mesh = Mesh()
        pond = bounds(POND_RIM)
        near = set(self.cells(pond))
        for j in range(self.rows):
            for i in range(self.columns):
                for corners in self.triangles(i, j):
                    points = [self.corner(*c) for c in corners]
                    flat = [(x, z) for x, _, z in points]
                    pieces = subtract(flat, POND_RIM) if (i, j) in near else [flat]
                    for piece in pieces:
                        mesh.poly("grass", [(x, self.height(x, z), z) for x, z in piece],
                                  normals=[self.normal(x, z) for x, z in piece])
        return mesh
