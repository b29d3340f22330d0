"""Whoever gets the page of vasorod-plan gets the licences of the npm packages in it."""

import json
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

from programs import BUILD, SOURCE

SCRIPT = SOURCE / "packaging" / "page_licences.sh"
TITLE = re.compile(r"^(\S+) (\d\S*), (.+)$")
# What all licences in the page have: a right that is given, and who gives it.
GRANT = re.compile(r"permission|permitted|redistribution", re.IGNORECASE)
OWNER = re.compile(r"copyright.*\d{4}", re.IGNORECASE)


def written(app):
    """The script's run on an app.js, and the file that it wrote, or None."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "licences.txt"
        run = subprocess.run([SCRIPT, app, file], capture_output=True, text=True)
        left = [path.name for path in Path(folder).iterdir()]
        assert left in ([], ["licences.txt"]), left
        return run, file.read_text() if left else None


def made_up(head):
    """The same of an app.js with this head."""
    with tempfile.TemporaryDirectory() as folder:
        app = Path(folder) / "app.js"
        app.write_text(head + "(()=>{})();\n")
        return written(app)


class Licences(unittest.TestCase):
    def test_every_package_of_the_page_has_its_text(self):
        run, text = written(BUILD / "hybrid" / "planner" / "page" / "app.js")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        lock = json.loads((SOURCE / "hybrid/planner/page/package-lock.json").read_text())
        names = []
        for part in text.split("\n----\n"):
            lines = [line for line in part.splitlines() if line]
            if not names:
                self.assertIn("vasorod-plan", lines.pop(0))
            name, version, licence = TITLE.match(lines[0]).groups()
            locked = lock["packages"][f"node_modules/{name}"]
            self.assertEqual((version, licence), (locked["version"], locked["license"]), name)
            self.assertRegex(part, GRANT, name)
            self.assertRegex(part, OWNER, name)
            names.append(name)
        # What the page asks for by name, and what that brings along.
        for name in ("@kitware/vtk.js", "uplot", "gl-matrix", "seedrandom", "d3-scale"):
            self.assertIn(name, names)
        self.assertEqual(len(set(names)), len(names))

    def test_debian_names_the_same_packages(self):
        head = (BUILD / "hybrid" / "planner" / "page" / "app.js").read_text().split("*/", 1)[0]
        names = [match[1] for match in map(TITLE.match, head.splitlines()) if match]
        comment = (SOURCE / "debian" / "copyright").read_text().split("\nFiles:", 1)[0]
        for name in names:
            self.assertRegex(comment, rf"[\s(]{re.escape(name)}[\s,.)]", name)

    def test_a_package_without_a_text_is_refused(self):
        run, text = made_up("/*!\nThis file contains these packages.\n\nnone-such 1.0, MIT\n*/\n")
        self.assertEqual((run.returncode, text), (1, None))
        self.assertIn("no licence text of none-such 1.0, MIT", run.stderr)
        last = "\n----\n\nother 2.0, ISC\n\nIts own.\n*/\n"
        run, text = made_up("/*!\nPackages.\n\nnone-such 1.0, MIT\n" + last)
        self.assertEqual((run.returncode, text), (1, None))

    def test_a_page_without_licences_is_refused(self):
        run, text = made_up("")
        self.assertEqual((run.returncode, text), (1, None))
        self.assertIn("found no licences", run.stderr)

    def test_an_own_text_stays_and_the_code_is_left_out(self):
        _, text = made_up("/*!\nPackages.\n\nseedrandom 3.0, MIT\n\nIts own.\n*/\n")
        self.assertTrue(text.endswith("seedrandom 3.0, MIT\n\nIts own.\n"), text)


if __name__ == "__main__":
    unittest.main()
