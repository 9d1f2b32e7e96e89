"""Convex polygons in the ground plane, as lists of (x, z).

Orientation: counter-clockwise seen from above (+Y towards the viewer, +Z towards the south),
so that a polygon read in order gives an upward face. `outward` walks such a polygon with its
inside on the left.
"""

from math import sqrt

MIN_AREA = 1e-4  # m2; slivers below are dropped: smaller than a fingernail, invisible


def signed_area(poly):
    """Area, positive when the polygon faces upwards."""
    total = 0.0
    for i, (x0, z0) in enumerate(poly):
        x1, z1 = poly[(i + 1) % len(poly)]
        total += x1 * z0 - x0 * z1
    return 0.5 * total


def facing_up(poly):
    """The polygon, reversed if it faced downwards."""
    return list(poly) if signed_area(poly) > 0 else list(reversed(poly))


def rect(x0, z0, x1, z1):
    """Axis-aligned rectangle."""
    return [(x0, z1), (x1, z1), (x1, z0), (x0, z0)]


def bounds(poly):
    """(min x, min z, max x, max z)."""
    xs = [p[0] for p in poly]
    zs = [p[1] for p in poly]
    return min(xs), min(zs), max(xs), max(zs)


def _side(a, b, p):
    """Positive when p lies left of a->b (inside an upward polygon)."""
    return (b[1] - a[1]) * (p[0] - a[0]) - (b[0] - a[0]) * (p[1] - a[1])


def contains(poly, p):
    """Whether a convex upward polygon holds a point (its border counts)."""
    return all(_side(a, poly[(i + 1) % len(poly)], p) >= -1e-9 for i, a in enumerate(poly))


def _cut(poly, a, b, sign):
    """The part of a convex polygon left (sign 1) or right (sign -1) of the line a->b."""
    out = []
    count = len(poly)
    sides = [sign * _side(a, b, p) for p in poly]
    for i in range(count):
        p, q = poly[i], poly[(i + 1) % count]
        sp, sq = sides[i], sides[(i + 1) % count]
        if sp >= 0:
            out.append(p)
        if (sp > 0 > sq) or (sp < 0 < sq):
            t = sp / (sp - sq)
            out.append((p[0] + (q[0] - p[0]) * t, p[1] + (q[1] - p[1]) * t))
    return out


def _solid(poly):
    return len(poly) >= 3 and signed_area(poly) > MIN_AREA


def clip(poly, convex):
    """Intersection of two convex polygons, or an empty list."""
    for i, a in enumerate(convex):
        poly = _cut(poly, a, convex[(i + 1) % len(convex)], 1)
        if len(poly) < 3:
            return []
    return poly if _solid(poly) else []


def _apart(box, other):
    return box[2] <= other[0] or other[2] <= box[0] or box[3] <= other[1] or other[3] <= box[1]


def subtract(poly, convex):
    """What is left of a convex polygon outside another, as convex pieces."""
    if _apart(bounds(poly), bounds(convex)) or not clip(poly, convex):
        return [poly]
    pieces = []
    for i, a in enumerate(convex):
        b = convex[(i + 1) % len(convex)]
        outside = _cut(poly, a, b, -1)
        if _solid(outside):
            pieces.append(outside)
        poly = _cut(poly, a, b, 1)
        if not _solid(poly):
            break
    return pieces


def subtract_all(polys, convexes):
    """Convex pieces of all `polys` outside all `convexes`."""
    for convex in convexes:
        polys = [piece for poly in polys for piece in subtract(poly, convex)]
    return polys


def offset(poly, distance):
    """A simple upward polygon grown by `distance` with mitred corners (negative shrinks)."""
    out = []
    count = len(poly)
    for i in range(count):
        (x0, z0), (x1, z1), (x2, z2) = poly[i - 1], poly[i], poly[(i + 1) % count]
        ax, az = x1 - x0, z1 - z0
        bx, bz = x2 - x1, z2 - z1
        la = sqrt(ax * ax + az * az)
        lb = sqrt(bx * bx + bz * bz)
        nax, naz = -az / la, ax / la  # right-hand normals point outwards
        nbx, nbz = -bz / lb, bx / lb
        scale = distance / (1.0 + nax * nbx + naz * nbz)
        out.append((x1 + (nax + nbx) * scale, z1 + (naz + nbz) * scale))
    return out
