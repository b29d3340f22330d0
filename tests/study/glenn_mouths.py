"""The study of the infant's mouth: scenes, table and chapter. Usage: glenn_mouths.py SOURCE_FOLDER
VASOROD."""

import math
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(sys.argv[1]) / "benchmarks" / "study"))
import glenn_mouths as mouths  # noqa: E402
import pressure  # noqa: E402
from chapters.pressure import infant_section  # noqa: E402
from finished import leave  # noqa: E402
from measure import result_of  # noqa: E402
from store import Store  # noqa: E402
from tables import read_table  # noqa: E402

made = mouths.scene(1.5, 10)
assert made["surgery"]["glenn"]["incision_length"] == 1.5
pressures = {one["name"]: one["pressure"] for one in made["vessels"] if "pressure" in one}
assert pressures["svc"] == {"scan": 5, "after": 10}
assert pressures["pulmonary_artery"] == {"scan": 15, "after": 10}
assert pressures["aorta"] == {"scan": 50, "after": 50}  # no part of the operation
runs = mouths.all_runs()
assert len({run.identity for run in runs}) == len(runs) == 12


def result(status):
    mouth = {"area": 30.0, "area_ratio": 0.9, "span": 15.0}
    mouth |= {"perimeter": 12 * math.pi, "perimeter_ratio": 1.2}  # a cut end of diameter 10
    return {
        "status": status,
        "glenn": {"mouth": mouth},
        "validity": {"largest_strain": 0.21},
    }


with tempfile.TemporaryDirectory() as scratch:
    folder = Path(scratch)
    store = Store(folder / "runs", {})
    left = [
        (mouths.run(1.25, 5), result("converged"), 0),
        (mouths.run(1.5, 0), result("iteration_limit"), 1),
    ]
    leave(store, left)
    mouths.make_table(store, folder / mouths.FILE)
    rows, notes = read_table(folder / mouths.FILE)
text = infant_section(rows, notes)
assert "| 1.25 | 5 | 30.0 | 0.90 | 1.50 | 1.20 | 0.21 | 2.0 |" in text, text
assert "| 1.5 | 0 | status iteration_limit | - |" in text, text

# The program's answer has the keys that the study reads.
with tempfile.TemporaryDirectory() as scratch:
    store = Store(scratch, {"vasorod": sys.argv[2]})
    small = pressure.hybrid_run("ellipse", 1.0, 10, 24)
    store.ensure(small)
    numbers = mouths.numbers(result_of(store, small.identity))
assert set(numbers) == set(mouths.COLUMNS) and all(value > 0 for value in numbers.values()), numbers
# The cut end of a vein of R 3.3 goes around a circle of that radius.
assert 0.8 < numbers["span"] < 1.6 and 0.9 < numbers["perimeter_ratio"] < 1.3, numbers
