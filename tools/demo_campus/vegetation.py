"""Trees and hedges: one shared mesh a species, placed many times."""

from .exact import Random, cos_deg, sin_deg
from .mesh import Mesh, unit
from .shapes import sphere_net, tube

SINK = 0.15  # trunks start below the ground, so that slopes show no gap


HIDDEN_INSIDE = 0.82  # a corner this deep in another lump (share of its radii) is never seen


class Crown:
    """Foliage: lumps of leaves with cut-out twigs on them, softly lit from the crown's middle."""

    def __init__(self, mesh, leaves, card, centre, seed):
        self._mesh, self._leaves, self._card = mesh, leaves, card
        self._centre, self._random = centre, Random(seed)
        self._points, self._faces = sphere_net(1)
        self._lumps = []  # (centre, radii, corner points)

    def _soft(self, point, normal, share=0.55):
        """A normal between the lump's own and the direction from the crown's middle."""
        away = unit(tuple(p - c for p, c in zip(point, self._centre)))
        return unit(tuple(n * (1.0 - share) + a * share for n, a in zip(normal, away)))

    def lump(self, centre, radii, cards=0, card_size=1.0):
        """One rounded mass of leaves, roughened, with twigs sticking out of it."""
        random = self._random
        shape = []
        for point in self._points:
            push = random.between(0.84, 1.14)
            shape.append(tuple(c + p * r * push for c, p, r in zip(centre, point, radii)))
        self._lumps.append((centre, radii, shape))
        for _ in range(cards):
            way = unit((random.between(-1, 1), random.between(-0.5, 1), random.between(-1, 1)))
            spot = tuple(c + w * r * random.between(0.92, 1.08)
                         for c, w, r in zip(centre, way, radii))
            self._twig(spot, way, card_size * random.between(0.75, 1.2))

    def finish(self):
        """Writes the lumps' faces, but for those deep inside another lump; returns the mesh."""
        for own, (_, _, shape) in enumerate(self._lumps):
            others = [lump for i, lump in enumerate(self._lumps) if i != own]
            hidden = [{i for i, lump in enumerate(others) if _inside(point, lump)}
                      for point in shape]
            for a, b, c in self._faces:
                if not hidden[a] & hidden[b] & hidden[c]:
                    self._mesh.poly(self._leaves, [shape[a], shape[b], shape[c]], normals=[
                        self._soft(shape[i], self._points[i]) for i in (a, b, c)])
        return self._mesh

    def _twig(self, spot, way, size):
        """A cut-out card through a point, its plane roughly along `way`."""
        random = self._random
        side = unit((random.between(-1, 1), random.between(-0.4, 0.4), random.between(-1, 1)))
        up = unit(tuple(w + random.between(-0.7, 0.7) for w in way))
        half = size / 2
        points = [tuple(s + a * u * half + b * v * half for s, u, v in zip(spot, side, up))
                  for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
        normal = self._soft(spot, way, 0.7)
        self._mesh.poly(self._card, points, [(0, 1), (1, 1), (1, 0), (0, 0)], [normal] * 4)


def _inside(point, lump):
    centre, radii, _ = lump
    return sum(((p - c) / r) ** 2 for p, c, r in zip(point, centre, radii)) < HIDDEN_INSIDE ** 2


def _trunk(mesh, material, height, radius, top_radius, branches, seed, sides=8):
    random = Random(seed)
    knee = (random.between(-0.08, 0.08), height * 0.5, random.between(-0.08, 0.08))
    middle = (radius + top_radius) / 2
    tube(mesh, material, (0.0, -SINK, 0.0), (0.0, 0.25, 0.0), radius * 1.35, radius, sides)
    # Each length starts inside the one below it: their rims do not meet exactly.
    tube(mesh, material, (0.0, 0.20, 0.0), knee, radius * 1.02, middle, sides)
    below = (knee[0] * 0.9, knee[1] - 0.06, knee[2] * 0.9)
    tube(mesh, material, below, (0.0, height, 0.0), middle, top_radius, sides)
    for k in range(branches):
        angle = 360.0 / branches * k + random.between(-25, 25)
        low = height * random.between(0.62, 0.9)
        reach = random.between(1.0, 1.6)
        tube(mesh, material, (0.0, low, 0.0),
             (reach * cos_deg(angle), low + reach * random.between(0.7, 1.2),
              reach * sin_deg(angle)), top_radius * 0.6, top_radius * 0.25, 5)


def oak(seed):
    """Broad and heavy."""
    mesh, random = Mesh(), Random(seed)
    _trunk(mesh, "bark", 4.2, 0.34, 0.22, 5, seed)
    crown = Crown(mesh, "leaves_oak", "card_oak", (0.0, 4.6, 0.0), seed + 1)
    for k in range(5):
        angle = 72.0 * k + random.between(-14, 14)
        reach = random.between(1.7, 2.3)
        crown.lump((reach * cos_deg(angle), random.between(4.0, 5.2), reach * sin_deg(angle)),
                   (random.between(1.6, 2.1), random.between(1.2, 1.6), random.between(1.6, 2.1)),
                   8, 1.4)
    crown.lump((0.2, 6.2, -0.1), (2.0, 1.5, 2.0), 10, 1.3)
    return crown.finish()


def lime(seed):
    """An avenue tree: egg-shaped."""
    mesh, random = Mesh(), Random(seed)
    _trunk(mesh, "bark", 4.0, 0.24, 0.15, 3, seed)
    crown = Crown(mesh, "leaves_lime", "card_lime", (0.0, 4.6, 0.0), seed + 1)
    for y, reach, size, count in ((3.8, 0.9, 1.3, 3), (5.2, 0.75, 1.25, 3)):
        for k in range(count):
            angle = 360.0 / count * k + y * 30 + random.between(-12, 12)
            crown.lump((reach * cos_deg(angle), y + random.between(-0.25, 0.25),
                        reach * sin_deg(angle)), (size, size * 1.05, size), 6, 1.05)
    crown.lump((0.0, 6.6, 0.0), (1.0, 1.25, 1.0), 8, 0.95)
    return crown.finish()


def birch(seed):
    """Slender, white-barked, airy."""
    mesh, random = Mesh(), Random(seed)
    _trunk(mesh, "bark_birch", 6.4, 0.15, 0.05, 5, seed)
    crown = Crown(mesh, "leaves_birch", "card_birch", (0.0, 5.0, 0.0), seed + 1)
    for k in range(6):
        angle = 137.0 * k
        reach = 1.0 - 0.1 * k
        crown.lump((reach * cos_deg(angle), 3.4 + 0.72 * k, reach * sin_deg(angle)),
                   (0.85 - 0.05 * k, 0.8 + random.between(0.0, 0.2), 0.85 - 0.05 * k), 7, 0.9)
    return crown.finish()


def willow(seed):
    """A dome with hanging curtains, for the pond."""
    mesh, random = Mesh(), Random(seed)
    _trunk(mesh, "bark", 3.6, 0.36, 0.22, 5, seed)
    crown = Crown(mesh, "leaves_willow", "card_willow", (0.0, 3.6, 0.0), seed + 1)
    crown.lump((0.0, 5.0, 0.0), (2.4, 1.3, 2.4), 8, 1.3)
    for k in range(7):
        angle = 51.4 * k + random.between(-8, 8)
        x, z = 2.5 * cos_deg(angle), 2.5 * sin_deg(angle)
        crown.lump((x, 3.6, z), (1.05, 1.6, 1.05), 5, 1.1)
        crown.lump((x * 1.05, 2.4, z * 1.05), (0.65, 1.0, 0.65), 3, 1.0)
    return crown.finish()


def cherry(seed):
    """A small tree in blossom."""
    mesh, random = Mesh(), Random(seed)
    _trunk(mesh, "bark", 2.5, 0.17, 0.11, 4, seed)
    crown = Crown(mesh, "blossom", "card_blossom", (0.0, 3.0, 0.0), seed + 1)
    for k in range(4):
        angle = 90.0 * k + random.between(-14, 14)
        crown.lump((1.05 * cos_deg(angle), 2.9 + random.between(-0.2, 0.4),
                    1.05 * sin_deg(angle)), (1.1, 0.8, 1.1), 7, 0.85)
    crown.lump((0.0, 3.7, 0.0), (1.15, 0.8, 1.15), 8, 0.85)
    return crown.finish()


def spruce(seed):
    """A conifer: drooping tiers with ragged rims."""
    mesh, random = Mesh(), Random(seed)
    _trunk(mesh, "bark", 2.2, 0.2, 0.16, 0, seed)
    sides, y = 14, 1.1
    for tier in range(7):
        share = 1.0 - tier / 7.6
        radius, height = 2.1 * share, 1.9 * (0.55 + 0.45 * share)
        rim = []
        for k in range(sides):
            reach = radius * (random.between(0.92, 1.08) if k % 2 else random.between(0.66, 0.78))
            angle = 360.0 / sides * k + 13.0 * tier
            rim.append((reach * cos_deg(angle), y - 0.18 * reach, reach * sin_deg(angle)))
        tip = (0.0, y + height, 0.0)
        for k in range(sides):
            a, b = rim[k], rim[(k + 1) % sides]
            normals = [unit((p[0], radius * 0.55, p[2])) for p in (b, a)] + [(0.0, 1.0, 0.0)]
            mesh.poly("needles", [b, a, tip], normals=normals)
            mesh.poly("needles", [a, b, (0.0, y + 0.25, 0.0)])
        y += height * 0.52
    return mesh


def poplar(seed):
    """A column."""
    mesh, random = Mesh(), Random(seed)
    _trunk(mesh, "bark", 5.0, 0.2, 0.1, 0, seed)
    crown = Crown(mesh, "leaves_oak", "card_oak", (0.0, 5.5, 0.0), seed + 1)
    for k in range(5):
        size = (0.9, 1.1, 1.1, 0.9, 0.55)[k]
        crown.lump((random.between(-0.15, 0.15), 2.4 + 1.6 * k, random.between(-0.15, 0.15)),
                   (size, 1.35, size), 7, 0.85)
    return crown.finish()


# species: (mesh builder, collider radius at scale 1, clear radius kept free around it)
SPECIES = {
    "oak": (oak, 0.36, 3.6), "lime": (lime, 0.26, 2.2), "birch": (birch, 0.18, 2.0),
    "willow": (willow, 0.38, 3.2), "cherry": (cherry, 0.20, 2.2), "spruce": (spruce, 0.24, 2.2),
    "poplar": (poplar, 0.24, 1.5),
}
TREE_COLLIDER_HEIGHT = 2.6


HEDGE_LENGTH, HEDGE_HEIGHT, HEDGE_WIDTH = 3.0, 1.05, 0.8


def hedge(seed):
    """Three metres of clipped hedge with an uneven, rounded top."""
    mesh, random = Mesh(), Random(seed)
    steps, half, width = 6, HEDGE_LENGTH / 2, HEDGE_WIDTH / 2
    section = [(width, -0.35), (width, 0.80), (width - 0.10, 1.0), (0.0, HEDGE_HEIGHT),
               (-width + 0.10, 1.0), (-width, 0.80), (-width, -0.35)]
    rows = []
    for k in range(steps + 1):
        x = -half + HEDGE_LENGTH * k / steps
        rough = 0.0 if k in (0, steps) else 1.0
        rows.append([(x, y + (random.between(-0.05, 0.03) * rough if y > 0 else 0.0),
                      z + random.between(-0.04, 0.04) * rough) for z, y in section])
    for a, b in zip(rows, rows[1:]):
        for i in range(len(section) - 1):
            mesh.quad("hedge", a[i], b[i], b[i + 1], a[i + 1])
    mesh.poly("hedge", rows[0])
    mesh.poly("hedge", rows[-1][::-1])
    return mesh
