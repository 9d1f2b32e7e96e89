#!/usr/bin/env python3
"""Writes the model of docs/how-to/your-own-campus.md: ground, a library, a hall and a kiosk, as boxes in an OBJ file."""

import argparse

BOXES = (("ground", (-20, -1, -20), (20, 0, 20)), ("library", (-12, 0, -6), (-4, 4, 4)), ("hall", (4, 0, -6), (12, 4, 4)),
         ("kiosk", (-1, 0, -12), (1, 3, -10)))
FACES = ((1, 2, 4, 3), (5, 7, 8, 6), (1, 5, 6, 2), (3, 4, 8, 7), (1, 3, 7, 5), (2, 6, 8, 4))


def main():
    """Writes the file."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("file")
    parser.add_argument("--centimetres", action="store_true")
    parser.add_argument("--z-up", action="store_true")
    options = parser.parse_args()
    lines = []
    for i, (name, low, high) in enumerate(BOXES):
        lines.append("o " + name)
        for x in (low[0], high[0]):
            for y in (low[1], high[1]):
                for z in (low[2], high[2]):
                    factor = 100 if options.centimetres else 1
                    point = (x, -z, y) if options.z_up else (x, y, z)
                    lines.append("v %g %g %g" % tuple(factor * each for each in point))
        lines += ["f " + " ".join(str(8 * i + corner) for corner in face) for face in FACES]
    with open(options.file, "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
