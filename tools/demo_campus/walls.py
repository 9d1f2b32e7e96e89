"""Walls with real thickness and real openings, and what fills the openings."""

from dataclasses import dataclass
from math import sqrt

from .polygon import offset

# (left, right) ends closed; walls that run into other walls leave theirs open.
CLOSED, OPEN = (True, True), (False, False)


@dataclass(frozen=True)
class Opening:
    """A hole in a wall: `at` metres along it (its middle), bottom and top above the wall's y0."""

    at: float
    width: float
    bottom: float
    top: float
    fill: str = ""      # window style, door style, or "" for a bare hole


@dataclass(frozen=True)
class WallStyle:
    """Materials of a wall; `inner` None makes a shell seen from outside only."""

    outer: str
    inner: str = None
    reveal: str = None
    thickness: float = 0.30
    recess: float = 0.28   # how deep a window sits in a shell


def _steps(low, high, cuts):
    """Sorted distinct positions from low to high."""
    inside = {round(c, 4) for c in cuts if low + 1e-4 < c < high - 1e-4}
    return [low] + sorted(inside) + [high]


def _grid_face(mesh, material, origin, direction, s_range, y0, y1, openings, flip):
    """One side of a wall as a grid without T-junctions, holes left out."""
    s_cuts = _steps(s_range[0], s_range[1],
                    [o.at + side * o.width / 2 for o in openings for side in (-1, 1)])
    y_cuts = _steps(y0, y1, [y0 + y for o in openings for y in (o.bottom, o.top)])

    def at(s, y):
        return origin[0] + direction[0] * s, y, origin[1] + direction[1] * s
    for s0, s1 in zip(s_cuts, s_cuts[1:]):
        middle = (s0 + s1) / 2
        for ya, yb in zip(y_cuts, y_cuts[1:]):
            height = (ya + yb) / 2 - y0
            if any(abs(middle - o.at) < o.width / 2 and o.bottom < height < o.top
                   for o in openings):
                continue
            corners = [at(s0, ya), at(s1, ya), at(s1, yb), at(s0, yb)]
            mesh.poly(material, corners[::-1] if flip else corners)


def wall(mesh, style, a, b, y0, y1, openings=(), inner_range=None, ends=CLOSED, top=True,
         thresholds=True):
    """A wall whose outer face runs from a to b with the outside on the right hand.

    thresholds: False leaves out the sills of doorways, where a floor runs through.
    inner_range: where the inner face starts and stops along a->b (mitred corners shorten it).
    Returns [(opening, middle point, direction, outward)] for whatever fills the openings.
    """
    dx, dz = b[0] - a[0], b[1] - a[1]
    length = sqrt(dx * dx + dz * dz)
    direction = (dx / length, dz / length)
    out = (-direction[1], direction[0])
    depth = style.thickness if style.inner else style.recess
    back = (a[0] - out[0] * style.thickness, a[1] - out[1] * style.thickness)
    s0, s1 = inner_range or (0.0, length)
    _grid_face(mesh, style.outer, a, direction, (0.0, length), y0, y1, openings, False)
    if style.inner:
        _grid_face(mesh, style.inner, back, direction, (s0, s1), y0, y1, openings, True)
        _edges(mesh, style, a, back, direction, length, (s0, s1), y0, y1, ends, top)
    places = []
    for opening in openings:
        _reveal(mesh, style.reveal or style.inner or style.outer, a, direction, out, depth, y0,
                opening, thresholds or opening.bottom > 0.0)
        places.append((opening, (a[0] + direction[0] * opening.at, y0 + opening.bottom,
                                 a[1] + direction[1] * opening.at), direction, out))
    return places


