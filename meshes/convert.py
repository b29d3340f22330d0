#!/usr/bin/env python3
"""A triangle surface from any format meshio reads (VTU, VTK, STL, PLY, OBJ, MSH, INP, ...) to VTP,
or to any format meshio writes.

Quadrilaterals are split, volume meshes give their boundary, points of equal coordinates are merged
and unused points left out.
Usage: convert.py IN OUT [--scale FACTOR] [--flip]. Needs meshio, numpy.
"""

import argparse

import meshio
import numpy as np

from vtp import write_vtp

# Faces of the volume cells (VTK's corner order), outward; triangles and quadrilaterals.
FACES = {
    "tetra": [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)],
    "hexahedron": [
        (0, 3, 2, 1),
        (4, 5, 6, 7),
        (0, 1, 5, 4),
        (1, 2, 6, 5),
        (2, 3, 7, 6),
        (3, 0, 4, 7),
    ],
    "wedge": [(0, 1, 2), (3, 5, 4), (0, 3, 4, 1), (1, 4, 5, 2), (2, 5, 3, 0)],
}


def split(polygons):
    """Triangles of triangles or quadrilaterals."""
    polygons = np.asarray(polygons)
    return (
        polygons
        if polygons.shape[1] == 3
        else np.vstack([polygons[:, [0, 1, 2]], polygons[:, [0, 2, 3]]])
    )


def boundary(cells, faces):
    """Faces that only one cell has."""
    result = []
    for corners in {len(face) for face in faces}:
        every = np.vstack([cells[:, face] for face in faces if len(face) == corners])
        _, index, count = np.unique(
            np.sort(every, axis=1), axis=0, return_index=True, return_counts=True
        )
        result.append(split(every[np.sort(index[count == 1])]))
    return result


def triangles_of(mesh):
    """The mesh's surface: its volume cells' boundary if it has any, else its triangles and
    quadrilaterals."""
    solid = [
        t
        for block in mesh.cells
        if block.type in FACES
        for t in boundary(block.data, FACES[block.type])
    ]
    plane = [split(block.data) for block in mesh.cells if block.type in ("triangle", "quad")]
    if len({block.type for block in mesh.cells if block.type in FACES}) > 1:
        raise SystemExit("convert: volume cells of one type only")
    if not solid and not plane:
        raise SystemExit(
            "convert: no triangle, quadrilateral, tetrahedron, hexahedron or wedge found"
        )
    return np.vstack(solid or plane)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("input")
    parser.add_argument("output")
    parser.add_argument(
        "--scale", type=float, default=1, help="factor on all coordinates, e.g. 1000 from m to mm"
    )
    parser.add_argument("--flip", action="store_true", help="turn the triangles over")
    given = parser.parse_args()
    mesh = meshio.read(given.input)
    triangles = triangles_of(mesh)
    points = np.zeros((len(mesh.points), 3))
    points[:, : mesh.points.shape[1]] = mesh.points
    _, first, same = np.unique(points, axis=0, return_index=True, return_inverse=True)
    triangles = first[same.ravel()][triangles]  # equal points: the lowest index
    triangles = triangles[[len(set(t)) == 3 for t in triangles]]
    used, triangles = np.unique(triangles, return_inverse=True)
    points, triangles = given.scale * points[used], triangles.reshape(-1, 3)
    if given.flip:
        triangles = triangles[:, ::-1]
    if given.output.endswith(".vtp"):
        write_vtp(given.output, points, triangles)
    else:
        meshio.Mesh(points, [("triangle", triangles.astype(np.int32))]).write(given.output)
    print(f"{given.output}: {len(points)} points, {len(triangles)} triangles")


if __name__ == "__main__":
    main()
