"""PNG files with a palette, written without any imaging library."""

import struct
import zlib

COMPRESSION = 9
BIN_SHIFT = 2  # colours are gathered in 6-bit bins before the palette is chosen


def _chunk(kind, data):
    body = kind + data
    return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))


def _median_cut(bins, count):
    """Splits {colour bin: weight} into `count` boxes of similar weight; returns the boxes."""
    boxes = [sorted(bins)]
    while len(boxes) < count:
        best, best_score, best_axis = None, 0, 0
        for i, box in enumerate(boxes):
            if len(box) < 2:
                continue
            weight = sum(bins[c] for c in box)
            for axis in range(3):
                values = [c[axis] for c in box]
                score = (max(values) - min(values)) ** 2 * weight
                if score > best_score:
                    best, best_score, best_axis = i, score, axis
        if best is None:
            break
        box = sorted(boxes[best], key=lambda c: (c[best_axis], c))
        half, running, cut = sum(bins[c] for c in box) / 2, 0, 1
        for i, c in enumerate(box):
            running += bins[c]
            if running >= half:
                cut = min(max(i, 1), len(box) - 1)
                break
        boxes[best:best + 1] = [box[:cut], box[cut:]]
    return boxes


def _palette(pixels, count):
    """Palette of at most `count` colours and a map from bin to palette index."""
    bins, sums = {}, {}
    for r, g, b in pixels:
        key = (r >> BIN_SHIFT, g >> BIN_SHIFT, b >> BIN_SHIFT)
        if key in bins:
            bins[key] += 1
            total = sums[key]
            total[0] += r
            total[1] += g
            total[2] += b
        else:
            bins[key], sums[key] = 1, [r, g, b]
    colours, index = [], {}
    for box in _median_cut(bins, count):
        weight = sum(bins[c] for c in box)
        colours.append(tuple((sum(sums[c][i] for c in box) + weight // 2) // weight
                             for i in range(3)))
        for c in box:
            index[c] = len(colours) - 1
    return colours, index


def write_png(path, width, height, pixels, colours=64, opaque=None):
    """Writes (r, g, b) pixels, row by row. `opaque`: one flag a pixel; absent ones are cut out."""
    shown = pixels if opaque is None else [p for p, o in zip(pixels, opaque) if o]
    palette, index = _palette(shown, colours)
    shift = BIN_SHIFT
    if opaque is None:
        codes = bytes(index[(r >> shift, g >> shift, b >> shift)] for r, g, b in pixels)
        transparency = b""
    else:
        mean = tuple(sum(p[i] for p in shown) // len(shown) for i in range(3))
        palette = [mean] + palette  # index 0 is clear, in the mean colour: no halo when filtered
        codes = bytes(index[(p[0] >> shift, p[1] >> shift, p[2] >> shift)] + 1 if o else 0
                      for p, o in zip(pixels, opaque))
        transparency = _chunk(b"tRNS", b"\0")
    rows = b"".join(b"\0" + codes[y * width:(y + 1) * width] for y in range(height))
    flat = bytes(v for colour in palette for v in colour)
    with open(path, "wb") as out:
        out.write(b"\x89PNG\r\n\x1a\n")
        out.write(_chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 3, 0, 0, 0)))
        out.write(_chunk(b"PLTE", flat) + transparency)
        out.write(_chunk(b"IDAT", zlib.compress(rows, COMPRESSION)))
        out.write(_chunk(b"IEND", b""))
