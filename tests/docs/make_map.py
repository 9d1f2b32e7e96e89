#!/usr/bin/env python3
"""Writes the map of docs/how-to/openstreetmap.md: a library with a main entrance, a path to it and a road, in OSM XML."""

import sys

# Degrees so small that a metre is the same in both directions: at the equator.
METRES = 111000.0
NODES = {1: (0, 0, ""), 2: (24, 0, ""), 3: (24, 14, ""), 4: (0, 14, ""), 5: (12, 0, '<tag k="entrance" v="main"/>'), 6: (12, -30, ""),
         7: (-60, -30, ""), 8: (60, -30, "")}
WAYS = {10: ((1, 5, 2, 3, 4, 1), {"building": "university", "name": "Library", "building:levels": "3", "opening_hours": "Mo-Fr 08:00-20:00"}),
        11: ((5, 6), {"highway": "footway"}),
        12: ((7, 6, 8), {"highway": "residential", "sidewalk": "both"})}


def main():
    """Writes the file."""
    lines = ['<osm version="0.6">', '<bounds minlat="-0.0006" minlon="-0.0006" maxlat="0.0006" maxlon="0.0006"/>']
    for number, (x, y, tags) in NODES.items():
        lines.append('<node id="%d" lat="%.7f" lon="%.7f">%s</node>' % (number, y / METRES, x / METRES, tags))
    for number, (nodes, tags) in WAYS.items():
        lines.append('<way id="%d">' % number + "".join('<nd ref="%d"/>' % node for node in nodes)
                     + "".join('<tag k="%s" v="%s"/>' % pair for pair in tags.items()) + "</way>")
    with open(sys.argv[1], "w", encoding="utf-8") as file:
        file.write("\n".join(lines + ["</osm>"]) + "\n")


if __name__ == "__main__":
    main()
