"""Roofs with eaves: every one a closed body, sheathed above, boarded below."""

from math import sqrt

from .polygon import offset
from .shapes import band, ring

EAVES_THICKNESS = 0.18


def hip(mesh, tiles, box, y, rise, eaves=0.6, soffit="frame_white", ridge=True):
    """A hipped roof over a rectangle (x0, z0, x1, z1) whose walls end at y."""
    x0, z0, x1, z1 = box[0] - eaves, box[1] - eaves, box[2] + eaves, box[3] + eaves
    half = min(x1 - x0, z1 - z0) / 2
    mx, mz = (x0 + x1) / 2, (z0 + z1) / 2
    if x1 - x0 >= z1 - z0:
        a, b = (x0 + half, mz), (x1 - half, mz)
    else:
        a, b = (mx, z0 + half), (mx, z1 - half)
    foot = y + EAVES_THICKNESS
    top = foot + rise
    sw, se, ne, nw = (x0, foot, z1), (x1, foot, z1), (x1, foot, z0), (x0, foot, z0)
    ra, rb = (a[0], top, a[1]), (b[0], top, b[1])
    if x1 - x0 >= z1 - z0:
        faces = [(sw, se, rb, ra), (se, ne, rb), (ne, nw, ra, rb), (nw, sw, ra)]
    else:
        faces = [(sw, se, rb), (se, ne, ra, rb), (ne, nw, ra), (nw, sw, rb, ra)]
    for face in faces:
        mesh.poly(tiles, face)
    mesh.box(soffit, (x0, y, z0), (x1, foot, z1), "Y")
    if ridge and ra != rb:
        w = 0.12
        mesh.box(tiles, (min(a[0], b[0]) - w, top - 0.08, min(a[1], b[1]) - w),
                 (max(a[0], b[0]) + w, top + 0.10, max(a[1], b[1]) + w), "y")


def gable(mesh, tiles, wall_material, box, y, rise, along="x", eaves=0.5, verge=0.3,
          soffit="frame_white"):
    """A saddle roof with its ridge along x or z, and the gable walls under it."""
    flat = box if along == "x" else (box[1], box[0], box[3], box[2])
    x0, z0, x1, z1 = flat
    mid, half = (z0 + z1) / 2, (z1 - z0) / 2
    slope = rise / half
    thick = EAVES_THICKNESS

    def put(points, material, flip=False):
        if along == "z":  # swap the axes; a swap mirrors, so the order turns round too
            points = [(pz, py, px) for px, py, pz in reversed(points)]
        mesh.poly(material, points[::-1] if flip else points)
    for x, flip in ((x1, False), (x0, True)):
        put([(x, y, z1), (x, y, z0), (x, y + rise, mid)], wall_material, flip)
    xa, xb = x0 - verge, x1 + verge
    low = y - eaves * slope
    for z_edge, flip in ((z1 + eaves, False), (z0 - eaves, True)):
        top_a, top_b = (xa, y + rise + thick, mid), (xb, y + rise + thick, mid)
        edge_a, edge_b = (xa, low + thick, z_edge), (xb, low + thick, z_edge)
        put([edge_a, edge_b, top_b, top_a], tiles, flip)
        under = [(p[0], p[1] - thick, p[2]) for p in (edge_a, edge_b, top_b, top_a)]
        put(under[::-1], soffit, flip)
        put([under[0], under[1], edge_b, edge_a], soffit, flip)
        put([under[1], under[2], top_b, edge_b], soffit, flip)
        put([under[3], under[0], edge_a, top_a], soffit, flip)


def flat(mesh, poly, parts, y, parapet=0.7, wall_material="concrete", coping="stone",
         covering="roof_gravel", thickness=0.3):
    """A flat roof with a parapet; parts: convex polygons that make up the outline."""
    for part in parts:
        mesh.poly(covering, [(x, y, z) for x, z in part])
    ring(mesh, wall_material, poly, y, y + parapet, thickness)
    cope = offset(poly, 0.06)
    ring(mesh, coping, cope, y + parapet - 0.02, y + parapet + 0.08, thickness + 0.12)


