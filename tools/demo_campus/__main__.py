"""Command line: writes the models, the textures and the campus description."""

import argparse
import os
import sys

from .campus_yaml import write_campus_yaml
from .gltf import drawn_triangles, write_glb
from .layout import CELL
from .site import build
from .textures import write_textures


def main(arguments=None):
    """Entry point; returns the exit code."""
    parser = argparse.ArgumentParser(prog="make-demo-campus", description=__doc__)
    parser.add_argument("--root", default=os.path.join(os.path.dirname(__file__), "..", ".."),
                        help="folder that gets campus_assets/ and config/ (default: the repository)")
    parser.add_argument("--no-textures", action="store_true", help="models and YAML only")
    options = parser.parse_args(arguments)
    folder = os.path.join(options.root, "campus_assets", "demo")
    os.makedirs(folder, exist_ok=True)
    os.makedirs(os.path.join(options.root, "config"), exist_ok=True)
    campus, total = build(), 0
    for name, nodes in campus.scenes.items():
        write_glb(os.path.join(folder, name), nodes)
        count = drawn_triangles(nodes)
        total += count
        print("%-16s %7d triangles drawn, %4d root nodes" % (name, count, len(nodes)))
    print("%-16s %7d triangles drawn (terrain cells of %g m)" % ("total", total, CELL))
    write_campus_yaml(os.path.join(options.root, "config", "demo.campus.yaml"), campus)
    if not options.no_textures:
        write_textures(os.path.join(folder, "textures"))
    return 0


if __name__ == "__main__":
    sys.exit(main())
