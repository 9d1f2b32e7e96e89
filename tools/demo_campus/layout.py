"""Where everything stands: the one table of positions of the demo campus.

World frame: metres, x east, z south, +Y up. A building's own frame has its front towards +z.
"""

from dataclasses import dataclass

from .exact import cos_deg, sin_deg
from .polygon import facing_up, rect

# The site is a whole number of terrain cells.
CELL = 3.0
WEST, EAST, NORTH, SOUTH = -120.0, 120.0, -114.0, 102.0

FLOOR_ABOVE_PAD = 0.10  # ground floors; the terrain under them stays this much lower


@dataclass(frozen=True)
class Placement:
    """A building's pose, and the flat ground (pad) prepared for it in its own frame."""

    x: float
    z: float
    yaw_deg: float
    level: float     # height of the pad, metres
    pad: tuple       # (x0, z0, x1, z1), own frame

    def world(self, x, z):
        """Own (x, z) to world (x, z)."""
        s, c = sin_deg(self.yaw_deg), cos_deg(self.yaw_deg)
        return self.x + x * c + z * s, self.z + z * c - x * s

    def local(self, x, z):
        """World (x, z) to own (x, z)."""
        s, c = sin_deg(self.yaw_deg), cos_deg(self.yaw_deg)
        dx, dz = x - self.x, z - self.z
        return dx * c - dz * s, dz * c + dx * s

    def point(self, x, y, z):
        """Own point, y above the pad, to a world point."""
        wx, wz = self.world(x, z)
        return wx, self.level + y, wz

    def outline(self, poly):
        """Own polygon to a world polygon."""
        return facing_up([self.world(x, z) for x, z in poly])


PLACEMENTS = {
    "gatehouse": Placement(0.0, 76.0, 0.0, -1.5, (-11.0, -5.0, 11.0, 5.0)),
    "library": Placement(0.0, -28.0, 0.0, 0.0, (-17.0, -10.0, 17.0, 15.0)),
    "admin": Placement(-50.0, 8.0, 90.0, 0.2, (-20.0, -14.0, 20.0, 14.0)),
    "science": Placement(52.0, 8.0, -90.0, 0.2, (-16.0, -8.0, 16.0, 9.0)),
    "cafeteria": Placement(32.0, 50.0, -90.0, -0.8, (-10.0, -7.0, 10.0, 15.0)),
    "theatre": Placement(-30.0, 50.0, 90.0, -0.8, (-13.0, -13.0, 13.0, 13.0)),
    "gallery": Placement(-66.0, 58.0, 0.0, -1.0, (-12.0, -8.0, 12.0, 9.0)),
    "clock-tower": Placement(32.0, -21.0, 0.0, 0.0, (-4.0, -4.0, 4.0, 5.0)),
    "dorm": Placement(74.0, -46.0, -90.0, 1.5, (-18.0, -18.0, 18.0, 8.0)),
    "sports-hall": Placement(-78.0, -52.0, 90.0, 1.2, (-18.0, -12.0, 18.0, 14.0)),
    "greenhouse": Placement(-27.0, -74.0, 12.0, 2.4, (-11.0, -4.5, 11.0, 5.0)),
    "observatory": Placement(22.0, -80.0, 0.0, 4.4, (-8.0, -8.0, 8.0, 11.0)),
    "pavilion": Placement(74.0, 43.0, 0.0, -1.2, (-5.0, -5.0, 5.0, 5.0)),
}

SQUARE = rect(-26.0, -17.9, 26.0, 32.0)
SQUARE_LEVEL = 0.0
FOUNTAIN = (0.0, 10.0)
FOUNTAIN_RADIUS = 3.2

POND_CENTRE, POND_LEVEL = (74.0, 64.0), -1.6
POND_RADII = (13.0, 10.0)
POND_DEPTH = 1.0      # rim to bed: a drop one can fall down but that does not hide the avatar
POND_WATER = 0.35     # rim to water surface
POND_CORNERS = 24


def _ellipse(centre, radii, corners):
    step = 360.0 / corners
    return facing_up([(centre[0] + radii[0] * cos_deg(step * i),
                       centre[1] + radii[1] * sin_deg(step * i)) for i in range(corners)])


POND_RIM = _ellipse(POND_CENTRE, POND_RADII, POND_CORNERS)
POND_COPING = _ellipse(POND_CENTRE, (POND_RADII[0] * 1.05, POND_RADII[1] * 1.05), POND_CORNERS)


@dataclass(frozen=True)
class Ribbon:
    """A road or path along a line of (x, z)."""

    name: str
    kind: str      # road | path
    width: float
    line: tuple


