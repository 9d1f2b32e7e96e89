"""Finds faces of different materials that lie in one plane and overlap: they would flicker."""

import os
import sys
from math import sqrt

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "tools"))

from demo_campus.polygon import clip, facing_up, signed_area   # noqa: E402

PLANE_STEP = 0.005      # metres; faces closer than this are in one plane
NORMAL_STEP = 0.002
MIN_OVERLAP = 0.05      # square metres; less is a hidden corner
ROUGH = ("leaves_", "blossom", "needles", "bark", "hedge")   # grown things may touch as they like


def _rotate(q, p):
    """A vector turned by a quaternion about +Y (x and z of the quaternion are zero)."""
    sin, cos = 2.0 * q[1] * q[3], 1.0 - 2.0 * q[1] * q[1]
    return p[0] * cos + p[2] * sin, p[1], p[2] * cos - p[0] * sin


def _plane(triangle):
    """(normal, distance) in rounded steps, or None for a sliver."""
    a, b, c = triangle
    u, v = [q - p for p, q in zip(a, b)], [q - p for p, q in zip(a, c)]
    n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
    length = sqrt(sum(k * k for k in n))
    if length < 2e-4:
        return None
    n = [k / length for k in n]
    return (tuple(round(k / NORMAL_STEP) for k in n),
            round(sum(p * q for p, q in zip(n, a)) / PLANE_STEP))


def world_faces(glb):
    """(triangle, material name, node name) of every hard face, in world coordinates."""
    nodes, out = glb.json["nodes"], []

    def visit(index, parents):
        node = nodes[index]
        chain = parents + [node]
        if "mesh" in node:
            for material, triangles in glb.mesh_triangles(node["mesh"]):
                if material.startswith(ROUGH):
                    continue
                for triangle in triangles:
                    for link in reversed(chain):
                        scale = link.get("scale", [1.0])[0]
                        turn, move = link.get("rotation"), link.get("translation", (0.0, 0.0, 0.0))
                        triangle = [[k * scale for k in p] for p in triangle]
                        if turn:
                            triangle = [_rotate(turn, p) for p in triangle]
                        triangle = [[a + b for a, b in zip(p, move)] for p in triangle]
                    out.append((triangle, material, node["name"]))
        for child in node.get("children", ()):
            visit(child, chain)
    for root in glb.json["scenes"][0]["nodes"]:
        visit(root, [])
    return out


def overlaps(faces):
    """{((node, material), (node, material)): square metres} of flickering pairs."""
    planes, found = {}, {}
    for triangle, material, node in faces:
        plane = _plane(triangle)
        if plane:
            planes.setdefault(plane, []).append((triangle, (node, material)))
    for (normal, _), members in planes.items():
        if len({owner[1] for _, owner in members}) < 2:
            continue
        drop = max(range(3), key=lambda k, n=normal: abs(n[k]))
        keep = [k for k in range(3) if k != drop]
        flat = []
        for triangle, owner in members:
            poly = facing_up([(p[keep[0]], p[keep[1]]) for p in triangle])
            flat.append((min(p[0] for p in poly), max(p[0] for p in poly), poly, owner))
        flat.sort(key=lambda entry: entry[0])
        for i, (_, right, poly, owner) in enumerate(flat):
            for left, _, other, rival in flat[i + 1:]:
                if left >= right:
                    break
                if owner[1] != rival[1]:
                    shared = clip(poly, other)
                    if shared:
                        key = tuple(sorted((owner, rival)))
                        found[key] = found.get(key, 0.0) + signed_area(shared)
    return {key: area for key, area in found.items() if area > MIN_OVERLAP}
