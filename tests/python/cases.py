"""What the tests of the Python package share: the built program, and small scenes as dicts."""

import json
import os
import subprocess
from pathlib import Path

SOURCE = Path(os.environ["VASOROD_SOURCE"])
PROGRAM = os.environ["VASOROD_PROGRAM"]


def program(*arguments):
    """Runs the program: (exit code, standard output, the sentence on standard error)."""
    run = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)
    return run.returncode, run.stdout, run.stderr.removeprefix("vasorod: ").removesuffix("\n")


def without_times(result):
    """A result.json without what differs between two runs."""
    return {key: value for key, value in result.items() if key != "seconds"}


def result_of(folder):
    """The result.json of a folder, without times."""
    return without_times(json.loads((Path(folder) / "result.json").read_text()))


def tube(fidelity="skin", stretch=0.05, around=24, along=36, **wall):
    """A tube of length 100 and radius 10 mm that is pulled by a strain; E = 1 MPa, t = 1 mm."""
    return {
        "scene": "pulled",
        "units": {"length": "mm", "stress": "MPa"},
        "vessels": [
            {
                "name": "tube",
                "tube": {"length": 100, "radius": 10, "around": around, "along": along},
                "wall": {"thickness": 1, "young": 1, "poisson": 0.3, **wall},
            }
        ],
        "ends": [
            {"vessel": "tube", "end": "start", "hold": True},
            {"vessel": "tube", "end": "end", "move": [0, 0, 100 * stretch]},
        ],
        "fidelity": fidelity,
    }


def beam(**end):
    """A straight bare rod of length 100 mm along x, clamped at its start; E I = 8.3e5 N mm^2."""
    stiffness = {"axial": 1e7, "shear": [5e6, 5e6], "bending": [8.3e5, 8.3e5], "torsion": 8.3e5}
    return {
        "scene": "beam",
        "units": {"length": "mm", "stress": "MPa"},
        "vessels": [
            {
                "name": "beam",
                "rod": {
                    "tangent": [1, 0, 0],
                    "normal": [0, 1, 0],
                    "position": [0, 0, 0],
                    "pieces": [{"length": 100, "elements": 20}],
                    "stiffness": stiffness,
                },
            }
        ],
        "ends": [
            {"vessel": "beam", "end": "start", "hold": True},
            {"vessel": "beam", "end": "end", **end},
        ],
        "fidelity": "rod",
    }


def long_solve():
    """A wide tube of 100,000 vertices that is bent at `paper`: minutes, in steps of seconds."""
    scene = tube("paper", around=400, along=250)
    scene["ends"][1] = {"vessel": "tube", "end": "end", "rotate_deg": [0, 20, 0]}
    return scene
