"""Outdoor furniture: shared meshes, origin on the ground, front towards +z."""

from .exact import cos_deg, sin_deg
from .mesh import Mesh
from .shapes import beam, lathe, ngon, prism, ring, sphere_net, tube
from .textures_grown import SIGNS, sign_uv


def bench():
    """A park bench 1.8 m long, seat 0.45 m high, on two cast frames."""
    mesh = Mesh()
    for k in range(4):
        z = -0.20 + 0.125 * k
        mesh.box("wood", (-0.9, 0.415, z), (0.9, 0.45, z + 0.10))
    for k in range(3):
        y = 0.54 + 0.12 * k
        z = -0.25 - 0.03 * k
        mesh.box("wood", (-0.9, y, z), (0.9, y + 0.09, z + 0.035))
    for x in (-0.75, 0.69):
        mesh.box("iron", (x, 0.0, 0.16), (x + 0.06, 0.62, 0.22), "y")
        mesh.box("iron", (x, 0.0, -0.27), (x + 0.06, 0.45, -0.21), "yY")
        mesh.box("iron", (x, 0.38, -0.21), (x + 0.06, 0.415, 0.16), "zZ")
        beam(mesh, "iron", (x + 0.03, 0.41, -0.25), (x + 0.03, 0.80, -0.36), 0.06, 0.07)
        mesh.box("iron", (x, 0.60, -0.28), (x + 0.06, 0.64, 0.24), "")
    return mesh


def lamp():
    """A lantern on a turned post, 3.9 m."""
    mesh = Mesh()
    lathe(mesh, "iron", [(0.17, 0.0), (0.17, 0.25), (0.10, 0.40), (0.10, 0.55), (0.06, 0.65),
                         (0.045, 3.15), (0.10, 3.22), (0.05, 3.30)], 8)
    lathe(mesh, "lamp_glass", [(0.09, 3.28), (0.17, 3.62)], 6, smooth=False)
    lathe(mesh, "iron", [(0.24, 3.60), (0.22, 3.66), (0.08, 3.82), (0.03, 3.84), (0.0, 3.94)], 6,
          smooth=False)
    return mesh


def litter_bin():
    """A slatted bin."""
    mesh = Mesh()
    lathe(mesh, "bins", [(0.24, 0.0), (0.26, 0.06), (0.26, 0.80), (0.29, 0.84), (0.22, 0.90),
                         (0.18, 0.90), (0.18, 0.55), (0.0, 0.55)], 12, smooth=False)
    return mesh


def bicycle_stand():
    """Three hoops in a row."""
    mesh = Mesh()
    for x in (-0.9, 0.0, 0.9):
        line = [(x, 0.0, -0.38), (x, 0.55, -0.38), (x, 0.75, -0.22), (x, 0.80, 0.0),
                (x, 0.75, 0.22), (x, 0.55, 0.38), (x, 0.0, 0.38)]
        for a, b in zip(line, line[1:]):
            tube(mesh, "metal", a, b, 0.028, 0.028, 6)
    return mesh


def bicycle(colour="fabric_red"):
    """A bicycle, seen from the side along z."""
    mesh = Mesh()
    for z in (-0.52, 0.52):
        for k in range(10):
            a, b = 36.0 * k, 36.0 * (k + 1)
            tube(mesh, "iron", (0.0, 0.34 + 0.33 * sin_deg(a), z + 0.33 * cos_deg(a)),
                 (0.0, 0.34 + 0.33 * sin_deg(b), z + 0.33 * cos_deg(b)), 0.018, 0.018, 3)
        tube(mesh, "metal", (-0.05, 0.34, z), (0.05, 0.34, z), 0.03, 0.03, 4)
    frame = [((0, 0.34, -0.52), (0, 0.80, -0.18)), ((0, 0.34, -0.52), (0, 0.30, -0.02)),
             ((0, 0.30, -0.02), (0, 0.88, -0.20)), ((0, 0.30, -0.02), (0, 0.80, 0.36)),
             ((0, 0.78, -0.16), (0, 0.82, 0.36)), ((0, 0.34, 0.52), (0, 0.98, 0.34))]
    for a, b in frame:
        tube(mesh, colour, a, b, 0.022, 0.022, 4)
    tube(mesh, "iron", (-0.26, 1.0, 0.30), (0.26, 1.0, 0.30), 0.016, 0.016, 4)
    mesh.box("iron", (-0.07, 0.88, -0.34), (0.07, 0.94, -0.08))
    return mesh


