"""The study of tubes under pressure and a load: scenes are what their names say, the table's
numbers are those of the results, the chapter says what the table says. Usage: inflated.py
SOURCE_FOLDER VASOROD."""

import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(sys.argv[1]) / "benchmarks" / "study"))
import inflated  # noqa: E402
from chapters.inflated import loads_section  # noqa: E402
from finished import comparing, leave  # noqa: E402
from pressure import solved  # noqa: E402
from store import Store  # noqa: E402
from tables import read_table  # noqa: E402

runs = inflated.all_runs()
assert len({run.identity for run in runs}) == len(runs) == 32
vessel = inflated.scene("twist", 10)["vessels"][0]
assert vessel["pressure"] == {"after": 10} and vessel["law"] == "neo-hookean"


def result(status, moment, flattening, own_error=None):
    return {
        "status": status,
        "model": {"vertices": 9},
        "metrics": [{"flattening": flattening}],
        "ends": [{}, {"force": [0.0, 0.0, 2.0], "moment": [0.0, moment, 0.0]}],
        "certificate": {"notes": []},
        "discretisation": {"error_estimate": own_error},
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
        ],
    )
    inflated.make_table(store, folder / inflated.FILE)
    loads = read_table(folder / inflated.FILE)
assert [row["failure"] for row in loads[0]] == [None, "status buckled"], loads
text = loads_section(*loads)
assert (
    "| coupled | bend | 5 | 0.020 | 0.090 | 0.000 | 4.762 | 0.001 | 0.2000 | 0.1000 |" in text
), text
assert "| coupled | bend | 10 | status buckled | -" in text, text

# The program reads the scenes, and its answer has what the study reads.
with tempfile.TemporaryDirectory() as scratch:
    store = Store(scratch, {"vasorod": sys.argv[2]})
    inflated.TUBE.update(around=16, along=16)
    for fidelity in inflated.FIDELITIES:
        run = inflated.hybrid_run("stretch", 10, fidelity)
        assert solved(store, store.ensure(run)), run.identity
