"""The study of bends under pressure: scenes are what their names say, the tables' numbers are those
of the results, the chapters say what the tables say. Usage: inflated_bends.py SOURCE_FOLDER
VASOROD."""

import math
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(sys.argv[1]) / "benchmarks" / "study"))
import inflated_bends as bends  # noqa: E402
import kinks  # noqa: E402
from chapters.inflated import bends_section, kinks_section  # noqa: E402
from finished import leave  # noqa: E402
from store import Store  # noqa: E402
from tables import read_table  # noqa: E402

runs = bends.all_runs()
assert len({run.identity for run in runs}) == len(runs) == 40
runs = kinks.all_runs()
assert len({run.identity for run in runs}) == len(runs) == 42

# A ring collapses at E t^3 / (4 (1 - nu^2) R^3), and Brazier's curvature grows with the pressure.
assert math.isclose(bends.collapse_pressure(), 1e-3 / (4 * (1 - 0.45**2)))
assert math.isclose(bends.brazier_curvature(3) / bends.brazier_curvature(0), 2)
for ratio in bends.RATIOS:
    bent = bends.scene("rigid", 0.8, ratio)
    angle = math.radians(bent["ends"][1]["rotate_deg"][1])
    assert math.isclose(angle / 200, 0.8 * bends.brazier_curvature(ratio))
    x, _, z = bent["ends"][1]["move"]  # an arc of that length: its chord
    assert math.isclose(math.hypot(x, 200 + z), 2 * 200 / angle * math.sin(angle / 2))
    pressure = bent["vessels"][0].get("pressure", {"scan": 0, "after": 0})
    assert pressure["scan"] == pressure["after"] == ratio * bends.collapse_pressure()
# A ring's I = pi R^3 t (1 + (t / R)^2 / 4).
assert math.isclose(bends.bending_stiffness(), math.pi * 1000 * (1 + 0.0025))
# A clamped column bends by itself at 4 pi^2 E I / L^2: N L^2 / 12 E I is pi^2 / 3 there.
force = 4 * math.pi**2 * bends.bending_stiffness() / 100**2
ratio = force / (0.1 * bends.collapse_pressure() * math.pi * 100)
assert math.isclose(bends.compressed_stiffness(ratio), math.pi**2 / 3)


def result(status, moment, flattening):
    return {
        "status": status,
        "metrics": [{"flattening": flattening}],
        "ends": [{}, {"moment": [0.0, moment, 0.0]}],
        "validity": {"wrinkling_ratio": 0.3},
    }


curvature = 0.2 * bends.brazier_curvature(0)
with tempfile.TemporaryDirectory() as scratch:
    folder = Path(scratch)
    store = Store(folder / "runs", {})
    stiff = bends.bending_stiffness() * curvature  # the moment of a ring that keeps its shape
    left = [
        (bends.run("soft", 0.2, 0), result("converged", 0.9 * stiff, 0.04), 0),
        (bends.run("soft", 0.2, 1), result("converged", stiff, 0.019), 0),
        (bends.run("rigid", 0.8, 5), result("buckled", 5.0, 0.6), 1),
        (bends.run("rigid", 0.5, 1), result("converged", 4.0, 0.1), 0),
        (bends.run("rigid", 0.55, 1), result("buckled", 5.0, 0.6), 1),
        (bends.run("rigid", 0.6, 1), result("converged", 5.0, 0.6), 0),
        (bends.run("rigid", 0.35, 5), result("buckled", 5.0, 0.6), 1),
        (bends.run("rigid", 1.05, 0, around=48), result("converged", 4.0, 0.2), 0),
        (bends.run("rigid", 0.5, 1, around=48), result("converged", 4.0, 0.2), 0),
        (bends.run("rigid", 0.55, 1, around=48), result("iteration_limit", 4.0, 0.2), 1),
        (bends.run("rigid", 0.6, 1, around=48), result("buckled", 4.0, 0.2), 1),
    ]
    leave(store, left)
    bends.make_table(store, folder / bends.FILE)
    rows, notes = read_table(folder / bends.FILE)
    kinks.make_table(store, folder / kinks.FILE)
    found = read_table(folder / kinks.FILE)
assert [row["stiffness"] for row in rows[:1]] == [0.9], rows
text = bends_section(rows, notes)
assert (
    "| soft | 0.2 | 1 | converged | 0.0190 | 0.475 | 0.500 | 3.322 | 1.0000 | 0.30 | 2.0 |" in text
), text
assert "| rigid | 0.8 | 5 | status buckled | - | - | - | - | - | - | 2.0 |" in text, text
text = kinks_section(*found)
# Over Brazier's curvature without pressure; what lies beyond the first kink does not count, be it
# smooth again.
assert "| 1 | 32 | 0.71 to 0.78 | 0.5 to 0.55 | 4 | 0.1 | 0.30 |" in text, text
assert "| 5 | 32 | below 0.86 | 0.35 | - | - | - |" in text, text
assert "| 0 | 48 | beyond 1.05 | 1.05 | 4 | 0.2 | 0.30 |" in text, text
assert "At 1 p_c another mesh kinks elsewhere" in " ".join(text.split()), text
# A bend without an end is no kink, and neither is what comes after it.
assert "| 1 | 48 | beyond 0.71 | 0.5 | 4 | 0.2 | 0.30 |" in text, text

# The program reads the scenes, and its answer has what the study reads.
with tempfile.TemporaryDirectory() as scratch:
    store = Store(scratch, {"vasorod": sys.argv[2]})
    store.ensure(bends.run("soft", 0.2, 1))
    (row,), _ = bends.rows_of(store, bends.plan())
assert row["failure"] is None and 0 < row["flattening"] < 0.02, row
assert 0.9 < row["stiffness"] < 1, row
