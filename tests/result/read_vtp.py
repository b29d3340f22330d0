"""Reads a VTP file (appended raw, zlib) by the format's description alone, without VTK: prints one
line per array with its section, name, type, components, tuples, first and last value."""
import struct
import sys
import zlib
import xml.etree.ElementTree as xml

FORMATS = {"Float64": "d", "Float32": "f", "Int32": "i", "Int64": "q", "UInt8": "B"}

data = open(sys.argv[1], "rb").read()
start = data.index(b"<AppendedData")
first = data.index(b"_", start) + 1
head = xml.fromstring(data[:start] + b"</VTKFile>")
header = {"UInt32": "I", "UInt64": "Q"}[head.get("header_type", "UInt32")]


def block(offset):
    size = struct.calcsize(header)
    at = first + offset
    count, _, _ = struct.unpack_from("<3" + header, data, at)
    sizes = struct.unpack_from(f"<{count}{header}", data, at + 3 * size)
    at += (3 + count) * size
    parts = []
    for length in sizes:
        parts.append(zlib.decompress(data[at : at + length]))
        at += length
    return b"".join(parts)


for section in head.find("PolyData").find("Piece"):
    for array in section:
        raw = block(int(array.get("offset")))
        code = FORMATS[array.get("type")]
        values = struct.unpack(f"<{len(raw) // struct.calcsize(code)}{code}", raw)
        if values:
            components = int(array.get("NumberOfComponents", "1"))
            print(
                section.tag,
                array.get("Name"),
                array.get("type"),
                components,
                len(values) // components,
                repr(values[0]),
                repr(values[-1]),
            )
