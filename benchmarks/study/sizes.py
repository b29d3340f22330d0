"""Cost against size: one gently bent tube with ever more vertices at `paper`, `coupled` and
`section`, whole programs without report. A size that would not fit in memory is not run, and the
table says so."""

import math

import counts
import extremes
from extremes import wall_extremes
from measure import result_of
from runs import Run, hybrid_arguments
from tables import provenance, write_table

FILE = "sizes.csv"
AROUND = (40, 84, 168, 266, 376, 532, 736)  # about 3 k to a million vertices
FIDELITIES = ("paper", "section", "coupled")
TIME_LIMIT = 1200  # seconds a run may take
MOST_COUPLED = 60_000  # vertices: the next size takes 12 GB at what a vertex of this one takes


def along(around):
    """Rows of nearly equilateral triangles."""
    edge = 2 * math.pi * wall_extremes.RADIUS / around
    return round(wall_extremes.LENGTH / (edge * math.sqrt(3) / 2))


def vertices(around):
    return around * (along(around) + 1)


def run(fidelity, around):
    bend = 0.25 * wall_extremes.brazier(1.0) * wall_extremes.LENGTH
    scene = wall_extremes.scene(around=around, along=along(around), bend=bend)
    return Run(
        f"sizes/{fidelity}-{around}",
        "vasorod",
        (*hybrid_arguments(fidelity), "--no-report", "--time-limit", str(TIME_LIMIT)),
        {"scene.yaml": scene},
    )


def points():
    return [(fidelity, around) for fidelity in FIDELITIES for around in AROUND]


def is_run(fidelity, around):
    return fidelity != "coupled" or vertices(around) <= MOST_COUPLED


def all_runs():
    return [run(*point) for point in points() if is_run(*point)]


COLUMNS = ("ending", "seconds", "peak_bytes", *counts.COLUMNS, "sentence")


def row_of(store, fidelity, around):
    """A size and its record; without one where it is not run, None where its run is missing."""
    row = {"fidelity": fidelity, "vertices": vertices(around), **dict.fromkeys(COLUMNS)}
    if not is_run(fidelity, around):
        return {**row, "ending": "not run"}, None
    record = store.record(run(fidelity, around).identity)
    if record is None:
        return None
    row["ending"], sentence = extremes.ending_of(store, record)
    row |= {"seconds": record["processor_seconds"], "peak_bytes": record["peak_bytes"]}
    row["sentence"] = sentence or None
    if record["exit"] in (0, 1):
        row |= counts.counts_of(result_of(store, record["identity"]))
    return row, record


def make_table(store, path, whole=True):
    """whole: not before all runs are finished."""
    found = [row_of(store, *point) for point in points()]
    if whole and None in found:
        return
    found = [one for one in found if one is not None]
    records = [record for _, record in found if record is not None]
    if records:
        note = "Cost against the number of vertices of one bent tube: whole programs on one thread,"
        note += f" without report, {TIME_LIMIT} s each at most; seconds: processor time"
        write_table(path, [row for row, _ in found], [note, *provenance(records)])
