"""Stairs, ramps and railings."""

from .shapes import beam

RISER, TREAD = 0.17, 0.29   # a comfortable public stair: 2 risers + tread = 0.63 m
RAIL_HEIGHT = 1.05


def flight(mesh, x0, z0, z1, y0, risers, tread=TREAD, material="stone", direction=1.0):
    """A solid straight flight rising along +x (or -x) from x0, between z0 and z1.

    The last riser ends at the upper floor's edge: there are risers - 1 treads.
    Returns the x where the upper floor begins.
    """
    for i in range(risers - 1):
        near, far = x0 + direction * tread * i, x0 + direction * tread * (i + 1)
        low, high = min(near, far), max(near, far)
        top = y0 + RISER * (i + 1)
        hidden = "yX" if direction > 0 else "yx"
        mesh.box(material, (low, top - RISER, z0), (high, top, z1), hidden)
        if i:  # the flanks down to the floor below
            for z, flip in ((z1, False), (z0, True)):
                face = [(low, y0, z), (high, y0, z), (high, top - RISER, z), (low, top - RISER, z)]
                mesh.poly(material, face[::-1] if flip else face)
    end = x0 + direction * tread * (risers - 1)
    back = [(end, y0, z1), (end, y0, z0), (end, y0 + RISER * (risers - 1), z0),
            (end, y0 + RISER * (risers - 1), z1)]
    mesh.poly(material, back if direction > 0 else back[::-1])
    return end


def front_steps(mesh, x0, x1, z_top, floor, risers, tread=0.30, material="stone"):
    """Steps in front of a platform whose edge is at z_top, going down towards +z."""
    for i in range(risers - 1):
        top = floor - RISER * (i + 1)
        mesh.box(material, (x0, -0.3, z_top + tread * i), (x1, top, z_top + tread * (i + 1)), "yz")


def ramp(mesh, x_high, x_low, z0, z1, floor, material="concrete"):
    """A ramp along x from a platform (height floor) down to the ground."""
    points = [(x_low, -0.02, z1), (x_low, -0.02, z0), (x_high, floor, z0), (x_high, floor, z1)]
    mesh.poly(material, points if x_low > x_high else points[::-1])
    for z, flip in ((z1, x_low < x_high), (z0, x_low > x_high)):
        face = [(x_high, -0.3, z), (x_low, -0.3, z), (x_low, -0.02, z), (x_high, floor, z)]
        mesh.poly(material, face[::-1] if flip else face)


def railing(mesh, start, end, material="iron", height=RAIL_HEIGHT, spacing=1.2, bars=3):
    """Posts and rails between two floor points."""
    length = max(abs(end[0] - start[0]), abs(end[2] - start[2]), 0.01)
    count = max(1, int(length / spacing + 0.5))
    for i in range(count + 1):
        t = i / count
        x, y, z = (a + (b - a) * t for a, b in zip(start, end))
        mesh.box(material, (x - 0.025, y, z - 0.025), (x + 0.025, y + height, z + 0.025), "y")
    for i in range(bars):
        lift = height * (i + 1) / bars - (0.03 if i + 1 == bars else 0.0)
        beam(mesh, material, (start[0], start[1] + lift, start[2]),
             (end[0], end[1] + lift, end[2]), 0.05 if i + 1 == bars else 0.03, 0.04)


def parapet_wall(mesh, start, end, thickness=0.15, height=RAIL_HEIGHT, material="plaster_inside"):
    """A closed low wall between two floor points (it may slope with a stair)."""
    beam(mesh, material, start, end, thickness, height)
