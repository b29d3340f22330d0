"""The generator still gives the committed infant anatomy: vertex counts within 1 % (gmsh's mesher
may differ between versions), and every committed point on the surface that the generator describes.
Usage: regenerates.py MESHES_FOLDER."""

import subprocess
import sys
import tempfile
from pathlib import Path

meshes = Path(sys.argv[1])
sys.path.insert(0, str(meshes))
from infant_anatomy import PARTS  # noqa: E402
from blended_surface import blend  # noqa: E402
from vtp import read_vtp  # noqa: E402

with tempfile.TemporaryDirectory() as scratch:
    subprocess.run([sys.executable, str(meshes / "infant_anatomy.py"), scratch], check=True)
    for name, bodies, edge, width, start in PARTS:
        old_points, old_triangles = read_vtp(meshes / "infant" / f"{name}.vtp")
        points, triangles = read_vtp(Path(scratch) / f"{name}.vtp")
        counts = f"{name}: {len(points)} vertices, {len(old_points)} committed"
        assert abs(len(points) - len(old_points)) <= 0.01 * len(old_points), counts
        distance = abs(blend(bodies, width)(old_points)[0]).max()
        assert distance < 1e-2, f"{name}: the committed points are not on the described surface"
