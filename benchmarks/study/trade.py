"""Time and memory against error on one case: every fidelity and resolution, shell and solid at
several refinements, and CalculiX where it is installed."""

from functools import lru_cache

import calculix
from accuracy import chosen_reference
from cases import case_named
from counts import counts_of
from measure import compared, converged, own_error, reactions, result_of, shapes
from runs import AROUND, FIDELITIES, hybrid, reference
from tables import provenance, write_table

CASE = "bend_t1_0.5"
REPEATS = 3  # the least processor time of these counts; see store.ENOUGH
SHELLS = (
    (2, (12, 16)),
    (2, (16, 24)),
    (3, (6, 8)),
    (3, (8, 12)),
    (3, (12, 16)),
    (4, (6, 8)),
    (4, (8, 12)),
)
SOLIDS = ((2, (12, 16)), (2, (16, 24)), (3, (8, 12)), (3, (12, 16)), (4, (6, 8)))
CALCULIX = {
    "S8R": ((12, 20), (16, 28), (24, 40), (36, 60)),
    "C3D20R": ((12, 20), (16, 28), (24, 40), (36, 60)),
}
STEPS = (0.5, 1.0)


def fem_runs(case):
    return [
        reference(case, model, degree, cells, 0, steps=STEPS)
        for model, ladder in (("shell", SHELLS), ("solid", SOLIDS))
        for degree, cells in ladder
    ]


def calculix_runs(case):
    return [
        calculix.run(case, kind, *cells) for kind, ladder in CALCULIX.items() for cells in ladder
    ]


def calculix_reference(case):
    """CalculiX has S = C : E, not the Biot law: its reference has that too."""
    return reference(case, "shell", 4, (8, 12), 1, law="svk")


def all_runs(case):
    if case.name != CASE:
        return []
    return [
        *(
            hybrid(case, fidelity, around)
            for fidelity in FIDELITIES
            if fidelity != "rod"
            for around in AROUND
        ),
        *fem_runs(case),
        *((*calculix_runs(case), calculix_reference(case)) if calculix.PROGRAM else ()),
    ]


@lru_cache
def timed():
    """Identities of the runs whose times are compared."""
    return frozenset(run.identity for run in all_runs(case_named(CASE)))


def row_of(model, settings, record, result, numbers, own, against):
    return {
        "case": CASE,
        "model": model,
        "settings": settings,
        "seconds": record["processor_seconds"],
        "solve_seconds": record.get("solve_seconds"),
        "repeats": record.get("repeats", 1),
        "peak_bytes": record["peak_bytes"],
        "rms": numbers["rms"],
        "largest": numbers["largest"],
        "reaction": max(numbers["force"], numbers["moment"]),
        "reference_rms": own["u_shape"],
        "reference": against,
        **counts_of(result),
    }


def make_table(store, path):
    case = case_named(CASE)
    truth, truth_record = chosen_reference(store, case)
    if truth is None:
        return
    rows, records = [], [truth_record]
    for run in all_runs(case):
        record = store.record(run.identity)
        if (
            run.program == "ccx"
            or not converged(store, record)
            or run.identity in (truth.identity, calculix_reference(case).identity)
        ):
            continue
        name = run.identity.split("/")[1]
        model, settings = name.split("-")[0], name.split("-", 1)[1].removesuffix("-r0-biot")
        numbers = compared(store, case, run, truth)
        records.append(record)
        rows.append(
            row_of(
                model,
                settings,
                record,
                result_of(store, run.identity),
                numbers,
                numbers,
                truth.identity.split("/")[1],
            )
        )
    own_truth = calculix_reference(case)
    if converged(store, store.record(own_truth.identity)):
        records.append(store.record(own_truth.identity))
        for run in calculix_runs(case):
            record = store.record(run.identity)
            if not converged(store, record):
                continue
            calculix.write_result(store, case, run, own_truth)
            numbers = {
                **shapes(
                    store,
                    run.identity,
                    own_truth.identity,
                    case.tube["radius"],
                    case.tube["length"],
                ),
                **reactions(
                    result_of(store, run.identity),
                    result_of(store, own_truth.identity),
                    case.tube["radius"],
                ),
            }
            records.append(record)
            rows.append(
                row_of(
                    "CalculiX " + run.identity.split("-")[1],
                    run.identity.rsplit("-", 1)[1],
                    record,
                    {},
                    numbers,
                    own_error(result_of(store, own_truth.identity)),
                    own_truth.identity.split("/")[1],
                )
            )
    if rows:
        write_table(
            path,
            rows,
            [
                (
                    f"Case {CASE}: processor time and peak memory of the whole program against its"
                    " error"
                ),
                *provenance(records),
            ],
        )
