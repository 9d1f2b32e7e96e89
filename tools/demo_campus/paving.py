"""Roads, paths, kerbs and squares, draped on the terrain.

Every surface follows the terrain's triangles exactly, lifted by its own height, so nothing
fights for a pixel and nothing leaves a gap: the terrain goes on underneath. Where surfaces
meet, the more important one is kept and cut out of the others.
"""

from dataclasses import dataclass
from math import sqrt

from .layout import AREAS, POND_COPING, POND_RIM, RIBBONS, ROAD_WIDTH, ROAD_Z
from .mesh import Mesh
from .polygon import bounds, clip, contains, facing_up, offset, subtract_all

# Heights above the terrain, metres.
ROAD_TOP = 0.04
PATH_TOP = 0.06
PAVEMENT_TOP = 0.15
KERB_TOP = 0.16        # 0.12 above a road, 0.10 above a path
KERB_WIDTH = 0.15
PAVEMENT_WIDTH = 1.8
COPING_TOP = 0.10
SKIRT = 0.06           # how far an edge reaches below what it stands on
PROBE = 0.02           # how far beyond an edge its neighbour is looked for


@dataclass
class Surface:
    """A paved surface: convex world polygons, each with an affine texture layout or None."""

    name: str
    material: str
    top: float
    pieces: list  # [(polygon, layout)]


def _strip(line, left, right):
    """Quads between two offsets of a line (metres to its right), with mitred joints."""
    closed = line[0] == line[-1]
    points = list(line[:-1] if closed else line)
    count = len(points)
    sides = []
    for i, (x, z) in enumerate(points):
        before = points[i - 1] if i or closed else None
        after = points[(i + 1) % count] if i + 1 < count or closed else None
        normals = []
        for (ax, az), (bx, bz) in [(p, q) for p, q in ((before, (x, z)), ((x, z), after))
                                   if p and q]:
            length = sqrt((bx - ax) ** 2 + (bz - az) ** 2)
            normals.append((-(bz - az) / length, (bx - ax) / length))
        nx, nz = sum(n[0] for n in normals), sum(n[1] for n in normals)
        scale = 2.0 / (nx * nx + nz * nz) if len(normals) == 2 else 1.0
        sides.append(((x + nx * left * scale, z + nz * left * scale),
                      (x + nx * right * scale, z + nz * right * scale)))
    quads = []
    for i in range(count if closed else count - 1):
        a, b = sides[i], sides[(i + 1) % count]
        quads.append((facing_up([a[0], a[1], b[1], b[0]]), points[i], points[(i + 1) % count]))
    return quads


def _along(start, end, run, width):
    """Texture layout along a ribbon: u across its width, v along it."""
    length = sqrt((end[0] - start[0]) ** 2 + (end[1] - start[1]) ** 2)
    dx, dz = (end[0] - start[0]) / length, (end[1] - start[1]) / length

    def layout(x, z):
        px, pz = x - start[0], z - start[1]
        return 0.5 + (px * -dz + pz * dx) / width, (run + px * dx + pz * dz) / 7.0
    return layout, length


def _ribbon_surface(ribbon):
    half, run, pieces = ribbon.width / 2.0, 0.0, []
    for quad, start, end in _strip(ribbon.line, -half, half):
        layout, length = _along(start, end, run, ribbon.width)
        pieces.append((quad, layout if ribbon.kind == "road" else None))
        run += length
    material, top = ("road", ROAD_TOP) if ribbon.kind == "road" else ("setts", PATH_TOP)
    return Surface(ribbon.name, material, top, pieces)


def _kerbs(ribbon):
    half = ribbon.width / 2.0
    pieces = [(quad, None) for side in (-1.0, 1.0)
              for quad, _, _ in _strip(ribbon.line, side * half, side * (half + KERB_WIDTH))]
    return Surface("kerb_" + ribbon.name.split("_", 1)[1], "granite", KERB_TOP, pieces)


def _area_kerb(name, poly):
    ring = offset(poly, KERB_WIDTH)
    pieces = []
    for i, a in enumerate(poly):
        j = (i + 1) % len(poly)
        pieces.append((facing_up([a, ring[i], ring[j], poly[j]]), None))
    return Surface(name, "granite", KERB_TOP, pieces)


