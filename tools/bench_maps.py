#!/usr/bin/env python3
"""Measures imports of maps, and exits with 1 if they cost more than they may: tools/bench maps MAP.osm…

Each map by itself: its time against that of GEOS in it, at most 3 times as long. The first one repeated five by five: at
most 27 times the time and 25 times the memory. Of several runs the least counts. Needs only the standard library.
"""

import argparse
import json
import os
import subprocess
import sys
import tempfile
import xml.etree.ElementTree
from xml.sax.saxutils import quoteattr

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
MOST_OF_GEOS = 3.0
GRID = 5
MOST_TIME, MOST_MEMORY = 27.0, 25.0
APART = 10**11  # between the numbers of elements in copies


def tags(element):
    return "".join("<tag k=%s v=%s/>" % (quoteattr(t.get("k")), quoteattr(t.get("v"))) for t in element.findall("tag"))


def repeated(source, count, target):
    """Writes a map of count by count copies of what is wholly inside of a map's bounds, side by side."""
    root = xml.etree.ElementTree.parse(source).getroot()
    south, west, north, east = (float(root.find("bounds").get(key)) for key in ("minlat", "minlon", "maxlat", "maxlon"))
    nodes = {n.get("id"): n for n in root.iter("node")
             if n.get("lat") and south <= float(n.get("lat")) <= north and west <= float(n.get("lon")) <= east}
    ways = {w.get("id"): w for w in root.iter("way") if all(r.get("ref") in nodes for r in w.findall("nd"))}
    relations = [r for r in root.iter("relation")
                 if all(m.get("type") == "way" and m.get("ref") in ways for m in r.findall("member"))]
    with open(target, "w", encoding="utf-8") as file:
        file.write('<osm version="0.6"><bounds minlat="%.7f" minlon="%.7f" maxlat="%.7f" maxlon="%.7f"/>\n'
                   % (south, west, south + count * (north - south), west + count * (east - west)))
        copies = [(i, j, (i * count + j) * APART) for i in range(count) for j in range(count)]
        for i, j, offset in copies:
            for number, node in nodes.items():
                file.write('<node id="%d" lat="%.7f" lon="%.7f">%s</node>\n'
                           % (int(number) + offset, float(node.get("lat")) + i * (north - south),
                              float(node.get("lon")) + j * (east - west), tags(node)))
        for _, _, offset in copies:
            for number, way in ways.items():
                refs = "".join('<nd ref="%d"/>' % (int(r.get("ref")) + offset) for r in way.findall("nd"))
                file.write('<way id="%d">%s%s</way>\n' % (int(number) + offset, refs, tags(way)))
        for _, _, offset in copies:
            for relation in relations:
                members = "".join('<member type="way" ref="%d" role=%s/>'
                                  % (int(m.get("ref")) + offset, quoteattr(m.get("role"))) for m in relation.findall("member"))
                file.write('<relation id="%d">%s%s</relation>\n' % (int(relation.get("id")) + offset, members, tags(relation)))
        file.write("</osm>\n")


def least(program, file, runs):
    """The least of each figure over some runs."""
    results = [json.loads(subprocess.run([program, file], check=True, capture_output=True, text=True).stdout) for _ in range(runs)]
    return {key: min(result[key] for result in results) for key in results[0]}


def main():
    """Prints a line a map, and the verdicts."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("maps", nargs="+")
    parser.add_argument("--program", default=os.path.join(ROOT, "build", "release", "map-bench"))
    parser.add_argument("--runs", type=int, default=7)
    options = parser.parse_args()
    good = True
    line = "%-24s %8d kB %9d triangles %8.2f s CPU %8.2f s in GEOS %6.2f times %8.0f MB"
    with tempfile.TemporaryDirectory() as folder:
        one, many = (os.path.join(folder, "%dx%d.osm" % (n, n)) for n in (1, GRID))
        repeated(options.maps[0], 1, one)
        repeated(options.maps[0], GRID, many)
        figures = {}
        for file in options.maps + [one, many]:
            result = figures[file] = least(options.program, file, options.runs if file != many else 3)
            print(line % (os.path.basename(file), os.path.getsize(file) / 1000, result["triangles"], result["cpu"],
                          result["geos"], result["cpu"] / result["geos"], result["megabytes"]))
            good = good and (file in (one, many) or result["cpu"] <= MOST_OF_GEOS * result["geos"])
        time, memory = (figures[many][key] / figures[one][key] for key in ("cpu", "megabytes"))
        print("%d times the area: %.1f times the time (at most %g), %.1f times the memory (at most %g)"
              % (GRID * GRID, time, MOST_TIME, memory, MOST_MEMORY))
        good = good and time <= MOST_TIME and memory <= MOST_MEMORY
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
