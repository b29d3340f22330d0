"""Fidelity `section` against the reference on every counted tube, and its time against the shell's
on one."""

import re
from bisect import bisect_left
from math import exp, log

import irregular
import trade
from accuracy import COLUMNS, accuracy_shell, measured
from cases import case_named, text_of
from measure import compared, converged, outcome, result_of
from runs import Run, hybrid_arguments
from tables import provenance, write_table

FILE, SPEED, REFINEMENT = "sections.csv", "sections_speed.csv", "sections_refinement.csv"
SURFACES = {"24": 24, "48": 48, "blue-noise": 48}  # by name: points around
ARGUMENTS = ("--no-report",)


def run(case, surface, fidelity="section"):
    """At no less than 24 points around the sections do not depend on the mesh; a surface from a
    file is fitted."""
    around = SURFACES[surface]
    if surface.isdigit():
        files = {"scene.yaml": case.changed(around=around).text}
    else:
        scene = case.changed().scene
        vessel = scene["vessels"][0]
        del vessel["tube"]
        vessel.update(surface="tube.vtp", surface_is="mid")
        files = {
            "scene.yaml": text_of(scene),
            "tube.vtp": lambda: irregular.mesh_of(case, surface)[0],
        }
    return Run(
        f"{case.name}/{fidelity}-{surface}-no-report",
        "vasorod",
        (*hybrid_arguments(fidelity), *ARGUMENTS),
        files,
    )


def runs_of(case):
    """By surface. One that is read has one thickness, so tapered walls are left out."""
    if not case.counted:
        return {}
    return {
        surface: run(case, surface)
        for surface in SURFACES
        if surface.isdigit() or "end_thickness" not in case.tube
    }


def speed_runs(case):
    """By model and settings: what is timed on trade.CASE."""
    runs = {
        (fidelity, surface): run(case, surface, fidelity)
        for fidelity in ("section", "coupled")
        for surface in ("24", "48")
    }
    for one in trade.fem_runs(case):
        model, settings = one.identity.split("/")[1].removesuffix("-r0-biot").split("-", 1)
        if model == "shell":
            runs[model, settings] = one
    return runs


def all_runs(case):
    runs = [*runs_of(case).values(), accuracy_shell(case)] if case.counted else []
    return runs + (list(speed_runs(case).values()) if case.name == trade.CASE else [])


def refinement_run():
    """The errors of given numbers of harmonics and spans (benchmarks/accuracy)."""
    return Run("sections/refinement", "section_refinement", (), {})


def refinement_rows(text):
    """The table section_refinement prints: a row per space."""
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if line.startswith("|") and len(cells) == 6 and cells[0].isdigit():
            yield {
                "harmonics": int(cells[0]),
                "spans": int(cells[1]),
                "unknowns": int(cells[2]),
                "rms": float(cells[3]),
                "moment": float(cells[4]),
                "settled": int(cells[5]),
            }


def timed():
    return frozenset(one.identity for one in speed_runs(case_named(trade.CASE)).values())


def resolution(result):
    """What the solver says of its sections: harmonics, spans, estimated error over R."""
    for note in result["certificate"]["notes"]:
        found = re.search(
            r"(\d+) harmonics around, (\d+) spans along; .* choice ([0-9.e+-]+)", note
        )
        if found:
            return int(found[1]), int(found[2]), float(found[3])
    return None, None, None


def rows_of(store, cases, records):
    for case, surface, one, record, reference in measured(store, cases, runs_of, records):
        solved = converged(store, record)
        numbers = resolution(result_of(store, one.identity)) if solved else (None, None, None)
        yield {
            "case": case.name,
            "family": case.family,
            "ratio": case.ratio,
            "thickness_over_radius": case.wall["thickness"] / case.tube["radius"],
            "surface": f"{surface} around" if surface.isdigit() else surface,
            **dict(zip(("harmonics", "spans", "estimate"), numbers)),
            "seconds": record["processor_seconds"],
            "solve_seconds": record.get("solve_seconds"),
            "reference": reference.identity.split("/")[1],
            **outcome(store, case, one, reference, COLUMNS),
        }


def speed_rows(store, records):
    case = case_named(trade.CASE)
    truth = accuracy_shell(case)
    if not converged(store, store.record(truth.identity)):
        return
    for (model, settings), one in speed_runs(case).items():
        record = store.record(one.identity)
        if not converged(store, record):
            continue
        records.append(record)
        numbers = compared(store, case, one, truth)
        yield {
            "case": case.name,
            "model": model,
            "settings": settings,
            "seconds": record["processor_seconds"],
            "solve_seconds": record.get("solve_seconds"),
            "repeats": record.get("repeats", 1),
            "rms": numbers["rms"],
            "reaction": max(numbers["force"], numbers["moment"]),
            "reference": truth.identity.split("/")[1],
        }


def beside(accuracy, rows):
    """The rows on generated tubes as rows of the accuracy table, of whose cases they are. Where its
    reference is another, the distance of the two counts as the reference's own error."""
    cases = {}
    for row in accuracy:
        cases.setdefault(row["case"], {})[row["model"]] = row
    found = []
    for row in rows:
        of = cases.get(row["case"])
        if of is None or not row["surface"].endswith(" around"):
            continue
        like = next(iter(of.values()))
        same = {name: like[name] for name in like if name not in COLUMNS}
        own = row["u_shape"]
        if own is not None and row["reference"] != like["reference"]:
            own += of["shell"]["rms"]
        numbers = {name: row[name] for name in (*COLUMNS, "reference", "failure")}
        around = int(row["surface"].removesuffix(" around"))
        found.append({**same, **numbers, "model": "section", "around": around, "u_shape": own})
    return found


def shell_time(rows, rms, column):
    """The shell's time for this error, on the line through log error and log time of the runs
    beside it; None outside of its runs."""
    front = []  # runs that no other beats in both
    for row in sorted((r for r in rows if r["model"] == "shell"), key=lambda r: -r["rms"]):
        while front and front[-1][column] >= row[column]:
            front.pop()
        front.append(row)
    errors = [-row["rms"] for row in front]
    k = bisect_left(errors, -rms)
    if k == 0 or k == len(front):
        return None
    a, b = front[k - 1], front[k]
    share = log(rms / a["rms"]) / log(b["rms"] / a["rms"])
    return exp((1 - share) * log(a[column]) + share * log(b[column]))


def make_refinement(store, path):
    record = store.record(refinement_run().identity)
    if record is None:
        return
    text = (store.folder(record["identity"]) / "output.txt").read_text()
    note = "Fidelity section in given spaces against the finest of both kinds: RMS over R, moment"
    note += " of the end over itself; t/R 0.1, L/R 10, half of Brazier's curvature, rigid ends"
    write_table(path, list(refinement_rows(text)), [note, *provenance([record])])


def make_tables(store, cases, baselines):
    make_refinement(store, baselines / REFINEMENT)
    records = []
    rows = list(rows_of(store, cases, records))
    if rows:
        write_table(
            baselines / FILE,
            rows,
            [
                "Fidelity section against the finite-element reference, law Biot; u_: the"
                " reference's own error; seconds: processor time with --no-report",
                *provenance(records),
            ],
        )
    records = []
    rows = list(speed_rows(store, records))
    if rows:
        write_table(
            baselines / SPEED,
            rows,
            [
                f"Case {trade.CASE}: processor time of the whole program (hybrid: --no-report) and"
                " of solving alone against its error",
                *provenance(records),
            ],
        )
