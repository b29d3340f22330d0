"""Triangle surfaces as VTK XML PolyData (.vtp): inline binary with zlib, the encoding VTK,
ParaView, Slicer and VMTK all read."""

import base64
import struct
import sys
import zlib

import numpy as np

_BLOCK = 1 << 15  # bytes per compressed block, VTK's own default
_TYPES = {"f8": "Float64", "f4": "Float32", "i4": "Int32", "i8": "Int64"}
_NUMPY = {name: "<" + code for code, name in _TYPES.items()}


def _data_array(name, values, components=1):
    """One <DataArray>: a header (blocks, block size, last block's size, compressed sizes) and the
    blocks, each in base64."""
    values = np.ascontiguousarray(values)
    raw = values.tobytes()
    blocks = [raw[k : k + _BLOCK] for k in range(0, len(raw), _BLOCK)]
    packed = [zlib.compress(block, 9) for block in blocks]
    last = len(blocks[-1]) % _BLOCK if blocks else 0
    header = struct.pack(f"<{3 + len(packed)}I", len(packed), _BLOCK, last, *map(len, packed))
    text = base64.b64encode(header) + base64.b64encode(b"".join(packed))
    return (
        f'<DataArray type="{_TYPES[values.dtype.str[1:]]}" Name="{name}"'
        f' NumberOfComponents="{components}" format="binary">\n{text.decode()}\n</DataArray>\n'
    )


def write_vtp(path, points, triangles):
    """points: n x 3 floats; triangles: m x 3 indices, counter-clockwise seen from outside."""
    if sys.byteorder != "little":
        raise SystemExit("write_vtp: written for little-endian machines only")
    points = np.asarray(points, dtype="<f8")
    triangles = np.asarray(triangles, dtype="<i4")
    offsets = np.arange(3, 3 * len(triangles) + 1, 3, dtype="<i4")
    with open(path, "w", encoding="ascii") as out:
        out.write(
            '<?xml version="1.0"?>\n<VTKFile type="PolyData" version="0.1"'
            ' byte_order="LittleEndian" header_type="UInt32"'
            ' compressor="vtkZLibDataCompressor">\n<PolyData>\n<Piece'
            f' NumberOfPoints="{len(points)}" NumberOfVerts="0" NumberOfLines="0"'
            f' NumberOfStrips="0" NumberOfPolys="{len(triangles)}">\n<Points>\n'
        )
        out.write(_data_array("Points", points, 3))
        out.write("</Points>\n<Polys>\n")
        out.write(_data_array("connectivity", triangles.ravel()))
        out.write(_data_array("offsets", offsets))
        out.write("</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n")


def _appended(data):
    """Reader of the arrays that VTK appends raw: element, name, type -> rows of three."""
    start = data.index(b"<AppendedData")
    body = data.index(b"_", start) + 1

    def array(element, name, dtype):
        head = data.index(f"<{element}>".encode(), 0, start)
        tag = data[data.index(f'Name="{name}"'.encode(), head) : start]
        at = body + int(tag.split(b'offset="', 1)[1].split(b'"', 1)[0])
        blocks = struct.unpack_from("<I", data, at)[0]
        sizes = struct.unpack_from(f"<{blocks}I", data, at + 12)
        at, raw = at + 12 + 4 * blocks, b""
        for size in sizes:
            raw += zlib.decompress(data[at : at + size])
            at += size
        return np.frombuffer(raw, dtype).reshape(-1, 3)

    return array("Points", "Points", "<f8"), array("Polys", "connectivity", "<i8")


def read_vtp(path):
    """Points and triangles of a compressed file: binary, as write_vtp writes it, or with VTK's raw
    appended data, as vasorod does (no other VTP: VTK reads those)."""
    with open(path, "rb") as file:
        data = file.read()
    if b"<AppendedData" in data:
        return _appended(data)
    text = data.decode("ascii")

    def array(element, name):
        name = text.index(f'Name="{name}"', text.index(f"<{element}>"))
        tag = text.rindex("<DataArray", 0, name)
        start = text.index(">", tag) + 1
        dtype = _NUMPY[text[tag:start].split('type="', 1)[1].split('"', 1)[0]]
        body = text[start : text.index("</DataArray>", start)].strip()
        blocks = struct.unpack("<I", base64.b64decode(body[:8])[:4])[0]
        chars = 4 * ((4 * (3 + blocks) + 2) // 3)  # base64 length of the header
        sizes = struct.unpack(f"<{3 + blocks}I", base64.b64decode(body[:chars]))[3:]
        packed, raw, at = base64.b64decode(body[chars:]), b"", 0
        for size in sizes:
            raw += zlib.decompress(packed[at : at + size])
            at += size
        return np.frombuffer(raw, dtype).reshape(-1, 3)

    return array("Points", "Points"), array("Polys", "connectivity")
