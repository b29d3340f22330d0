"""What goes out to meshio is what its files hold, and what comes in from it is solved."""

import tempfile
import unittest
from pathlib import Path

import numpy as np
import vasorod
from cases import SOURCE, tube, without_times

try:
    import meshio
except ImportError:
    meshio = None


@unittest.skipIf(meshio is None, "meshio is not installed (Debian: python3-meshio)")
class Meshio(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def same(self, mesh, read):
        np.testing.assert_array_equal(read.points, mesh.points)
        self.assertEqual(list(read.cells_dict), list(mesh.cells_dict))
        for kind, cells in mesh.cells_dict.items():
            np.testing.assert_array_equal(read.cells_dict[kind], cells)
        for mine, file in ((mesh.point_data, read.point_data), (mesh.cell_data, read.cell_data)):
            self.assertEqual(set(mine), set(file))
            for name, values in mine.items():
                np.testing.assert_array_equal(np.squeeze(file[name]), np.squeeze(values))

    def test_vtu_and_xdmf_hold_every_array(self):
        scene = SOURCE / "benchmarks" / "cases" / "glenn" / "infant.yaml"
        vessel = vasorod.solve(scene, fidelity="skin").vessels["svc"]
        for part in (vessel, vessel.centerline, vessel.stump):
            mesh = vasorod.to_meshio(part)
            np.testing.assert_array_equal(mesh.points, part.points)
            self.assertEqual(list(mesh.point_data), list(part.point_arrays))
            meshio.write(self.folder / "part.vtu", mesh)
            self.same(mesh, meshio.read(self.folder / "part.vtu"))

    def test_xdmf_holds_every_array(self):
        try:
            import h5py  # noqa: F401
        except ImportError:
            self.skipTest("meshio's XDMF needs h5py (Debian: python3-h5py)")
        mesh = vasorod.to_meshio(vasorod.solve(tube()).vessels["tube"])
        meshio.write(self.folder / "tube.xdmf", mesh)
        self.same(mesh, meshio.read(self.folder / "tube.xdmf"))

    def test_a_vtp_file_goes_out_through_read_surface(self):
        surface = vasorod.read_surface(SOURCE / "meshes" / "infant" / "svc.vtp")
        mesh = vasorod.to_meshio(surface)
        meshio.write(self.folder / "svc.vtu", mesh)
        self.same(mesh, meshio.read(self.folder / "svc.vtu"))

    def test_a_mesh_of_meshio_is_solved_as_its_arrays_are(self):
        wall = vasorod.solve(tube()).vessels["tube"]
        meshio.write_points_cells(
            self.folder / "wall.vtu", wall.rest, [("triangle", wall.triangles)]
        )
        scene = tube()
        del scene["vessels"][0]["tube"]
        results = []
        for surface in (meshio.read(self.folder / "wall.vtu"), (wall.rest, wall.triangles)):
            scene["vessels"][0]["surface"] = surface
            results.append(without_times(vasorod.solve(scene).json))
        self.assertEqual(results[0], results[1])
        scene["vessels"][0]["surface"] = meshio.Mesh(wall.rest, [("line", [[0, 1]])])
        with self.assertRaisesRegex(ValueError, "found a mesh without triangles"):
            vasorod.Scene(scene)


if __name__ == "__main__":
    unittest.main()
