"""The main library: sandstone, a portico with six columns, two floors one can walk."""

from .. import furnishing as furn
from ..mesh import Mesh
from ..polygon import rect
from ..roofs import cornice, gable, hip
from ..shapes import band, lathe, prism
from ..stairs import RISER, flight, front_steps, parapet_wall, railing, ramp
from ..walls import Opening, WallStyle, partition, row, wainscot
from .base import Building, Trigger, inside

HALF_X, HALF_Z = 17.0, 10.0
FLOOR = 4 * RISER                 # ground floor above the square: four steps
RISERS = 21
UPPER = FLOOR + RISERS * RISER
SLAB = 0.30
CEILING, WALL_TOP = 7.05, 8.0
DOOR_WIDTH, DOOR_HEIGHT = 1.6, 2.5
PORTICO_X, PORTICO_Z = 8.0, 14.0  # half width, front edge
COLUMN_HEIGHT = 5.6
RAMP_LENGTH = 5.4                 # 0.70 m of rise: 7.4 degrees
STAIR_X, STAIR_Z0, STAIR_Z1 = 4.0, -9.7, -8.1
STAIR_END = STAIR_X + (RISERS - 1) * 0.29
STAIR_HOLE = rect(STAIR_X + 0.2, STAIR_Z0, STAIR_END, STAIR_Z1)
WALLS = WallStyle("ashlar", "plaster_inside", "stone", 0.30)


def _openings():
    lower, upper = (0.9, 2.9), (UPPER - FLOOR + 0.75, UPPER - FLOOR + 2.45)
    front_at = (2.0, 5.0, 8.0, 11.2, 22.8, 26.0, 29.0, 32.0)
    front = [Opening(17.0, DOOR_WIDTH, 0.0, DOOR_HEIGHT, "open")]
    front += [Opening(a, 1.2, *storey, "tall") for a in front_at for storey in (lower, upper)]
    front.append(Opening(17.0, 1.2, *upper, "tall"))
    back = [o for o in row(34.0, 10, 1.2, *lower, "tall") if not 6.0 < o.at < 14.0]
    back += row(34.0, 10, 1.2, *upper, "tall")
    side = row(20.0, 5, 1.2, *lower, "tall", skip=(1,)) + row(20.0, 5, 1.2, *upper, "tall")
    other = row(20.0, 5, 1.2, *lower, "tall", skip=(3,)) + row(20.0, 5, 1.2, *upper, "tall")
    return {0: front, 1: side, 2: back, 3: other}


def _column():
    mesh = Mesh()
    mesh.box("stone", (-0.48, 0.0, -0.48), (0.48, 0.16, 0.48), "y")
    lathe(mesh, "ashlar", [(0.46, 0.16), (0.46, 0.28), (0.38, 0.36), (0.375, 2.4), (0.32, 5.1),
                           (0.32, 5.22), (0.44, 5.38)], 16)
    mesh.box("stone", (-0.48, 5.38, -0.48), (0.48, COLUMN_HEIGHT, 0.48), "")
    return mesh


def _portico(library):
    base, roof, column = library.part("portico"), library.part("roof"), _column()
    prism(base, "stone", rect(-PORTICO_X, HALF_Z, PORTICO_X, PORTICO_Z), -0.3, FLOOR,
          cap_material="slabs")
    front_steps(library.part("steps"), -PORTICO_X, PORTICO_X, PORTICO_Z, FLOOR, 4)
    for i in range(6):
        library.prop("column", column, (-7.0 + 2.8 * i, FLOOR, 13.3))
    y = FLOOR + COLUMN_HEIGHT
    beam = rect(-PORTICO_X + 0.1, HALF_Z, PORTICO_X - 0.1, PORTICO_Z - 0.1)
    prism(base, "ashlar", beam, y, y + 0.9, bottom=True)
    band(base, "stone", beam, y + 0.7, y + 0.92, 0.2)
    gable(roof, "slate", "ashlar", (-7.9, 7.0, 7.9, 13.9), y + 0.92, 2.3, "z", 0.4, 0.25, "stone")
    ramp(library.part("ramp"), PORTICO_X, PORTICO_X + RAMP_LENGTH, 11.6, 13.4, FLOOR)
    for z in (11.65, 13.35):
        railing(library.part("ramp"), (PORTICO_X + 0.1, FLOOR - 0.01, z),
                (PORTICO_X + RAMP_LENGTH, 0.0, z), spacing=1.3)
    railing(library.part("ramp"), (PORTICO_X - 0.06, FLOOR, HALF_Z + 0.1),
            (PORTICO_X - 0.06, FLOOR, 11.4))
    railing(library.part("ramp"), (-PORTICO_X + 0.06, FLOOR, HALF_Z + 0.1),
            (-PORTICO_X + 0.06, FLOOR, PORTICO_Z - 0.2))


