"""Where the outdoor furniture stands."""

from . import furniture
from .exact import Random, sin_deg, cos_deg
from .gltf import Node
from .layout import FOUNTAIN, FOUNTAIN_RADIUS, PLACEMENTS, ROAD_WIDTH, ROAD_Z
from .textures_grown import SIGNS

BOUNDARY = (-117.0, -111.0, 117.0, 99.0)   # the wall round the site

# (x, z, yaw): benches along the avenue and round the square; the first one is on the tour.
BENCHES = [(1.95, 62.0, -90.0), (-1.95, 70.0, 90.0), (-1.95, 54.5, 90.0), (1.95, 54.5, -90.0),
           (1.95, 46.0, -90.0), (-1.95, 46.0, 90.0), (-1.95, 38.0, 90.0), (1.95, 38.0, -90.0),
           (-24.8, 0.0, 90.0), (-24.8, 16.0, 90.0), (24.8, 0.0, -90.0), (24.8, 16.0, -90.0),
           (-8.0, 10.0, 90.0), (8.5, 10.0, -90.0), (-52.5, 12.0, 90.0), (-52.5, 4.0, 90.0),
           (58.0, 56.0, 45.0), (74.0, 80.5, 180.0), (93.5, 64.0, -90.0), (-63.0, 67.5, -90.0),
           (72.6, 42.2, 90.0)]
LAMPS = ([(side * 3.0, 36.0 + 10.0 * k) for k in range(4) for side in (-1, 1)]
         + [(x, z) for x in (-25.3, 25.3) for z in (-10.0, 4.0, 12.5, 24.0)]
         + [(-80.0, 84.6), (-48.0, 84.6), (-20.0, 84.6), (20.0, 84.6), (48.0, 84.6), (80.0, 84.6)]
         + [(24.2, -32.0), (24.2, -56.0), (-24.2, -32.0), (-24.2, -56.0), (0.0, -45.0), (40.0, -48.4),
            (-45.0, -48.4), (44.0, 31.6), (84.0, 32.2), (-50.0, 32.4), (-84.0, 33.2), (56.5, 66.5),
            (76.0, 47.5), (-64.3, 76.0), (30.0, 68.5), (-30.0, 68.5)])
BINS = [(3.0, 60.6), (-3.0, 53.2), (-25.2, 17.6), (25.2, 1.6), (16.2, 51.9), (62.0, 32.4),
        (-61.4, 66.2), (-5.4, 86.2)]
# (x, z, yaw, length, width, flower kinds): the first one is on the tour.
BEDS = [(9.0, 21.0, 0.0, 4.4, 1.8, (0, 1)), (-9.0, 21.0, 0.0, 4.4, 1.8, (2, 3)),
        (9.0, -1.0, 0.0, 4.4, 1.8, (2, 1)), (-9.0, -1.0, 0.0, 4.4, 1.8, (0, 3)),
        (-18.0, 10.0, 90.0, 5.0, 1.8, (1, 3)), (18.5, 10.0, 90.0, 5.0, 1.8, (0, 2)),
        (-44.0, 14.5, 0.0, 4.4, 1.6, (0, 2)), (-44.0, 1.5, 0.0, 4.4, 1.6, (1, 3)),
        (18.4, 56.0, 90.0, 3.6, 1.2, (0, 1)), (18.4, 43.6, 90.0, 3.6, 1.2, (2, 3)),
        (-68.9, 68.0, 90.0, 4.0, 1.2, (2, 3)), (40.0, 5.0, 90.0, 3.6, 1.4, (1, 3)),
        (40.0, 11.0, 90.0, 3.6, 1.4, (0, 2))]
PLANTERS = [(-20.0, -6.0), (20.0, -6.0), (-20.0, 24.5), (20.0, 24.5)]  # trees in stone boxes
SIGN_POSTS = [("WELCOME TO CAMPUS", 6.2, 85.0, 0.0), ("MAIN LIBRARY", -12.8, -12.0, 0.0),
              ("LECTURE THEATRE", -6.0, 47.2, 90.0), ("CAFETERIA", 6.0, 47.4, -90.0),
              ("ADMINISTRATION", -29.0, 11.4, 90.0), ("SCIENCE BLOCK", 30.0, 11.4, -90.0),
              ("SPORTS HALL", -60.0, -49.2, 90.0), ("OBSERVATORY", 24.8, -64.0, 0.0),
              ("GREENHOUSE", -23.4, -62.0, 0.0), ("ART GALLERY", -63.2, 74.0, 0.0),
              ("NORTH DORM", 62.5, -43.4, -90.0), ("CLOCK TOWER", 35.2, -14.0, 0.0),
              ("POND & PAVILION", 50.0, 63.6, -60.0)]