def _surfaces():
    """All surfaces, the most important first."""
    coping = [(facing_up([POND_RIM[i], POND_COPING[i], POND_COPING[(i + 1) % len(POND_RIM)],
                          POND_RIM[(i + 1) % len(POND_RIM)]]), None) for i in range(len(POND_RIM))]
    roads = [_ribbon_surface(r) for r in RIBBONS if r.kind == "road"]
    areas = [Surface(name, material, PATH_TOP, [(facing_up(poly), None)])
             for name, material, poly in AREAS]
    paths = [_ribbon_surface(r) for r in RIBBONS if r.kind == "path"]
    near = ROAD_WIDTH / 2.0 + KERB_WIDTH
    pavement = [(quad, None) for quad, _, _ in
                _strip(((-119.0, ROAD_Z), (119.0, ROAD_Z)), -near, -near - PAVEMENT_WIDTH)]
    kerbs = [_kerbs(r) for r in RIBBONS]
    kerbs += [_area_kerb("kerb_" + name.split("_", 1)[-1], facing_up(poly))
              for name, _, poly in AREAS if not name.startswith("path_inlay")]
    return ([Surface("pond_coping", "granite", COPING_TOP, coping)] + roads + areas + paths
            + kerbs[:1] + [Surface("path_pavement", "slabs", PAVEMENT_TOP, pavement)] + kerbs[1:])


class Paving:
    """All paved surfaces of the site; `voids` are building floors, cut out of them."""

    def __init__(self, terrain, voids):
        self._terrain = terrain
        self._index = {}  # terrain cell -> [(top, polygon, name)], highest first
        self.surfaces = []
        taken = [facing_up(v) for v in voids]
        for surface in _surfaces():
            own = []
            for poly, layout in surface.pieces:
                rest = subtract_all([poly], _near(taken, poly))
                rest = subtract_all(rest, _near(own, poly))
                surface_pieces = [(piece, layout) for piece in rest]
                own.append(poly)
                self._keep(surface, surface_pieces)
            taken += own
        for entries in self._index.values():
            entries.sort(key=lambda entry: -entry[0])

    def _keep(self, surface, pieces):
        if not self.surfaces or self.surfaces[-1].name != surface.name:
            self.surfaces.append(Surface(surface.name, surface.material, surface.top, []))
        self.surfaces[-1].pieces += pieces
        for poly, _ in pieces:
            for cell in self._terrain.cells(bounds(poly)):
                self._index.setdefault(cell, []).append((surface.top, poly, surface.name))

    def lift(self, x, z):
        """Height of the highest surface above the terrain at a point (0 on grass)."""
        cell = self._terrain.cells((x, z, x, z))[0]
        for top, poly, _ in self._index.get(cell, ()):
            if contains(poly, (x, z)):
                return top
        return 0.0

    def top(self, x, z):
        """Height of what one stands on outdoors."""
        return self._terrain.height(x, z) + self.lift(x, z)

    def meshes(self):
        """[(node name, mesh)] of every surface."""
        return [(surface.name, self._mesh(surface)) for surface in self.surfaces if surface.pieces]

    def _mesh(self, surface):
        mesh, terrain = Mesh(), self._terrain
        for poly, layout in surface.pieces:
            for cell in terrain.cells(bounds(poly)):
                for corners in terrain.triangles(*cell):
                    flat = [(x, z) for x, _, z in (terrain.corner(*c) for c in corners)]
                    piece = clip(poly, flat)
                    if piece:
                        self._face(mesh, surface, piece, layout)
        return mesh

    def _face(self, mesh, surface, piece, layout):
        terrain = self._terrain
        points = [(x, terrain.height(x, z) + surface.top, z) for x, z in piece]
        mesh.poly(surface.material, points,
                  uvs=[layout(x, z) for x, z in piece] if layout else None,
                  normals=[terrain.normal(x, z) for x, z in piece])
        for i, (x0, z0) in enumerate(piece):
            x1, z1 = piece[(i + 1) % len(piece)]
            length = sqrt((x1 - x0) ** 2 + (z1 - z0) ** 2)
            if length < 0.01:
                continue
            out = self.lift((x0 + x1) / 2 - (z1 - z0) / length * PROBE,
                            (z0 + z1) / 2 + (x1 - x0) / length * PROBE)
            if out < surface.top - 0.001:
                a, b = points[i], points[(i + 1) % len(piece)]
                foot = surface.top - out + SKIRT
                side = "granite" if surface.material == "road" else surface.material
                mesh.quad(side, (a[0], a[1] - foot, a[2]), (b[0], b[1] - foot, b[2]), b, a)


def _near(convexes, poly):
    """Those convex polygons that overlap a polygon."""
    box = bounds(poly)
    out = []
    for other in convexes:
        b = bounds(other)
        if b[0] < box[2] and box[0] < b[2] and b[1] < box[3] and box[1] < b[3] \
                and clip(poly, other):
            out.append(other)
    return out
