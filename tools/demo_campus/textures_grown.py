"""Textures of ground, plants, water, signs and other things that are not laid in courses."""

from math import sqrt

from . import font
from .exact import Random, cos_deg, sin_deg
from .noise import field, grain
from .textures_built import clamp, mix, shaded


def grass(size):
    """A lawn: broad patches, tufts and blades, a little clover and straw."""
    broad = field(size, 51, [(3, 3, 3), (7, 7, 2)])
    tufts = field(size, 52, [(24, 24, 1), (56, 56, 1)])
    blades = field(size, 53, [(160, 64, 1), (256, 128, 1)])
    fine = grain(size, 54)
    out = []
    for b, t, s, f in zip(broad, tufts, blades, fine):
        colour = mix((84, 112, 48), (112, 128, 62), b * 1.4 - 0.2)
        light = 0.62 + 0.30 * t + 0.34 * s + 0.14 * f
        if f > 0.985 and t > 0.55:
            colour = (150, 148, 92)
        out.append(clamp((colour[0] * light, colour[1] * light, colour[2] * light)))
    return out


def gravel(size):
    """Small stones of mixed greys and browns."""
    out = [(112, 106, 96)] * (size * size)
    random = Random(55)
    for _ in range(size * size // 26):
        cx, cy, radius = random.below(size), random.below(size), random.between(1.5, 3.6)
        base = random.pick([(158, 150, 136), (140, 132, 120), (172, 166, 154), (128, 122, 116)])
        _disc(out, size, cx, cy, radius, lambda d, base=base: clamp(
            tuple(c * (1.06 - 0.42 * d) for c in base)))
    return out


def _disc(out, size, cx, cy, radius, colour_at):
    """Paints a disc on a tiling image; colour_at gets the relative distance from the centre."""
    reach = int(radius) + 1
    for dy in range(-reach, reach + 1):
        for dx in range(-reach, reach + 1):
            d = (dx * dx + dy * dy) / (radius * radius)
            if d <= 1.0:
                out[(cy + dy) % size * size + (cx + dx) % size] = colour_at(d)


def _leaf(out, mask, size, spot, angle, length, colour, wrap=True):
    """Paints a pointed leaf with a midrib."""
    cx, cy = spot
    c, s = cos_deg(angle), sin_deg(angle)
    reach = int(length) + 1
    for dy in range(-reach, reach + 1):
        for dx in range(-reach, reach + 1):
            along, across = (dx * c + dy * s) / length, (dy * c - dx * s) / length
            half = 0.42 * (1.0 - along * along)
            if abs(along) >= 1.0 or abs(across) > half:
                continue
            x, y = cx + dx, cy + dy
            if not wrap and not (0 <= x < size and 0 <= y < size):
                continue
            light = 1.16 if abs(across) < 0.05 else 1.0 if across > 0 else 0.86
            at = y % size * size + x % size
            out[at] = clamp(tuple(v * light for v in colour))
            if mask is not None:
                mask[at] = True


def leaves(size, seed, colours, dark):
    """Dense foliage: leaf over leaf, the upper ones lighter."""
    random = Random(seed)
    out = [dark] * (size * size)
    count = size * size // 56
    for i in range(count):
        light = 0.55 + 0.5 * i / count + random.between(-0.08, 0.08)
        colour = tuple(v * light for v in random.pick(colours))
        _leaf(out, None, size, (random.below(size), random.below(size)), random.between(0, 360),
              random.between(0.022, 0.036) * size, colour)
    return out


def leaf_card(size, seed, colours, dark):
    """A cut-out twig: leaves within a round outline, thinner towards its rim."""
    random = Random(seed)
    out, mask = [dark] * (size * size), [False] * (size * size)
    count = 330
    for i in range(count):
        angle, reach = random.between(0, 360), sqrt(random.unit()) * 0.43 * size
        spot = (int(size / 2 + reach * cos_deg(angle)), int(size / 2 + reach * sin_deg(angle)))
        light = 0.6 + 0.45 * i / count
        colour = tuple(v * light for v in random.pick(colours))
        _leaf(out, mask, size, spot, random.between(0, 360), 0.055 * size, colour, False)
    return out, mask


def needles(size):
    """Conifer twigs: short strokes pointing down."""
    random = Random(58)
    out = [(30, 44, 30)] * (size * size)
    count = size * size // 18
    for i in range(count):
        x, y, slant = random.below(size), random.below(size), random.between(-0.6, 0.6)
        light = 0.6 + 0.5 * i / count
        colour = clamp(tuple(v * light for v in random.pick([(64, 92, 58), (52, 82, 56),
                                                            (78, 100, 60)])))
        for step in range(size // 22):
            out[(y + step) % size * size + int(x + slant * step) % size] = colour
    return out


def bark(size, light, dark, seed, birch=False):
    """Furrowed bark, or white birch bark with dark marks."""
    furrows = field(size, seed, [(24, 4, 2), (48, 10, 2), (96, 40, 1)])
    out = [clamp(mix(dark, light, max(0.0, min(1.0, v * 2.2 - 0.6)))) for v in furrows]
    if birch:
        random = Random(seed)
        out = [clamp(mix((176, 170, 158), (226, 222, 212), v)) for v in furrows]
        for _ in range(46):
            x, y, length = random.below(size), random.below(size), 4 + random.below(size // 6)
            for i in range(length):
                for thick in range(1 + random.below(3)):
                    out[(y + thick) % size * size + (x + i) % size] = (58, 52, 48)
    return out


def water(size):
    """Ripples over deep green water."""
    swell = field(size, 60, [(5, 4, 2), (12, 9, 2), (30, 20, 1)])
    out = []
    for v in swell:
        t = abs(v - 0.5) * 2.0
        out.append(clamp(mix((86, 124, 128), (46, 82, 84), min(1.0, t * 1.8))))
    return out


FLOWER_KINDS = [((206, 62, 62), (240, 196, 60)), ((236, 196, 66), (170, 96, 30)),
                ((152, 92, 190), (244, 226, 120)), ((238, 226, 226), (236, 190, 60))]


def flowers(size):
    """Four cut-out clumps of flowers side by side, one kind each."""
    random = Random(61)
    out, mask = [(70, 100, 48)] * (size * size), [False] * (size * size)
    quarter = size // len(FLOWER_KINDS)
    for kind, (petal, heart) in enumerate(FLOWER_KINDS):
        left = kind * quarter
        for _ in range(26):
            x, top = left + 5 + random.below(quarter - 10), int(size * random.between(0.12, 0.55))
            for y in range(top, size):
                out[y * size + x], mask[y * size + x] = (72, 108, 50), True
        for _ in range(60):
            spot = (left + 6 + random.below(quarter - 12), int(size * random.between(0.45, 0.97)))
            _clip_leaf(out, mask, size, spot, random, left, quarter)
        for _ in range(34):
            cx, cy = left + 8 + random.below(quarter - 16), int(size * random.between(0.07, 0.6))
            _blossom(out, mask, size, (cx, cy), random.between(4.0, 6.5), petal, heart)
    return out, mask


def _clip_leaf(out, mask, size, spot, random, left, quarter):
    if left + 12 < spot[0] < left + quarter - 12:
        green = random.pick([(74, 112, 52), (90, 128, 60), (62, 98, 48)])
        _leaf(out, mask, size, spot, 90 + random.between(-50, 50), 11, green, False)


def _blossom(out, mask, size, centre, radius, petal, heart):
    reach = int(radius) + 1
    for dy in range(-reach, reach + 1):
        for dx in range(-reach, reach + 1):
            d = (dx * dx + dy * dy) / (radius * radius)
            y = centre[1] + dy
            if d <= 1.0 and 0 <= y < size:
                at = y * size + centre[0] + dx
                out[at] = heart if d < 0.12 else clamp(tuple(v * (1.08 - 0.3 * d) for v in petal))
                mask[at] = True


SIGNS = ["WELCOME TO CAMPUS", "MAIN LIBRARY", "LECTURE THEATRE", "CAFETERIA", "ADMINISTRATION",
         "SCIENCE BLOCK", "SPORTS HALL", "OBSERVATORY", "GREENHOUSE", "ART GALLERY",
         "NORTH DORM", "CLOCK TOWER", "POND & PAVILION", "GATEHOUSE", "READING ROOM", "KITCHEN"]
SIGN_COLUMNS, SIGN_ROWS = 2, 8


def sign_uv(index):
    """(u0, v0, u1, v1) of a sign in the sheet."""
    u, v = (index % SIGN_COLUMNS) / SIGN_COLUMNS, (index // SIGN_COLUMNS) / SIGN_ROWS
    return u, v, u + 1.0 / SIGN_COLUMNS, v + 1.0 / SIGN_ROWS


def signs(size):
    """Sixteen name boards, white on green, blue and brown."""
    grounds = [(30, 74, 58), (28, 60, 96), (96, 52, 38)]
    out = [(0, 0, 0)] * (size * size)
    width, height = size // SIGN_COLUMNS, size // SIGN_ROWS
    for i, text in enumerate(SIGNS):
        left, top = (i % SIGN_COLUMNS) * width, (i // SIGN_COLUMNS) * height
        ground = grounds[i % len(grounds)]
        for y in range(height):
            for x in range(width):
                frame = min(x, y, width - 1 - x, height - 1 - y)
                out[(top + y) * size + left + x] = (226, 222, 208) if 3 <= frame < 5 else ground
        scale = 3 if font.width(text, 3) < width - 24 else 2
        x0 = left + (width - font.width(text, scale)) // 2
        y0 = top + (height - font.HEIGHT * scale) // 2
        for dx, dy in font.dots(text, scale):
            out[(y0 + dy) * size + x0 + dx] = (240, 238, 228)
    return out


def books(size):
    """Four shelves of book spines."""
    random = Random(62)
    out = [(46, 34, 26)] * (size * size)
    shelf = size // 4
    colours = [(126, 44, 40), (44, 70, 104), (58, 92, 62), (150, 120, 66), (86, 60, 92),
               (172, 160, 136), (70, 72, 78), (118, 76, 48)]
    for row in range(4):
        bottom, x = (row + 1) * shelf - 7, 2
        while x < size - 3:
            thick, tall = 4 + random.below(7), int(shelf * random.between(0.60, 0.84))
            colour, light = random.pick(colours), random.between(0.8, 1.15)
            for dx in range(min(thick, size - x - 1)):
                side = 0.72 if dx in (0, thick - 1) else 1.0
                for dy in range(tall):
                    band = 1.35 if dy in (tall - 8, tall - 9, 8) else 1.0
                    out[(bottom - dy) * size + x + dx] = clamp(
                        tuple(v * light * side * band for v in colour))
            x += thick
        for y in range(bottom + 1, bottom + 8):
            out[min(y, size - 1) * size:(min(y, size - 1) + 1) * size] = [(128, 92, 58)] * size
    return out


def notices(size):
    """A cork board with paper notices."""
    random = Random(63)
    out = shaded(size, 64, (150, 112, 70), (186, 144, 96), [(64, 64, 1)], 0.8)
    for i in range(13):
        w, h = int(size * random.between(0.14, 0.24)), int(size * random.between(0.16, 0.30))
        x0 = int((i % 4) * size * 0.24 + size * 0.03 + random.below(8))
        y0 = int((i // 4) * size * 0.245 + size * 0.03 + random.below(6))
        paper = random.pick([(236, 234, 224), (240, 226, 150), (190, 216, 232), (240, 190, 176)])
        for y in range(y0, min(y0 + h, size - 3)):
            for x in range(x0, min(x0 + w, size - 3)):
                text = (y - y0) % 6 in (3, 4) and 5 < x - x0 < w - 5 and y - y0 > 5
                out[y * size + x] = (92, 92, 96) if text and (x * 7 + y // 6) % 11 > 2 else paper
    return out


def paintings(size):
    """Four abstract pictures in gilt frames, in a two by two sheet."""
    random = Random(65)
    out = [(150, 118, 62)] * (size * size)
    half = size // 2
    for i in range(4):
        left, top = (i % 2) * half, (i // 2) * half
        sky = random.pick([(196, 208, 216), (226, 196, 150), (120, 146, 170), (210, 180, 176)])
        for y in range(6, half - 6):
            for x in range(6, half - 6):
                out[(top + y) * size + left + x] = clamp(tuple(v * (0.7 + 0.4 * y / half)
                                                               for v in sky))
        for _ in range(9):
            colour = random.pick([(170, 60, 44), (40, 76, 110), (220, 170, 60), (60, 96, 66),
                                  (40, 38, 44), (232, 222, 204)])
            cx, cy = 8 + random.below(half - 16), 8 + random.below(half - 16)
            w, h = 6 + random.below(half // 3), 4 + random.below(half // 4)
            for y in range(max(8, cy - h), min(half - 8, cy + h)):
                for x in range(max(8, cx - w), min(half - 8, cx + w)):
                    if ((x - cx) / w) ** 2 + ((y - cy) / h) ** 2 < 1.0:
                        out[(top + y) * size + left + x] = colour
    return out


def clock(size):
    """A clock face that shows ten past ten."""
    out = []
    middle = (size - 1) / 2
    marks = [(sin_deg(30 * i), -cos_deg(30 * i)) for i in range(12)]
    hands = [(sin_deg(305), -cos_deg(305), 0.5, 0.045), (sin_deg(60), -cos_deg(60), 0.76, 0.03)]
    for y in range(size):
        for x in range(size):
            px, py = (x - middle) / middle, (y - middle) / middle
            radius = sqrt(px * px + py * py)
            colour = (236, 230, 212) if radius < 0.93 else (54, 48, 44)
            if radius > 0.99:
                colour = (150, 136, 112)
            for mx, my in marks:
                along, across = px * mx + py * my, abs(px * my - py * mx)
                if 0.72 < along < 0.90 and across < 0.028:
                    colour = (40, 36, 36)
            for hx, hy, reach, thick in hands:
                along, across = px * hx + py * hy, abs(px * hy - py * hx)
                if -0.12 < along < reach and across < thick:
                    colour = (30, 28, 30)
            out.append(colour)
    return out
