"""Writes OpenStreetMap's PBF (wiki.openstreetmap.org/wiki/PBF_Format) from XML: as plain as the format allows."""

import struct
import sys
import xml.etree.ElementTree
import zlib


def varint(value):
    """An unsigned number, seven bits a byte."""
    out = bytearray()
    while value > 0x7F:
        out.append(value & 0x7F | 0x80)
        value >>= 7
    return bytes(out + bytes([value]))


def zigzag(value):
    """A signed number as an unsigned one."""
    return 2 * value if value >= 0 else -2 * value - 1


def number(key, value):
    """A field with a number."""
    return varint(key << 3) + varint(value)


def field(key, data):
    """A field with bytes."""
    return varint(key << 3 | 2) + varint(len(data)) + data


def packed(key, values):
    """A field with a list of numbers."""
    return field(key, b"".join(varint(v) for v in values)) if values else b""


def blob(kind, data):
    """A file block, compressed."""
    body = number(2, len(data)) + field(3, zlib.compress(data))
    header = field(1, kind) + number(3, len(body))
    return struct.pack(">I", len(header)) + header + body


def deltas(values):
    """Differences from one to the next."""
    return [zigzag(b - a) for a, b in zip([0] + values, values)]


def pbf_of(xml_text):
    """The same map."""
    root = xml.etree.ElementTree.fromstring(xml_text)
    strings = [b""]

    def index(text):
        data = text.encode("utf-8")
        if data not in strings:
            strings.append(data)
        return strings.index(data)

    def tags(element):
        pairs = [(index(t.get("k")), index(t.get("v"))) for t in element.findall("tag")]
        return packed(2, [k for k, _ in pairs]) + packed(3, [v for _, v in pairs])

    nodes = b"".join(field(1, number(1, zigzag(int(n.get("id")))) + tags(n) +
                           number(8, zigzag(round(float(n.get("lat")) * 1e7))) +
                           number(9, zigzag(round(float(n.get("lon")) * 1e7)))) for n in root.findall("node"))
    ways = b"".join(field(3, number(1, int(w.get("id"))) + tags(w) +
                          packed(8, deltas([int(n.get("ref")) for n in w.findall("nd")]))) for w in root.findall("way"))
    kinds = {"node": 0, "way": 1, "relation": 2}
    relations = b"".join(field(4, number(1, int(r.get("id"))) + tags(r) +
                               packed(8, [index(m.get("role")) for m in r.findall("member")]) +
                               packed(9, deltas([int(m.get("ref")) for m in r.findall("member")])) +
                               packed(10, [kinds[m.get("type")] for m in r.findall("member")]))
                         for r in root.findall("relation"))
    groups = b"".join(field(2, group) for group in (nodes, ways, relations) if group)
    header = field(4, b"OsmSchema-V0.6")
    bounds = root.find("bounds")
    if bounds is not None:
        edges = [zigzag(round(float(bounds.get(k)) * 1e9)) for k in ("minlon", "maxlon", "maxlat", "minlat")]
        header = field(1, b"".join(number(i + 1, edge) for i, edge in enumerate(edges))) + header
    return blob(b"OSMHeader", header) + blob(b"OSMData", field(1, b"".join(field(1, s) for s in strings)) + groups)


if __name__ == "__main__":
    with open(sys.argv[1], "rb") as source, open(sys.argv[2], "wb") as target:
        target.write(pbf_of(source.read()))
