"""The table behind `accuracy: x`, hybrid/judge/accuracy_table.cpp, from the accuracy table and that
of sections. It is made from pulled, twisted and bent straight tubes; all other cases check that its
promise is kept (see held_out)."""

import math

import sections
from measure import converged, failure_of, result_of
from runs import Run, hybrid_arguments
from tables import provenance, read_table, write_table

FIDELITIES = ("skin", "paper", "section", "coupled")
KINDS = ("stretch", "twist", "bend")
# On what was measured: a tube twice as long exceeded the bare table by 41 %, a tapered one by 8 %.
SAFETY = 1.5
HEAD = """// Written by benchmarks/study/study.py promise: do not edit. Made from
// {source}.
// clang-format off
#include "judge/accuracy_table.h"

namespace vasorod {{
namespace {{

using enum LoadKind;

constexpr AccuracyRow rows[] = {{
{rows}
}};

}}  // namespace

std::span<const AccuracyRow> accuracy_table() {{
  return rows;
}}

AccuracyScope accuracy_scope() {{
  return {{{{{thickness}}}, {{{length}}}}};
}}

}}  // namespace vasorod
"""


def up(value):
    """Rounded up to two digits: what is promised is never less than what was measured."""
    if value == 0:
        return "0.0"
    step = 10.0 ** (math.floor(math.log10(value)) - 1)
    return f"{math.ceil(value / step - 1e-9) * step:.2g}"


def mean_edge(around, length=10.0, along_ratio=88 / 48):
    """Mean edge over R of a generated tube with `around` points around (staggered rows), length
    over R as given, 1 % added."""
    row = length / (around * along_ratio)
    half = 2 * math.sin(math.pi / (2 * around))
    return 1.01 * (2 * math.sin(math.pi / around) + 2 * math.hypot(row, half)) / 3


def promise_rows(accuracy):
    """(fidelity, kind, edge, demand, error) sorted; the error is SAFETY times the largest measured
    over all walls with the reference's own added."""
    made_from = [
        row
        for row in accuracy
        if row["counted"] and row["family"] in KINDS and row["model"] in FIDELITIES
    ]
    rows = []
    for fidelity in FIDELITIES:
        for kind in KINDS:
            mine = [row for row in made_from if row["model"] == fidelity and row["family"] == kind]
            for around in sorted({row["around"] for row in mine}, reverse=True):
                largest = 0.0
                for ratio in sorted({row["ratio"] for row in mine}):
                    level = [
                        row for row in mine if row["around"] == around and row["ratio"] == ratio
                    ]
                    if not level or any(row["rms"] is None for row in level):
                        break  # what failed is not promised, nor anything beyond it
                    largest = max(
                        largest, *(row["rms"] + (row["u_shape"] or 0) for row in level), 0.0
                    )
                    rows.append(
                        (
                            fidelity,
                            kind,
                            mean_edge(around),
                            min(row[f"demand_{kind}"] for row in level),
                            SAFETY * largest,
                        )
                    )
    return rows


def source_text(accuracy, source):
    rows = promise_rows(accuracy)
    tubes = [row for row in accuracy if row["family"] in KINDS]

    def span(column):
        values = [row[column] for row in tubes]
        return f"{min(values):g}, {max(values):g}"

    lines = [
        f'    {{"{fidelity}", {kind}, {edge:.4f}, {demand:.4g}, {up(error)}}},'
        for fidelity, kind, edge, demand, error in rows
    ]
    return HEAD.format(
        source=source,
        rows="\n".join(lines),
        thickness=span("thickness_over_radius"),
        length=span("length_over_radius"),
    )


def promised(rows, fidelity, around, demands):
    """As hybrid/judge/choose_fidelity.cpp does it: linear from zero at rest, summed over the kinds
    of load; None where the table ends."""
    total = 0.0
    for kind in KINDS:
        mine = [
            (demand, error)
            for f, k, edge, demand, error in rows
            if f == fidelity and k == kind and edge == mean_edge(around)
        ]
        before = (0.0, 0.0)
        for demand, error in mine:
            if demands[f"demand_{kind}"] <= demand:
                total += before[1] + (error - before[1]) * (
                    demands[f"demand_{kind}"] - before[0]
                ) / (demand - before[0])
                break
            before = (demand, error)
        else:
            return None
    return total


def pressed(row):
    """True where choose_fidelity.cpp promises nothing because the rod is pressed."""
    return (
        row["demand_press"] is not None
        and row["demand_press"] > 0.1 * 0.605 * row["thickness_over_radius"]
    )


def held_out(accuracy, within=True):
    """Every measured result the table was not made from, within its scope: (row, what it says the
    error is); else those that are pressed."""
    rows = promise_rows(accuracy)
    out = []
    for row in accuracy:
        if (
            row["family"] in KINDS
            or row["family"] == "curved"
            or not row["counted"]
            or row["model"] not in FIDELITIES
            or row["rms"] is None
            or pressed(row) == within
        ):
            continue
        error = promised(rows, row["model"], row["around"], row)
        if error is not None:
            out.append((row, error))
    return out


WANTED = (0.05, 0.01, 0.002)  # RMS distance over R that `accuracy:` is asked for


def promise_run(case, wanted):
    """The case as a user would ask for it, with `accuracy: x` in place of a fidelity."""
    changed = case.changed()
    del changed.scene["fidelity"]
    changed.scene["accuracy"] = wanted
    return Run(
        f"{case.name}/accuracy-{wanted:g}",
        "vasorod",
        hybrid_arguments(),
        {"scene.yaml": changed.text},
    )


def runs_of(case):
    """By what is asked for."""
    return (
        {wanted: promise_run(case, wanted) for wanted in WANTED} if case.family == "fresh" else {}
    )


def all_runs(case):
    return list(runs_of(case).values())


def make_table(store, cases, path, accuracy):
    """What `accuracy: x` chose on cases that neither the table nor its margin was made from, and
    how far that is from the reference by the accuracy table."""
    known = {(row["case"], row["model"], row["around"]): row for row in accuracy}
    rows, records = [], []
    for case in cases:
        for wanted, run in runs_of(case).items():
            record = store.record(run.identity)
            if record is None:
                continue
            records.append(record)
            row = {"case": case.name, "wanted": wanted, "chosen": None, "rms": None}
            row |= {"u_shape": None, "failure": None}
            if converged(store, record):
                row["chosen"] = result_of(store, run.identity)["fidelity"]
                own = known[case.name, row["chosen"], case.tube["around"]]
                row |= {name: own[name] for name in ("rms", "u_shape")}
            else:
                row["failure"] = failure_of(store, record)
            rows.append(row)
    if rows:
        write_table(
            path,
            rows,
            [
                (
                    "What accuracy: x chose on cases its table was not made from; rms: its measured"
                    " distance over R, of accuracy.csv and sections.csv"
                ),
                *provenance(records),
            ],
        )


def measurements(baselines):
    """Of every fidelity, as rows of the accuracy table."""
    accuracy, _ = read_table(baselines / "accuracy.csv")
    return accuracy + sections.beside(accuracy, read_table(baselines / sections.FILE)[0])


SOURCE = "benchmarks/baselines/accuracy.csv and sections.csv"


def write_promise(baselines, target):
    target.write_text(source_text(measurements(baselines), SOURCE))
