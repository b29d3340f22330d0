"""The join's study: scenes are what their names say, the table's numbers are those of the results,
the chapter says what its table says, and a mouth that moved is named.
Usage: join.py SOURCE_FOLDER VASOROD."""

import sys
import tempfile
from pathlib import Path

import yaml

sys.path.insert(0, str(Path(sys.argv[1]) / "benchmarks" / "study"))
import join  # noqa: E402
from chapters.join import join_section, limit_and_order  # noqa: E402
from finished import comparing, leave  # noqa: E402
from measure import converged, result_of  # noqa: E402
from store import Store  # noqa: E402
from tables import read_table  # noqa: E402

base = yaml.safe_load(join.OPENINGS["slit"][0].read_text())
made = yaml.safe_load(join.scene("ellipse", 0.25, "neo-hookean", 80, 1.2))
for before, after in zip(base["vessels"], made["vessels"]):
    assert after["wall"]["thickness"] == before["wall"]["thickness"] / 4
    assert after["law"] == "neo-hookean"
    finer = [after["tube"][key] / before["tube"][key] for key in ("around", "along")]
    assert all(abs(factor - 4 / 3) < 0.01 for factor in finer), finer
    assert all(after["tube"][key] % 2 == 0 for key in ("around", "along"))
assert made["surgery"]["glenn"]["incision_shape"] == {"ellipse": 0.5}
assert made["surgery"]["glenn"]["incision_length"] == 1.2
unchanged = yaml.safe_load(join.scene("slit", 1.0, "biot", 60, 1.0))
for vessel in unchanged["vessels"]:
    assert vessel.pop("law") == "biot"
assert unchanged == base
ends = yaml.safe_load(join.scene("end to end", 0.5, "biot", 72, 1.0))
assert ends["surgery"] == yaml.safe_load(join.OPENINGS["end to end"][0].read_text())["surgery"]
assert [vessel["wall"]["thickness"] for vessel in ends["vessels"]] == [0.225, 0.2]
assert [vessel["tube"]["around"] for vessel in ends["vessels"]] == [72, 72]
assert join.mouth_of({"end_to_end": {"mouth": 1}}) == join.mouth_of({"glenn": {"mouth": 1}}) == 1

runs = join.all_runs()
assert len({run.identity for run in runs}) == len(runs)
assert {run.program for run in runs} == {"vasorod", "vasorod-fem"}


def result(fidelity, mouth, energy, force, own_error=None):
    return {
        "fidelity": fidelity,
        "status": "converged",
        "glenn": {"mouth": {"area": mouth, "span": 10.0, "width": 1.0}},
        "energy": {"total": energy},
        "ends": [{"force": [0.0, 3.0, 4.0]}, {"force": [force, 0.0, 0.0]}],
        "discretisation": {"error_estimate": own_error},
    }


# A compare that answers; results and records as the programs leave them.
with tempfile.TemporaryDirectory() as scratch:
    folder = Path(scratch)
    vessels = [
        {"vessel": "vein", "surface": {"rms": 0.01}},
        {"vessel": "artery", "surface": {"rms": 0.02}},
    ]
    store = Store(folder / "runs", {"vasorod": comparing(folder, vessels)})
    truth = join.shell_run("slit", 1.0, "biot")
    finished = [
        (truth, result("shell", 8.0, 0.04, 10.0, 0.002), 0),
        (join.hybrid_run("slit", 1.0, "biot", around=40), result("coupled", 7.0, 0.05, 9.0), 0),
        (join.hybrid_run("slit", 1.0, "biot", around=60), result("coupled", 0.0, 0.0, 0.0), 1),
        (join.hybrid_run("slit", 1.0, "biot", "paper"), result("paper", 9.0, 7.0, 1.0), 0),
    ]
    finished[2][1]["status"] = "iteration_limit"
    finished[1][1]["counts"] = dict.fromkeys(join.counts.COLUMNS, 40)
    leave(store, finished)
    join.make_table(store, folder / "join.csv")
    rows, notes = read_table(folder / "join.csv")
assert [(row["fidelity"], row["around"]) for row in rows] == [
    ("coupled", 40),
    ("coupled", 60),
    ("paper", 60),
]
assert rows[0]["mouth"] == 7 and rows[0]["support"] == 9 and rows[0]["rms_second"] == 0.02
assert rows[1]["failure"] == "status iteration_limit" and rows[1]["mouth"] is None
assert rows[0]["solves"] == 40 and rows[1]["solves"] is None
assert rows[2]["energy"] is None and rows[2]["support_reference"] == 10

# The real programs' answers have the keys that the study reads.
with tempfile.TemporaryDirectory() as scratch:
    store = Store(scratch, {"vasorod": sys.argv[2]})
    runs = [join.hybrid_run("ellipse", 1.0, law, around=24) for law in join.LAWS]
    for run in runs:
        assert converged(store, store.ensure(run)), run.identity
    apart = join.distances(store, *runs)
    assert len(apart) == 2 and all(0 < rms < 1 for rms in apart), apart
    assert join.support(result_of(store, runs[0].identity)) > 0

text = join_section(rows, notes)
assert (
    "| slit | 1 | biot | coupled | 40 | 8.00 | 7.00 | -12.50 | +25.00 | -10.00 | 1.00 | 2.00 | 0.20"
    in text
), text
assert "| slit | 1 | biot | coupled | 60 | status iteration_limit | -" in text, text
assert "| slit | 1 | biot | paper | 60 | 8.00 | 9.00 | +12.50 | - | - |" in text, text
assert "| slit | biot | coupled | 40 | 12.50 | 2.0 | 2.0 |" in text, text

limit, order = limit_and_order({n: 8.0 - 300 * n**-1.5 for n in (40, 60, 80, 120)})
assert abs(limit - 8) < 1e-6 and order == 1.5, (limit, order)
finer = [
    {**rows[0], "law": "neo-hookean", "around": n, "mouth": 8.0 - 320 / n**2}
    for n in (40, 60, 80, 120)
]
text = join_section(finer, notes)
assert "7.978 (120) | 2.0 | 8.000 | +0.00 |" in text, text

now = [{"mouth": 7.02, "energy": 0.0501}, None]
assert join.drifts(rows[:2], now) == []
now[0]["mouth"] = 7.1
assert len(join.drifts(rows[:2], now)) == 1 and "mouth 7" in join.drifts(rows[:2], now)[0]
now[0] |= {"mouth": 7.0, "solves": 44, "factor_nonzeros": 40}
assert join.drifts(rows[:2], now) == [], "a tenth more solves is within the tolerance"
now[0] |= {"solves": 45, "factor_nonzeros": 41}
assert [sentence.split(": ")[-1] for sentence in join.drifts(rows[:2], now)] == [
    "solves 40 -> 45",
    "factor_nonzeros 40 -> 41",
]
now[0] = {"mouth": 7.0, "energy": 0.05}
now[1] = {"mouth": 7.0, "energy": 0.05}
assert [sentence.split()[-2:] for sentence in join.drifts(rows[:2], now)] == [["converges", "now"]]
