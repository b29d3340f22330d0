"""Results have the program's numbers, to the last bit, and those of closed forms."""

import ctypes
import json
import math
import multiprocessing
import tempfile
import threading
import unittest
from pathlib import Path

import numpy as np
import vasorod
import read_vtp
from cases import SOURCE, beam, program, result_of, tube, without_times


class ClosedForms(unittest.TestCase):
    def test_a_pulled_tube_answers_with_e_a_strain(self):
        exact = 1 * 2 * math.pi * 10 * 1 * 0.05
        for fidelity in vasorod.fidelities():
            result = vasorod.solve(tube(around=32, along=48), fidelity=fidelity)
            self.assertEqual((result.status, result.fidelity), ("converged", fidelity))
            start, end = (reaction["force"][2] for reaction in result.json["ends"])
            # up to the error of the mesh's polygon of 32 sides
            self.assertAlmostEqual(end, exact, delta=0.01 * exact)
            self.assertAlmostEqual(start, -exact, delta=0.01 * exact)

    def test_a_rod_is_pulled_by_its_force_over_e_a(self):
        line = vasorod.solve(beam(force=[500.0, 0, 0])).vessels["beam"].centerline
        np.testing.assert_allclose(line.points[:, 0], line.rest[:, 0] * (1 + 500 / 1e7), rtol=1e-12)
        np.testing.assert_allclose(line.point_arrays["SectionForce"][:, 2], 500, rtol=1e-9)

    def test_a_moment_rolls_a_rod_up_to_an_arc(self):
        result = vasorod.solve(beam(moment=[0, 0, 8.3e5 * (math.pi / 2) / 100]))
        radius = 100 / (math.pi / 2)
        end = result.vessels["beam"].centerline.points[-1]
        np.testing.assert_allclose(end, [radius, radius, 0], atol=1e-6)


class TheProgramsNumbers(unittest.TestCase):
    """Solves a scene file with the program and with the package, both with one thread."""

    def check(self, scene, fidelity):
        with tempfile.TemporaryDirectory() as scratch:
            folder = Path(scratch) / "program"
            code, _, said = program(
                "solve", scene, "-o", folder, "--fidelity", fidelity, "--no-report"
            )
            self.assertLessEqual(code, 1, said)
            result = vasorod.solve(scene, fidelity=fidelity)
            self.assertEqual(without_times(result.json), result_of(folder))
            files = {"result.json", "scene.pvd"}
            for name, vessel in result.vessels.items():
                if len(vessel.points):
                    files.add(f"{name}.vtp")
                    self.same(vessel, vessel.triangles, folder / f"{name}.vtp")
                if vessel.centerline is not None:
                    files.add(f"{name}_centerline.vtp")
                    line = vessel.centerline
                    self.same(line, line.lines, folder / f"{name}_centerline.vtp")
                if vessel.stump is not None:
                    files.add(f"{name}_stump.vtp")
                    self.same(vessel.stump, vessel.stump.triangles, folder / f"{name}_stump.vtp")
            self.assertEqual({path.name for path in folder.iterdir()}, files)
            written = Path(scratch) / "written"
            result.write(written, report=False)
            self.assertEqual({path.name for path in written.iterdir()}, files)
            for name in files - {"result.json"}:
                self.assertEqual((written / name).read_bytes(), (folder / name).read_bytes(), name)
            self.assertEqual(result_of(written), result_of(folder))
            return result

    def same(self, part, cells, path):
        """The arrays of a part of a result are those of its file: names, order, types, bits."""
        points, file_cells, point_arrays, cell_arrays = read_vtp.read(path)
        self.bits(part.points, points, f"{path}: points")
        self.assertEqual([list(cell) for cell in cells], [list(cell) for cell in file_cells])
        for mine, file in (
            (part.point_arrays, point_arrays),
            (getattr(part, "cell_arrays", {}), cell_arrays),
        ):
            self.assertEqual(list(mine), list(file), path)
            for name, values in mine.items():
                self.bits(values, file[name], f"{path}: {name}")

    def bits(self, mine, file, place):
        self.assertEqual((mine.shape, mine.dtype), (file.shape, file.dtype), place)
        self.assertEqual(np.ascontiguousarray(mine).tobytes(), file.tobytes(), place)

    def test_of_a_bent_tube_at_coupled(self):
        self.check(SOURCE / "examples" / "scene.yaml", "coupled")

    def test_of_a_tree_of_rods(self):
        self.check(SOURCE / "benchmarks" / "cases" / "rod" / "b13-tree.yaml", "rod")

    def test_of_a_glenn_operation_with_its_stump_and_the_inputs_own_arrays(self):
        scene = SOURCE / "benchmarks" / "cases" / "glenn" / "infant.yaml"
        result = self.check(scene, "skin")
        self.assertIsNotNone(result.vessels["svc"].stump)
        self.assertIsNone(result.vessels["aorta"].stump)
        self.assertTrue(result.vessels["heart"].obstacle)
        self.assertIsNone(result.vessels["heart"].centerline)

    def test_of_input_arrays_of_every_type(self):
        """A surface with own arrays of small types, two of them with names of ours."""
        from vtkmodules.util.numpy_support import numpy_to_vtk
        from vtkmodules.vtkCommonCore import vtkPoints
        from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
        from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

        wall = vasorod.solve(tube()).vessels["tube"]
        data, points, polys = vtkPolyData(), vtkPoints(), vtkCellArray()
        points.SetData(numpy_to_vtk(wall.rest, deep=True))
        for triangle in wall.triangles.tolist():
            polys.InsertNextCell(3, triangle)
        data.SetPoints(points)
        data.SetPolys(polys)
        for dtype in ("i1", "u1", "i2", "u2", "i4", "u4", "f4", "f8"):
            for attributes, rows in ((data.GetPointData(), 888), (data.GetCellData(), 1728)):
                array = numpy_to_vtk(np.arange(rows).astype(dtype), deep=True)
                array.SetName(f"of_{dtype}")
                attributes.AddArray(array)
        vectors = numpy_to_vtk(np.arange(3 * 888).reshape(-1, 3).astype("f4"), deep=True)
        vectors.SetName("TwistShear")
        data.GetPointData().AddArray(vectors)
        with tempfile.TemporaryDirectory() as scratch:
            writer = vtkXMLPolyDataWriter()
            writer.SetInputData(data)
            writer.SetFileName(scratch + "/own.vtp")
            writer.Write()
            text = (SOURCE / "examples" / "scene.yaml").read_text()
            text = text[: text.index("vessels:")] + (
                "vessels:\n  - {name: own, surface: own.vtp, wall: {thickness: 1, young: 1000,"
                " poisson: 0.3}}\nends:\n  - {vessel: own, end: start, hold: true}\n"
                "  - {vessel: own, end: end, move: [0, 0, 1]}\nfidelity: skin\n"
            )
            scene = Path(scratch) / "scene.yaml"
            scene.write_text(text)
            own = self.check(scene, "skin").vessels["own"]
        self.assertEqual(own.cell_arrays["of_u1"].dtype, np.uint8)
        self.assertEqual(own.point_arrays["TwistShear_input"].dtype, np.float32)


