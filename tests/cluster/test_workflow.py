"""The options of a scene by examples/cluster/Snakefile with two local jobs, and by one process.

    test_workflow.py SOURCE VASOROD SNAKEMAKE
"""

import csv
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SOURCE, VASOROD, SNAKEMAKE = (Path(word).resolve() for word in sys.argv[1:4])

SCENE = (
    (SOURCE / "tests" / "program" / "small_glenn.yaml").read_text()
    + """
explore:
  incision_along: [0.5, 0.01]
  around_deg: 0
  rotation_deg: [0, 30, 60]
  stages: [rod, skin]
  best: 2
"""
)


def rows_of(folder):
    """The table without times, which differ from run to run."""
    with open(folder / "options.csv", newline="") as file:
        return [{**row, "seconds": bool(row["seconds"])} for row in csv.DictReader(file)]


class Workflow(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)
        self.scene = self.folder / "scene.yaml"
        self.scene.write_text(SCENE)

    def workflow(self):
        command = [SNAKEMAKE, "-s", SOURCE / "examples/cluster/Snakefile", "--cores", "2"]
        command += ["--config", f"scene={self.scene}", f"folder={self.folder / 'jobs'}"]
        command += [f"vasorod={VASOROD}"]
        done = subprocess.run(command, cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout + done.stderr

    def test_jobs_make_the_table_of_one_process(self):
        said = self.workflow()
        self.assertIn("option", said)
        subprocess.run([VASOROD, "explore", self.scene, "-o", self.folder / "one"], check=True)
        jobs, one = rows_of(self.folder / "jobs"), rows_of(self.folder / "one")
        self.assertEqual(len(jobs), 6)
        self.assertEqual(jobs, one)
        self.assertEqual([row["fidelity"] for row in jobs][:2], ["skin", "skin"])
        self.assertIn("not_built", {row["ending"] for row in jobs})
        for part in ("finished", "options"):
            names = [
                sorted(path.name for path in (self.folder / run / part).iterdir())
                for run in ("jobs", "one")
            ]
            self.assertEqual(*names)
        self.assertTrue((self.folder / "jobs/index.html").exists())
        self.assertIn("Nothing to be done", self.workflow())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
