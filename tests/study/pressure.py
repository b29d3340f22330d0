"""The study of joins under pressure: scenes are what their names say, the table's numbers are those
of the results, the chapter says what its table says. Usage: pressure.py SOURCE_FOLDER VASOROD."""

import sys
import tempfile
from pathlib import Path

import yaml

sys.path.insert(0, str(Path(sys.argv[1]) / "benchmarks" / "study"))
import join  # noqa: E402
import pressure  # noqa: E402
from chapters.pressure import limit_of, pressure_section, shells_section  # noqa: E402
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
# Three lengths, four pressures and three meshes, a finest and the ellipse; of the shell a run each,
# and two finer ones.
assert len({run.identity for run in runs}) == len(runs) == 3 * 4 * 3 + 2 + 3 * 4 + 1 + 2
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
text = pressure_section(rows, notes)
assert "| slit | 1 | 5 | 60 | 20.00 | 21.00 | +5.00 | 10.00 x 3.00 | +5.00 | +0.00 |" in text, text
assert "| slit | 1 | 10 | 60 | status iteration_limit | -" in text, text
assert "own error is at most 0.10 %" in " ".join(text.split()), text
assert "over its meshes" not in text
slit = dict(zip(("opening", "length", "pressure"), pressure.PAPERS))
meshes = [
    {**slit, "around": n, "mouth": 20 - 2 * (10 / n) ** 2, "failure": None}
    for n in (20, 40, 60, 80)
]
assert limit_of(meshes).endswith("goes to 20.00 mm2 over its meshes, with order 2.0.")
text = shells_section(*shells)
assert "| 24 | status iteration_limit |" in text, text
meshes = {"unknowns": 9, "support": 1, "energy": 1, "seconds": 1, "failure": None}
rows = [{"cells": n, "mouth": 20 - 2 * (12 / n) ** 2, **meshes} for n in (24, 36, 48)]
text = " ".join(shells_section(rows, shells[1]).split())
assert "goes to 20.00 mm2 with order 2.0" in text and "| 24 | 9 | 19.500 |" in text, text

# The program's answer has the keys that the study reads.
with tempfile.TemporaryDirectory() as scratch:
    store = Store(scratch, {"vasorod": sys.argv[2]})
    run = pressure.hybrid_run("ellipse", 1.0, 10, 24)
    assert pressure.solved(store, store.ensure(run))
    assert result_of(store, run.identity)["balance"][0]["pressure"]
