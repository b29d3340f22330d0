"""The way to meshio, which reads and writes many formats but not VTP."""

from __future__ import annotations

from typing import TYPE_CHECKING, Union

import numpy as np

from ._core import Centerline, Surface, Vessel

if TYPE_CHECKING:
    import meshio


def to_meshio(part: Union[Vessel, Centerline, Surface]) -> meshio.Mesh:
    """A vessel, a centerline or a surface as a meshio.Mesh with its arrays (Debian:
    python3-meshio).

    Its write() knows VTU, XDMF, PLY, STL and many more. A mesh with triangles goes into a Scene as
    ``surface``. ModuleNotFoundError without meshio.

    >>> mesh = vasorod.to_meshio(result.vessels["tube"])
    >>> mesh.write(os.path.join(tempfile.mkdtemp(), "tube.vtu"))
    >>> line = vasorod.to_meshio(result.vessels["tube"].centerline)
    >>> line.cells_dict["line"].shape == (len(line.points) - 1, 2)
    True
    """
    import meshio

    if isinstance(part, Centerline):
        pairs = [np.column_stack([line[:-1], line[1:]]) for line in part.lines]
        return meshio.Mesh(
            part.points, [("line", np.concatenate(pairs))], point_data=part.point_arrays
        )
    return meshio.Mesh(
        part.points,
        [("triangle", part.triangles)],
        point_data=part.point_arrays,
        cell_data={name: [values] for name, values in part.cell_arrays.items()},
    )
