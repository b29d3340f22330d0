"""Triangle surfaces as VTK XML PolyData (.vtp): inline binary with zlib, the encoding VTK,
ParaView, Slicer and VMTK all read."""

import base64
import struct
import sys
import zlib

import numpy as np

_BLOCK = 1 << 15  # bytes per compressed block, VTK's own default
_TYPES = {"f8": "Float64", "f4": "Float32", "i4": "Int32", "i8": "Int64"}


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


def read_vtp(path):
    """Points and triangles of a file written by write_vtp (no other VTP: VTK reads those)."""
    with open(path, encoding="ascii") as file:
        text = file.read()

    def array(name, dtype):
        start = text.index(">", text.index(f'Name="{name}"')) + 1
        body = text[start : text.index("</DataArray>", start)].strip()
        blocks = struct.unpack("<I", base64.b64decode(body[:8])[:4])[0]
        chars = 4 * ((4 * (3 + blocks) + 2) // 3)  # base64 length of the header
        sizes = struct.unpack(f"<{3 + blocks}I", base64.b64decode(body[:chars]))[3:]
        packed, raw, at = base64.b64decode(body[chars:]), b"", 0
        for size in sizes:
            raw += zlib.decompress(packed[at : at + size])
            at += size
        return np.frombuffer(raw, dtype).reshape(-1, 3)

    return array("Points", "<f8"), array("connectivity", "<i4")
