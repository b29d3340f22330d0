"""The limits of each solver: groups of the rod as `rod_extremes` prints them, one run for each wall
scene of extremes/wall_extremes.py, and the ends of the reference runs in the sensitivity sweeps and
outside the range of the model. chapters/limits.py writes them to docs/extremes.md."""

import re
import sys

from measure import result_of
from runs import Run, hybrid_arguments
from store import REPOSITORY
from tables import extended, provenance, write_table

sys.path.insert(0, str(REPOSITORY / "benchmarks" / "extremes"))
import wall_extremes  # noqa: E402

TIME_LIMIT = 120  # seconds a run may take
MOST_COUPLED = (
    100_000  # vertices: the factor of more does not fit beside other programs on a small machine
)


def rod_run():
    return Run("extremes/rod", "rod_extremes", (), {})


def wall_run(case, fidelity):
    name = re.sub(r"[^A-Za-z0-9.+-]+", "_", f"{case.family}-{case.name}")
    return Run(
        f"extremes/{fidelity}-{name}",
        "vasorod",
        (*hybrid_arguments(fidelity), "--time-limit", str(TIME_LIMIT)),
        {"scene.yaml": case.scene},
    )


def wall_cases():
    return [
        (case, fidelity)
        for case in wall_extremes.cases()
        for fidelity in case.fidelities
        if not (
            fidelity == "coupled" and case.family == "vertices" and int(case.name) > MOST_COUPLED
        )
    ]


def all_runs():
    return [rod_run(), *(wall_run(*pair) for pair in wall_cases())]


def rod_rows(text):
    """The table rod_extremes prints: a row per group."""
    rows = []
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if line.startswith("|") and len(cells) == 7 and cells[2].isdigit():
            rows.append(
                {
                    "group": cells[0],
                    "range": cells[1],
                    "cases": int(cells[2]),
                    "certified": int(cells[3]),
                    "most_iterations": cells[4],
                    "seconds": float(cells[5]),
                    "other": None if cells[6] == "-" else cells[6],
                }
            )
    return rows


def ending_of(store, record):
    """(how the run ended, its sentence): a status, `refused` with one sentence, or `failed`."""
    if record["exit"] == 2:
        return "refused", record["sentence"]
    if record["exit"] not in (0, 1):
        return "failed", f"exit code {record['exit']} {record['sentence']}"
    result = result_of(store, record["identity"])
    checked = {key: result[key] for key in ("ends", "balance", "energy", "metrics")}
    if result["status"] not in wall_extremes.STATUSES or not wall_extremes.finite(checked):
        return "failed", "a number that is not finite"
    return result["status"], "; ".join(result["certificate"]["notes"])


def make_tables(store, baselines, whole=True):
    """whole: a family of which a run is missing is left out, as a share of its runs says nothing of
    the range."""
    record = store.record(rod_run().identity)
    if record is not None:
        rows = rod_rows((store.folder(record["identity"]) / "output.txt").read_text())
        write_table(
            baselines / "extremes_rod.csv",
            rows,
            ["The rod solver pushed, a line per group of cases", *provenance([record])],
        )
    rows, records = [], []
    found = [
        (case, fidelity, store.record(wall_run(case, fidelity).identity))
        for case, fidelity in wall_cases()
    ]
    unfinished = {(case.family, fidelity) for case, fidelity, record in found if record is None}
    for case, fidelity, record in found:
        if record is None or (whole and (case.family, fidelity) in unfinished):
            continue
        records.append(record)
        ending, sentence = ending_of(store, record)
        rows.append(
            {
                "fidelity": fidelity,
                "family": case.family,
                "case": case.name,
                "ending": ending,
                "seconds": record["processor_seconds"],
                "peak_bytes": record["peak_bytes"],
                "sentence": sentence or None,
            }
        )
    if rows:
        path = baselines / "extremes_wall.csv"
        plan = [(fidelity, case.family, case.name) for case, fidelity in wall_cases()]
        note = f"The walls pushed, a line per scene, {TIME_LIMIT} s each at most"
        notes = [note, *provenance(records)]
        write_table(path, *extended(path, ("fidelity", "family", "case"), plan, rows, notes))