def _upper_floor(library):
    room = inside(rect(-HALF_X, -HALF_Z, HALF_X, HALF_Z), WALLS.thickness)
    library.floor("parquet", room, UPPER, [STAIR_HOLE], "upper_floor")
    library.ceiling("plaster_inside", room, UPPER - SLAB, [STAIR_HOLE])
    library.hole_edges("wood", STAIR_HOLE, UPPER - SLAB, UPPER, "upper_floor", (2,))
    library.ceiling("plaster_inside", room, CEILING)
    for x in (-15.0, -11.4, -7.8, -4.2, -0.6, 12.2, 15.6):  # oak beams over the hall
        library.part("ceiling").box("wood_dark", (x - 0.13, UPPER - SLAB - 0.22, -9.7),
                                    (x + 0.13, UPPER - SLAB, 1.875), "Yz")
    for x in (-14.0, -9.5, 0.0, 4.5, 9.0, 13.5):
        library.part("ceiling").box("wood_dark", (x - 0.13, CEILING - 0.25, -9.7),
                                    (x + 0.13, CEILING, 9.7), "YzZ")
    stairs = library.part("stairs")
    flight(stairs, STAIR_X, STAIR_Z0, STAIR_Z1, FLOOR, RISERS, material="wood")
    parapet_wall(stairs, (STAIR_X, FLOOR + 0.05, STAIR_Z1 + 0.02),
                 (STAIR_END, UPPER - 0.05, STAIR_Z1 + 0.02), 0.10, 1.0, "wood_dark")
    parapet_wall(stairs, (STAIR_X + 0.1, UPPER, STAIR_Z1 + 0.14),
                 (STAIR_END + 0.1, UPPER, STAIR_Z1 + 0.14), 0.12, 1.05, "wood_dark")
    parapet_wall(stairs, (STAIR_X + 0.14, UPPER, STAIR_Z0),
                 (STAIR_X + 0.14, UPPER, STAIR_Z1 + 0.08), 0.12, 1.05, "wood_dark")
    door = [Opening(9.7, 1.2, 0.0, 2.2)]
    partition(library.part("partitions"), "plaster_inside", (-5.0, 9.7), (-5.0, -9.7), UPPER,
              CEILING, door)
    wainscot(library.part("partitions"), "wood_dark", (-5.0, 9.7), (-5.0, -9.7), UPPER, door)


def _ground_floor(library):
    library.floor("parquet", inside(rect(-HALF_X, -HALF_Z, HALF_X, HALF_Z), WALLS.thickness), FLOOR)
    mesh, top = library.part("partitions"), UPPER - SLAB
    doors = [Opening(16.7 + x, width, 0.0, 2.3) for x, width in
             ((-11.0, 1.2), (0.0, 1.5), (11.0, 1.2))]
    partition(mesh, "plaster_inside", (-16.7, 2.0), (16.7, 2.0), FLOOR, top, doors)
    wainscot(mesh, "wood_dark", (-16.7, 2.0), (16.7, 2.0), FLOOR, doors)
    door = [Opening(3.7, 1.2, 0.0, 2.3)]
    for x in (-5.0, 5.0):
        partition(mesh, "plaster_inside", (x, 9.7), (x, 2.125), FLOOR, top, door)
        wainscot(mesh, "wood_dark", (x, 9.7), (x, 2.125), FLOOR, door)


