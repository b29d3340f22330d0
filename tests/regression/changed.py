"""The check of the baselines names every number that was changed in them, with what it was, what it
is and what is allowed, and nothing else; every column of every table has a tolerance or a reason
for having none. Usage: changed.py SOURCE_FOLDER BUILD_FOLDER"""

import contextlib
import io
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

SOURCE, BUILD = Path(sys.argv[1]), Path(sys.argv[2])
sys.path[:0] = [str(SOURCE / "benchmarks" / name) for name in ("study", "speed")]
import drift  # noqa: E402
import instructions  # noqa: E402
import repeated  # noqa: E402
from store import Store  # noqa: E402
from tables import read_table, replace_rows  # noqa: E402

BASELINES = SOURCE / "benchmarks" / "baselines"


def told(call):
    said = io.StringIO()
    with contextlib.redirect_stdout(said):
        answer = call()
    return answer, said.getvalue()


# Every table has rows that a check repeats, and their keys are rows of it.
plan = (*repeated.ALONE, *repeated.ANATOMY, *repeated.AGAINST)
files = {one.file for one in plan}
on_disk = {path.name for path in BASELINES.glob("*.csv")}
assert on_disk - files == {"instructions.csv"}, on_disk - files
for one in plan:
    rows, _ = read_table(BASELINES / one.file)
    known = repeated.by_key(rows, one.keys)
    for row in one.rows:
        assert row in known, (one.file, row)
    for column in rows[0]:
        assert column in one.keys or column in drift.TOLERANCES, (one.file, column)
for column, rule in drift.TOLERANCES.items():
    assert len(rule.reason) > 10, column

# The rule itself.
old = {"case": "a", "rms": 1e-3, "failure": None, "solves": None, "seconds": 1.0}
assert drift.drifts(("case",), old, {**old, "rms": 1.019e-3, "seconds": 9.0, "solves": 7}) == []
((column, was, now, _),) = drift.drifts(("case",), old, {**old, "rms": 1.021e-3})
assert (column, was, now) == ("rms", 1e-3, 1.021e-3)
assert [m[0] for m in drift.drifts(("case",), old, {**old, "rms": None})] == ["rms"]
assert [m[0] for m in drift.drifts(("case",), old, {"case": "a"})] == ["rms"]
failed = {**old, "failure": "status unstable"}
assert [m[0] for m in drift.drifts(("case",), old, failed)] == ["failure"]
assert [m[0] for m in drift.drifts(("case",), failed, old)] == ["failure"]
assert drift.same("sentence", "after 7 turns", "after 8 turns", drift.EXACT)
assert not drift.same("sentence", "after 7 turns", "before 7 turns", drift.EXACT)
assert drift.same("most_iterations", "100 (case 3)", "109 (case 5)", drift.ITERATIONS)
assert not drift.same("most_iterations", "100 (case 3)", "112 (case 3)", drift.ITERATIONS)
try:
    drift.drifts(("case",), {**old, "colour": 1}, old)
    raise AssertionError("a column without a tolerance was taken")
except SystemExit as error:
    assert "colour" in str(error)

# The whole of it: a table is changed, and the programs run.
(one,) = [one for one in repeated.ALONE if one.file == "extremes_rod.csv"]
with tempfile.TemporaryDirectory() as scratch:
    folder = Path(scratch) / "baselines"
    shutil.copytree(BASELINES, folder)
    store = Store(Path(scratch) / "results", {"rod_extremes": BUILD / "bin" / "rod_extremes"})
    assert repeated.check_table(store, folder, one) == []
    row = repeated.by_key(read_table(folder / one.file)[0], one.keys)[("trees",)]
    changed = {**row, "certified": row["certified"] - 1, "most_iterations": "99 (elsewhere)"}
    replace_rows(folder / one.file, one.keys, [changed], "changed")
    found = repeated.check_table(store, folder, one)
    assert len(found) == 2, found
    assert found[0].startswith("extremes_rod.csv: trees: certified was 3, is 4, allowed"), found
    assert "most_iterations was 99 (elsewhere), is " in found[1], found
    # Taken anew, the table is what it was, with the reason.
    repeated.ALONE = (one,)
    repeated.glenns.has_anatomy = lambda: False
    told(lambda: repeated.accept(store, folder, False, "because"))
    again, notes = read_table(folder / one.file)
    assert notes[-1].startswith("1 rows accepted ") and notes[-1].endswith(": because"), notes
    good, said = told(lambda: repeated.check(store, folder, False))
    assert good and "4 rows of extremes_rod.csv: no drift" in said, said
    assert len(again) == len(read_table(BASELINES / one.file)[0])

# Instructions: a baseline of half as many fails, one of as many does not.
known = {"wall": (1000, "c++ 12"), "rod": (1000, "c++ 12")}
lines, moved = instructions.compare({"wall": 1019, "rod": 979}, known, "c++ 12")
assert moved == ["rod"] and "-2.10%" in lines[1] and lines[1].endswith("MOVED"), lines
lines, moved = instructions.compare({"wall": 1100, "rod": 1200, "new": 1}, known, "c++ 13")
assert moved == ["rod", "new"], lines
command = [sys.executable, SOURCE / "benchmarks" / "speed" / "instructions.py", BUILD]
command += ["--only", "rod_solve", "--baseline"]
with tempfile.TemporaryDirectory() as scratch:
    history = Path(scratch) / "instructions.csv"
    wrong = instructions.last_known(BASELINES / "instructions.csv")["rod_solve"]
    instructions.write(history, {"rod_solve": wrong[0] // 2}, wrong[1])
    bad = subprocess.run([*command, history], capture_output=True, text=True)
    if bad.returncode != instructions.SKIPPED:
        assert bad.returncode == 1 and "rod_solve" in bad.stdout and "MOVED" in bad.stdout, bad
    # Without valgrind it says so.
    none = subprocess.run(
        [*command, history], capture_output=True, text=True, env={"PATH": scratch}
    )
    assert none.returncode == instructions.SKIPPED and "valgrind is not installed" in none.stdout
