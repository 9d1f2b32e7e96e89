"""Solids the buildings, trees and furniture are made of."""

from math import sqrt

from .exact import cos_deg, sin_deg
from .mesh import unit
from .polygon import facing_up, offset


def ngon(sides, radius, centre=(0.0, 0.0), start_deg=0.0):
    """A regular polygon, upward."""
    return facing_up([(centre[0] + radius * cos_deg(start_deg + 360.0 / sides * i),
                       centre[1] + radius * sin_deg(start_deg + 360.0 / sides * i))
                      for i in range(sides)])


def prism(mesh, material, poly, y0, y1, top=True, bottom=False, cap_material=None):
    """An upright prism over an upward polygon (caps only where it is convex)."""
    count = len(poly)
    for i, (x0, z0) in enumerate(poly):
        x1, z1 = poly[(i + 1) % count]
        mesh.quad(material, (x0, y0, z0), (x1, y0, z1), (x1, y1, z1), (x0, y1, z0))
    if top:
        mesh.poly(cap_material or material, [(x, y1, z) for x, z in poly])
    if bottom:
        mesh.poly(cap_material or material, [(x, y0, z) for x, z in reversed(poly)])


def band(mesh, material, poly, y0, y1, out, bottom=True):
    """A plinth, string course or cornice: a belt that stands `out` from a polygon's walls."""
    outer, count = offset(poly, out), len(poly)
    for i in range(count):
        j = (i + 1) % count
        (ax, az), (bx, bz), (cx, cz), (dx, dz) = outer[i], outer[j], poly[j], poly[i]
        mesh.quad(material, (ax, y0, az), (bx, y0, bz), (bx, y1, bz), (ax, y1, az))
        mesh.quad(material, (ax, y1, az), (bx, y1, bz), (cx, y1, cz), (dx, y1, dz))
        if bottom:
            mesh.quad(material, (bx, y0, bz), (ax, y0, az), (dx, y0, dz), (cx, y0, cz))


def ring(mesh, material, poly, y0, y1, thickness):
    """A parapet or kerb: a closed wall of some thickness inside a polygon's outline."""
    inner, count = offset(poly, -thickness), len(poly)
    for i in range(count):
        j = (i + 1) % count
        (ax, az), (bx, bz), (cx, cz), (dx, dz) = poly[i], poly[j], inner[j], inner[i]
        mesh.quad(material, (ax, y0, az), (bx, y0, bz), (bx, y1, bz), (ax, y1, az))
        mesh.quad(material, (cx, y0, cz), (dx, y0, dz), (dx, y1, dz), (cx, y1, cz))
        mesh.quad(material, (ax, y1, az), (bx, y1, bz), (cx, y1, cz), (dx, y1, dz))


def lathe(mesh, material, profile, sides, centre=(0.0, 0.0), smooth=True, start_deg=0.0,
          uv_around=None):
    """A body of revolution about a vertical axis. profile: (radius, y), from bottom to top.

    A profile that turns back towards the axis gives the underside and top faces.
    """
    steps = len(profile) - 1
    rim = [(cos_deg(start_deg - 360.0 / sides * i), sin_deg(start_deg - 360.0 / sides * i))
           for i in range(sides + 1)]
    slopes = []
    for (r0, y0), (r1, y1) in zip(profile, profile[1:]):
        length = sqrt((r1 - r0) ** 2 + (y1 - y0) ** 2) or 1.0
        slopes.append(((y1 - y0) / length, (r0 - r1) / length))
    run = [0.0]
    for (r0, y0), (r1, y1) in zip(profile, profile[1:]):
        run.append(run[-1] + sqrt((r1 - r0) ** 2 + (y1 - y0) ** 2))
    widest = max(r for r, _ in profile)
    around = uv_around or max(1.0, round(6.2831853 * widest))

    def corner(level, i):
        radius, y = profile[level]
        return centre[0] + radius * rim[i][0], y, centre[1] + radius * rim[i][1]

    def tilt(step, level):
        if not smooth:
            return slopes[step]
        other = step + 1 if level > step else step - 1
        if 0 <= other < steps:
            dot = slopes[step][0] * slopes[other][0] + slopes[step][1] * slopes[other][1]
            if dot > 0.6:
                return (slopes[step][0] + slopes[other][0], slopes[step][1] + slopes[other][1])
        return slopes[step]

    for step in range(steps):
        for i in range(sides):
            spots = ((step, i), (step, i + 1), (step + 1, i + 1), (step + 1, i))
            points, normals, uvs = [], [], []
            for level, k in spots:
                n_out, n_up = tilt(step, level)
                points.append(corner(level, k))
                side = rim[k] if smooth else (rim[i][0] + rim[i + 1][0], rim[i][1] + rim[i + 1][1])
                side = unit((side[0], 0.0, side[1]))
                normals.append(unit((side[0] * n_out, n_up, side[2] * n_out)))
                uvs.append((around * k / sides, -run[level]))
            _lathe_face(mesh, material, profile, step, points, normals, uvs)


