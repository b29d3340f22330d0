"""What is refused is refused with the program's sentence, as the error that Python has for it."""

import copy
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import vasorod
import yaml
from cases import SOURCE, beam, long_solve, program, tube


def changed(scene, *keys, to):
    """A copy of a scene with one value changed."""
    scene = copy.deepcopy(scene)
    place = scene
    for key in keys[:-1]:
        place = place[key]
    place[keys[-1]] = to
    return scene


class Scenes(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def said(self, error, call, *arguments, **named):
        with self.assertRaises(error) as caught:
            call(*arguments, **named)
        self.assertEqual(str(caught.exception).count("\n"), 0)
        return str(caught.exception)

    def test_a_scene_that_the_reader_refuses(self):
        for scene in (
            changed(tube(), "vessels", 0, "wall", "young", to=-1),
            changed(tube(), "vessels", 0, "wal", to=1),
            changed(tube(), "ends", 1, "vessel", to="tub"),
            changed(tube(), "ends", 1, "move", to=[0, 0]),
            changed(tube(), "ends", 0, "hold", to="true"),
            changed(tube(), "units", to={"length": "mm"}),
            changed(beam(), "vessels", 0, "rod", "pieces", 0, "elements", to=None),
            changed(tube(), "fidelity", to=None),
            changed(tube(), "vessels", to=[]),
        ):
            path = self.folder / "scene.yaml"
            path.write_text(yaml.safe_dump(scene))
            code, _, sentence = program("solve", path, "-o", self.folder / "out")
            self.assertEqual(code, 2)
            self.assertEqual(self.said(ValueError, vasorod.read_scene, path), sentence)
            # A dict has no file and no line. The rest is the same.
            place, _, rest = sentence.partition(": ")
            self.assertTrue(place.startswith(str(path)), sentence)
            self.assertEqual(self.said(ValueError, vasorod.Scene, scene), rest)

    def test_a_scene_that_cannot_be_solved(self):
        for scene in (
            changed(tube(), "fidelity", to="glass"),
            changed(tube(), "ends", to=[]),
            changed(tube(), "ends", 1, "end", to={"near": [300, 0, 0]}),
            changed(beam(force=[1, 0, 0]), "ends", 0, to={"vessel": "beam", "end": "end"}),
        ):
            path = self.folder / "scene.yaml"
            path.write_text(yaml.safe_dump(scene))
            code, _, sentence = program("solve", path, "-o", self.folder / "out")
            self.assertEqual(code, 2)
            self.assertEqual(self.said(ValueError, vasorod.solve, path), sentence)
            self.assertTrue(self.said(ValueError, vasorod.solve, scene))

    def test_files_that_are_not_there_or_no_surfaces(self):
        missing = self.folder / "missing.vtp"
        text = self.folder / "text.stl"
        text.write_text("no surface")
        for path in (missing, text):
            _, _, sentence = program("fit", path, "-o", self.folder / "out")
            self.assertEqual(self.said(ValueError, vasorod.fit, path), sentence)
            self.assertEqual(self.said(ValueError, vasorod.read_surface, path), sentence)
        _, _, sentence = program("solve", missing, "-o", self.folder / "out")
        self.assertEqual(self.said(ValueError, vasorod.solve, missing), sentence)
        closed = SOURCE / "meshes" / "infant" / "heart.vtp"
        _, _, sentence = program("fit", closed, "-o", self.folder / "out")
        self.assertEqual(self.said(ValueError, vasorod.fit, closed), sentence)
        for options in ({"length_unit": "inch"}, {"remesh": -1}, {"remesh": float("nan")}):
            self.assertIn("expected", self.said(ValueError, vasorod.fit, closed, **options))

    def test_folders_that_may_not_be_replaced(self):
        (self.folder / "mine.txt").write_text("mine")
        path = self.folder / "scene.yaml"
        path.write_text(yaml.safe_dump(tube()))
        other = self.folder / "sub"
        other.mkdir()
        (other / "mine.txt").write_text("mine")
        for folder in (self.folder, other):
            code, _, sentence = program("solve", path, "-o", folder)
            self.assertEqual(code, 3)
            stages = []
            found = self.said(OSError, vasorod.solve, path, out=folder, progress=stages.append)
            self.assertEqual(found, sentence)
            self.assertEqual(stages, [], "found out before the solve")
        found = self.said(OSError, vasorod.solve(tube()).write, other)
        self.assertEqual(found, sentence)
        self.assertEqual((other / "mine.txt").read_text(), "mine")

    def test_results_that_cannot_be_compared(self):
        vasorod.solve(tube(), out=self.folder / "a", report=False)
        vasorod.solve(changed(tube(), "scene", to="b"), out=self.folder / "b", report=False)
        for b in ("b", "c"):
            _, _, sentence = program("compare", self.folder / "a", self.folder / b)
            self.assertEqual(
                self.said(ValueError, vasorod.compare, self.folder / "a", self.folder / b), sentence
            )

    def test_options_of_solve(self):
        for options in ({"threads": 0}, {"time_limit": 0}, {"time_limit": float("nan")}):
            (name,) = options
            self.assertRegex(
                self.said(ValueError, vasorod.solve, tube(), **options),
                f"^{name}: found .*expected",
            )
        with self.assertRaises(TypeError):
            vasorod.solve(tube(), fidelty="rod")

    def test_no_memory(self):
        path = self.folder / "scene.yaml"
        path.write_text(yaml.safe_dump(tube("coupled", around=1400, along=1400)))
        code = (
            f"import vasorod\ntry: vasorod.solve({str(path)!r})\nexcept MemoryError as e: print(e)"
        )
        run = subprocess.run(
            ["sh", "-c", 'ulimit -v 4000000; exec "$0" -c "$1"', sys.executable, code],
            capture_output=True,
            text=True,
            env={**os.environ, "OPENBLAS_NUM_THREADS": "1"},
        )
        self.assertRegex(run.stdout, "^[^\n]*memory[^\n]*, expected [^\n]*\n$", run.stderr)

    def test_a_time_limit_before_there_is_a_state(self):
        # Many vessels to read and fit, far longer than the 1.5 s that a solve has to come to one.
        scene = {**long_solve(), "fidelity": "rod"}
        tube, ends = scene["vessels"][0], scene["ends"]
        names = [f"tube{k}" for k in range(30)]
        scene["vessels"] = [{**tube, "name": name} for name in names]
        scene["ends"] = [{**end, "vessel": name} for name in names for end in ends]
        with self.assertRaisesRegex(TimeoutError, "^stopped at .*, before there was a state"):
            vasorod.solve(scene, time_limit=1e-3)


if __name__ == "__main__":
    unittest.main()
