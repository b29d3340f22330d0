"""Scenes from files, dicts and surfaces in memory are the same scenes."""

import gc
import os
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np
import vasorod
import yaml
from cases import SOURCE, program, result_of, tube, without_times


def numbers(result):
    """A result.json without what names the file it came from."""
    return {k: v for k, v in without_times(result.json).items() if k != "environment"}


class FromDicts(unittest.TestCase):
    def test_a_dict_gives_the_numbers_of_the_file(self):
        for name in ("examples/scene.yaml", "benchmarks/cases/rod/b13-tree.yaml"):
            path = SOURCE / name
            keys = yaml.safe_load(path.read_text())
            from_file = vasorod.solve(path)
            from_dict = vasorod.solve(vasorod.Scene(keys, folder=path.parent))
            self.assertEqual(numbers(from_dict), numbers(from_file))
            self.assertEqual(from_dict.json["environment"]["inputs"], {})

    def test_surfaces_are_looked_for_in_the_folder(self):
        path = SOURCE / "benchmarks" / "cases" / "glenn" / "infant.yaml"
        scene = vasorod.Scene(yaml.safe_load(path.read_text()), folder=path.parent)
        self.assertEqual(scene.vessels, ["svc", "pulmonary_artery", "aorta", "heart"])
        self.assertEqual((scene.length_unit, scene.stress_unit), ("mm", "MPa"))
        self.assertEqual(scene.fidelity, "paper")
        files = vasorod.solve(scene, fidelity="rod").json["environment"]["inputs"]
        self.assertEqual(set(files), {"svc.vtp", "pulmonary_artery.vtp", "aorta.vtp", "heart.vtp"})

    def test_numbers_of_numpy_and_paths_are_taken(self):
        plain, other = tube(), tube()
        other["ends"][1]["move"] = np.array([0, 0, 5], dtype=np.float32)
        other["vessels"][0]["tube"]["around"] = np.int64(24)
        other["ends"] = tuple(other["ends"])
        self.assertEqual(numbers(vasorod.solve(other)), numbers(vasorod.solve(plain)))
        other["vessels"][0]["wall"]["young"] = {1.0}
        with self.assertRaisesRegex(TypeError, r"scene\.vessels\[0\]\.wall\.young: found set"):
            vasorod.Scene(other)

    def test_every_double_stays_the_same(self):
        """Positions of bare rods go through unchanged: the scene's text loses no bit."""
        start = [0.1 + 0.2, -1e-5 / 3, np.nextafter(1.0, 2.0)]
        scene = tube()
        stiffness = {"axial": 1, "shear": [1, 1], "bending": [1, 1], "torsion": 1}
        scene["vessels"] = [
            {
                "name": "rod",
                "rod": {
                    "position": start,
                    "pieces": [{"length": 1, "elements": 1}],
                    "stiffness": stiffness,
                },
            }
        ]
        scene["ends"] = [
            {"vessel": "rod", "end": "start", "hold": True},
            {"vessel": "rod", "end": "end", "force": [0, 0, 0]},
        ]
        scene["fidelity"] = "rod"
        line = vasorod.solve(scene).vessels["rod"].centerline
        self.assertEqual(line.rest[0].tolist(), start)


class SurfacesInMemory(unittest.TestCase):
    """The oracle: the program on a VTP file that another writer made of the same arrays."""

    @classmethod
    def setUpClass(cls):
        sys.path.insert(0, str(SOURCE / "meshes"))
        from vtp import write_vtp

        sys.path.pop(0)
        wall = vasorod.solve(tube()).vessels["tube"]
        cls.points, cls.triangles = wall.rest, wall.triangles
        cls.scratch = tempfile.TemporaryDirectory()
        folder = Path(cls.scratch.name)
        write_vtp(folder / "tube.vtp", cls.points, cls.triangles)
        (folder / "scene.yaml").write_text(yaml.safe_dump(cls.scene("tube.vtp")))
        code, _, said = program("solve", folder / "scene.yaml", "-o", folder / "out", "--no-report")
        assert code == 0, said
        cls.expected = result_of(folder / "out")
        del cls.expected["environment"]

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    @staticmethod
    def scene(surface):
        scene = tube("coupled")
        del scene["vessels"][0]["tube"]
        scene["vessels"][0]["surface"] = surface
        return scene

    def test_arrays_are_solved_as_a_file_is(self):
        result = vasorod.solve(self.scene((self.points, self.triangles)))
        self.assertEqual(numbers(result), self.expected)
        self.assertEqual(list(result.json["environment"]["inputs"]), ["tube.ply"])

    def test_any_order_and_type_of_numbers_will_do(self):
        points = np.asfortranarray(self.points)
        result = vasorod.solve(self.scene((points, self.triangles.astype(np.uint64))))
        self.assertEqual(numbers(result), self.expected)
        result = vasorod.solve(self.scene((self.points.tolist(), self.triangles.tolist())))
        self.assertEqual(numbers(result), self.expected)

    def test_vessels_and_surfaces_are_taken(self):
        surface = vasorod.read_surface(Path(self.scratch.name) / "tube.vtp")
        self.assertEqual(numbers(vasorod.solve(self.scene(surface))), self.expected)
        fitted = vasorod.fit(surface).vessels["surface"]
        self.assertEqual(numbers(vasorod.solve(self.scene(fitted))), self.expected)

    def test_fit_gives_the_numbers_of_the_file(self):
        path = Path(self.scratch.name) / "tube.vtp"
        in_memory = vasorod.fit((self.points, self.triangles))
        of_file = vasorod.fit(path)
        self.assertEqual(in_memory.json["fit"], of_file.json["fit"])
        folder = Path(self.scratch.name) / "fit"
        program("fit", path, "-o", folder, "--quiet")
        self.assertEqual(without_times(of_file.json), result_of(folder))
        self.assertAlmostEqual(of_file.json["fit"]["length"], 100, places=3)
        smaller = vasorod.fit((self.points / 10, self.triangles), length_unit="cm", remesh=0.2)
        self.assertAlmostEqual(smaller.json["fit"]["length"], 10, places=2)
        self.assertEqual(smaller.length_unit, "cm")
        self.assertNotEqual(len(smaller.vessels["surface"].points), len(self.points))

    def test_the_temporary_file_goes_with_the_scene(self):
        scene = vasorod.Scene(self.scene((self.points, self.triangles)))
        folder = scene._files
        self.assertEqual(os.listdir(folder), ["tube.ply"])
        del scene
        gc.collect()
        self.assertFalse(os.path.exists(folder))

    def test_what_is_no_surface_is_refused(self):
        good = self.points, self.triangles
        for surface, found in (
            (5, "found int"),
            ((self.points,), "found tuple"),
            ((self.points[:, :2], good[1]), r"found points of shape \(888, 2\)"),
            ((good[0], self.points), "found triangles of shape"),
            ((good[0], good[1] + 1), "found triangles of points 1 to 888, expected 0 to 887"),
            ((good[0] * np.nan, good[1]), "found a coordinate of point 0 that is not a number"),
        ):
            with self.assertRaisesRegex(ValueError, found):
                vasorod.solve(self.scene(surface))


if __name__ == "__main__":
    unittest.main()
