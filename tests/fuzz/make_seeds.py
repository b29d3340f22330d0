"""Writes seeds/{vtp,ply,stl,obj}: one small tube in every encoding the readers know; and
seeds/mask: one small mask likewise.

    python3 tests/fuzz/make_seeds.py

The seeds are in the tree; this says how they were made."""

import base64
import gzip
import lzma
import math
import pathlib
import struct
import zlib

AROUND, ALONG, RADIUS, LENGTH = 6, 2, 5.0, 12.0
SEEDS = pathlib.Path(__file__).parent / "seeds"


def tube():
    """Points row by row from z = 0, each second row turned by half an edge; triangles outward."""
    points = [
        (
            RADIUS * math.cos(2 * math.pi * (i + 0.5 * (j % 2)) / AROUND),
            RADIUS * math.sin(2 * math.pi * (i + 0.5 * (j % 2)) / AROUND),
            LENGTH * j / ALONG,
        )
        for j in range(ALONG + 1)
        for i in range(AROUND)
    ]
    triangles = []
    for j in range(ALONG):
        for i in range(AROUND):
            a, b = j * AROUND + i, j * AROUND + (i + 1) % AROUND
            c, d = a + AROUND, b + AROUND
            triangles += [(a, b, c), (b, d, c)] if j % 2 == 0 else [(a, b, d), (a, d, c)]
    return points, triangles


def flat(rows):
    return [value for row in rows for value in row]


def write(name, content):
    file = SEEDS / name
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_bytes(content if isinstance(content, bytes) else content.encode())


def lz4_literals(data):
    """An LZ4 block that packs nothing: one run of literals."""
    if len(data) < 15:
        return bytes([len(data) << 4]) + data
    more, rest = bytearray([0xF0]), len(data) - 15
    while rest >= 255:
        more.append(255)
        rest -= 255
    return bytes(more) + bytes([rest]) + data


def lzma_block(data):
    return lzma.compress(data, format=lzma.FORMAT_XZ, preset=0)


PACKERS = {
    "vtkZLibDataCompressor": zlib.compress,
    "vtkLZ4DataCompressor": lz4_literals,
    "vtkLZMADataCompressor": lzma_block,
}
CODES = {"Float32": "f", "Float64": "d", "Int64": "q", "Int32": "i", "UInt8": "B"}


class Vtp:
    """One encoding of a VTP file: the bytes of its arrays, inline or appended."""

    def __init__(self, format_, encoding="base64", word="I", order="<", packer=None):
        self.format, self.encoding, self.word, self.order = format_, encoding, word, order
        self.packer, self.appended = packer, b""

    def encoded(self, parts):
        if self.encoding == "raw":
            return b"".join(parts)
        return b"".join(base64.b64encode(part) for part in parts)

    def bytes_of(self, kind, values):
        data = struct.pack(f"{self.order}{len(values)}{CODES[kind]}", *values)
        if not self.packer:
            head = struct.pack(self.order + self.word, len(data))
            return self.encoded([head + data])
        packed = PACKERS[self.packer](data)
        head = struct.pack(f"{self.order}4{self.word}", 1, len(data), 0, len(packed))
        return self.encoded([head, packed])

    def array(self, name, kind, values, components=1):
        tag = f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{components}"'
        if self.format == "ascii":
            return f'{tag} format="ascii">{" ".join(f"{v:g}" for v in values)}</DataArray>\n'
        data = self.bytes_of(kind, values)
        if self.format == "binary":
            return f'{tag} format="binary">{data.decode()}</DataArray>\n'
        offset, self.appended = len(self.appended), self.appended + data
        return f'{tag} format="appended" offset="{offset}"/>\n'

    def cells(self, kind, cells):
        ends = [sum(map(len, cells[: k + 1])) for k in range(len(cells))]
        return (
            f"<{kind}>\n"
            + self.array("connectivity", "Int64", flat(cells))
            + self.array("offsets", "Int32", ends)
            + f"</{kind}>\n"
        )

    def text(self, points, polygons, strips=(), lines=()):
        order = "LittleEndian" if self.order == "<" else "BigEndian"
        header = "UInt64" if self.word == "Q" else "UInt32"
        compressor = f' compressor="{self.packer}"' if self.packer else ""
        count = len(polygons) + len(strips) + len(lines)
        out = (
            f'<?xml version="1.0"?>\n<VTKFile type="PolyData" version="1.0" byte_order="{order}"'
            f' header_type="{header}"{compressor}>\n<PolyData>\n'
            f'<Piece NumberOfPoints="{len(points)}" NumberOfVerts="0" NumberOfLines="{len(lines)}"'
            f' NumberOfStrips="{len(strips)}" NumberOfPolys="{len(polygons)}">\n'
            f'<PointData>\n{self.array("T", "Float32", range(len(points)))}</PointData>\n'
            f'<CellData>\n{self.array("ModelFaceID", "UInt8", [k % 3 for k in range(count)])}'
            f"</CellData>\n<Points>\n"
            + self.array("Points", "Float64", flat(points), 3)
            + "</Points>\n"
        )
        if lines:
            out += self.cells("Lines", lines)
        if strips:
            out += self.cells("Strips", strips)
        out += self.cells("Polys", polygons) + "</Piece>\n</PolyData>\n"
        if self.format != "appended":
            return (out + "</VTKFile>\n").encode()
        out += f'<AppendedData encoding="{self.encoding}">\n_'
        return out.encode() + self.appended + b"\n</AppendedData>\n</VTKFile>\n"


