"""Tables are read as they were written, with their provenance.
Usage: tables.py SOURCE_FOLDER VASOROD."""

import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(sys.argv[1]) / "benchmarks" / "study"))
from tables import extended, markdown, outcomes, provenance, read_table  # noqa: E402
from tables import write_table  # noqa: E402

records = [
    {"identity": f"case/{k}", "program": "vasorod", "program_sha256": "a" * 64, "commit": commit}
    for k, commit in enumerate(("c2", "c1", "c1"))
]
notes = ["what it is, with a comma", *provenance([*records, records[0]])]
assert notes[1] == "vasorod aaaaaaaaaaaa: 3 runs at c1, c2", notes
rows = [
    {"case": "bend", "rms": 1.23456789e-5, "largest": None, "failure": 'found "x", expected y'},
    {"case": "twist", "rms": 0.25, "largest": 3, "failure": None},
]
with tempfile.TemporaryDirectory() as scratch:
    file = Path(scratch) / "deep" / "table.csv"
    write_table(file, rows, notes)
    back, back_notes = read_table(file)
assert back_notes == notes
assert (
    back[0]["failure"] == rows[0]["failure"]
    and back[0]["largest"] is None
    and back[1]["largest"] == 3
)
assert abs(back[0]["rms"] / rows[0]["rms"] - 1) < 1e-5 and back[1]["rms"] == 0.25
assert markdown(("a", "b"), [(1, "x")]) == "| a | b |\n| --- | --- |\n| 1 | x |\n"
# A run without a result says why, and is not asked for its numbers.
asked = outcomes(
    ("case", "rms", "largest"), rows, lambda row: [row["case"]], lambda row: [row["rms"] * 4, 3]
)
assert asked.splitlines()[2:] == ['| bend | found "x", expected y | - |', "| twist | 1.0 | 3 |"]

# A plan that grew: what was run now stands in its place, the rest stays, what the plan has dropped
# goes, and a column that is new is empty where nothing was run.
with tempfile.TemporaryDirectory() as scratch:
    file = Path(scratch) / "table.csv"
    old = [{"case": name, "around": k, "rms": 1.0} for name, k in (("a", 1), ("b", 2), ("c", 3))]
    write_table(file, old, ["what", "vasorod aaa: 3 runs at c1"])
    now = [{"case": name, "around": k, "rms": 2.0, "new": 5} for name, k in (("b", 2), ("d", 4))]
    plan = [("d", 4), ("a", 1), ("b", 2)]
    merged, lines = extended(file, ("case", "around"), plan, now, ["what", "vasorod bbb: 2 runs"])
    nowhere = extended(Path(scratch) / "none.csv", ("case", "around"), plan, now, ["what"])
assert [(row["case"], row["rms"], row["new"]) for row in merged] == [
    ("d", 2.0, 5),
    ("a", 1.0, None),
    ("b", 2.0, 5),
], merged
assert lines == [
    "what",
    "vasorod bbb: 2 runs",
    "1 rows from before, vasorod aaa: 3 runs at c1",
], lines
assert [row["case"] for row in nowhere[0]] == ["d", "b"] and nowhere[1] == ["what"]
