"""The study of tubes under pressure: scenes are what their names say, the tables' numbers are those
of the results, the chapters say what the tables say. Usage: inflated.py SOURCE_FOLDER VASOROD."""

import math
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(sys.argv[1]) / "benchmarks" / "study"))
import inflated  # noqa: E402
from chapters.inflated import bends_section, loads_section  # noqa: E402
from finished import comparing, leave  # noqa: E402
from pressure import solved  # noqa: E402
from store import Store  # noqa: E402
from tables import read_table  # noqa: E402

runs = inflated.all_runs()
assert len({run.identity for run in runs}) == len(runs) == 72
vessel = inflated.scene("twist", 10)["vessels"][0]
assert vessel["pressure"] == {"after": 10} and vessel["law"] == "neo-hookean"

# A ring collapses at E t^3 / (4 (1 - nu^2) R^3), and Brazier's curvature grows with the pressure.
assert math.isclose(inflated.collapse_pressure(), 1e-3 / (4 * (1 - 0.45**2)))
assert math.isclose(inflated.brazier_curvature(3) / inflated.brazier_curvature(0), 2)
for ratio in inflated.RATIOS:
    bent = inflated.bend_scene("rigid", 0.8, ratio)
    angle = math.radians(bent["ends"][1]["rotate_deg"][1])
    assert math.isclose(angle / 200, 0.8 * inflated.brazier_curvature(ratio))
    x, _, z = bent["ends"][1]["move"]  # an arc of that length: its chord
    assert math.isclose(math.hypot(x, 200 + z), 2 * 200 / angle * math.sin(angle / 2))
    pressure = bent["vessels"][0].get("pressure", {"scan": 0, "after": 0})
    assert pressure["scan"] == pressure["after"] == ratio * inflated.collapse_pressure()


def result(status, moment, flattening, own_error=None):
    return {
        "status": status,
        "model": {"vertices": 9},
        "metrics": [{"flattening": flattening}],
        "ends": [{}, {"force": [0.0, 0.0, 2.0], "moment": [0.0, moment, 0.0]}],
        "certificate": {"notes": []},
        "discretisation": {"error_estimate": own_error},
        "validity": {"wrinkling_ratio": 0.3},
    }


with tempfile.TemporaryDirectory() as scratch:
    folder = Path(scratch)
    line = {"rms": 0.1, "largest": 0.2}
    surface = {"rms": 0.0002, "largest": 0.0009}
    vessels = [{"vessel": "tube", "radius": 3.3, "surface": surface, "centerline": line}]
    store = Store(folder / "runs", {"vasorod": comparing(folder, vessels)})
    leave(
        store,
        [
            (inflated.hybrid_run("bend", 5), result("converged", 6.6, 0.2), 0),
            (inflated.shell_run("bend", 5), result("equilibrium_only", 6.93, 0.1, 1e-5), 1),
            (inflated.hybrid_run("bend", 10), result("buckled", 6.6, 0.2), 1),
            (inflated.shell_run("bend", 10), result("equilibrium_only", 6.93, 0.1, 1e-5), 1),
            (inflated.bend_run("soft", 0.2, 0), result("converged", 5.0, 0.04), 0),
            (inflated.bend_run("soft", 0.2, 1), result("converged", 5.0, 0.019), 0),
            (inflated.bend_run("rigid", 0.8, 5), result("buckled", 5.0, 0.6), 1),
        ],
    )
    inflated.make_tables(store, folder)
    loads = read_table(folder / inflated.FILE)
    bends = read_table(folder / inflated.BENDS)
assert [row["failure"] for row in loads[0]] == [None, "status buckled"], loads
text = loads_section(*loads)
assert (
    "| coupled | bend | 5 | 0.020 | 0.090 | 0.000 | 4.762 | 0.001 | 0.2000 | 0.1000 |" in text
), text
assert "| coupled | bend | 10 | status buckled | -" in text, text
text = bends_section(*bends)
assert "| soft | 0.2 | 1 | converged | 0.0190 | 0.475 | 0.500 | 5 | 0.30 | 2.0 |" in text, text
assert "| rigid | 0.8 | 5 | status buckled | - | - | - | - | - | 2.0 |" in text, text

# The program reads the scenes, and its answer has what the study reads.
with tempfile.TemporaryDirectory() as scratch:
    store = Store(scratch, {"vasorod": sys.argv[2]})
    inflated.TUBE.update(around=16, along=16)
    runs = [inflated.hybrid_run("stretch", 10, fidelity) for fidelity in inflated.FIDELITIES]
    runs.append(inflated.bend_run("soft", 0.2, 1))
    for run in runs:
        assert solved(store, store.ensure(run)), run.identity
    rows, _ = inflated.bend_rows(store)
    assert [row["failure"] for row in rows] == [None]
    assert 0 < rows[0]["flattening"] < 0.02 and rows[0]["moment"] > 0, rows