def _furniture(library):
    shelf, table, chair = furn.bookshelf(), furn.table(2.0, 1.0), furn.chair()
    for x in (-15.0, -12.6, -10.2, -7.8, -5.4, -3.0):
        for z in (-7.6, -3.4):
            library.prop("shelf", shelf, (x, FLOOR, z), 90.0)
    for x in (12.4, 14.8):
        library.prop("shelf", shelf, (x, FLOOR, -2.2), 90.0)
    for x in (-13.5, -9.0):
        for z in (4.4, 7.4):
            _table_group(library, table, chair, (x, FLOOR, z))
    for x in (8.5, 13.0):
        _table_group(library, table, chair, (x, FLOOR, 7.0))
    library.prop("desk", furn.counter(3.0), (3.3, FLOOR, 5.6), -90.0)
    for z in (3.4, 8.6):
        library.prop("armchair", furn.armchair(), (-4.2, FLOOR, z), 90.0)
    for x in (-14.0, -9.5):
        for z in (-6.0, 0.0, 6.0):
            _table_group(library, table, chair, (x, UPPER, z))
    for x in (0.0, 4.5, 9.0, 13.5):
        library.prop("shelf", shelf, (x, UPPER, 7.2), 90.0)
        _table_group(library, table, chair, (x, UPPER, 1.0))
    pictures = [furn.painting(i) for i in range(4)]
    for i, x in enumerate((-14.0, -7.5, -3.0, 3.0, 7.5, 14.0)):
        library.prop("painting", pictures[i % 4], (x, FLOOR + 0.25, 2.13))
    for i, z in enumerate((4.2, 8.2)):
        library.prop("painting", pictures[i], (-4.87, FLOOR + 0.25, z), 90.0)
        library.prop("painting", pictures[i + 2], (4.87, FLOOR + 0.25, z), -90.0)
        library.prop("painting", pictures[i + 1], (-4.87, UPPER + 0.1, z), 90.0)
    lamp = furn.pendant_lamp(0.5)
    for x in (-11.0, 0.0, 11.0):
        for z in (-4.0, 6.0):
            library.prop("pendant", lamp, (x, UPPER - SLAB, z))
            library.prop("pendant", lamp, (x, CEILING, z))


def _table_group(building, table, chair, at):
    building.prop("table", table, at)
    for dx in (-0.5, 0.5):
        building.prop("chair", chair, (at[0] + dx, at[1], at[2] + 0.72), 180.0)
        building.prop("chair", chair, (at[0] + dx, at[1], at[2] - 0.72), 0.0)


def build():
    """The whole library."""
    library = Building("library")
    outline = rect(-HALF_X, -HALF_Z, HALF_X, HALF_Z)
    library.voids = [rect(-HALF_X + 0.05, -HALF_Z + 0.05, HALF_X - 0.05, HALF_Z - 0.05),
                     rect(-PORTICO_X + 0.05, HALF_Z - 0.05, PORTICO_X - 0.05, PORTICO_Z)]
    band(library.part("plinth"), "stone", outline, -0.3, FLOOR - 0.03, 0.08, bottom=False)
    library.shell(WALLS, outline, FLOOR, WALL_TOP, _openings())
    band(library.part("walls"), "stone", outline, UPPER - 0.15, UPPER + 0.10, 0.06)
    cornice(library.part("roof"), "stone", outline, WALL_TOP)
    hip(library.part("roof"), "roof_tiles", (-HALF_X, -HALF_Z, HALF_X, HALF_Z), WALL_TOP, 4.2,
        0.55, "stone")
    _ground_floor(library)
    _upper_floor(library)
    _portico(library)
    _furniture(library)
    library.door_trigger(0.0, FLOOR, HALF_Z)
    library.triggers.append(Trigger("upper-floor", (0.0, UPPER + 1.3, 0.0), (33.0, 2.4, 19.0)))
    library.triggers.append(Trigger("reading-room", (-11.0, FLOOR + 1.4, 5.9), (11.0, 2.8, 7.0)))
    library.points = {
        "library-steps": (0.0, 0.06, 16.5), "library-portico": (0.0, FLOOR, 11.6),
        "library-door": (0.0, FLOOR, 10.0), "library-lobby": (0.0, FLOOR, 6.5),
        "library-desk": (1.8, FLOOR, 5.6), "library-hall": (0.0, FLOOR, 0.5),
        "library-reading-room": (-6.6, FLOOR, 6.0), "library-stacks": (0.0, FLOOR, -5.5),
        "library-wall": (-1.4, FLOOR, -9.45),
        "library-stairs-foot": (2.6, FLOOR, -8.9),
        "library-stairs-bottom": (3.6, FLOOR, -8.9),
        "library-stairs-top": (STAIR_END + 0.7, UPPER, -8.9),
        "library-gallery": (11.5, UPPER, -5.0), "library-rare-books": (-6.6, UPPER, 0.0),
        "library-ramp-foot": (PORTICO_X + RAMP_LENGTH + 1.0, 0.06, 12.5),
        "library-ramp-top": (PORTICO_X - 0.7, FLOOR, 12.5)}
    return library
