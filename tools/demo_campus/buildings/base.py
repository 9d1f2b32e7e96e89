"""What every building is made of: named parts, shared windows, rooms and named points."""

import math
from dataclasses import dataclass, field

from .. import joinery
from ..gltf import Node
from ..layout import PLACEMENTS
from ..mesh import Mesh
from ..polygon import offset, subtract
from ..shapes import prism
from ..walls import perimeter

FOOTING = 0.12  # metres
_FITTINGS = {}  # (style, width, height, thickness) -> shared mesh


def _fitting(style, width, height, thickness):
    key = (style, width, height, thickness if style == "open" else 0.0)
    if key not in _FITTINGS:
        if style == "open":
            _FITTINGS[key] = joinery.open_door(width, height, thickness)
        elif style == "door":
            _FITTINGS[key] = joinery.closed_door(width, height)
        else:
            _FITTINGS[key] = joinery.window(style, width, height)
    return _FITTINGS[key]


def yaw_towards(out_x, out_z):
    """Degrees about +Y that turn +z to a horizontal direction."""
    return round(math.degrees(math.atan2(out_x, out_z)), 3) + 0.0


@dataclass
class Trigger:
    """A trigger box in the building's frame: its centre (y above the pad) and size."""

    name: str
    centre: tuple
    size: tuple


@dataclass
class Building:
    """A building under construction. Coordinates: own frame, y above its pad."""

    id: str
    parts: dict = field(default_factory=dict)
    props: list = field(default_factory=list)
    points: dict = field(default_factory=dict)     # place name -> (x, y, z)
    triggers: list = field(default_factory=list)
    voids: list = field(default_factory=list)      # convex floors that paving leaves out
    _counts: dict = field(default_factory=dict)

    @property
    def place(self):
        """Where it stands."""
        return PLACEMENTS[self.id]

    @property
    def node_name(self):
        """Its node; parts and props are named after it."""
        return self.id.replace("-", "_")

    def part(self, name):
        """The mesh of a named part, e.g. walls."""
        return self.parts.setdefault(name, Mesh())

    def prop(self, kind, mesh, at, yaw_deg=0.0, scale=1.0):
        """Places a copy of a shared mesh."""
        self._counts[kind] = self._counts.get(kind, 0) + 1
        name = "%s_%s_%02d" % (self.node_name, kind, self._counts[kind])
        self.props.append(Node(name, mesh, at, yaw_deg, scale))

    def fill(self, places, thickness=0.30):
        """Puts windows and doors into wall openings (see walls.wall)."""
        for opening, at, _, out in places:
            if opening.fill:
                mesh = _fitting(opening.fill, round(opening.width, 3),
                                round(opening.top - opening.bottom, 3), thickness)
                kind = "door" if opening.fill in ("open", "door") else "window"
                self.prop(kind, mesh, at, yaw_towards(*out))

    def shell(self, style, poly, y0, y1, openings=None, part="walls", top=True, footing=FOOTING):
        """Outer walls along a polygon, with their windows and doors.

        They go a hand (footing) deeper than y0, behind the plinth, so that no slit opens under them.
        """
        if footing:
            prism(self.part(part), style.outer, poly, y0 - footing, y0, top=False)
        self.fill(perimeter(self.part(part), style, poly, y0, y1, openings, top),
                  style.thickness)

    def floor(self, material, poly, y, holes=(), part="floor"):
        """A walkable floor over a convex polygon, minus convex holes."""
        for piece in _minus(poly, holes):
            self.part(part).poly(material, [(x, y, z) for x, z in piece])

    def ceiling(self, material, poly, y, holes=(), part="ceiling"):
        """The underside of a storey."""
        for piece in _minus(poly, holes):
            self.part(part).poly(material, [(x, y, z) for x, z in reversed(piece)])

    def hole_edges(self, material, hole, y0, y1, part="floor", skip=()):
        """The faces of a slab around an opening, looking into it; skip: edges along a wall."""
        mesh, count = self.part(part), len(hole)
        for i, (ax, az) in enumerate(hole):
            if i in skip:
                continue
            bx, bz = hole[(i + 1) % count]
            mesh.quad(material, (bx, y0, bz), (ax, y0, az), (ax, y1, az), (bx, y1, bz))

    def door_trigger(self, x, y, z, width=2.4, depth=2.4, name="door"):
        """A trigger around a doorway whose threshold is (x, y, z)."""
        self.triggers.append(Trigger(name, (x, y + 1.25, z), (width, 2.5, depth)))

    def node(self):
        """The node tree."""
        place = self.place
        children = [Node("%s_%s" % (self.node_name, name), mesh)
                    for name, mesh in self.parts.items()]
        return Node(self.node_name, None, (place.x, place.level, place.z), place.yaw_deg,
                    children=children + self.props)


def _minus(poly, holes):
    pieces = [poly]
    for hole in holes:
        pieces = [rest for piece in pieces for rest in subtract(piece, hole)]
    return pieces


def inside(poly, thickness):
    """The room inside walls of some thickness."""
    return offset(poly, -thickness)
