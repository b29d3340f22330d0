"""Arrays look at the result's memory, keep it alive, and are taken by others as they are."""

import gc
import unittest

import numpy as np
import vasorod
from cases import SOURCE, beam, tube

GLENN = SOURCE / "benchmarks" / "cases" / "glenn" / "infant.yaml"


def all_arrays(result):
    for vessel in result.vessels.values():
        parts = [vessel, vessel.centerline, vessel.stump]
        for part in filter(None, parts):
            yield from (
                getattr(part, name)
                for name in ("points", "rest", "triangles", "lines")
                if isinstance(getattr(part, name, None), np.ndarray)
            )
            yield from part.point_arrays.values()
            yield from getattr(part, "cell_arrays", {}).values()


class Memory(unittest.TestCase):
    def test_arrays_outlive_what_they_came_from(self):
        result = vasorod.solve(tube())
        arrays = list(all_arrays(result))
        copies = [array.copy() for array in arrays]
        del result
        gc.collect()
        rubbish = [vasorod.solve(tube(stretch=0.1)) for _ in range(3)]  # writes over freed memory
        for array, copy in zip(arrays, copies):
            np.testing.assert_array_equal(array, copy)
        del rubbish

    def test_a_centerline_outlives_its_vessel(self):
        line = vasorod.solve(beam(force=[0, 1, 0])).vessels["beam"].centerline
        gc.collect()
        self.assertEqual(line.rest[-1].tolist(), [100, 0, 0])

    def test_the_result_goes_when_nothing_looks_at_it(self):
        """A hundred results of 2.4 MB of points do not stay."""

        def resident():
            with open("/proc/self/statm") as file:
                return int(file.read().split()[1]) * 4096

        scene = vasorod.Scene(tube("rod", around=20, along=40))
        for _ in range(20):
            vasorod.solve(scene)
        before = resident()
        for _ in range(200):
            arrays = list(all_arrays(vasorod.solve(scene)))
        del arrays
        self.assertLess(resident() - before, 20e6)

    def test_nothing_is_copied_and_nothing_can_be_changed(self):
        vessel = vasorod.solve(tube("coupled")).vessels["tube"]
        for name in ("points", "rest", "triangles"):
            first, second = getattr(vessel, name), getattr(vessel, name)
            self.assertTrue(np.shares_memory(first, second), name)
            self.assertTrue(first.flags.c_contiguous)
        self.assertTrue(np.shares_memory(vessel.rest, vessel.point_arrays["RestPosition"]))
        for array in all_arrays(vasorod.solve(tube("coupled"))):
            with self.assertRaisesRegex(ValueError, "read-only"):
                array[...] = 0
        vessel.points.copy()[0] = 1


class Shapes(unittest.TestCase):
    def test_types_and_shapes(self):
        for vessel in vasorod.solve(GLENN, fidelity="skin").vessels.values():
            n, m = len(vessel.points), len(vessel.triangles)
            self.assertEqual((vessel.points.shape, vessel.points.dtype), ((n, 3), np.float64))
            self.assertEqual((vessel.rest.shape, vessel.rest.dtype), ((n, 3), np.float64))
            self.assertEqual((vessel.triangles.shape, vessel.triangles.dtype), ((m, 3), np.int32))
            self.assertEqual((vessel.triangles.min(), vessel.triangles.max()), (0, n - 1))
            for name, values in vessel.point_arrays.items():
                self.assertEqual(len(values), n, name)
            for name, values in vessel.cell_arrays.items():
                self.assertEqual(len(values), m, name)

    def test_displacements_and_directors(self):
        vessel = vasorod.solve(GLENN, fidelity="skin").vessels["svc"]
        np.testing.assert_array_equal(
            vessel.point_arrays["Displacement"], vessel.points - vessel.rest
        )
        frames = np.stack([vessel.centerline.point_arrays[f"Director{k}"] for k in (1, 2, 3)], 1)
        np.testing.assert_allclose(
            frames @ frames.transpose(0, 2, 1), np.broadcast_to(np.eye(3), frames.shape), atol=1e-12
        )
        np.testing.assert_allclose(np.cross(frames[:, 0], frames[:, 1]), frames[:, 2], atol=1e-12)

    def test_a_bare_rod_has_its_centerline_only(self):
        rod = vasorod.solve(beam(force=[0, 1, 0])).vessels["beam"]
        self.assertEqual((rod.points.shape, rod.triangles.shape), ((0, 3), (0, 3)))
        self.assertIsNone(rod.stump)
        self.assertEqual([line.tolist() for line in rod.centerline.lines], [list(range(21))])

    def test_a_branched_vessel_has_several_lines(self):
        aorta = vasorod.fit(SOURCE / "meshes" / "infant" / "aorta.vtp").vessels["aorta"]
        nodes = np.concatenate(aorta.centerline.lines)
        self.assertEqual(set(nodes), set(range(len(aorta.centerline.points))))
        self.assertEqual(len(aorta.centerline.lines), 7)  # four forks' worth: three arch vessels


class Others(unittest.TestCase):
    def test_vtk_takes_points_and_arrays_without_a_copy(self):
        from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

        vessel = vasorod.solve(tube()).vessels["tube"]
        for array in (vessel.points, vessel.point_arrays["AxialStretch"]):
            there = numpy_to_vtk(array)
            self.assertTrue(np.shares_memory(vtk_to_numpy(there), array))

    def test_pyvista_takes_them_as_they_are(self):
        try:
            import pyvista
        except ImportError:
            self.skipTest("PyVista is not installed; Debian 12 has no package of it")
        vessel = vasorod.solve(tube()).vessels["tube"]
        mesh = pyvista.PolyData.from_regular_faces(vessel.points, vessel.triangles)
        np.testing.assert_array_equal(mesh.regular_faces, vessel.triangles)
        mesh.point_data.update(vessel.point_arrays)
        self.assertEqual(mesh.n_open_edges, 48)


if __name__ == "__main__":
    unittest.main()