def sign(index):
    """A name board on two posts: text on both sides."""
    mesh = Mesh()
    for x in (-0.95, 0.87):
        mesh.box("iron", (x, 0.0, -0.04), (x + 0.08, 1.85, 0.04), "y")
    mesh.box("frame_dark", (-0.87, 1.25, -0.03), (0.87, 1.70, 0.03), "xX")
    u0, v0, u1, v1 = sign_uv(index)
    for z, flip in ((0.035, False), (-0.035, True)):
        face = [(-0.86, 1.26, z), (0.86, 1.26, z), (0.86, 1.69, z), (-0.86, 1.69, z)]
        uvs = [(u0, v1), (u1, v1), (u1, v0), (u0, v0)]
        if flip:
            face, uvs = [face[1], face[0], face[3], face[2]], uvs
        mesh.poly("signs", face, uvs)
    return mesh


def wall_sign(text, width):
    """A name board to hang on a wall (its back at z = 0, its lower edge at y = 0)."""
    mesh, half = Mesh(), width / 2
    u0, v0, u1, v1 = sign_uv(SIGNS.index(text))
    mesh.box("frame_dark", (-half - 0.04, -0.04, 0.0), (half + 0.04, width / 4 + 0.04, 0.05), "z")
    mesh.poly("signs", [(-half, 0.0, 0.055), (half, 0.0, 0.055), (half, width / 4, 0.055),
                        (-half, width / 4, 0.055)], [(u0, v1), (u1, v1), (u1, v0), (u0, v0)])
    return mesh


def notice_board():
    """A roofed notice board."""
    mesh = Mesh()
    for x in (-0.85, 0.77):
        mesh.box("wood_dark", (x, 0.0, -0.05), (x + 0.08, 2.1, 0.05), "y")
    mesh.box("wood_dark", (-0.77, 0.85, -0.04), (0.77, 1.95, 0.02))
    mesh.poly("notices", [(-0.72, 0.9, 0.03), (0.72, 0.9, 0.03), (0.72, 1.9, 0.03),
                          (-0.72, 1.9, 0.03)], [(0, 1), (1, 1), (1, 0), (0, 0)])
    mesh.quad("wood", (-1.0, 2.08, 0.28), (1.0, 2.08, 0.28), (1.0, 2.30, 0.0), (-1.0, 2.30, 0.0))
    mesh.quad("wood", (1.0, 2.08, -0.28), (-1.0, 2.08, -0.28), (-1.0, 2.30, 0.0), (1.0, 2.30, 0.0))
    mesh.quad("wood_dark", (-1.0, 2.07, -0.28), (1.0, 2.07, -0.28), (1.0, 2.07, 0.28),
              (-1.0, 2.07, 0.28))
    return mesh


def bollard():
    """A granite bollard, radius 0.16."""
    mesh = Mesh()
    lathe(mesh, "granite", [(0.16, -0.2), (0.16, 0.70), (0.19, 0.74), (0.17, 0.84), (0.0, 0.92)], 10)
    return mesh


def parasol():
    """A parasol beside a table."""
    mesh = Mesh()
    tube(mesh, "metal", (0.0, 0.0, 0.0), (0.0, 2.5, 0.0), 0.03, 0.03, 6)
    lathe(mesh, "metal", [(0.28, 0.0), (0.28, 0.06), (0.04, 0.08)], 8, smooth=False)
    lathe(mesh, "canvas", [(1.55, 2.12), (0.0, 2.62)], 8, smooth=False)
    return mesh


def fountain(radius):
    """A round basin with a two-tiered centre; returns (stone mesh, water mesh)."""
    stone, water = Mesh(), Mesh()
    lathe(stone, "stone", [(radius, -0.1), (radius, 0.40), (radius + 0.06, 0.42),
                           (radius + 0.06, 0.52), (radius - 0.34, 0.52), (radius - 0.34, 0.10),
                           (0.0, 0.10)], 32, smooth=False)
    lathe(stone, "stone", [(0.55, 0.1), (0.50, 0.45), (0.24, 0.60), (0.20, 1.25), (0.95, 1.55),
                           (1.0, 1.62), (0.86, 1.62), (0.14, 1.48), (0.11, 2.05), (0.42, 2.25),
                           (0.45, 2.30), (0.36, 2.30), (0.0, 2.24)], 18)
    for y, size in ((0.40, radius - 0.34), (1.58, 0.84), (2.27, 0.34)):
        water.poly("water", [(x, y, z) for x, z in ngon(24, size)])
    return stone, water


SCULPTURE_RADIUS, SCULPTURE_HEIGHT = 0.9, 1.85