def _corner(cx, cz, radius, start_deg, stop_deg, steps=6):
    return tuple((cx + radius * cos_deg(start_deg + (stop_deg - start_deg) * i / steps),
                  cz + radius * sin_deg(start_deg + (stop_deg - start_deg) * i / steps))
                 for i in range(steps + 1))


def _pond_walk():
    return tuple((POND_CENTRE[0] + 17.5 * cos_deg(15.0 * i),
                  POND_CENTRE[1] + 14.5 * sin_deg(15.0 * i)) for i in range(25))


ROAD_Z = 91.0
ROAD_WIDTH = 7.0
RIBBONS = (
    Ribbon("road_main", "road", ROAD_WIDTH, ((-119.0, ROAD_Z), (119.0, ROAD_Z))),
    Ribbon("road_service", "road", 6.0,
           ((104.0, 88.0), (104.0, -80.0)) + _corner(84.0, -80.0, 20.0, 0.0, -90.0)[1:]
           + _corner(-84.0, -80.0, 20.0, -90.0, -180.0) + ((-104.0, 88.0),)),
    Ribbon("path_avenue", "path", 5.0, ((0.0, 88.0), (0.0, 31.0))),
    Ribbon("path_theatre", "path", 3.0, ((-2.0, 50.0), (-18.0, 50.0))),
    Ribbon("path_cafeteria", "path", 3.0, ((2.0, 50.0), (17.5, 50.0))),
    Ribbon("path_admin", "path", 4.0, ((-25.5, 8.0), (-37.0, 8.0))),
    Ribbon("path_science", "path", 4.0, ((25.5, 8.0), (44.5, 8.0))),
    Ribbon("path_west", "path", 2.4, ((-25.0, 26.0), (-34.0, 33.0), (-66.0, 35.0), (-101.5, 35.0))),
    Ribbon("path_east", "path", 2.4, ((25.0, 26.0), (36.0, 33.0), (62.0, 34.0), (101.5, 34.0))),
    Ribbon("path_clock_tower", "path", 4.0, ((32.0, -17.5), (32.0, -11.0), (25.5, -11.0))),
    Ribbon("path_library_west", "path", 2.4, ((-22.5, -13.5), (-22.5, -50.0), (-26.0, -69.0))),
    Ribbon("path_library_east", "path", 2.4, ((22.5, -13.5), (22.5, -52.0), (22.0, -69.5))),
    Ribbon("path_north", "path", 2.4, ((-66.0, -52.0), (-40.0, -50.0), (-22.0, -47.0), (22.0, -47.0),
                                       (48.0, -46.0), (66.5, -46.0))),
    Ribbon("path_dorm", "path", 2.4, ((58.0, -46.0), (60.0, -24.0), (101.5, -22.0))),
    Ribbon("path_gallery", "path", 2.4, ((-66.0, 88.0), (-66.0, 65.5))),
    Ribbon("path_gate_west", "path", 2.4, ((-2.0, 66.5), (-46.0, 66.5), (-56.0, 70.0), (-66.5, 70.0))),
    Ribbon("path_gate_east", "path", 2.4, ((2.0, 66.5), (46.0, 66.5), (57.0, 64.0))),
    Ribbon("path_pond", "path", 1.8, _pond_walk()),
    Ribbon("path_pavilion", "path", 2.0, ((74.0, 33.5), (74.0, 39.0))),
    Ribbon("path_pavilion_south", "path", 2.0, ((74.0, 46.5), (74.0, 50.0))),
)

# Bands of small stones in the square's paving, and a disc round the fountain.
_BAND = 0.45
_INLAYS = tuple(("path_inlay_%02d" % (i + 1), "setts", poly) for i, poly in enumerate(
    [_ellipse(FOUNTAIN, (6.4, 6.4), 32)]
    + [rect(x - _BAND, -17.0, x + _BAND, 31.0) for x in (-13.0, 13.0)]
    + [rect(-25.0, z - _BAND, 25.0, z + _BAND) for z in (-10.0, 3.0, 16.0, 26.0)]))

# Paved areas that are not ribbons, the upper ones first: (name, material, world polygon).
AREAS = _INLAYS + (
    ("square", "slabs", SQUARE),
    ("path_terrace", "slabs", rect(17.0, 40.5, 25.5, 59.5)),
    ("path_courtyard", "slabs", rect(-54.5, -2.5, -36.5, 18.5)),
    ("path_gallery_court", "slabs", rect(-70.0, 65.0, -62.0, 71.0)),
)
