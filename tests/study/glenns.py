"""The study of Glenn shunts on the adult anatomy: scenes are what their names say, the table's rows
are those of the results, the chapter counts them. Usage: glenns.py SOURCE_FOLDER VASOROD."""

import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(sys.argv[1]) / "benchmarks" / "study"))
import glenns  # noqa: E402
from chapters.limits import folded_section, glenn_section  # noqa: E402
from chapters.limits_answers import folded_answer  # noqa: E402
from finished import leave  # noqa: E402
from store import Store  # noqa: E402
from tables import read_table  # noqa: E402

runs = [glenns.run(*pick) for pick in glenns.picks()]
assert len({run.identity for run in runs}) == len(runs) == 24
folded = [glenns.folded_run(*pick) for pick in glenns.folded()]
assert len({run.identity for run in runs + folded}) == 24 + 48
assert glenns.all_runs() == (runs + folded if glenns.has_anatomy() else [])
plain = glenns.scene(0, "low", "upper side", 45)
assert not any("pressure" in vessel or "law" in vessel for vessel in plain["vessels"])
assert plain["surgery"]["glenn"]["incision_length"] == 1.25
assert glenns.scene(12, "low", "upper side", 45)["vessels"][0]["pressure"]["after"] == 12
glenn = glenns.scene(0, "low", "upper side", -60)["surgery"]["glenn"]
assert glenn["cut"] == glenns.CUTS["low"] and glenn["rotation_deg"] == -60
assert glenn["svc"] == "svc" and glenn["keep"], "what is not picked stays the scene's"


def result(status, crossings=(), notes=()):
    return {
        "status": status,
        "ends": [],
        "balance": [],
        "energy": {},
        "metrics": [],
        "certificate": {"notes": list(notes)},
        "validity": {"largest_strain": 0.7},
        "self_intersections": list(crossings),
    }


crossing = {"a": "svc", "b": "svc", "depth": 1.25}
endings = [result("converged")] * 22
endings += [result("self_intersecting", [crossing]), result("interrupted", notes=["too long"])]
glenns.has_anatomy = lambda: True
with tempfile.TemporaryDirectory() as scratch:
    folder = Path(scratch)
    store = Store(folder / "study", {})
    glenns.make_table(store, folder / glenns.FILE)
    assert not (folder / glenns.FILE).exists(), "a share of the runs is no table"
    leave(
        store,
        [(one, end, int(end["status"] != "converged")) for one, end in zip(runs, endings)],
    )
    glenns.make_table(store, folder / glenns.FILE)
    rows, notes = read_table(folder / glenns.FILE)
assert [row["ending"] for row in rows[-2:]] == ["self_intersecting", "interrupted"]
assert rows[-2]["crossings"] == "svc, svc: 1.25" and rows[-1]["sentence"] == "too long"
assert rows[0]["strain"] == 0.7 and rows[-1]["strain"] is None
text = "\n".join(glenn_section(rows, notes))
assert "`converged` 22 of 24 (91.7 %), `self_intersecting` 1 of 24 (4.2 %)" in " ".join(
    text.split()
), text
assert "| low | towards the vein | -60 | interrupted | 2.0 | - | too long |" in text, text

with tempfile.TemporaryDirectory() as scratch:
    folder = Path(scratch)
    store = Store(folder / "study", {})
    endings = [result("buckled")] * 4 + [result("iteration_limit", notes=["half way"])] * 2
    endings += [result("converged")] * 42
    for end in endings:
        end["glenn"] = {"mouth": {"area_ratio": 0.75}}
    leave(
        store,
        [(one, end, int(end["status"] != "converged")) for one, end in zip(folded, endings)],
    )
    glenns.make_folded_table(store, folder / glenns.FOLDED_FILE)
    rows, notes = read_table(folder / glenns.FOLDED_FILE)
assert [row["pressure"] for row in rows] == [0] * 24 + [12] * 24
assert rows[0]["mouth"] == 0.75 and rows[5]["mouth"] is None and rows[5]["strain"] is None
text = " ".join("\n".join(folded_section(rows, notes)).split())
assert "Without pressure, law Biot: 22 of 24 (91.7 %) ended in such a minimum." in text, text
assert "With 12 mmHg after the operation, neo-Hookean: 24 of 24 (100.0 %) ended" in text, text
assert "| half way |" in text, text
answer = "\n".join(folded_answer(rows))
assert "| 12 mmHg | auto | 6 of 6 | 0.75 | 2.0 |" in answer, answer
