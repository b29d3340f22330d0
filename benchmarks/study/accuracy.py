"""The accuracy table: every fidelity at three resolutions, and the shell, against the solid on
every case."""

from measure import converged, failure_of, outcome, result_of
from runs import AROUND, FIDELITIES, accuracy_reference, accuracy_shell, hybrid
from tables import provenance, write_table

COLUMNS = (
    "rms",
    "largest",
    "centerline_rms",
    "centerline_largest",
    "force",
    "moment",
    "reaction_signed",
    "flattening",
    "flattening_reference",
    "u_shape",
    "u_reaction",
)
DEMANDS = ("demand_stretch", "demand_twist", "demand_bend", "demand_press")


def demand_of(store, case):
    """What the case asks of a vessel as its rod sees it: see hybrid/judge/accuracy_table.h."""
    run = hybrid(case, "skin", 48)
    if not converged(store, store.record(run.identity)):
        return {name: None for name in DEMANDS}
    result = result_of(store, run.identity)
    return {
        "demand_stretch": max(abs(v - 1) for v in result["metrics"][0]["stretch"]),
        "demand_twist": result["validity"]["twist_ratio"],
        "demand_bend": result["validity"]["wrinkling_ratio"],
        "demand_press": max(0.0, 1 - min(result["metrics"][0]["stretch"])),
    }


def hybrid_runs(case):
    return [hybrid(case, fidelity, around) for fidelity in FIDELITIES for around in AROUND]


def chosen_reference(store, case):
    """The solid where it converged, else the shell, else nothing: (run, record)."""
    for run in (accuracy_reference(case), accuracy_shell(case)):
        record = store.record(run.identity)
        if converged(store, record):
            return run, record
    return None, None


def measured(store, cases, runs_of, records):
    """Every finished run of the cases that have a reference: (case, what runs_of(case) calls it,
    run, its record, reference). `records` takes the runs' and the references'."""
    for case in cases:
        reference, reference_record = chosen_reference(store, case)
        for name, run in runs_of(case).items():
            record = store.record(run.identity)
            if reference is not None and record is not None:
                records += [record, reference_record]
                yield case, name, run, record, reference


def rows_of(store, case, records):
    """One row per run of the case. A run that failed has its sentence instead of numbers. Beyond
    the model's range there may be no converged reference: then the rows say only how runs ended."""
    reference, record = chosen_reference(store, case)
    if reference is None and case.counted:
        return []
    if record is not None:
        records.append(record)
    rows = []
    demand = demand_of(store, case)
    others = hybrid_runs(case)
    if reference is None or reference.identity != accuracy_shell(case).identity:
        others.append(accuracy_shell(case))
    for run in others:
        record = store.record(run.identity)
        if record is None:
            continue
        records.append(record)
        settings = run.identity.split("/")[1].split("-")
        row = {
            "case": case.name,
            "family": case.family,
            "ratio": case.ratio,
            "counted": int(case.counted),
            "model": settings[0],
            "around": int(settings[1]) if settings[1].isdigit() else None,
            "reference": reference and reference.identity.split("/")[1],
            "thickness_over_radius": case.wall["thickness"] / case.tube["radius"],
            "length_over_radius": case.tube["length"] / case.tube["radius"],
            **demand,
        }
        if reference is None:
            row.update(
                {name: None for name in COLUMNS},
                failure=(
                    "nothing to compare with"
                    if converged(store, record)
                    else failure_of(store, record)
                ),
            )
        else:
            row.update(outcome(store, case, run, reference, COLUMNS))
        rows.append(row)
    return rows


def make_table(store, cases, path):
    records = []
    rows = [row for case in cases for row in rows_of(store, case, records)]
    write_table(
        path,
        rows,
        [
            "Errors against the finite-element reference, law Biot; u_: the reference's own error",
            *provenance(records),
        ],
    )
    return rows