def vtp_seeds(points, triangles):
    write("vtp/ascii.vtp", Vtp("ascii").text(points, triangles))
    write("vtp/inline.vtp", Vtp("binary").text(points, triangles))
    write("vtp/inline_big_endian.vtp", Vtp("binary", word="Q", order=">").text(points, triangles))
    write("vtp/appended_base64.vtp", Vtp("appended").text(points, triangles))
    write("vtp/appended_raw.vtp", Vtp("appended", "raw", "Q").text(points, triangles))
    for name in PACKERS:
        short = name[3:].replace("DataCompressor", "").lower()
        write(f"vtp/{short}.vtp", Vtp("appended", "raw", packer=name).text(points, triangles))
    write("vtp/zlib_inline.vtp", Vtp("binary", packer="vtkZLibDataCompressor").text(*tube()))
    strip = [v for i in range(AROUND + 1) for v in (i % AROUND + AROUND, i % AROUND)]
    lid = list(range(AROUND - 1, -1, -1))
    upper = triangles[2 * AROUND :]
    write("vtp/strip_line_lid.vtp", Vtp("ascii").text(points, upper + [lid], [strip], [[0, 6]]))


def ply_seeds(points, triangles):
    head = (
        "ply\nformat {}\ncomment a tube\nelement vertex {}\nproperty {} x\nproperty {} y\n"
        "property {} z\nproperty uchar red\nelement face {}\n"
        "property list uchar int vertex_indices\nproperty int ModelFaceID\nend_header\n"
    )
    text = head.format("ascii 1.0", len(points), *["double"] * 3, len(triangles))
    text += "".join(f"{x:g} {y:g} {z:g} 7\n" for x, y, z in points)
    write("ply/ascii.ply", text + "".join(f"3 {a} {b} {c} 1\n" for a, b, c in triangles))
    for order, name in (("<", "little"), (">", "big")):
        text = head.format(f"binary_{name}_endian 1.0", len(points), *["float"] * 3, len(triangles))
        data = b"".join(struct.pack(order + "3fB", *p, 7) for p in points)
        data += b"".join(struct.pack(order + "B4i", 3, *t, 1) for t in triangles)
        write(f"ply/binary_{name}.ply", text.encode() + data)


def stl_seeds(points, triangles):
    text = "solid tube\n"
    data = b"tube".ljust(80) + struct.pack("<I", len(triangles))
    for t in triangles:
        corners = [points[k] for k in t]
        text += " facet normal 0 0 0\n  outer loop\n"
        text += "".join(f"   vertex {x:g} {y:g} {z:g}\n" for x, y, z in corners)
        text += "  endloop\n endfacet\n"
        data += struct.pack("<12fH", 0, 0, 0, *flat(corners), 0)
    write("stl/ascii.stl", text + "endsolid tube\n")
    write("stl/binary.stl", data)


def obj_seeds(points, triangles):
    corners = "".join(f"v {x:g} {y:g} {z:g}\n" for x, y, z in points)
    faces = "".join(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in triangles)
    write("obj/plain.obj", "# a tube\no tube\n" + corners + faces)
    count = len(points)
    faces = "".join(f"f {a + 1}/1/1 {b - count}//1 \\\n {c + 1}/1\n" for a, b, c in triangles)
    write("obj/normals.obj", "vn 0 0 1\nvt 0 0\nusemtl m\n" + corners + faces + "l 1 2\np 3\n")


