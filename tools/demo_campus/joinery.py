"""Windows and doors: shared meshes, one for each style and size.

Own frame: origin at the middle of the opening's sill in the plane of the outer wall face,
x along the wall, y up, z outwards.
"""

from dataclasses import dataclass

from .mesh import Mesh


@dataclass(frozen=True)
class WindowStyle:
    """How a window looks. setback: frame's distance behind the wall face, metres."""

    frame: str
    glass: str = "glass"
    sill: str = "stone"
    lintel: str = "stone"
    columns: int = 2
    rows: int = 2
    setback: float = 0.12
    bar: float = 0.06
    see_through: bool = False  # glass and bars on both sides


WINDOWS = {
    "sash": WindowStyle("frame_white", columns=2, rows=3),
    "sash_lit": WindowStyle("frame_white", "clear_glass", columns=2, rows=3, see_through=True),
    "casement": WindowStyle("frame_dark", columns=2, rows=1, lintel=None, sill="concrete"),
    "tall": WindowStyle("frame_green", "clear_glass", columns=2, rows=4, see_through=True),
    "shop": WindowStyle("frame_dark", "clear_glass", sill="concrete", lintel=None, columns=2,
                        rows=1, see_through=True),
    "slot": WindowStyle("frame_dark", columns=1, rows=3, lintel=None, sill=None),
    "slot_lit": WindowStyle("frame_dark", "clear_glass", columns=1, rows=3, lintel=None, sill=None,
                            see_through=True),
    "stone": WindowStyle("frame_dark", columns=2, rows=3, setback=0.2),
    "clerestory": WindowStyle("frame_dark", "clear_glass", columns=4, rows=1, sill=None,
                              lintel=None, see_through=True),
}
BAR_DEPTH = 0.07
LEDGE = 0.07       # how far sills and lintels stand out from the wall
LEDGE_SIDE = 0.10  # how far they reach beyond the opening


def _bars(mesh, style, width, height):
    """Frame, mullions and transoms."""
    half, bar = width / 2, style.bar
    front, back = -style.setback, -style.setback - BAR_DEPTH
    hidden = "" if style.see_through else "z"

    def piece(x0, y0, x1, y1, skip):
        mesh.box(style.frame, (x0, y0, back), (x1, y1, front), skip + hidden)
    piece(-half, 0.0, -half + bar, height, "xyY")
    piece(half - bar, 0.0, half, height, "XyY")
    piece(-half + bar, 0.0, half - bar, bar, "xXy")
    piece(-half + bar, height - bar, half - bar, height, "xXY")
    for i in range(1, style.columns):
        x = -half + width * i / style.columns
        piece(x - bar / 2, bar, x + bar / 2, height - bar, "yY")
    thin = bar * 0.6
    for i in range(1, style.rows):
        y = height * i / style.rows
        mesh.box(style.frame, (-half + bar, y - thin / 2, back + 0.02),
                 (half - bar, y + thin / 2, front - 0.01), "xX" + hidden)


def window(style_name, width, height):
    """A window of a style."""
    style, mesh, half = WINDOWS[style_name], Mesh(), width / 2
    _bars(mesh, style, width, height)
    z = -style.setback - BAR_DEPTH * 0.5
    pane = [(-half, 0.0, z), (half, 0.0, z), (half, height, z), (-half, height, z)]
    mesh.poly(style.glass, pane, [(0.0, 1.0), (0.97, 1.0), (0.97, 0.0), (0.0, 0.0)])
    if style.sill:
        mesh.box(style.sill, (-half - LEDGE_SIDE, -0.09, -style.setback),
                 (half + LEDGE_SIDE, 0.005, LEDGE), "z")
    if style.lintel:
        mesh.box(style.lintel, (-half - LEDGE_SIDE, height, 0.0),
                 (half + LEDGE_SIDE, height + 0.20, LEDGE - 0.03), "z")
    return mesh


def closed_door(width, height, setback=0.12, frame="stone"):
    """A door that stays shut: panelled leaves in a stone surround."""
    mesh, half = Mesh(), width / 2
    z = -setback
    mesh.poly("door_wood", [(-half, 0.0, z), (half, 0.0, z), (half, height, z), (-half, height, z)],
              [(0.0, 1.0), (1.0, 1.0), (1.0, 0.0), (0.0, 0.0)])
    for x in (-0.09, 0.06):
        mesh.box("brass", (x, 1.0, z), (x + 0.03, 1.18, z + 0.05), "z")
    surround(mesh, width, height, frame)
    return mesh


def surround(mesh, width, height, material="stone", out=0.06, side=0.22):
    """An architrave around an opening, with a small hood."""
    half = width / 2
    mesh.box(material, (-half - side, 0.0, 0.0), (-half, height, out), "zy")
    mesh.box(material, (half, 0.0, 0.0), (half + side, height, out), "zy")
    mesh.box(material, (-half - side, height, 0.0), (half + side, height + side, out), "z")
    mesh.box(material, (-half - side - 0.08, height + side, 0.0),
             (half + side + 0.08, height + side + 0.10, out + 0.16), "z")


def open_door(width, height, thickness=0.30, frame="frame_dark", leaf="door_wood"):
    """A doorway that stands open: a lining, and two leaves folded back against the inner wall."""
    mesh, half, lining = Mesh(), width / 2, 0.04
    surround(mesh, width, height, frame, out=0.04, side=0.12)
    for side in (-1.0, 1.0):
        x0, x1 = sorted((side * (half + 0.02), side * (half + 0.02 + width * 0.47)))
        mesh.box(leaf, (x0, 0.01, -thickness - 0.02 - lining), (x1, height - 0.02,
                                                              -thickness - 0.02))
        grip = side * (half + width * 0.42)
        mesh.box("brass", (grip - 0.015, 0.95, -thickness - 0.10),
                 (grip + 0.015, 1.20, -thickness - 0.06), "Z")
    return mesh
