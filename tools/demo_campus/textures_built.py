"""Textures of walls, roofs, paving and floors: courses of pieces with joints."""

from .exact import Random
from .noise import field, grain


def mix(a, b, t):
    """Colour between two colours."""
    return tuple(x + (y - x) * t for x, y in zip(a, b))


def clamp(colour):
    """Colour as bytes."""
    return tuple(0 if v < 0 else 255 if v > 255 else int(v + 0.5) for v in colour)


def shaded(size, seed, low, high, octaves, speckle=0.0):
    """A surface between two colours, by noise, with pixel speckle of +-speckle/2."""
    soft, fine = field(size, seed, octaves), grain(size, seed + 7)
    out = []
    for s, f in zip(soft, fine):
        t = s + (f - 0.5) * speckle
        out.append(clamp((low[0] + (high[0] - low[0]) * t, low[1] + (high[1] - low[1]) * t,
                          low[2] + (high[2] - low[2]) * t)))
    return out


def courses(size, seed, columns, rows, *, colours, joint, joint_colour, stagger=0.5,
            rough=0.25, bevel=0.0, spread=0.08, profile=None):
    """Pieces in staggered courses.

    joint: width in pixels; rough: strength of the surface noise; bevel: how much darker a piece
    gets towards its joints; spread: random light of whole pieces; profile(u, v): light over one
    piece, u and v in 0..1.
    """
    random = Random(seed)
    pieces = [[(random.pick(colours), 1.0 + spread * (random.unit() * 2 - 1))
               for _ in range(columns)] for _ in range(rows)]
    soft = field(size, seed + 1, [(16, 16, 2), (64, 64, 2), (128, 128, 1)])
    fine = grain(size, seed + 2)
    width, height = size / columns, size / rows
    out = []
    for y in range(size):
        row = int(y / height)
        in_y = y - row * height
        shift = (row % 2) * stagger * width
        edge_y = min(in_y, height - in_y)
        base = y * size
        for x in range(size):
            at = (x + shift) % size
            column = int(at / width)
            in_x = at - column * width
            edge = min(edge_y, in_x, width - in_x)
            noise = (soft[base + x] - 0.5) * rough + (fine[base + x] - 0.5) * rough * 0.5
            if edge < joint * 0.5:
                light = 1.0 + noise
                r, g, b = joint_colour
            else:
                (r, g, b), light = pieces[row][column]
                light += noise
                if bevel and edge < joint * 0.5 + 3.0:
                    light -= bevel * (1.0 - (edge - joint * 0.5) / 3.0)
                if profile:
                    light *= profile(in_x / width, in_y / height)
            out.append(clamp((r * light, g * light, b * light)))
    return out


def _tile_profile(u, v):
    """A curved roof tile, shaded by the one above."""
    return (0.72 + 1.1 * u * (1.0 - u)) * (0.62 + 0.38 * min(1.0, v * 4.0))


def _slate_profile(_, v):
    return 0.70 + 0.30 * min(1.0, v * 5.0)


def _board_profile(_, v):
    return 0.80 + 0.20 * min(1.0, v * 8.0)


def brick(size, colours, seed):
    """Running bond with pale mortar."""
    return courses(size, seed, 8, 24, colours=colours, joint=size / 180,
                   joint_colour=(168, 158, 144), rough=0.30, bevel=0.10, spread=0.12)


def ashlar(size):
    """Warm sandstone blocks."""
    return courses(size, 21, 4, 6, colours=[(196, 180, 150), (204, 190, 162), (188, 170, 140),
                                            (200, 184, 158)],
                   joint=2.5, joint_colour=(140, 128, 108), rough=0.16, bevel=0.08, spread=0.05)


def slabs(size):
    """Large paving stones of the square."""
    return courses(size, 22, 6, 6, colours=[(164, 158, 148), (172, 164, 150), (154, 150, 144),
                                            (178, 168, 152)],
                   joint=2.5, joint_colour=(104, 100, 92), rough=0.16, bevel=0.06, spread=0.06)


def setts(size):
    """Small paving bricks of the footpaths."""
    return courses(size, 23, 10, 20, colours=[(150, 118, 98), (160, 128, 106), (140, 112, 98),
                                              (156, 134, 116)],
                   joint=2.0, joint_colour=(98, 90, 80), rough=0.22, bevel=0.10, spread=0.10)


def roof_tiles(size):
    """Clay tiles."""
    return courses(size, 24, 12, 8, colours=[(168, 84, 58), (156, 76, 54), (178, 94, 64),
                                             (146, 74, 56)],
                   joint=0.0, joint_colour=(80, 44, 34), rough=0.22, spread=0.10,
                   profile=_tile_profile)


def slate(size):
    """Slates."""
    return courses(size, 25, 10, 12, colours=[(92, 98, 108), (84, 90, 100), (100, 104, 110),
                                              (88, 98, 104)],
                   joint=1.2, joint_colour=(50, 54, 60), rough=0.20, spread=0.10,
                   profile=_slate_profile)


def planks(size):
    """Horizontal boards; tinted by the materials that use them."""
    return courses(size, 26, 1, 8, colours=[(176, 142, 104), (166, 132, 96), (184, 150, 112)],
                   joint=0.0, joint_colour=(70, 52, 36), rough=0.16, spread=0.06, stagger=0.0,
                   profile=_board_profile)


def parquet(size):
    """Oak strip floor."""
    return courses(size, 27, 3, 16, colours=[(172, 126, 80), (160, 114, 70), (182, 138, 92),
                                             (150, 108, 68)],
                   joint=1.0, joint_colour=(84, 58, 36), rough=0.14, spread=0.07)