WALL_SIGNS = [("library", "MAIN LIBRARY", 0.0, 3.42, 10.0),   # building, text, own (x, y, z)
              ("cafeteria", "CAFETERIA", 0.0, 3.42, 9.6),
              ("theatre", "LECTURE THEATRE", 0.0, 2.95, 12.08),
              ("gallery", "ART GALLERY", 0.0, 3.4, 8.0)]
STANDS = [(20.5, 61.4, 0.0), (-34.0, 16.8, 0.0), (40.5, 1.0, 90.0), (-60.0, -58.0, 90.0),
          (64.0, -52.0, 90.0), (20.0, -21.0, 90.0)]
BOLLARDS = [(-4.2, 86.4), (-2.9, 86.4), (2.9, 86.9), (4.2, 86.4), (-1.45, 84.4), (1.45, 84.4)]
SCULPTURE = (15.0, 27.0)
NOTICES = [(-4.2, 66.0 - 2.3, 90.0), (-15.0, -8.5, 0.0)]


class Outfitting:
    """Furniture nodes, and the numbers colliders need."""

    def __init__(self, terrain, paving):
        self._terrain, self._paving = terrain, paving
        self.nodes = []
        self._counts = {}

    def _put(self, kind, mesh, x, z, yaw=0.0, name=None):
        count = self._counts[kind] = self._counts.get(kind, 0) + 1
        node = Node(name or "%s_%02d" % (kind, count), mesh, (x, self._paving.top(x, z), z), yaw)
        self.nodes.append(node)
        return node

    def _many(self, kind, mesh, spots):
        for x, z, *yaw in spots:
            self._put(kind, mesh, x, z, yaw[0] if yaw else 0.0)

    def furnish(self):
        """Everything but the boundary."""
        self._many("bench", furniture.bench(), BENCHES)
        self._many("lamp", furniture.lamp(), LAMPS)
        self._many("bin", furniture.litter_bin(), BINS)
        self._many("bicycle_stand", furniture.bicycle_stand(), STANDS)
        bikes = [furniture.bicycle("fabric_red"), furniture.bicycle("fabric_blue"),
                 furniture.bicycle("plaster_teal")]
        for i, (x, z, yaw) in enumerate(STANDS):
            for k in range(2 + i % 2):
                shift = -0.78 + 0.9 * k
                self._put("bicycle", bikes[(i + k) % 3], x + shift * cos_deg(yaw),
                          z - shift * sin_deg(yaw), yaw)
        self._many("bollard", furniture.bollard(), BOLLARDS)
        self._many("notice_board", furniture.notice_board(), NOTICES)
        random = Random(77)
        for x, z, yaw, length, width, kinds in BEDS:
            self._put("flower_bed", furniture.flower_bed(length, width, kinds, random), x, z, yaw)
        self._many("planter", furniture.planter(), PLANTERS)
        for text, x, z, yaw in SIGN_POSTS:
            self._put("sign", furniture.sign(SIGNS.index(text)), x, z, yaw)
        for owner, text, x, y, z in WALL_SIGNS:
            place = PLACEMENTS[owner]
            self.nodes.append(Node("wall_sign_" + owner, furniture.wall_sign(text, 2.4),
                                   place.point(x, y, z), place.yaw_deg))
        stone, water = furniture.fountain(FOUNTAIN_RADIUS)
        self._put("fountain", stone, *FOUNTAIN, name="fountain")
        self._put("fountain_water", water, *FOUNTAIN, name="fountain_water")
        self._put("sculpture", furniture.sculpture(), *SCULPTURE, name="sculpture")

    def enclose(self):
        """The boundary wall, with iron railings where the road leaves."""
        x0, z0, x1, z1 = BOUNDARY
        step = furniture.WALL_PANEL
        panel, fence = furniture.wall_panel(), furniture.fence_panel()
        sides = [(x0, z1, 1, 0, x1 - x0, 0.0), (x1, z1, 0, -1, z1 - z0, 90.0),
                 (x1, z0, -1, 0, x1 - x0, 180.0), (x0, z0, 0, 1, z1 - z0, 270.0)]
        for x, z, dx, dz, length, yaw in sides:
            for k in range(int(length / step)):
                px, pz = x + dx * step * (k + 0.5), z + dz * step * (k + 0.5)
                on_road = dz and abs(pz - ROAD_Z) < ROAD_WIDTH / 2 + 1.0
                kind, mesh = ("fence", fence) if on_road else ("boundary_wall", panel)
                count = self._counts[kind] = self._counts.get(kind, 0) + 1
                self.nodes.append(Node("%s_%03d" % (kind, count), mesh,
                                       (px, self._paving.top(px, pz), pz), yaw))
