"""The pond: a quay wall all round but in the east, where the bed rises as a beach."""

from .layout import POND_CENTRE, POND_CORNERS, POND_DEPTH, POND_LEVEL, POND_RADII, POND_WATER
from .exact import cos_deg, sin_deg
from .mesh import Mesh

BEACH = 0.45  # how far the beach reaches in, as a share of the radius


def _ring(depth_share):
    """The basin at a share of its depth: rim (0) to bed (1), counter-clockwise from above."""
    ring = []
    for i in range(POND_CORNERS):
        angle = -360.0 / POND_CORNERS * i
        c, s = cos_deg(angle), sin_deg(angle)
        share = 1.0 - BEACH * max(0.0, c) * depth_share
        ring.append((POND_CENTRE[0] + POND_RADII[0] * share * c,
                     POND_LEVEL - POND_DEPTH * depth_share,
                     POND_CENTRE[1] + POND_RADII[1] * share * s))
    return ring


def basin():
    """Walls, beach and bed, seen from inside."""
    mesh, rim, bed = Mesh(), _ring(0.0), _ring(1.0)
    centre = (POND_CENTRE[0], POND_LEVEL - POND_DEPTH, POND_CENTRE[1])
    for i in range(POND_CORNERS):
        j = (i + 1) % POND_CORNERS
        steep = cos_deg(360.0 / POND_CORNERS * (i + 0.5)) < 0.15
        mesh.quad("granite" if steep else "gravel", bed[j], bed[i], rim[i], rim[j])
        mesh.poly("pond_bed", [bed[i], bed[j], centre])
    return mesh


def water():
    """The water surface; nothing collides with it."""
    mesh = Mesh()
    ring = _ring(POND_WATER / POND_DEPTH)
    centre = (POND_CENTRE[0], POND_LEVEL - POND_WATER, POND_CENTRE[1])
    for i, a in enumerate(ring):
        mesh.poly("water", [a, ring[(i + 1) % POND_CORNERS], centre])
    return mesh