SIZE, SPACING, ORIGIN = (3, 4, 5), (1.0, 0.8, 2.0), (10.0, 20.0, 30.0)
# The mask: 1 in the six voxels that do not lie on the border.
VOXELS = [
    int(all(0 < index < side - 1 for index, side in zip((i, j, k), SIZE)))
    for k in range(SIZE[2])
    for j in range(SIZE[1])
    for i in range(SIZE[0])
]


def voxels(code, order="<"):
    return struct.pack(f"{order}{len(VOXELS)}{code}", *VOXELS)


def nifti(kind, code, order="<", quaternion=False):
    """`kind`: NIfTI's number of the voxels' type."""
    head = bytearray(352)

    def put(at, codes, *values):
        struct.pack_into(order + codes, head, at, *values)

    put(0, "i", 348)
    put(40, "4h", 3, *SIZE)
    put(70, "2h", kind, 8 * struct.calcsize("<" + code))
    put(76, "4f", -1 if quaternion else 1, *SPACING)
    put(108, "2f", 352, 1)
    head[123] = 2
    put(252, "2h", int(quaternion), int(not quaternion))
    put(256, "6f", 0, 1, 0, *ORIGIN)
    for row in range(3):
        put(280 + 16 * row, "4f", *[SPACING[row] * (row == k) for k in range(3)], ORIGIN[row])
    head[344:347] = b"n+1"
    return bytes(head) + voxels(code, order)


def nrrd(kind, encoding, more=""):
    columns = [tuple(SPACING[row] * (row == k) for row in range(3)) for k in range(3)]
    *steps, origin = [f"({','.join(f'{x:g}' for x in p)})" for p in (*columns, ORIGIN)]
    return (
        f"NRRD0004\n# a mask\ntype: {kind}\ndimension: 3\nspace: left-posterior-superior\n"
        f"sizes: {' '.join(map(str, SIZE))}\nspace directions: {' '.join(steps)}\n"
        f"kinds: domain domain domain\nencoding: {encoding}\nspace origin: {origin}\n"
        f'space units: "mm" "mm" "mm"\nname:=mask\n{more}\n'
    ).encode()


def metaimage(kind, more="", data="LOCAL"):
    return (
        f"ObjectType = Image\nNDims = 3\n{more}TransformMatrix = 1 0 0 0 1 0 0 0 1\n"
        f"Offset = {' '.join(f'{x:g}' for x in ORIGIN)}\n"
        f"ElementSpacing = {' '.join(f'{x:g}' for x in SPACING)}\n"
        f"DimSize = {' '.join(map(str, SIZE))}\nElementType = {kind}\nElementDataFile = {data}\n"
    ).encode()


def mask_seeds():
    text = " ".join(map(str, VOXELS)).encode() + b"\n"
    write("mask/plain.nii", nifti(2, "B"))
    write("mask/real.nii", nifti(16, "f"))
    write("mask/big_endian.nii", nifti(4, "h", ">", quaternion=True))
    write("mask/packed.nii.gz", gzip.compress(nifti(512, "H", quaternion=True), mtime=0))
    write("mask/plain.nrrd", nrrd("uchar", "raw") + voxels("B"))
    write("mask/text.nrrd", nrrd("int", "ascii") + text)
    packed = gzip.compress(voxels("h", ">"), mtime=0)
    write("mask/packed.nrrd", nrrd("short", "gzip", "endian: big\n") + packed)
    write("mask/beside.nhdr", nrrd("uchar", "raw", "data file: voxels.raw\n"))
    write("mask/plain.mha", metaimage("MET_DOUBLE") + voxels("d"))
    write("mask/text.mha", metaimage("MET_CHAR", "BinaryData = False\n") + text)
    packed = zlib.compress(voxels("q"))
    write("mask/packed.mha", metaimage("MET_LONG_LONG", "CompressedData = True\n") + packed)
    write("mask/beside.mhd", metaimage("MET_UCHAR", data="voxels.raw"))
    write("mask/voxels.raw", voxels("B"))


if __name__ == "__main__":
    surface = tube()
    vtp_seeds(*surface)
    ply_seeds(*surface)
    stl_seeds(*surface)
    obj_seeds(*surface)
    mask_seeds()
