"""The installed tree is whole: its program solves its scene, also where the tree was moved to."""

import json
import os
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

from programs import BUILD, PROGRAMS, SOURCE, output


class Install(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        prefix = Path(folder.name) / "prefix"
        output(os.environ["VASOROD_CMAKE"], "--install", BUILD, "--prefix", prefix)
        self.prefix = Path(folder.name) / "moved"
        shutil.move(prefix, self.prefix)
        self.share = self.prefix / "share"

    def test_the_programs_run_and_a_scene_is_solved(self):
        for program in PROGRAMS:
            installed = self.prefix / "bin" / program.name
            self.assertEqual(output(installed, "--version"), output(program, "--version"))
        scene = self.share / "vasorod" / "benchmarks" / "cases" / "glenn" / "infant.yaml"
        result = self.prefix / "result"
        program = self.prefix / "bin" / "vasorod"
        output(program, "solve", scene, "--fidelity", "skin", "--no-report", "-o", result)
        self.assertEqual(json.loads((result / "result.json").read_text())["status"], "converged")

    def test_the_planner_plans_its_scene(self):
        program = self.prefix / "bin" / "vasorod-plan"
        if not program.is_file():
            self.skipTest("built without the planner")
        scene = self.share / "vasorod" / "benchmarks" / "cases" / "glenn" / "infant.yaml"
        said = output(sys.executable, SOURCE / "packaging" / "try_planner.py", program, scene)
        self.assertIn("predicted", said)

    def test_every_installed_scene_finds_its_surfaces(self):
        scenes = list((self.share / "vasorod").rglob("*.yaml"))
        self.assertGreater(len(scenes), 3)
        for scene in scenes:
            for line in scene.read_text().splitlines():
                if line.strip().startswith("surface: "):
                    surface = scene.parent / line.split(": ", 1)[1].strip()
                    self.assertTrue(surface.is_file(), f"{scene.name}: {surface}")

    def test_nothing_is_left_out(self):
        for program in PROGRAMS:
            completion = self.share / "bash-completion" / "completions" / program.name
            self.assertEqual(
                completion.read_text(),
                (SOURCE / "packaging" / "completion" / "vasorod.bash").read_text(),
            )
            page = self.share / "man" / "man1" / f"{program.name}.1"
            self.assertEqual(page.is_file(), (BUILD / "man" / page.name).is_file())
        if (self.prefix / "bin" / "vasorod-plan").is_file():
            licences = self.share / "doc" / "vasorod-plan" / "page-licences.txt"
            self.assertIn("Kitware", licences.read_text())
            self.assertEqual(list(self.prefix.rglob("libvasorod_planner*")), [])
        for name in ("scene", "result"):
            schema = self.share / "vasorod" / "schema" / f"{name}.schema.json"
            self.assertIn("$defs", json.loads(schema.read_text()))
        self.assertTrue((self.share / "doc" / "vasorod" / "CITATION.cff").is_file())


if __name__ == "__main__":
    unittest.main()