def cone(mesh, tiles, poly, y, rise, eaves=0.6, soffit="frame_white", lantern=0.0):
    """A pyramid over a convex polygon; lantern > 0 stops it at that share of its size."""
    low = offset(poly, eaves)
    count = len(poly)
    cx = sum(p[0] for p in poly) / count
    cz = sum(p[1] for p in poly) / count
    foot = y + EAVES_THICKNESS
    top = foot + rise
    high = [(cx + (x - cx) * lantern, cz + (z - cz) * lantern) for x, z in low]
    for i in range(count):
        j = (i + 1) % count
        a, b, c, d = low[i], low[j], high[j], high[i]
        mesh.poly(tiles, [(a[0], foot, a[1]), (b[0], foot, b[1]), (c[0], top, c[1]),
                          (d[0], top, d[1])][:4 if lantern else 3])
    mesh.poly(soffit, [(x, y, z) for x, z in reversed(low)])
    for i in range(count):
        (ax, az), (bx, bz) = low[i], low[(i + 1) % count]
        mesh.quad(soffit, (ax, y, az), (bx, y, bz), (bx, foot, bz), (ax, foot, az))
    return high, top


def barrel(mesh, cover, wall_material, box, y, rise, segments=14, eaves=0.5,
           soffit="frame_white"):
    """A segmental vault along x over a rectangle, with its end walls."""
    x0, z0, x1, z1 = box
    half, mid = (z1 - z0) / 2 + eaves, (z0 + z1) / 2
    radius = (half * half + rise * rise) / (2 * rise)
    line = []
    for i in range(segments + 1):
        z = -half + 2 * half * i / segments
        height = sqrt(radius * radius - z * z) - (radius - rise)
        line.append((mid + z, y + height, z / radius, sqrt(radius * radius - z * z) / radius))
    xa, xb = x0 - eaves, x1 + eaves
    run = 0.0
    for (za, ya, na, ua), (zb, yb, nb, ub) in zip(line, line[1:]):
        step = sqrt((zb - za) ** 2 + (yb - ya) ** 2)
        thick = EAVES_THICKNESS
        top = [(xa, ya + thick, za), (xa, yb + thick, zb), (xb, yb + thick, zb),
               (xb, ya + thick, za)]
        normals = [(0.0, ua, na), (0.0, ub, nb), (0.0, ub, nb), (0.0, ua, na)]
        uvs = [(xa / 2, run / 2), (xa / 2, (run + step) / 2), (xb / 2, (run + step) / 2),
               (xb / 2, run / 2)]
        mesh.poly(cover, top, uvs, normals)
        under = [(px, py - thick, pz) for px, py, pz in reversed(top)]
        mesh.poly(soffit, under)
        mesh.quad(soffit, (xb, ya, za), (xb, ya + thick, za), (xb, yb + thick, zb), (xb, yb, zb))
        mesh.quad(soffit, (xa, ya, za), (xa, yb, zb), (xa, yb + thick, zb), (xa, ya + thick, za))
        ca, cb = max(z0, min(z1, za)), max(z0, min(z1, zb))
        if cb > ca:
            mesh.poly(wall_material, [(x1, y, cb), (x1, y, ca), (x1, ya, ca), (x1, yb, cb)])
            mesh.poly(wall_material, [(x0, y, ca), (x0, y, cb), (x0, yb, cb), (x0, ya, ca)])
        run += step
    for z, sign in ((line[0][0], -1), (line[-1][0], 1)):
        a, b = (xa, y, z), (xb, y, z)
        c, d = (xb, y + EAVES_THICKNESS, z), (xa, y + EAVES_THICKNESS, z)
        mesh.poly(soffit, [a, b, c, d] if sign > 0 else [d, c, b, a])


def cornice(mesh, material, poly, y):
    """A moulded cornice in two belts under an eaves line at y."""
    band(mesh, material, poly, y - 0.45, y - 0.20, 0.12)
    band(mesh, material, poly, y - 0.20, y, 0.28)
