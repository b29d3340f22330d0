"""tube.py and convert.py against closed forms: volumes and areas (Pappus), tags, orientation, and
what a conversion must not change.
Usage: tube_and_convert.py MESHES_FOLDER."""

import math
import subprocess
import sys
import tempfile
from pathlib import Path

import meshio
import numpy as np

MESHES = Path(sys.argv[1])
sys.path.insert(0, str(MESHES))
from vtp import read_vtp  # noqa: E402


def run(script, *words):
    return subprocess.run(
        [sys.executable, str(MESHES / script), *map(str, words)], capture_output=True, text=True
    )


def must(script, *words):
    done = run(script, *words)
    assert done.returncode == 0, f"{script} {words}: {done.stderr}"


def enclosed(points, triangles):
    p = points[triangles]
    return np.sum(p[:, 0] * np.cross(p[:, 1], p[:, 2])) / 6


def area(points, triangles):
    p = points[triangles]
    return np.linalg.norm(np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), axis=1).sum() / 2


with tempfile.TemporaryDirectory() as scratch:
    scratch = Path(scratch)
    shape = ["--length", 100, "--radius", 10, "--end-radius", 6, "--bend-deg", 90]
    # A bent wall's volume is 2 pi times the integral of R t along the centerline, its section's
    # centroid lying on that (Pappus).
    wall = ["--thickness", 2, "--end-thickness", 1, "--layers", 2, "--around", 64, "--along", 80]
    s = (np.arange(20000) + 0.5) / 20000
    volume = 2 * math.pi * 100 * np.mean((10 - 4 * s) * (2 - s))
    for version in ([], ["--msh2"]):
        must("tube.py", scratch / "wall.msh", *shape, *wall, *version)
        mesh = meshio.read(scratch / "wall.msh")
        assert len(mesh.cells_dict["hexahedron"]) == 64 * 80 * 2
        tags = mesh.cell_data_dict["gmsh:physical"]
        assert set(tags["hexahedron"]) == {10} and {
            t: int(np.sum(tags["quad"] == t)) for t in (1, 2, 3, 4)
        } == {1: 128, 2: 128, 3: 5120, 4: 5120}
        must("convert.py", scratch / "wall.msh", scratch / "wall.vtp")
        points, triangles = read_vtp(scratch / "wall.vtp")
        assert abs(enclosed(points, triangles) / volume - 1) < 3e-3, (
            enclosed(points, triangles) / volume
        )
    # The mid-wall surface, as quadrilaterals and as triangles: area 2 pi int R (1 + slope^2)^(1/2)
    # on the straight tube.
    straight = ["--length", 50, "--radius", 5, "--end-radius", 3, "--around", 60]
    exact = math.pi * (5 + 3) * math.hypot(50, 2)
    must("tube.py", scratch / "quad.msh", "--cells", "quad", *straight)
    must("convert.py", scratch / "quad.msh", scratch / "quad.stl")
    must(
        "convert.py", scratch / "quad.stl", scratch / "quad.vtp", "--scale", 2
    )  # STL keeps float32 corners, not points
    points, triangles = read_vtp(scratch / "quad.vtp")
    assert len(points) == 60 * 17 and len(triangles) == 60 * 16 * 2
    assert abs(area(points, triangles) / (4 * exact) - 1) < 3e-3
    must("tube.py", scratch / "triangle.vtp", "--cells", "triangle", *straight)
    points, triangles = read_vtp(scratch / "triangle.vtp")
    assert abs(area(points, triangles) / exact - 1) < 3e-3
    center, normal = points[triangles].mean(axis=1), np.cross(
        *(points[triangles[:, k]] - points[triangles[:, 0]] for k in (1, 2))
    )
    assert np.all(np.sum(center[:, :2] * normal[:, :2], axis=1) > 0), "triangles must face outwards"
    # Bad input ends with a sentence, not a mesh.
    for words, said in (
        (["--thickness", 25], "does not fit"),
        (["--thickness", 1, "--around", 6], "multiple of 4"),
        (["--cells", "quad"], ".vtp with --cells triangle"),
    ):
        out = scratch / ("no.vtp" if "quad" in words else "no.msh")
        done = run("tube.py", out, "--length", 10, "--radius", 5, *words)
        assert done.returncode == 2 and said in done.stderr and not out.exists(), done.stderr