def _edges(mesh, style, a, back, direction, length, s_range, y0, y1, ends, top):
    def front(s, y):
        return a[0] + direction[0] * s, y, a[1] + direction[1] * s

    def rear(s, y):
        return back[0] + direction[0] * s, y, back[1] + direction[1] * s
    s0, s1 = s_range
    if top:
        mesh.quad(style.outer, front(0, y1), front(length, y1), rear(s1, y1), rear(s0, y1))
    if ends[0]:
        mesh.quad(style.outer, rear(s0, y0), front(0, y0), front(0, y1), rear(s0, y1))
    if ends[1]:
        mesh.quad(style.outer, front(length, y0), rear(s1, y0), rear(s1, y1), front(length, y1))


def _reveal(mesh, material, a, direction, out, depth, y0, opening, sill):
    """The four faces inside an opening, or three without its sill."""
    left, right = opening.at - opening.width / 2, opening.at + opening.width / 2
    low, high = y0 + opening.bottom, y0 + opening.top

    def at(s, y, d):
        return a[0] + direction[0] * s - out[0] * d, y, a[1] + direction[1] * s - out[1] * d
    mesh.quad(material, at(left, low, 0), at(left, low, depth),
              at(left, high, depth), at(left, high, 0))
    mesh.quad(material, at(right, low, depth), at(right, low, 0),
              at(right, high, 0), at(right, high, depth))
    mesh.quad(material, at(left, high, 0), at(left, high, depth),
              at(right, high, depth), at(right, high, 0))
    if sill:
        mesh.quad(material, at(left, low, depth), at(left, low, 0),
                  at(right, low, 0), at(right, low, depth))


def perimeter(mesh, style, poly, y0, y1, openings=None, top=True):
    """Walls along an upward polygon (outer faces); openings: {edge index: [Opening]}."""
    inner = offset(poly, -style.thickness)
    count, places = len(poly), []
    for i, a in enumerate(poly):
        b = poly[(i + 1) % count]
        dx, dz = b[0] - a[0], b[1] - a[1]
        length = sqrt(dx * dx + dz * dz)

        def along(p, a=a, dx=dx, dz=dz, length=length):
            return ((p[0] - a[0]) * dx + (p[1] - a[1]) * dz) / length
        places += wall(mesh, style, a, b, y0, y1, (openings or {}).get(i, ()),
                       (along(inner[i]), along(inner[(i + 1) % count])), OPEN, top)
    return places


def partition(mesh, material, a, b, y0, y1, openings=(), thickness=0.25):
    """An inner wall centred on the line a-b, closed on all sides."""
    dx, dz = b[0] - a[0], b[1] - a[1]
    length = sqrt(dx * dx + dz * dz)
    ox, oz = -dz / length * thickness / 2, dx / length * thickness / 2
    style = WallStyle(material, material, material, thickness)
    return wall(mesh, style, (a[0] + ox, a[1] + oz), (b[0] + ox, b[1] + oz), y0, y1, openings,
                thresholds=False)


def wainscot(mesh, material, a, b, y0, openings=(), height=1.0, thickness=0.29):
    """Panelling along both sides of a partition, interrupted at its doorways."""
    dx, dz = b[0] - a[0], b[1] - a[1]
    length = sqrt(dx * dx + dz * dz)
    start = -0.05  # its ends reach into the walls it runs against
    for opening in sorted(openings, key=lambda o: o.at) + [None]:
        stop = opening.at - opening.width / 2 - 0.04 if opening else length + 0.05
        if stop - start > 0.1:
            ends = [(a[0] + dx * s / length, a[1] + dz * s / length) for s in (start, stop)]
            partition(mesh, material, *ends, y0, y0 + height, (), thickness)
        if opening:
            start = opening.at + opening.width / 2 + 0.04


def row(length, count, width, bottom, top, fill, margin=1.2, skip=()):
    """Evenly spaced openings along a wall of some length; skip: numbers to leave out."""
    pitch = (length - 2 * margin) / count
    return [Opening(margin + pitch * (i + 0.5), width, bottom, top, fill)
            for i in range(count) if i not in skip]
