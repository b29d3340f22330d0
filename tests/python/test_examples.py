"""The examples run, say the right numbers, and draw their plots."""

import os
import re
import struct
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from cases import SOURCE, program, result_of

try:
    import matplotlib
except ImportError:
    matplotlib = None

GLENN = SOURCE / "benchmarks" / "cases" / "glenn" / "infant.yaml"


class Examples(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def run_example(self, name, *arguments):
        run = subprocess.run(
            [sys.executable, SOURCE / "examples" / "python" / name, *arguments],
            capture_output=True,
            text=True,
            cwd=self.folder,
            env={**os.environ, "MPLCONFIGDIR": str(self.folder)},
        )
        self.assertEqual(run.returncode, 0, run.stderr)
        return run.stdout

    def check_plot(self, path):
        """A PNG picture that is not one colour."""
        data = path.read_bytes()
        self.assertEqual(data[:8], b"\x89PNG\r\n\x1a\n")
        width, height = struct.unpack(">II", data[16:24])
        from matplotlib import image

        pixels = image.imread(path)
        self.assertEqual(pixels.shape[:2], (height, width))
        self.assertGreater(pixels[..., :3].std(), 0.05)

    def test_the_rod_rolls_up(self):
        rows = self.run_example("rod.py").splitlines()[1:]
        angle, x, y, apart = map(float, rows[3].split())
        # a quarter of a circle of length 100
        self.assertEqual((angle, x, y), (90.0, 63.661977, 63.661977))
        self.assertLess(apart, 1e-6)

    def test_the_sweep_is_timoshenkos(self):
        rows = self.run_example("modulus_sweep.py").splitlines()[1:]
        self.assertEqual(len(rows), 12)
        for row in rows:
            _, force, expected = map(float, row.split())
            # one rod with 48 elements, large displacements left out of the closed form
            self.assertAlmostEqual(force, expected, delta=1e-3 * expected)

    def test_the_glenn_says_the_programs_numbers(self):
        said = self.run_example("glenn.py", GLENN)
        program("solve", GLENN, "-o", self.folder / "out", "--fidelity", "skin", "--no-report")
        result = result_of(self.folder / "out")
        self.assertIn(f"infant: {result['status']}", said)
        pairs = int(re.search(r"(\d+) pairs", said)[1])
        self.assertEqual(pairs, result["glenn"]["join"]["pairs"])
        for vessel in result["metrics"]:
            self.assertRegex(
                said, f"{vessel['vessel']} .* shear {vessel['largest_twist_shear']:.4f}"
            )

    @unittest.skipIf(matplotlib is None, "no matplotlib (Debian: python3-matplotlib)")
    def test_the_sweep_is_drawn(self):
        self.run_example("modulus_sweep.py", self.folder / "sweep.png")
        self.check_plot(self.folder / "sweep.png")

    @unittest.skipIf(matplotlib is None, "no matplotlib (Debian: python3-matplotlib)")
    def test_the_glenn_is_drawn(self):
        self.run_example("glenn.py", GLENN, self.folder / "glenn.png")
        self.check_plot(self.folder / "glenn.png")


if __name__ == "__main__":
    unittest.main()
