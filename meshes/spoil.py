#!/usr/bin/env python3
"""Spoils a vessel surface in the ways in which segmentations leave theirs: the corpus on which
`vasorod prepare` is tested. Needs numpy alone; the same input gives the same files."""

import argparse
import gzip
import pathlib
import struct
import zlib

import numpy as np

import vtp


def boundary_loops(triangles):
    """Loops of vertices in the direction of the boundary in its triangles."""
    sides = {(a, b) for t in triangles.tolist() for a, b in zip(t, t[1:] + t[:1])}
    following = {a: b for a, b in sides if (b, a) not in sides}
    loops = []
    while following:
        loop = [min(following)]
        while loop[-1] in following:
            loop.append(following.pop(loop[-1]))
        loops.append(loop[:-1])
    return loops


def closed(points, triangles):
    """Every end closed by a fan around its centroid."""
    points, triangles = list(points), triangles.tolist()
    for loop in boundary_loops(np.array(triangles)):
        center = len(points)
        points.append(np.mean([points[v] for v in loop], axis=0))
        triangles += [[b, a, center] for a, b in zip(loop, loop[1:] + loop[:1])]
    return np.array(points), np.array(triangles)


def normals(points, triangles):
    corner = points[triangles]
    face = np.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    vertex = np.zeros_like(points)
    for k in range(3):
        np.add.at(vertex, triangles[:, k], face)
    return vertex / np.linalg.norm(vertex, axis=1)[:, None]


def double(points, triangles, thickness):
    """The wall as a solid: outer and inner face, joined by a ring at every end."""
    inner = points - thickness * normals(points, triangles)
    n = len(points)
    rings = []
    for loop in boundary_loops(triangles):
        for a, b in zip(loop, loop[1:] + loop[:1]):
            rings += [[b, a, a + n], [b, a + n, b + n]]
    return np.vstack([points, inner]), np.vstack([triangles, triangles[:, ::-1] + n, rings])


def ball(center, radius, around=12):
    """A closed ball of triangles."""
    points, triangles = [(0, 0, 1)], []
    for i in range(1, around):
        for j in range(2 * around):
            theta, phi = np.pi * i / around, np.pi * j / around
            points.append((np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)))
    points.append((0, 0, -1))
    ring = 2 * around
    for j in range(ring):
        k = (j + 1) % ring
        triangles.append((0, 1 + j, 1 + k))
        for i in range(around - 2):
            a, b = 1 + i * ring + j, 1 + i * ring + k
            triangles += [(a, a + ring, b), (b, a + ring, b + ring)]
        last = 1 + (around - 2) * ring
        triangles.append((last + j, len(points) - 1, last + k))
    return np.array(center) + radius * np.array(points), np.array(triangles)


def voxels(points, triangles, spacing):
    """The voxels whose centres are in a closed surface (mask[x, y, z]) and the first one's centre:
    rays along z, parity of the triangles that they pass."""
    origin = points.min(axis=0) - 2.2 * spacing
    size = np.ceil((points.max(axis=0) + 2.2 * spacing - origin) / spacing).astype(int)
    mask = np.zeros(size, dtype=np.uint8)
    # A shift below any coordinate's resolution in the image keeps rays off edges and corners.
    at = (points - origin) / spacing + np.array([1.234e-7, 2.345e-7, 0])
    for a, b, c in at[triangles]:
        low = np.ceil(np.minimum(np.minimum(a, b), c)[:2]).astype(int)
        high = np.floor(np.maximum(np.maximum(a, b), c)[:2]).astype(int)
        det = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        if det == 0:
            continue
        for x in range(low[0], high[0] + 1):
            for y in range(low[1], high[1] + 1):
                u = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / det
                v = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / det
                if u >= 0 and v >= 0 and u + v <= 1:
                    z = a[2] + u * (b[2] - a[2]) + v * (c[2] - a[2])
                    mask[x, y, int(np.ceil(z)) :] ^= 1
    return mask, origin


def stairs(mask, origin, spacing):
    """The faces between voxels inside and outside, two triangles each."""
    points, triangles, number = [], [], {}

    def corner(p):
        if p not in number:
            number[p] = len(points)
            points.append(origin + spacing * (np.array(p) - 0.5))
        return number[p]

    padded = np.pad(mask, 1)
    for axis in range(3):
        for side in (0, 1):
            beside = np.roll(padded, 1 - 2 * side, axis)
            for voxel in np.argwhere((padded == 1) & (beside == 0)) - 1:
                u, v = np.eye(3, dtype=int)[(axis + 1) % 3], np.eye(3, dtype=int)[(axis + 2) % 3]
                base = voxel + side * np.eye(3, dtype=int)[axis]
                ring = [corner(tuple(p)) for p in (base, base + u, base + u + v, base + v)]
                ring = ring if side else ring[::-1]
                triangles += [ring[:3], [ring[0], ring[2], ring[3]]]
    return np.array(points), np.array(triangles)


