"""Triangle meshes, grouped by material, on a 0.1 mm lattice.

Vertices are stored as integers (0.1 mm, 1e-4 of a normal or of a texture repeat): equal corners
are shared exactly, and no last-bit difference of a computation reaches a file.
"""

from math import sqrt

from .materials import MATERIALS

LATTICE = 10000  # steps per metre, per unit normal and per texture repeat
FLAT = 0.95      # |normal.y| above which a texture is laid out by x and z


def _newell(points):
    """Twice the area vector of a polygon."""
    nx = ny = nz = 0.0
    for i, (x0, y0, z0) in enumerate(points):
        x1, y1, z1 = points[(i + 1) % len(points)]
        nx += (y0 - y1) * (z0 + z1)
        ny += (z0 - z1) * (x0 + x1)
        nz += (x0 - x1) * (y0 + y1)
    return nx, ny, nz


def unit(vector):
    """A vector of length one (or up, for a null vector)."""
    x, y, z = vector
    length = sqrt(x * x + y * y + z * z)
    return (x / length, y / length, z / length) if length > 1e-12 else (0.0, 1.0, 0.0)


def _lattice(values):
    return tuple(int(round(v * LATTICE)) for v in values)


class Part:
    """The triangles of one material."""

    def __init__(self):
        self.vertices = {}  # (x y z nx ny nz u v) in lattice steps -> index, in order of first use
        self.indices = []

    def vertex(self, point, normal, uv):
        """Index of a vertex, shared when an equal one exists."""
        key = _lattice(point) + _lattice(normal) + _lattice(uv)
        return self.vertices.setdefault(key, len(self.vertices))


class Mesh:
    """Named parts by material; faces are given counter-clockwise as seen from outside."""

    def __init__(self):
        self.parts = {}

    def triangles(self):
        """Number of triangles."""
        return sum(len(part.indices) // 3 for part in self.parts.values())

    def poly(self, material, points, uvs=None, normals=None):
        """A flat convex polygon. Without uvs the material's tile size lays the texture out."""
        normal = unit(_newell(points))
        if uvs is None:
            uvs = self.layout(material, points, normal)
        part = self.parts.setdefault(material, Part())
        corners = [part.vertex(p, normals[i] if normals else normal, uvs[i])
                   for i, p in enumerate(points)]
        spots = [_lattice(p) for p in points]
        for i in range(1, len(corners) - 1):
            if _has_area(spots[0], spots[i], spots[i + 1]):
                part.indices += (corners[0], corners[i], corners[i + 1])

    def quad(self, material, a, b, c, d, uvs=None, normals=None):
        """A four-cornered face."""
        self.poly(material, (a, b, c, d), uvs, normals)

    @staticmethod
    def layout(material, points, normal):
        """Texture coordinates in real size: x/z on flat faces, along the face elsewhere."""
        tile_u, tile_v = MATERIALS[material].tile
        nx, ny, nz = normal
        if ny > FLAT or ny < -FLAT:
            return [(x / tile_u, z / tile_v) for x, _, z in points]
        tx, _, tz = unit((nz, 0.0, -nx))
        bx, by, bz = ny * tz, nz * tx - nx * tz, -ny * tx
        return [((x * tx + z * tz) / tile_u, -(x * bx + y * by + z * bz) / tile_v)
                for x, y, z in points]

    def box(self, material, low, high, skip=""):
        """An axis-aligned box; skip names faces to leave out, of 'x X y Y z Z' (capital: high)."""
        (x0, y0, z0), (x1, y1, z1) = low, high
        faces = {
            "x": ((x0, y0, z0), (x0, y0, z1), (x0, y1, z1), (x0, y1, z0)),
            "X": ((x1, y0, z1), (x1, y0, z0), (x1, y1, z0), (x1, y1, z1)),
            "y": ((x0, y0, z0), (x1, y0, z0), (x1, y0, z1), (x0, y0, z1)),
            "Y": ((x0, y1, z1), (x1, y1, z1), (x1, y1, z0), (x0, y1, z0)),
            "z": ((x1, y0, z0), (x0, y0, z0), (x0, y1, z0), (x1, y1, z0)),
            "Z": ((x0, y0, z1), (x1, y0, z1), (x1, y1, z1), (x0, y1, z1)),
        }
        for name, corners in faces.items():
            if name not in skip:
                self.poly(material, corners)

    def merge(self, other, move=(0.0, 0.0, 0.0), sin=0.0, cos=1.0, scale=1.0):
        """Adds a copy of another mesh, scaled, turned about +Y and moved."""
        def turn(x, y, z):
            return x * cos + z * sin, y, z * cos - x * sin
        for material, source in other.parts.items():
            part = self.parts.setdefault(material, Part())
            index = []
            for key in source.vertices:
                x, y, z, nx, ny, nz, u, v = (k / LATTICE for k in key)
                px, py, pz = turn(x * scale, y * scale, z * scale)
                index.append(part.vertex((px + move[0], py + move[1], pz + move[2]),
                                         turn(nx, ny, nz), (u, v)))
            part.indices += [index[i] for i in source.indices]


def _has_area(a, b, c):
    ux, uy, uz = b[0] - a[0], b[1] - a[1], b[2] - a[2]
    vx, vy, vz = c[0] - a[0], c[1] - a[1], c[2] - a[2]
    return (uy * vz - uz * vy) or (uz * vx - ux * vz) or (ux * vy - uy * vx)