def floor_tiles(size):
    """Pale square tiles."""
    return courses(size, 28, 6, 6, colours=[(196, 192, 182), (188, 184, 174), (202, 198, 188)],
                   joint=2.0, joint_colour=(132, 128, 120), rough=0.06, spread=0.03, stagger=0.0)


def concrete(size):
    """Board-marked concrete with panel joints."""
    return courses(size, 29, 2, 2, colours=[(158, 156, 150), (152, 150, 146)], joint=2.0,
                   joint_colour=(108, 106, 102), rough=0.20, spread=0.03, stagger=0.0)


def metal_seam(size):
    """Standing-seam sheet: four ribs a repeat."""
    def rib(u, _):
        return 1.25 if u < 0.05 else 0.70 if u < 0.10 else 0.97 + 0.06 * u
    return courses(size, 30, 4, 1, colours=[(176, 180, 184)], joint=0.0, joint_colour=(0, 0, 0),
                   rough=0.08, spread=0.03, stagger=0.0, profile=rib)


def copper(size):
    """Verdigris sheets."""
    return courses(size, 31, 4, 4, colours=[(104, 158, 138), (96, 150, 132), (114, 164, 144),
                                            (100, 144, 124)],
                   joint=2.0, joint_colour=(66, 108, 94), rough=0.24, spread=0.05)


def glass(size):
    """A window pane that reflects sky above and trees below."""
    soft = field(size, 32, [(3, 2, 2), (6, 4, 1)])
    out = []
    for y in range(size):
        for x in range(size):
            t = soft[y * size + x]
            out.append(clamp(mix((44, 58, 70), (116, 142, 162), t)))
    return out


def curtain_glass(size):
    """Panes of a glass front, each tilted a little differently, with blinds here and there."""
    random = Random(33)
    panes = [[(random.between(0.0, 0.35), random.unit() < 0.16) for _ in range(4)]
             for _ in range(2)]
    soft = field(size, 34, [(4, 4, 2), (9, 9, 1)])
    out = []
    for y in range(size):
        for x in range(size):
            u, v = x * 4 / size, y * 2 / size
            tilt, blind = panes[int(v)][int(u)]
            in_v = v - int(v)
            t = 0.65 * (1.0 - in_v) * (1.0 - tilt) + 0.35 * soft[y * size + x]
            colour = mix((38, 62, 78), (150, 186, 208), t)
            if blind and in_v < 0.55:
                colour = mix((196, 198, 192), (170, 174, 172), (y % 6) / 6)
            out.append(clamp(colour))
    return out


def lit_room(size):
    """What glows behind a window at night: a lamp's light on the ceiling, curtains at the sides."""
    out = []
    for y in range(size):
        for x in range(size):
            u, v = (x + 0.5) / size, (y + 0.5) / size
            away = ((u - 0.5) ** 2 + (v - 0.28) ** 2) ** 0.5
            colour = mix((255, 250, 236), (168, 140, 104), min(1.0, 1.5 * away))
            if min(u, 1.0 - u) < 0.16:
                fold = 0.5 + 0.5 * ((x // 2) % 2)
                colour = mix((196, 132, 78), (150, 96, 56), fold)
            elif v > 0.86:
                colour = (92, 70, 50)
            out.append(clamp(colour))
    return out


def lit_front(size):
    """Panes of a glass front at night: some offices are empty, in some the blinds are down."""
    random = Random(61)
    panes = [[0.0 if random.unit() < 0.35 else random.between(0.45, 1.0) for _ in range(4)]
             for _ in range(2)]
    out = []
    for y in range(size):
        for x in range(size):
            u, v = x * 4 / size, y * 2 / size
            light = panes[int(v)][int(u)]
            colour = mix((255, 248, 226), (196, 172, 134), v - int(v))
            out.append(clamp(mix((6, 7, 9), colour, light)))
    return out


def road(size):
    """Seven metres of carriageway: edge lines and a dashed centre line, along v."""
    out = shaded(size, 35, (70, 71, 74), (98, 98, 98),
                 [(8, 8, 2), (32, 32, 1), (128, 128, 1)], 0.9)
    wear = field(size, 36, [(24, 24, 1), (96, 96, 1)])
    metre = size / 7.0
    for y in range(size):
        for x in range(size):
            centre = abs(x - size / 2) < 0.07 * metre and y % (size // 2) < size * 0.28
            edge = 0.22 * metre < x < 0.36 * metre or 0.22 * metre < size - x < 0.36 * metre
            if (centre or edge) and wear[y * size + x] < 0.66:
                out[y * size + x] = clamp(mix(out[y * size + x], (214, 212, 204), 0.85))
    return out


def door(size):
    """A panelled wooden door leaf."""
    soft = field(size, 37, [(24, 3, 2), (96, 6, 1)])
    out = []
    for y in range(size):
        v = y / size
        for x in range(size):
            u = x / size
            light = 0.85 + 0.3 * soft[y * size + x]
            leaf = (u * 2) % 1.0
            panel_u = min(leaf - 0.16, 0.84 - leaf)
            panel_v = max(min(v - 0.07, 0.44 - v), min(v - 0.52, 0.93 - v))
            edge = min(panel_u, panel_v)
            if abs(u - 0.5) < 0.008:
                light *= 0.45
            elif 0 <= edge < 0.025:
                light *= 0.66
            elif edge >= 0.025:
                light *= 1.08
            out.append(clamp((118 * light, 74 * light, 46 * light)))
    return out