def forces(stretch):
    return vasorod.solve(tube("coupled", stretch)).json["ends"]


class Solving(unittest.TestCase):
    def test_the_result_folder_is_written_too(self):
        with tempfile.TemporaryDirectory() as scratch:
            result = vasorod.solve(tube(), out=Path(scratch) / "out")
            self.assertTrue((Path(scratch) / "out" / "report.html").is_file())
            self.assertEqual(without_times(result.json), result_of(Path(scratch) / "out"))
            # what is said afterwards agrees with the file, its times too
            self.assertIn("write", result.json["seconds"])

    def test_two_solves_at_once_give_the_numbers_of_one(self):
        alone = without_times(vasorod.solve(tube("coupled")).json)
        together = [None, None, None]

        def work(k):
            together[k] = without_times(vasorod.solve(tube("coupled")).json)

        threads = [threading.Thread(target=work, args=(k,)) for k in range(3)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(together, [alone] * 3)

    def test_processes_that_are_forked_give_the_same_numbers(self):
        alone = [forces(stretch) for stretch in (0.01, 0.02, 0.03)]
        with multiprocessing.get_context("fork").Pool(2) as pool:
            self.assertEqual(pool.map(forces, (0.01, 0.02, 0.03)), alone)

    def test_certify_asks_for_the_sign_of_the_smallest_curvature(self):
        for certify, expected in ((False, None), (True, True)):
            result = vasorod.solve(tube("paper"), certify=certify)
            found = result.json["certificate"]["smallest_curvature_positive"]
            self.assertEqual(found, expected)

    def test_numpy_gets_its_threads_back(self):
        """Where NumPy uses the same OpenBLAS, one thread for a solve is not one thread for it."""
        blas = ctypes.CDLL("libopenblas.so.0")
        blas.openblas_set_num_threads(2)
        vasorod.solve(tube(), threads=1)
        self.assertEqual(blas.openblas_get_num_threads(), 2)


class Comparing(unittest.TestCase):
    def test_results_and_folders_give_the_programs_numbers(self):
        with tempfile.TemporaryDirectory() as scratch:
            a, b = Path(scratch) / "a", Path(scratch) / "b"
            first = vasorod.solve(tube(), out=a, report=False)
            second = vasorod.solve(tube("coupled"), out=b, report=False)
            code, printed, said = program("compare", a, b)
            self.assertEqual(code, 0, said)
            self.assertEqual(str(vasorod.compare(a, b)), printed)
            expected = json.loads(program("compare", a, b, "--json")[1])
            self.assertEqual(vasorod.compare(a, b).json, expected)
            in_memory = vasorod.compare(first, second).json
            for side in "ab":
                self.assertEqual(in_memory[side].pop("folder"), "in memory")
                expected[side].pop("folder")
                # a second writing takes its time too
                in_memory[side].pop("seconds"), expected[side].pop("seconds")
            in_memory.pop("seconds_ratio"), expected.pop("seconds_ratio")
            self.assertEqual(in_memory, expected)


if __name__ == "__main__":
    unittest.main()
