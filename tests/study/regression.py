"""The regression command finds nothing on the same program and names a 2 % change of one
coefficient, with a picture where matplotlib is installed. A script in place of vasorod changes the
wall or the energies' coefficients of its scene, then calls vasorod.
Usage: regression.py SOURCE_FOLDER VASOROD."""

import contextlib
import io
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(sys.argv[1]) / "benchmarks" / "study"))
import regression  # noqa: E402
import sensitivity  # noqa: E402
from store import Store  # noqa: E402
from tables import read_table  # noqa: E402

# smaller than the real one: one load, two factors, coarse
sensitivity.LOADS = {"bend": sensitivity.LOADS["bend"]}
sensitivity.FACTORS = sensitivity.FEW = (0.1, 1.0)
sensitivity.FIDELITIES = ("paper",)
sensitivity.hybrid_run.__defaults__ = (24,)

ALTERED = """#!{python}
import os, sys, yaml
if sys.argv[1] == 'solve':
    scene = yaml.safe_load(open('scene.yaml'))
    vessel = scene['vessels'][0]
    {change}
    yaml.safe_dump(scene, open('scene.yaml', 'w'))
os.execv({vasorod!r}, ['vasorod', *sys.argv[1:]])
"""


def told(call):
    said = io.StringIO()
    with contextlib.redirect_stdout(said):
        answer = call()
    return answer, said.getvalue()


with tempfile.TemporaryDirectory() as scratch:
    scratch = Path(scratch)
    baselines = scratch / "baselines"
    good = Store(scratch / "results", {"vasorod": sys.argv[2]})
    for one in sensitivity.runs("bend", sensitivity.FIDELITIES, sensitivity.FACTORS):
        record = good.ensure(one)
        assert record["exit"] == 0, record
    with_reference = sensitivity.make_rows
    sensitivity.make_rows = lambda store: with_reference(
        store, sensitivity.LOADS, sensitivity.FIDELITIES, sensitivity.FACTORS, False
    )
    regression.accept(good, baselines, "first")
    rows, notes = read_table(baselines / regression.FILE)
    assert len(rows) == 4 and all(
        row["energy"] > 0 and row["failure"] is None for row in rows
    ), rows
    assert all(0 < row["factorisations"] <= row["solves"] for row in rows), rows
    assert all(row["factor_nonzeros"] > 0 for row in rows), rows
    assert notes[-1].startswith("accepted ") and notes[-1].endswith(": first")
    regression.accept(good, baselines, "again")
    assert [note.rsplit(": ")[-1] for note in read_table(baselines / regression.FILE)[1][-2:]] == [
        "first",
        "again",
    ], "a reason was lost"

    ok, said = told(lambda: regression.check(good, baselines))
    assert ok and "4 points" in said, said

    for name, change in {
        "stiffness": "vessel['wall']['young'] *= 1.02",
        "shear": "vessel['wall']['shear'] *= 1.02",
    }.items():
        program = scratch / f"altered-{name}"
        program.write_text(
            ALTERED.format(python=sys.executable, vasorod=sys.argv[2], change=change)
        )
        program.chmod(0o755)
        image = scratch / f"{name}.png"
        altered = Store(scratch / f"results-{name}", {"vasorod": program})
        ok, said = told(lambda: regression.check(altered, baselines, image=image))
        if name == "shear":
            # bending along the inextensible arc has no shear: nothing moves, so nothing is found
            assert ok, said
            continue
        assert (
            not ok and "paper bend" in said and "moment" in said
        ), f"{name} by 2 % was not caught: {said}"
        assert image.exists() or "python3-matplotlib" in said, said

# the rule itself: relative to the largest value on the same curve
rows = [
    {
        "load": "bend",
        "modulus": "E",
        "fidelity": "paper",
        "factor": f,
        **{q: None for q in regression.QUANTITIES},
        "force": v,
    }
    for f, v in ((0.01, 1.0), (1.0, 100.0))
]
moved = [dict(rows[0], force=1.4), dict(rows[1], force=100.0)]
assert regression.drifts(rows, moved) == [], "0.4 of 100 is within 0.5 %"
moved[0]["force"] = 1.6
assert [(f[1], round(f[4], 9)) for f in regression.drifts(rows, moved)] == [("force", 0.006)]
# counts have tolerances of their own; a table from before them has nothing to compare
moved[0]["force"] = 1.0
moved[0]["solves"] = 200
assert regression.drifts(rows, moved) == [], "the baseline has no count"
rows[0]["solves"] = 190
assert regression.drifts(rows, moved) == [], "within a tenth"
rows[0]["solves"] = 100
assert [f[1:] for f in regression.drifts(rows, moved)] == [("solves", 100, 200, 1.0)]
moved[0]["solves"] = 10
assert [f[4] for f in regression.drifts(rows, moved)] == [-0.9], "fewer is a change too"
moved[0]["solves"] = None
assert regression.drifts(rows, moved) == []
moved[0]["force"] = None
assert [f[4] for f in regression.drifts(rows, moved)] == [None], "a number that went is a drift"
