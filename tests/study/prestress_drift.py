"""The study of drift: scenes are what their names say, the table's numbers are those of the
results, the chapter says what its table says. Usage: prestress_drift.py SOURCE_FOLDER VASOROD."""

import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(sys.argv[1]) / "benchmarks" / "study"))
import prestress_drift as drift  # noqa: E402
from chapters.prestress import drift_section  # noqa: E402
from finished import comparing, leave  # noqa: E402
from store import Store  # noqa: E402
from tables import read_table  # noqa: E402

made = drift.anatomy_scene("infant")
assert [vessel["name"] for vessel in made["vessels"]] == ["svc", "pulmonary_artery"]
assert "surgery" not in made and {end["vessel"] for end in made["ends"]} == {
    "svc",
    "pulmonary_artery",
}
for vessel in made["vessels"]:
    assert vessel["pressure"]["scan"] == vessel["pressure"]["after"] > 0
    assert vessel["axial_prestretch"] > 1
for vessel in drift.emptied(made)["vessels"]:
    assert "pressure" not in vessel and "axial_prestretch" not in vessel
assert made["vessels"][0]["pressure"]  # the scene itself is as it was

pairs = list(drift.pairs())
assert len({tuple(names.values()) for names, *_ in pairs}) == len(pairs)
assert {run.program for run in drift.all_runs()} == {"vasorod", "vasorod-fem"}

with tempfile.TemporaryDirectory() as scratch:
    folder = Path(scratch)
    moved = {"rms": 1e-13, "largest": 3e-12}
    store = Store(
        folder / "runs",
        {"vasorod": comparing(folder, [{"vessel": "tube", "radius": 3, "surface": moved}] * 2)},
    )
    law = "neo-hookean"
    leave(
        store,
        [
            (drift.run("curved", law, "coupled", seen=False), {"status": "converged"}, 0),
            (drift.run("curved", law, "coupled"), {"status": "converged"}, 0),
            (drift.run("curved", law, "solid"), {"status": "equilibrium_only"}, 1),
            (drift.run("curved", law, "section"), {"status": "iteration_limit"}, 1),
        ],
    )
    drift.make_table(store, folder / drift.FILE)
    rows, notes = read_table(folder / drift.FILE)
assert [row["drift"] for row in rows] == [None, 3e-12, 3e-12], rows
text = drift_section(rows, notes)
assert "| curved tube at 12 mmHg | neo-hookean | `solid` | 3.0e-12 | 2.0 |" in text, text
assert "`section` | status iteration_limit | - |" in text, text

# The program says so.
drift.inflated.TUBE.update(around=16, along=16)
with tempfile.TemporaryDirectory() as scratch:
    store = Store(scratch, {"vasorod": sys.argv[2]})
    for model in drift.HYBRID:
        store.ensure(drift.run("both", "biot", model))
    store.ensure(drift.run("both", "biot", "coupled", seen=False))
    rows, _ = drift.rows(store)
assert len(rows) == 2 and all(0 <= row["drift"] < 1e-9 for row in rows), rows
