"""The study of vessels with a stress as they were seen: scenes are what their names say, the
tables' numbers are those of the results, the chapters say what the tables say. Usage: prestress.py
SOURCE_FOLDER VASOROD."""

import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(sys.argv[1]) / "benchmarks" / "study"))
import inflated  # noqa: E402
import prestress  # noqa: E402
from chapters.prestress import joins_section, tubes_section  # noqa: E402
from finished import comparing, leave  # noqa: E402
from measure import result_of  # noqa: E402
from pressure import solved  # noqa: E402
from store import Store  # noqa: E402
from tables import read_table  # noqa: E402

runs = prestress.all_runs()
assert len({run.identity for run in runs}) == len(runs)
assert {run.program for run in runs} == {"vasorod", "vasorod-fem"}
released = prestress.tube_scene("release", "curved", "biot")
(vessel,) = released["vessels"]
assert vessel["axial_prestretch"] == 1.05 and vessel["tube"]["bend_deg"] == 40, vessel
# Half of E t (1.05 - 1) 2 pi R, what held ends carry.
force = 0.5 * 0.5 * 0.33 * 0.05 * 2 * 3.14159265 * 3.3
assert abs(released["ends"][1]["force"][2] / force - 1) < 1e-3
joined = prestress.join_scene("slit", 1.25, 1.05)
assert {one["name"]: one["pressure"] for one in joined["vessels"]} == prestress.PRESSURES
assert [one["axial_prestretch"] for one in joined["vessels"]] == [1.05, 1.05]


def result(fidelity, status, mouth, energy, own_error=None):
    return {
        "fidelity": fidelity,
        "status": status,
        "model": {"vertices": 9},
        "metrics": [{"flattening": 0.1}],
        "glenn": {"mouth": {"area": mouth, "span": 10.0, "width": 3.0}},
        "energy": {"total": energy},
        "ends": [
            {"force": [0.0, 3.0, 4.0], "moment": [0.0, 0.0, 0.0]},
            {"force": [0.0, 0.0, 2.0], "moment": [0.0, 0.0, 0.0]},
        ],
        "certificate": {"notes": []},
        "discretisation": {"error_estimate": own_error},
    }


def finished(pairs, mine, its):
    """Of the first pair both results, of the second a shell that does not arrive."""
    (*_, run, shell), (*_, second, other) = pairs
    return [
        (run, mine, 0),
        (shell, its, 1),
        (second, mine, 0),
        (other, {**its, "status": "iteration_limit"}, 1),
    ]


with tempfile.TemporaryDirectory() as scratch:
    folder = Path(scratch)
    line = {"rms": 0.1, "largest": 0.2}
    surface = {"rms": 0.0002, "largest": 0.0009}
    vessels = [
        {"vessel": name, "radius": 3.3, "surface": surface, "centerline": line}
        for name in ("vein", "artery")
    ]
    store = Store(folder / "runs", {"vasorod": comparing(folder, vessels)})
    mine = result("coupled", "converged", 21, 0.21)
    its = result("shell", "equilibrium_only", 20, 0.2, 1e-3)
    leave(store, finished(list(prestress.tube_pairs())[:2], mine, its))
    leave(store, finished(list(prestress.join_pairs())[:2], mine, its))
    prestress.make_tables(store, folder)
    tubes, joins = (read_table(folder / name) for name in prestress.FILES)
for rows, _ in (tubes, joins):
    assert [row["failure"] for row in rows] == [None, "status iteration_limit"], rows
text = tubes_section(*tubes)
assert "| biot | 0.020 | 0.090 | 0.000 | 0.000 | +5.00 | 0.100 |" in text, text
assert "| svk | status iteration_limit | -" in text, text
text = joins_section(*joins)
assert "the vein at 5 and the artery at 15 mmHg" in text.replace("\n", " "), text
assert "| slit | 1 | 1 | 20.00 | 21.00 | +5.00 | 10.00 x 3.00 | +5.00 | +0.00 |" in text, text

# The program reads the scenes, and its answer has what the study reads.
with tempfile.TemporaryDirectory() as scratch:
    store = Store(scratch, {"vasorod": sys.argv[2]})
    inflated.TUBE.update(around=16, along=16)
    for case in prestress.TUBES:
        scene = prestress.tube_scene(case, "straight", prestress.LAW)
        run, _ = prestress.pair(case, scene, 16, inflated.CELLS)
        assert solved(store, store.ensure(run)), case
        assert result_of(store, run.identity)["energy"]["total"] > 0