def _lathe_face(mesh, material, profile, step, points, normals, uvs):
    if profile[step][0] < 1e-6:
        keep = (0, 2, 3)
    elif profile[step + 1][0] < 1e-6:
        keep = (0, 1, 2)
    else:
        keep = (0, 1, 2, 3)
    mesh.poly(material, [points[k] for k in keep], [uvs[k] for k in keep],
              [normals[k] for k in keep])


def tube(mesh, material, start, end, radius0, radius1, sides=6):
    """A tapered round bar between two points, without end caps."""
    axis = unit(tuple(b - a for a, b in zip(start, end)))
    helper = (1.0, 0.0, 0.0) if abs(axis[0]) < 0.8 else (0.0, 0.0, 1.0)
    u = unit(_cross(axis, helper))
    v = _cross(axis, u)
    length = sqrt(sum((b - a) ** 2 for a, b in zip(start, end)))
    spokes = []
    for i in range(sides + 1):
        c, s = cos_deg(360.0 / sides * i), sin_deg(360.0 / sides * i)
        spokes.append(tuple(u[k] * c + v[k] * s for k in range(3)))
    for i in range(sides):
        corners = []
        for centre, radius, spoke in ((start, radius0, spokes[i]), (start, radius0, spokes[i + 1]),
                                      (end, radius1, spokes[i + 1]), (end, radius1, spokes[i])):
            corners.append(tuple(centre[k] + radius * spoke[k] for k in range(3)))
        normals = [spokes[i], spokes[i + 1], spokes[i + 1], spokes[i]]
        uvs = [(i / sides, 0.0), ((i + 1) / sides, 0.0),
               ((i + 1) / sides, -length / 2), (i / sides, -length / 2)]
        if radius1 < 1e-6:
            mesh.poly(material, corners[:3], uvs[:3], normals[:3])
        else:
            mesh.quad(material, *corners, uvs, normals)


def beam(mesh, material, start, end, width, height):
    """A rectangular bar between two points: its section is `width` across, `height` high.

    The section stays upright (its sides vertical), so a railing follows a stair.
    """
    dx, dz = end[0] - start[0], end[2] - start[2]
    length = sqrt(dx * dx + dz * dz)
    nx, nz = -dz / length * width / 2, dx / length * width / 2

    def section(point):
        x, y, z = point
        return [(x - nx, y, z - nz), (x + nx, y, z + nz),
                (x + nx, y + height, z + nz), (x - nx, y + height, z - nz)]
    a, b = section(start), section(end)
    for i in range(4):
        j = (i + 1) % 4
        mesh.quad(material, b[i], b[j], a[j], a[i])
    mesh.poly(material, a)
    mesh.poly(material, list(reversed(b)))


def _cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


_PHI = 1.618033989
_ICO_POINTS = [unit(p) for p in (
    (-1, _PHI, 0), (1, _PHI, 0), (-1, -_PHI, 0), (1, -_PHI, 0), (0, -1, _PHI), (0, 1, _PHI),
    (0, -1, -_PHI), (0, 1, -_PHI), (_PHI, 0, -1), (_PHI, 0, 1), (-_PHI, 0, -1), (-_PHI, 0, 1))]
_ICO_FACES = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4),
              (11, 10, 2), (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8),
              (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]


def sphere_net(levels):
    """(points, faces) of a unit sphere: an icosahedron, each face split in four `levels` times."""
    points, faces = list(_ICO_POINTS), list(_ICO_FACES)
    for _ in range(levels):
        middle, split = {}, []

        def between(i, j, middle=middle):
            key = (min(i, j), max(i, j))
            if key not in middle:
                points.append(unit(tuple(a + b for a, b in zip(points[i], points[j]))))
                middle[key] = len(points) - 1
            return middle[key]
        for a, b, c in faces:
            ab, bc, ca = between(a, b), between(b, c), between(c, a)
            split += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
        faces = split
    return points, faces
