"""The study of tubes that a pressure widens: scenes, closed form, table and chapter. Usage:
widening.py SOURCE_FOLDER VASOROD."""

import math
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(sys.argv[1]) / "benchmarks" / "study"))
import widening  # noqa: E402
from chapters.inflated import widening_section  # noqa: E402
from finished import comparing, leave  # noqa: E402
from store import Store  # noqa: E402
from tables import read_table  # noqa: E402

# Lame's tube of R 10 and t 1 moves by .881404 (nu .3) and .746255 (nu .5) at E / 100; a thin tube
# of nu .5 by .025 at p_c.
for poisson, moved in ((0.3, 0.881404), (0.5, 0.746255)):
    ratio = 0.01 / widening.pressure_of(poisson, 1)
    assert math.isclose(widening.closed_form(poisson, ratio), moved / 10, rel_tol=1e-6)
assert math.isclose(widening.closed_form(0.5, 1), 0.0025, rel_tol=0.01)
runs = widening.all_runs()
assert len({run.identity for run in runs}) == len(runs) == 3 + 2 * (4 + 4 + 2)

with tempfile.TemporaryDirectory() as scratch:
    folder = Path(scratch)
    vessel = {"vessel": "tube", "radius": 10, "surface": {"rms": 0.0025, "largest": 0.0026}}
    vessel["centerline"] = {"rms": 0.0, "largest": 0.0}
    store = Store(folder / "runs", {"vasorod": comparing(folder, [vessel])})
    leave(
        store,
        [
            (widening.empty(0.5), {"status": "converged"}, 0),
            (widening.run("section", 0.5, 1), {"status": "converged"}, 0),
            (widening.run("coupled", 0.5, 1), {"status": "iteration_limit"}, 1),
        ],
    )
    widening.make_table(store, folder / widening.FILE)
    rows, notes = read_table(folder / widening.FILE)
text = widening_section(rows, notes)
assert "| 0.5 | 1 | `section` | 0.002500 | 0.002488 | +0.50 |" in text, text
assert "| 0.5 | 1 | `coupled` | status iteration_limit | - | - |" in text, text

# The program widens so: within the terms in (t / R)^2 and the strain that the closed form lacks.
with tempfile.TemporaryDirectory() as scratch:
    store = Store(scratch, {"vasorod": sys.argv[2]})
    for run in (widening.empty(0.5), widening.run("coupled", 0.5, 1)):
        store.ensure(run)
    (row,), _ = widening.rows(store)
assert abs(row["widening"] / row["closed_form"] - 1) < 0.01, row
assert abs(row["widening"] - 0.0025) < 0.01 * 0.0025, row
