"""Indoor furniture: shared meshes, origin on the floor, front towards +z."""

from .mesh import Mesh
from .shapes import lathe


def _legs(mesh, material, half_x, half_z, height, thick=0.05):
    for x in (-half_x, half_x - thick):
        for z in (-half_z, half_z - thick):
            mesh.box(material, (x, 0.0, z), (x + thick, height, z + thick), "yY")


def table(length=1.6, width=0.8, top="wood", legs="iron"):
    """A plain table, 0.74 m high."""
    mesh = Mesh()
    mesh.box(top, (-length / 2, 0.70, -width / 2), (length / 2, 0.74, width / 2))
    _legs(mesh, legs, length / 2 - 0.06, width / 2 - 0.06, 0.70)
    return mesh


def round_table(radius=0.45, top="wood"):
    """A bistro table on one foot."""
    mesh = Mesh()
    lathe(mesh, "iron", [(0.24, 0.0), (0.24, 0.03), (0.04, 0.05), (0.03, 0.70)], 8)
    lathe(mesh, top, [(0.0, 0.70), (radius, 0.70), (radius, 0.74), (0.0, 0.74)], 14, smooth=False)
    return mesh


def chair(seat="wood", legs="iron"):
    """A chair facing +z, seat 0.45 m."""
    mesh = Mesh()
    mesh.box(seat, (-0.21, 0.42, -0.21), (0.21, 0.45, 0.21))
    mesh.box(seat, (-0.21, 0.60, -0.23), (0.21, 0.86, -0.20))
    _legs(mesh, legs, 0.20, 0.20, 0.42, 0.035)
    for x in (-0.20, 0.165):
        mesh.box(legs, (x, 0.45, -0.225), (x + 0.035, 0.62, -0.205), "yY")
    return mesh


def bookshelf(length=3.0, depth=0.5, height=2.1):
    """A double-sided bookcase."""
    mesh, half = Mesh(), length / 2
    for x0 in (-half, half - 0.04):
        mesh.box("wood_dark", (x0, 0.0, -depth / 2), (x0 + 0.04, height, depth / 2), "y")
    mesh.box("wood_dark", (-half + 0.04, height - 0.05, -depth / 2),
             (half - 0.04, height, depth / 2), "xX")
    mesh.box("wood_dark", (-half + 0.04, 0.0, -depth / 2 + 0.03),
             (half - 0.04, 0.10, depth / 2 - 0.03), "xXyY")
    mesh.box("books", (-half + 0.04, 0.10, -depth / 2 + 0.03),
             (half - 0.04, height - 0.05, depth / 2 - 0.03), "xXyY")
    mesh.box("wood_dark", (-half + 0.04, 0.06, -depth / 2), (half - 0.04, 0.11, depth / 2), "xX")
    return mesh


def counter(length=3.0, depth=0.8, height=1.05, front="wood", top="stone"):
    """A service desk or bar."""
    mesh, half = Mesh(), length / 2
    mesh.box(front, (-half, 0.0, -depth / 2), (half, height - 0.05, depth / 2), "yY")
    mesh.box(top, (-half - 0.05, height - 0.05, -depth / 2 - 0.05),
             (half + 0.05, height, depth / 2 + 0.08))
    return mesh


def stove(length=2.0):
    """A kitchen range."""
    mesh, half = Mesh(), length / 2
    mesh.box("metal", (-half, 0.0, -0.35), (half, 0.90, 0.35), "y")
    for x in (-half + 0.4, 0.0, half - 0.4):
        lathe(mesh, "iron", [(0.16, 0.90), (0.16, 0.92), (0.0, 0.92)], 8, (x, 0.0), False)
    mesh.box("metal", (-half, 2.1, -0.4), (half, 2.5, 0.4))
    return mesh


def armchair(cover="fabric_red"):
    """A low upholstered chair."""
    mesh = Mesh()
    mesh.box(cover, (-0.38, 0.0, -0.38), (0.38, 0.42, 0.38), "y")
    mesh.box(cover, (-0.38, 0.42, -0.38), (0.38, 0.85, -0.20), "y")
    for x in (-0.38, 0.24):
        mesh.box(cover, (x, 0.42, -0.20), (x + 0.14, 0.62, 0.38), "yz")
    return mesh


def painting(index, width=1.4, height=1.0):
    """A framed picture that hangs with its back at z = 0, its middle at 1.6 m."""
    mesh = Mesh()
    u, v = (index % 2) * 0.5, (index // 2 % 2) * 0.5
    y0, y1, half = 1.6 - height / 2, 1.6 + height / 2, width / 2
    mesh.box("wood_dark", (-half - 0.05, y0 - 0.05, 0.0), (half + 0.05, y1 + 0.05, 0.03), "z")
    mesh.poly("painting", [(-half, y0, 0.065), (half, y0, 0.065), (half, y1, 0.065),
                           (-half, y1, 0.065)],
              [(u, v + 0.5), (u + 0.5, v + 0.5), (u + 0.5, v), (u, v)])
    for box in (((-half, y0, 0.03), (half, y0 + 0.03, 0.08)),
                ((-half, y1 - 0.03, 0.03), (half, y1, 0.08)),
                ((-half, y0 + 0.03, 0.03), (-half + 0.03, y1 - 0.03, 0.08)),
                ((half - 0.03, y0 + 0.03, 0.03), (half, y1 - 0.03, 0.08))):
        mesh.box("brass", box[0], box[1], "z")
    return mesh


def plinth_with_figure(kind):
    """A museum pedestal with a small sculpture: 0 a turned vase, 1 stacked blocks, 2 a cone."""
    mesh = Mesh()
    mesh.box("frame_white", (-0.3, 0.0, -0.3), (0.3, 0.95, 0.3), "y")
    if kind == 0:
        lathe(mesh, "bronze", [(0.12, 0.95), (0.08, 1.05), (0.24, 1.30), (0.16, 1.55),
                               (0.20, 1.62), (0.0, 1.62)], 14)
    elif kind == 1:
        mesh.box("stone", (-0.22, 0.95, -0.16), (0.12, 1.2, 0.16), "y")
        mesh.box("bronze", (-0.08, 1.2, -0.2), (0.24, 1.42, 0.1), "")
        mesh.box("stone", (-0.1, 1.42, -0.08), (0.06, 1.8, 0.08), "y")
    else:
        lathe(mesh, "copper", [(0.22, 0.95), (0.05, 1.7), (0.0, 1.72)], 12)
    return mesh


def pendant_lamp(drop=0.8):
    """A ceiling lamp; origin at the ceiling."""
    mesh = Mesh()
    mesh.box("iron", (-0.01, -drop, -0.01), (0.01, 0.0, 0.01), "yY")
    lathe(mesh, "lamp_glass", [(0.0, -drop - 0.28), (0.16, -drop - 0.24), (0.19, -drop - 0.12),
                               (0.05, -drop), (0.0, -drop)], 8)
    return mesh
