"""Pictures as `vasorod draw` writes them: PNG of 8 bits, RGBA, read with the standard library."""

import re
import struct
import zlib
from pathlib import Path


def read_png(path):
    """Width, height, the bytes of all rows. ValueError for what `vasorod draw` does not write."""
    data = Path(path).read_bytes()
    if data[:8] != b"\x89PNG\r\n\x1a\n":
        raise ValueError(f"{path}: no PNG")
    at, packed, head = 8, b"", None
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at : at + 8])
        body = data[at + 8 : at + 8 + size]
        if kind == b"IHDR":
            head = struct.unpack(">IIBBBBB", body)
        elif kind == b"IDAT":
            packed += body
        at += 12 + size
    if head is None or head[2:] != (8, 6, 0, 0, 0):
        raise ValueError(f"{path}: expected 8 bits, RGBA, not interlaced")
    width, height = head[:2]
    flat, stride = zlib.decompress(packed), 4 * width + 1
    rows, above = [], bytes(4 * width)
    for row in range(height):
        kind, line = flat[row * stride], flat[row * stride + 1 : (row + 1) * stride]
        if kind not in (0, 2):
            raise ValueError(f"{path}: found the filter {kind}, expected none or the row above")
        above = bytes((a + b) & 255 for a, b in zip(line, above)) if kind == 2 else line
        rows.append(above)
    return width, height, b"".join(rows)


def difference(one, other):
    """The mean difference of two pictures' bytes over 255; 1 where their sizes differ."""
    a, b = read_png(one), read_png(other)
    if a[:2] != b[:2]:
        return 1.0
    return sum(abs(x - y) for x, y in zip(a[2], b[2])) / len(a[2]) / 255


def drawn_pictures(text):
    """The pictures of a page that its blocks draw: [(name in pictures/, path from the page)]."""
    drawn = set(re.findall(r"-o pictures/([\w.-]+\.png)", text))
    shown = re.findall(r"!\[[^\]]*\]\(([^)]+\.png)\)", text)
    return [(Path(path).name, path) for path in shown if Path(path).name in drawn]
