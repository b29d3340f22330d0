"""Cost against size: the scenes have the sizes that the table names, what is not run is said to be,
and growth is that of the sizes that converged. Usage: sizes.py SOURCE_FOLDER VASOROD."""

import math
import sys
import tempfile
from pathlib import Path

import yaml

sys.path.insert(0, str(Path(sys.argv[1]) / "benchmarks" / "study"))
import sizes  # noqa: E402
from chapters.limits_answers import sizes_answer  # noqa: E402
from chapters.sizes import growth, sizes_section  # noqa: E402
from finished import leave  # noqa: E402
from store import Store  # noqa: E402
from tables import read_table  # noqa: E402

runs = sizes.all_runs()
assert len({run.identity for run in runs}) == len(runs)
assert sizes.vertices(sizes.AROUND[0]) == 3000 and sizes.vertices(sizes.AROUND[-1]) > 900_000
for around in sizes.AROUND:
    tube = yaml.safe_load(sizes.run("paper", around).files["scene.yaml"])["vessels"][0]["tube"]
    assert tube["around"] * (tube["along"] + 1) == sizes.vertices(around), tube
    across, edge = tube["length"] / tube["along"], 2 * math.pi * tube["radius"] / around
    assert abs(across / edge / (math.sqrt(3) / 2) - 1) < 0.01, "not equilateral"


def result(status, nonzeros):
    parts = {"ends": [], "balance": {"forces": 0.0}, "energy": {"total": 1.0}, "metrics": []}
    counts = {"factorisations": 2, "solves": 9, "gradients": 9, "hessians": 2, "outer": 1}
    counts["factor_nonzeros"] = nonzeros
    return {"status": status, **parts, "counts": counts, "certificate": {"notes": ["stopped"]}}


# Twice the entries a vertex at four and a bit times the vertices; the next size was stopped.
first, second, third = sizes.AROUND[:3]
ratio = sizes.vertices(second) / sizes.vertices(first)
finished = [
    (sizes.run("paper", first), result("converged", 90000), 0),
    (sizes.run("paper", second), result("converged", round(180000 * ratio)), 0),
    (sizes.run("paper", third), result("interrupted", None), 1),
]
with tempfile.TemporaryDirectory() as scratch:
    folder = Path(scratch)
    store = Store(folder / "runs", {})
    leave(store, finished, peak_bytes=2**30)
    sizes.make_table(store, folder / "whole.csv")
    assert not (folder / "whole.csv").exists(), "not before all runs are finished"
    sizes.make_table(store, folder / sizes.FILE, whole=False)
    rows, notes = read_table(folder / sizes.FILE)
done = [row for row in rows if row["ending"] == "converged"]
assert [row["factor_nonzeros"] for row in done] == [90000, round(180000 * ratio)], rows
assert abs(growth(done, "factor_nonzeros") - 1 - math.log(2) / math.log(ratio)) < 1e-4
assert growth(done, "peak_bytes") == 0
left = [row for row in rows if row["ending"] == "not run"]
assert {row["fidelity"] for row in left} == {"coupled"} and left[0]["seconds"] is None, left
text = "\n".join(sizes_section(rows, notes))
assert "| paper | 3000 | converged | 2.0 | 1024 | 3.58e+05 | 2 | 9 | 9 | 2 | 30 | stopped |" in text
# Coupled has no size that converged here, and so nothing to go by.
assert "would take" not in text, text
done = [{**row, "fidelity": "coupled"} for row in done]
gib = 1 / sizes.vertices(second) * left[0]["vertices"]
said = f"on more vertices: {left[0]['vertices']:.0f} would take at least {gib:.0f} GiB"
assert said in " ".join("\n".join(sizes_section(rows + done, notes)).split()), said
assert "interrupted" in text and "not run" in text and "coupled`:" not in text, text
answer = "\n".join(sizes_answer(rows))
assert f"| `paper` | {sizes.vertices(second)} | 2.0 | 1024 |" in answer, answer