def write_nifti(path, mask, origin, spacing):
    """RAS, mm, packed; x and y of LPS points change their sign."""
    head = bytearray(352)
    struct.pack_into("<i", head, 0, 348)
    struct.pack_into("<8h", head, 40, 3, *mask.shape, 1, 1, 1, 1)
    struct.pack_into("<hh", head, 70, 2, 8)
    struct.pack_into("<8f", head, 76, 1, spacing, spacing, spacing, 0, 0, 0, 0)
    struct.pack_into("<f", head, 108, 352)
    head[123] = 2
    struct.pack_into("<hh", head, 252, 0, 1)
    struct.pack_into("<4f", head, 280, -spacing, 0, 0, -origin[0])
    struct.pack_into("<4f", head, 296, 0, -spacing, 0, -origin[1])
    struct.pack_into("<4f", head, 312, 0, 0, spacing, origin[2])
    head[344:348] = b"n+1\0"
    path.write_bytes(gzip.compress(bytes(head) + mask.tobytes(order="F"), mtime=0))


def write_nrrd(path, mask, origin, spacing):
    """LPS, packed, the axes stored as z, y, x."""
    text = (
        "NRRD0004\ntype: uchar\ndimension: 3\nspace: left-posterior-superior\n"
        f"sizes: {mask.shape[2]} {mask.shape[1]} {mask.shape[0]}\n"
        f"space directions: (0,0,{spacing}) (0,{spacing},0) ({spacing},0,0)\n"
        "encoding: gzip\n"
        f"space origin: ({origin[0]},{origin[1]},{origin[2]})\n\n"
    )
    path.write_bytes(text.encode() + gzip.compress(mask.tobytes(order="C"), mtime=0))


def write_metaimage(path, mask, origin, spacing):
    """LPS, packed, the second axis stored backwards."""
    last = origin + spacing * np.array([0, mask.shape[1] - 1, 0])
    text = (
        "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
        "CompressedData = True\nTransformMatrix = 1 0 0 0 -1 0 0 0 1\n"
        f"Offset = {last[0]} {last[1]} {last[2]}\n"
        f"ElementSpacing = {spacing} {spacing} {spacing}\n"
        f"DimSize = {mask.shape[0]} {mask.shape[1]} {mask.shape[2]}\n"
        "ElementType = MET_USHORT\nElementDataFile = LOCAL\n"
    )
    values = mask[:, ::-1, :].astype("<u2").tobytes(order="F")
    path.write_bytes(text.encode() + zlib.compress(values))


def write_ply(path, points, triangles, space):
    with open(path, "w", encoding="ascii") as out:
        out.write(
            f"ply\nformat ascii 1.0\ncomment SPACE={space}\nelement vertex {len(points)}\n"
            "property double x\nproperty double y\nproperty double z\n"
            f"element face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n"
        )
        np.savetxt(out, points, "%.9f")
        np.savetxt(out, np.insert(triangles, 0, 3, axis=1), "%d")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("surface", type=pathlib.Path, help="a VTP file that vtp.py wrote, LPS, mm")
    parser.add_argument("folder", type=pathlib.Path, help="for the spoilt files")
    parser.add_argument("--spacing", type=float, default=0.5, help="of the masks, mm")
    parser.add_argument("--thickness", type=float, default=0.6, help="of the double wall, mm")
    options = parser.parse_args()
    try:
        points, triangles = vtp.read_vtp(options.surface)
    except (OSError, ValueError, struct.error, zlib.error):
        points = triangles = ()
    if len(triangles) == 0:
        parser.error(f"{options.surface}: found no triangles, expected a file that vtp.py wrote")
    folder = options.folder
    folder.mkdir(parents=True, exist_ok=True)
    shut, lidded = closed(points, triangles)

    vtp.write_vtp(folder / "closed.vtp", shut, lidded)
    vtp.write_vtp(folder / "inverted.vtp", points, triangles[:, ::-1])
    mixed = triangles.copy()
    mixed[::3] = mixed[::3, ::-1]
    vtp.write_vtp(folder / "mixed.vtp", points, mixed)
    vtp.write_vtp(folder / "cm.vtp", points / 10, triangles)

    island, faces = ball(points.max(axis=0) + 5, 1.5)
    vtp.write_vtp(
        folder / "islands.vtp",
        np.vstack([points, island]),
        np.vstack([triangles, faces + len(points)]),
    )
    vtp.write_vtp(folder / "double.vtp", *double(points, triangles, options.thickness))

    # Holes away from the ends: a vertex' triangles, and those around them.
    ends = points[[v for loop in boundary_loops(triangles) for v in loop]]
    away = [
        v
        for v in range(0, len(points), max(1, len(points) // 40))
        if np.linalg.norm(ends - points[v], axis=1).min() > 5 * options.spacing
    ][:3]
    gone = np.zeros(len(points), dtype=bool)
    for v in away:
        gone |= np.linalg.norm(points - points[v], axis=1) < 0.8
    vtp.write_vtp(folder / "holes.vtp", points, triangles[~gone[triangles].any(axis=1)])

    turned = points * np.array([-1, -1, 1])
    write_ply(folder / "ras.ply", turned, triangles, "RAS")

    mask, origin = voxels(shut, lidded, options.spacing)
    write_nifti(folder / "mask.nii.gz", mask, origin, options.spacing)
    write_nrrd(folder / "mask.nrrd", mask, origin, options.spacing)
    write_metaimage(folder / "mask.mha", mask, origin, options.spacing)
    vtp.write_vtp(folder / "stairs.vtp", *stairs(mask, origin, options.spacing))


if __name__ == "__main__":
    main()
