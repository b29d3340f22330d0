"""cmake --install puts the package where the interpreter looks for it below the prefix."""

import os
import site
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path


class Install(unittest.TestCase):
    def test_the_installed_package_is_imported_and_solves(self):
        with tempfile.TemporaryDirectory() as prefix:
            subprocess.run(
                [os.environ["VASOROD_CMAKE"], "--install", os.environ["VASOROD_BUILD"]]
                + ["--prefix", prefix],
                check=True,
                capture_output=True,
            )
            folder = Path(prefix) / os.environ["VASOROD_PYTHON_FOLDER"]
            # Below another prefix the interpreter would look here.
            self.assertIn(str(folder), site.getsitepackages([prefix]))
            installed = {path.name for path in (folder / "vasorod").iterdir()}
            built = Path(os.environ["VASOROD_BUILD"]) / "python" / "vasorod"
            there = {path.name for path in built.iterdir() if path.name != "__pycache__"}
            self.assertEqual(installed, there)
            self.assertTrue(all(not path.is_symlink() for path in (folder / "vasorod").iterdir()))
            code = "import vasorod; print(vasorod.__file__, vasorod.fidelities())"
            run = subprocess.run(
                [sys.executable, "-c", code],
                env={**os.environ, "PYTHONPATH": str(folder)},
                capture_output=True,
                text=True,
            )
            self.assertEqual(run.returncode, 0, run.stderr)
            names = ["rod", "skin", "paper", "section", "coupled"]
            expected = f"{folder / 'vasorod' / '__init__.py'} {names}\n"
            self.assertEqual(run.stdout, expected)


if __name__ == "__main__":
    unittest.main()