def sculpture():
    """A bronze sphere on a plinth: centre at SCULPTURE_HEIGHT."""
    mesh = Mesh()
    prism(mesh, "granite", ngon(4, 0.85, start_deg=45.0), -0.2, 0.95)
    prism(mesh, "granite", ngon(4, 1.1, start_deg=45.0), -0.2, 0.25)
    points, faces = sphere_net(2)
    for a, b, c in faces:
        corners = [points[i] for i in (a, b, c)]
        mesh.poly("bronze", [(x * SCULPTURE_RADIUS, SCULPTURE_HEIGHT + y * SCULPTURE_RADIUS,
                              z * SCULPTURE_RADIUS) for x, y, z in corners], normals=corners)
    return mesh


BED_HEIGHT, SOIL_HEIGHT = 0.42, 0.36


def flower_bed(length, width, kinds, random):
    """A raised stone bed with flowers and low green."""
    mesh = Mesh()
    half_x, half_z = length / 2, width / 2
    outline = [(-half_x, half_z), (half_x, half_z), (half_x, -half_z), (-half_x, -half_z)]
    ring(mesh, "stone", outline, -0.25, BED_HEIGHT, 0.18)
    soil = [(x * (1 - 0.18 / half_x), SOIL_HEIGHT, z * (1 - 0.18 / half_z)) for x, z in outline]
    mesh.poly("soil", soil)
    count = int(length * width * 5)
    for _ in range(count):
        x = random.between(-half_x + 0.4, half_x - 0.4)
        z = random.between(-half_z + 0.4, half_z - 0.4)
        kind, size = random.pick(kinds), random.between(0.22, 0.30)
        turn = random.between(0.0, 180.0)
        for extra in (0.0, 90.0):
            dx, dz = size * cos_deg(turn + extra), size * sin_deg(turn + extra)
            y0, y1 = 0.33, 0.33 + size * 2.4
            mesh.poly("flowers", [(x - dx, y0, z - dz), (x + dx, y0, z + dz), (x + dx, y1, z + dz),
                                  (x - dx, y1, z - dz)],
                      [(kind / 4, 1.0), (kind / 4 + 0.25, 1.0), (kind / 4 + 0.25, 0.0),
                       (kind / 4, 0.0)], [(0.0, 1.0, 0.0)] * 4)
        _blossoms_from_above(mesh, (x, 0.33 + size * random.between(1.5, 1.9), z), 0.9 * size, kind)
    return mesh


def _blossoms_from_above(mesh, centre, half, kind):
    """A level card with the upper half of the clump's picture: upright cards vanish in a plan."""
    x, y, z = centre
    left, right = kind / 4, kind / 4 + 0.25
    mesh.poly("flowers", [(x - half, y, z + half), (x + half, y, z + half), (x + half, y, z - half),
                          (x - half, y, z - half)],
              [(left, 0.6), (right, 0.6), (right, 0.05), (left, 0.05)], [(0.0, 1.0, 0.0)] * 4)


PLANTER_SIZE = 2.2


def planter():
    """A square stone box for a tree; its upper edge serves as a seat."""
    mesh, half = Mesh(), PLANTER_SIZE / 2
    outline = [(-half, half), (half, half), (half, -half), (-half, -half)]
    ring(mesh, "granite", outline, -0.2, 0.45, 0.3)
    mesh.poly("soil", [(x * 0.75, SOIL_HEIGHT, z * 0.75) for x, z in outline])
    return mesh


WALL_PANEL = 6.0
WALL_HEIGHT = 2.2


def wall_panel():
    """Six metres of boundary wall with a pier at its left end; deep footing for slopes."""
    mesh, half = Mesh(), WALL_PANEL / 2
    mesh.box("brick_red", (-half, -0.9, -0.12), (half, WALL_HEIGHT - 0.2, 0.12), "yxX")
    mesh.box("stone", (-half, WALL_HEIGHT - 0.2, -0.18), (half, WALL_HEIGHT - 0.1, 0.18), "xX")
    mesh.box("brick_red", (-half - 0.25, -0.9, -0.25), (-half + 0.25, WALL_HEIGHT, 0.25), "yY")
    mesh.box("stone", (-half - 0.31, WALL_HEIGHT, -0.31), (-half + 0.31, WALL_HEIGHT + 0.12, 0.31))
    return mesh


def fence_panel():
    """Six metres of iron railings, for the closed ends of the road."""
    mesh, half = Mesh(), WALL_PANEL / 2
    for y in (0.25, 1.95):
        mesh.box("iron", (-half, y, -0.03), (half, y + 0.06, 0.03))
    for k in range(31):
        x = -half + 0.2 * k
        tube(mesh, "iron", (x, 0.0, 0.0), (x, 2.2, 0.0), 0.015, 0.008, 4)
    mesh.box("iron", (-half - 0.1, -0.2, -0.1), (-half + 0.1, 2.4, 0.1), "y")
    return mesh
