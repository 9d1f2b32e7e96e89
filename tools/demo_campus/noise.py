"""Tileable value noise as flat lists of numbers in 0..1 (row by row)."""

from .exact import Random, smooth


def octave(size, cells_x, cells_y, seed):
    """One octave: a random lattice of cells_x by cells_y, smoothly interpolated, tileable."""
    random = Random(seed)
    lattice = [[random.unit() for _ in range(cells_x)] for _ in range(cells_y)]
    columns = []
    for x in range(size):
        at = x * cells_x / size
        cell = int(at)
        columns.append((cell % cells_x, (cell + 1) % cells_x, smooth(at - cell)))
    rows = [[row[a] + (row[b] - row[a]) * t for a, b, t in columns] for row in lattice]
    out = []
    for y in range(size):
        at = y * cells_y / size
        cell = int(at)
        t = smooth(at - cell)
        top, bottom = rows[cell % cells_y], rows[(cell + 1) % cells_y]
        out += [a + (b - a) * t for a, b in zip(top, bottom)]
    return out


def field(size, seed, octaves):
    """A weighted sum of octaves [(cells x, cells y, weight)], scaled back to 0..1."""
    total = sum(weight for _, _, weight in octaves)
    out = [0.0] * (size * size)
    for i, (cells_x, cells_y, weight) in enumerate(octaves):
        share = weight / total
        layer = octave(size, cells_x, cells_y, seed * 31 + i)
        out = [o + share * v for o, v in zip(out, layer)]
    return out


def grain(size, seed):
    """Pixel noise in 0..1."""
    random = Random(seed)
    return [random.unit() for _ in range(size * size)]


class Relief:
    """Value noise over the plane, for the terrain."""

    def __init__(self, seed, cells=64):
        random = Random(seed)
        self._cells = cells
        self._lattice = [[random.between(-1.0, 1.0) for _ in range(cells)] for _ in range(cells)]

    def at(self, x, z):
        """Noise in -1..1 at lattice coordinates."""
        ix, iz = int(x // 1), int(z // 1)
        tx, tz = smooth(x - ix), smooth(z - iz)
        n, rows = self._cells, self._lattice
        top, bottom = rows[iz % n], rows[(iz + 1) % n]
        a = top[ix % n] + (top[(ix + 1) % n] - top[ix % n]) * tx
        b = bottom[ix % n] + (bottom[(ix + 1) % n] - bottom[ix % n]) * tx
        return a + (b - a) * tz
