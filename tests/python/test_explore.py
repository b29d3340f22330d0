"""Explorations: the program's numbers, resumed, stopped, refused."""

import csv
import json
import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

import vasorod
import yaml
from cases import SOURCE, program


def small(**explore):
    """A shunt of two generated tubes, as a dict, with its options."""
    scene = yaml.safe_load((SOURCE / "tests" / "program" / "small_glenn.yaml").read_text())
    return {**scene, "explore": explore}


class Explorations(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name) / "dir"
        self.scene_file = Path(scratch.name) / "scene.yaml"

    def explore(self, options=None, **more):
        scene = small(**(options or {"rotation_deg": [0, 40, -70], "stages": "skin"}))
        return vasorod.explore(scene, self.folder, report=False, **more)

    def test_has_the_rows_of_the_program(self):
        options = {"incision_along": [0.5, 0.02], "around_deg": 0, "stages": "skin"}
        options["rotation_deg"] = [0, 40, -70]
        done = self.explore(options)
        self.scene_file.write_text(json.dumps(small(**options)))
        other = self.folder.with_name("other")
        program("explore", self.scene_file, "-o", other, "--no-report")
        with open(other / "options.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), 6)
        self.assertTrue(done.finished)
        for mine, row in zip(done.options, rows, strict=True):
            self.assertEqual(mine["option"], row["option"])  # also the names: one folder serves
            self.assertEqual(str(mine["rank"] or ""), row["rank"])
            self.assertEqual(mine["status"] or "", row["status"])
            self.assertEqual(mine["mark"], row["mark"])
            self.assertEqual("; ".join(mine["past"]), row["past"])
            said = "; ".join(mine["sentences"])
            if mine["ending"] == "not_built":  # it begins with the file, or the dict's name
                said = said.partition(": ")[2]
                self.assertIn("incision", said)
            self.assertTrue(row["sentence"].endswith(said))
            for key, value in mine["values"].items():
                self.assertEqual(value, row[key])
            for name, value in mine["criteria"].items():
                self.assertAlmostEqual(float(row[name]) / (value or 1), bool(value), places=5)
        self.assertEqual({row["ending"] for row in rows}, {"solved", "not_built"})

    def test_goes_on_where_it_was(self):
        self.assertEqual(self.explore().found, 0)
        again = self.explore({"rotation_deg": [0, 40, -70, 15], "stages": "skin"})
        self.assertEqual((again.found, len(again.options)), (3, 4))

    def test_searches_and_samples_of_a_dict_are_those_of_its_file(self):
        options = {"rotation_deg": [0, 40], "stages": "rod", "refine": {"evaluations": 2}}
        wall = {"what": "young", "factor": [0.5, 2]}
        options["vary"] = {"uncertain": [wall], "samples": 3, "best": 2}
        done = self.explore(options)
        self.assertIn(True, [row["refined"] for row in done.options])
        self.assertEqual(done.ranking["samples"], 3)
        self.scene_file.write_text(json.dumps(small(**options)))
        other = vasorod.explore(self.scene_file, self.folder, report=False)
        self.assertGreater(other.found, 3)
        self.assertEqual(other.ranking, done.ranking)
        first = done.options[0]["samples"]
        self.assertEqual(other.options[0]["samples"], first)
        low, high = first["intervals"]["stretch"]
        self.assertLessEqual(low, high)
        self.assertIsNone(self.explore().ranking)

    def test_a_surface_in_memory_is_known_again(self):
        done = []
        for _ in range(2):
            scene = small(rotation_deg=[0, 30], stages="rod")
            artery = scene["vessels"][1]
            alone = {"scene": "a", "units": scene["units"], "fidelity": "skin"}
            alone["vessels"] = [dict(artery)]
            alone["ends"] = [{"vessel": "rpa", "end": "start", "hold": True}]
            tube = vasorod.solve(alone).vessels["rpa"]
            artery["surface"] = (tube.rest, tube.triangles)
            del artery["tube"]
            done.append(vasorod.explore(scene, self.folder, report=False))
        self.assertEqual([one.found for one in done], [0, 2])

    def test_says_what_it_does(self):
        said = []
        self.explore(progress=said.append)
        self.assertIn("fitting vessel svc", said)
        self.assertEqual([line for line in said if "3 of 3" in line], ["skin: 3 of 3"])

    def test_stages_and_best_override_the_scenes(self):
        done = self.explore(stages=["rod", "skin"], best=1)
        self.assertEqual([row["fidelity"] for row in done.options], ["skin", "rod", "rod"])

    def test_wrong_arguments_are_one_sentence(self):
        for arguments, sentence in (
            ({"stages": "skin"}, "stages: found 'skin', expected a list of rod, skin"),
            ({"stages": ["fine"]}, r"stages: found \['fine'\]"),
            ({"best": 0}, "best: found 0, expected 1 to 1000"),
            ({"threads": 0}, "threads: found 0"),
            ({"time_limit": float("nan")}, "time_limit: found nan"),
            ({"options": {"cut_along": 2}}, "explore.cut_along: found 2"),
        ):
            with self.assertRaisesRegex(ValueError, sentence):
                self.explore(**arguments)
        self.assertFalse(self.folder.exists())

    def test_what_is_not_ours_is_left_alone(self):
        self.folder.mkdir()
        (self.folder / "mine").write_text("x")
        with self.assertRaisesRegex(OSError, "holds files but no exploration of ours"):
            self.explore()

    def test_the_time_limit_stops_with_what_is_finished(self):
        many = {"cut_along": {"from": 0.3, "to": 0.8, "steps": 40}, "rotation_deg": [0, 10, 20]}
        done = self.explore({**many, "stages": "skin"}, time_limit=2)
        self.assertFalse(done.finished)
        self.assertEqual(len(done.options), 120)
        self.assertIn("open", {row["ending"] for row in done.options})

    def test_what_progress_raises_ends_it(self):
        class Enough(Exception):
            pass

        def progress(line):
            if "1 of" in line:
                raise Enough

        with self.assertRaises(Enough):
            self.explore(progress=progress, threads=1)
        self.assertGreater(self.explore().found, 0)

    def begun(self):
        """A Python that explores many options and has finished one."""
        many = {"cut_along": {"from": 0.3, "to": 0.8, "steps": 40}, "rotation_deg": [0, 10, 20]}
        code = (
            "import sys, vasorod\n"
            f"sys.path.insert(0, {str(Path(__file__).parent)!r})\n"
            "from test_explore import small\n"
            "def progress(line):\n"
            "    if '1 of' in line: print('begun', flush=True)\n"
            f"vasorod.explore(small(**{many!r}, stages='skin'), {str(self.folder)!r},\n"
            "                report=False, progress=progress)\n"
        )
        child = subprocess.Popen(
            [sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL
        )
        self.addCleanup(child.stdout.close)
        self.assertEqual(child.stdout.readline(), b"begun\n")
        return child

    def test_ctrl_c_writes_the_table(self):
        child = self.begun()
        child.send_signal(signal.SIGINT)
        self.assertEqual(child.wait(timeout=60), -signal.SIGINT)  # as KeyboardInterrupt ends it
        with open(self.folder / "options.csv", newline="") as file:
            endings = {row["ending"] for row in csv.DictReader(file)}
        self.assertEqual(endings, {"solved", "open"})

    def test_ends_with_the_python_that_began_it(self):
        child = self.begun()
        child.kill()
        child.wait()
        for _ in range(200):
            time.sleep(0.1)
            if not processes_about(self.folder):
                return
        self.fail(f"goes on: {processes_about(self.folder)}")


def processes_about(folder):
    """Those that hold a file below a folder open: an exploration holds its lock."""
    found = []
    for process in Path("/proc").glob("[0-9]*"):
        try:
            links = [os.readlink(link) for link in (process / "fd").iterdir()]
        except OSError:
            continue
        if any(link.startswith(str(folder)) for link in links):
            found.append(process.name)
    return found


if __name__ == "__main__":
    unittest.main()
