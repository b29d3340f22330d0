"""The study of fidelity section: what it reads from a result, and the shell's time at equal error.
Usage: sections.py SOURCE_FOLDER VASOROD."""

import math
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(sys.argv[1]) / "benchmarks" / "study"))
import sections  # noqa: E402
import trade  # noqa: E402
from cases import all_cases, case_named  # noqa: E402
from chapters.sections import (  # noqa: E402
    refinement_section,
    sections_section,
    speed_section,
)
from measure import converged, moved_end, norm, result_of, shapes  # noqa: E402
from store import Store  # noqa: E402

with tempfile.TemporaryDirectory() as scratch:
    store = Store(scratch, {"vasorod": sys.argv[2]})
    runs = sections.runs_of(case_named("bend_t1_0.25"))
    assert list(runs) == ["24", "48", "blue-noise"]
    for run in runs.values():
        assert converged(store, store.ensure(run)), run.identity
    # The tubes' vertices lie on one surface, however many they are.
    coarse, fine, fitted = (result_of(store, run.identity) for run in runs.values())
    assert abs(norm(moved_end(coarse)[1]) / norm(moved_end(fine)[1]) - 1) < 1e-6
    assert abs(norm(moved_end(fitted)[1]) / norm(moved_end(fine)[1]) - 1) < 3e-3
    identities = [run.identity for run in runs.values()]
    assert shapes(store, identities[0], identities[1], 10, 100)["rms"] < 1e-3  # chords apart
    harmonics, spans, estimate = sections.resolution(fine)
    assert 3 <= harmonics <= 13 and spans >= 6 and 0 < estimate < 1e-4
    assert sections.resolution({"certificate": {"notes": ["nothing"]}}) == (None, None, None)

assert sections.runs_of(case_named("twist_t2_90")) == {}
assert list(sections.runs_of(case_named("tapered_t1_0.4"))) == ["24", "48"]
assert all((len(sections.all_runs(case)) > 4) == (case.name == trade.CASE) for case in all_cases())

# Between runs of errors 1e-2 and 1e-4 that take 1 and 4 s, 1e-3 takes 2; the dearer and worse run
# is not on the line.
rows = [
    {"model": "shell", "rms": 1e-2, "seconds": 1.0, "solve_seconds": 0.5},
    {"model": "shell", "rms": 2e-3, "seconds": 9.0, "solve_seconds": 8.0},
    {"model": "shell", "rms": 1e-4, "seconds": 4.0, "solve_seconds": 2.0},
]
assert math.isclose(sections.shell_time(rows, 1e-3, "seconds"), 2)
assert sections.shell_time(rows, 2e-2, "seconds") is None
assert sections.shell_time(rows, 1e-5, "seconds") is None

mine = {"case": "bend_t1_0.5", "settings": 24.0, "reaction": 1e-3}
text = speed_section(
    [{**mine, **row} for row in rows]
    + [{**mine, "model": "section", "rms": 1e-3, "seconds": 0.1, "solve_seconds": 0.05}],
    [],
)
assert "| section | 24 | 0.1000 | 0.100 | 0.100 | 0.050 | 20.0 | 20.0 |" in text, text
row = {
    "case": "k",
    "surface": "48 around",
    "rms": 1e-4,
    "force": 2e-3,
    "moment": 1e-3,
    "harmonics": 7,
    "spans": 22,
    "estimate": 2e-5,
    "solve_seconds": 0.03,
    "failure": None,
}
table = sections_section(
    [row, {**row, "surface": "blue-noise", "rms": None, "failure": "status buckled"}], []
)
assert "| k | 0.010 / 0.20 | status buckled | 7, 22 | 0.0020 | 30 |" in table, table

# What section_refinement prints: the order is that from one number of spans to the next.
printed = """## Refinement
| harmonics | spans | unknowns | rms | moment | settled |
|---|---|---|---|---|---|
| 11 | 10 | 900 | 0.008 | 0.01 | 1 |
| 11 | 20 | 1800 | 0.001 | 0.0025 | 1 |
| 3 | 20 | 480 | 0.02 | 0.03 | 0 |
"""
found = list(sections.refinement_rows(printed))
assert [row["spans"] for row in found] == [10, 20, 20] and found[1]["rms"] == 0.001, found
text = refinement_section(found, [])
assert "| 11 | 20 | 1800 | 0.100000 | 3.0 | 0.250000 | 2.0 | yes |" in text, text
assert "| 3 | 20 | 480 | 2.000000 | - | 3.000000 | - | no |" in text, text

# As rows of the accuracy table they have what it says of the case; where it has another reference,
# that one's distance is added to the error of theirs.
numbers = {**dict.fromkeys(sections.COLUMNS, 0.5), "failure": None}
one = {"case": "k", "around": 48.0, "demand_bend": 0.3, "reference": "solid", **numbers}
accuracy = [{**one, "model": "skin"}, {**one, "model": "shell", "around": None, "rms": 0.01}]
mine = {"case": "k", "surface": "24 around", **numbers, "rms": 0.002, "u_shape": 1e-4}
rows = [
    {**mine, "reference": "shell"},
    {**mine, "reference": "solid", "surface": "48 around"},
    {**mine, "reference": "solid", "surface": "blue-noise"},
    {**mine, "case": "unknown", "reference": "solid"},
]
found = sections.beside(accuracy, rows)
assert [(row["model"], row["around"], row["demand_bend"]) for row in found] == [
    ("section", 24, 0.3),
    ("section", 48, 0.3),
], found
assert [row["u_shape"] for row in found] == [1e-4 + 0.01, 1e-4]
assert all(row.keys() == accuracy[0].keys() for row in found)
