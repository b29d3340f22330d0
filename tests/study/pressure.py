"""The study of joins under pressure: scenes are what their names say, the table's numbers are those
of the results, the chapter says what its table says. Usage: pressure.py SOURCE_FOLDER VASOROD."""

import sys
import tempfile
from pathlib import Path

import yaml

sys.path.insert(0, str(Path(sys.argv[1]) / "benchmarks" / "study"))
import chapters.pressure as chapter  # noqa: E402
import join  # noqa: E402
import pressure  # noqa: E402
from finished import comparing, leave  # noqa: E402
from measure import result_of  # noqa: E402
from store import Store  # noqa: E402
from tables import read_table  # noqa: E402

made = yaml.safe_load(pressure.scene("ellipse", 1.25, 10, 80))
unpressed = yaml.safe_load(join.scene("ellipse", 1.0, "neo-hookean", 80, 1.25))
assert made["units"].pop("pressure") == "mmHg"
for vessel in made["vessels"]:
    assert vessel.pop("pressure") == {"after": 10}
assert made == unpressed

runs = pressure.all_runs()
# Three lengths, four pressures and three meshes, four finest and the ellipse; of the shell a run
# each, without pressure those of the join, and two finer ones.
assert len({run.identity for run in runs}) == len(runs) == 3 * 4 * 3 + 4 + 1 + 3 * 4 + 1 + 2
assert pressure.shell_run("slit", 1.25, 0) == join.shell_run("slit", 1.0, "neo-hookean", 1.25)
assert "pressure" not in pressure.scene("slit", 1.0, 0, 60)
assert {run.program for run in runs} == {"vasorod", "vasorod-fem"}


def result(fidelity, status, mouth, energy, own_error=None):
    return {
        "fidelity": fidelity,
        "status": status,
        "glenn": {"mouth": {"area": mouth, "span": 10.0, "width": 3.0}},
        "energy": {"total": energy},
        "ends": [{"force": [0.0, 3.0, 4.0]}],
        "discretisation": {"error_estimate": own_error},
    }


# A compare that answers; results and records as the programs leave them. The reference certifies no
# minimum under a pressure; at `iteration_limit` there is no solution.
with tempfile.TemporaryDirectory() as scratch:
    folder = Path(scratch)
    vessels = [{"vessel": name, "surface": {"rms": 0.002}} for name in ("vein", "artery")]
    store = Store(folder / "runs", {"vasorod": comparing(folder, vessels)})
    finished = [
        (pressure.shell_run("slit", 1.0, 5), result("shell", "equilibrium_only", 20, 0.2, 1e-3), 1),
        (pressure.hybrid_run("slit", 1.0, 5), result("coupled", "converged", 21, 0.21), 0),
        (pressure.shell_run("slit", 1.0, 10), result("shell", "iteration_limit", 9, 0.9), 1),
        (pressure.hybrid_run("slit", 1.0, 10), result("coupled", "converged", 9, 0.9), 0),
    ]
    leave(store, finished)
    pressure.make_tables(store, folder)
    rows, notes = read_table(folder / pressure.FILE)
    shells = read_table(folder / pressure.SHELL_FILE)
assert [(row["pressure"], row["failure"]) for row in rows] == [
    (5, None),
    (10, "status iteration_limit"),
], rows
text = chapter.pressure_section(rows, notes)
assert "| slit | 1 | 5 | 60 | 20.00 | 21.00 | +5.00 | 10.00 x 3.00 | +5.00 | +0.00 |" in text, text
assert "| slit | 1 | 10 | 60 | status iteration_limit | -" in text, text
assert "own error is at most 0.10 % under pressure." in " ".join(text.split()), text
errors = [{"pressure": p, "own_error": 0.01 * (1 + p), "failure": None} for p in (0, 1, 2)]
assert (
    chapter.own_errors(errors)
    == "The shell's own error is at most 3.00 % under pressure, 1.00 % without."
)
slit = {"opening": "slit", "length": 1, "pressure": 10, "mouth_reference": 16, "failure": None}


def meshes_of(order):
    """A mouth that goes to 20, with an error of that order."""
    return [
        {**slit, "around": n, "mouth": 20 - 2 * (10 / n) ** order} for n in (120, 20, 40, 60, 80)
    ]


assert "| 10 | 19.500 (20), " in chapter.order_table(meshes_of(2)), chapter.order_table(
    meshes_of(2)
)
assert "| 2.0 | 20.000 | +25.00 |" in chapter.order_table(meshes_of(2)), chapter.order_table(
    meshes_of(2)
)
# Beyond the orders that are looked for there is no limit to be read off.
assert "| - | - | - |" in chapter.order_table(meshes_of(0.1)), chapter.order_table(meshes_of(0.1))
assert "| 10 |" not in chapter.order_table(meshes_of(2)[:3])
text = chapter.shells_section(*shells)
assert "| 24 | status iteration_limit |" in text, text
meshes = {"unknowns": 9, "support": 1, "energy": 1, "seconds": 1, "failure": None}
rows = [{"cells": n, "mouth": 20 - 2 * (12 / n) ** 2, **meshes} for n in (24, 36, 48)]
text = " ".join(chapter.shells_section(rows, shells[1]).split())
assert "the mouth changes by 1.92 %" in text and "| 24 | 9 | 19.500 |" in text, text

# The program's answer has the keys that the study reads.
with tempfile.TemporaryDirectory() as scratch:
    store = Store(scratch, {"vasorod": sys.argv[2]})
    run = pressure.hybrid_run("ellipse", 1.0, 10, 24)
    assert pressure.solved(store, store.ensure(run))
    assert result_of(store, run.identity)["balance"][0]["pressure"]
