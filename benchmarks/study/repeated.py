"""The rows of the baseline tables that a quick check runs anew: a few of each table, chosen so that
all of them take minutes. A table's rows are made by the table's own module from the finished runs.
Those that compare with the finite-element reference need `vasorod-fem`."""

import tempfile
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Callable

import accuracy
import counts
import extremes
import glenn_mouths
import glenns
import inflated
import inflated_bends
import irregular
import join
import kinks
import laws
import pressure
import prestress
import prestress_drift
import promise
import sections
import sensitivity
import shear_gap
import sizes
import trade
import widening
from cases import case_named
from drift import TOLERANCES, VALUE, Unchecked, drifts, sentence
from regression import accepted
from runs import accuracy_shell, hybrid, reference
from store import REPOSITORY
from tables import read_table, replace_rows

BASELINES = REPOSITORY / "benchmarks" / "baselines"
BEND, PAST, FRESH = "bend_t1_0.5", "twist_t2_90", "fresh_bend_t0.7"
JOIN = ("ellipse", 1.0, "biot", 1.0, "coupled", 40)
UNDER_PRESSURE = ("slit", 1.0, 10, 40)
BENDS = (
    ("soft", 0.2, 0, "coupled", 32),
    ("soft", 0.2, 5, "coupled", 32),
    ("rigid", 0.4, 1, "coupled", 32),
    ("soft", 0.2, 5, "section", 32),
)
KINK = tuple(("rigid", share, 1, "coupled", 32) for share in (0.65, 0.7))  # on both its sides


@dataclass(frozen=True)
class Repeated:
    """Rows of one table."""

    file: str
    keys: tuple  # the columns that name a row
    rows: tuple  # their values
    runs: Callable  # () -> the runs that the rows are made from
    make: Callable  # (store, folder): writes the table of the finished runs into folder
    values: tuple = ()  # columns that are no errors here as they are in other tables


def bend_runs():
    """`bend_t1_0.5` and its reference, which six tables share."""
    bend = case_named(BEND)
    return [
        accuracy_shell(bend),
        *(hybrid(bend, fidelity, 24) for fidelity in ("rod", "skin", "paper", "coupled")),
        *(hybrid(bend, fidelity, 48) for fidelity in ("skin", "paper", "coupled")),
    ]


def past_runs():
    """Past the limit, where no reference converges: how the runs end."""
    past = case_named(PAST)
    return [hybrid(past, "skin", 48), *(hybrid(past, name, 24) for name in ("paper", "coupled"))]


def trade_runs():
    bend = case_named(BEND)
    coarse = [("shell", 3, (6, 8)), ("solid", 2, (12, 16))]
    return bend_runs() + [reference(bend, *one, 0, steps=trade.STEPS) for one in coarse]


def section_runs():
    bend = case_named(BEND)
    return [*bend_runs(), *(sections.run(bend, surface) for surface in sections.SURFACES)]


def speed_runs():
    bend = case_named(BEND)
    timed = sections.speed_runs(bend)
    names = (("section", "24"), ("coupled", "24"), ("shell", "p3-6x8"))
    return [accuracy_shell(bend), *(timed[name] for name in names)]


def laws_runs():
    bend = case_named(BEND)
    return [one(bend, law) for one in (laws.shell, laws.coupled) for law in ("biot", "svk")]


def promise_runs():
    fresh = case_named(FRESH)
    return [accuracy_shell(fresh), *(promise.promise_run(fresh, wanted) for wanted in (0.05, 0.01))]


def sensitivity_shells():
    return [sensitivity.reference_run("stretch", "E", factor) for factor in (1.0, 0.01)]


def wall_rows():
    return (
        ("paper", "coefficients", "k_s/k_b 0.0001, k_c/k_b 0.001"),
        ("paper", "vertices", 13020),
        ("paper", "aspect", "100 along the axis, three rows"),
        ("paper", "twist", "2 turns"),
        ("coupled", "moduli", "E x 1e-06, G x 1e-06"),
        ("coupled", "moduli", "E x 1000, G x 1"),
        ("coupled", "vertices", 1680),
        ("coupled", "bend", "t/R 0.1, Brazier ratio 0.9"),
        ("section", "moduli", "E x 1, G x 1000"),
        ("section", "vertices", 1680),
    )


def wall_runs():
    wanted = {(fidelity, family, str(case)) for fidelity, family, case in wall_rows()}
    return [
        extremes.wall_run(case, fidelity)
        for case, fidelity in extremes.wall_cases()
        if (fidelity, case.family, case.name) in wanted
    ]


def with_folder(make, *names):
    """Of a module's `make_table(store, path)`, its `make(store, folder)`."""
    return lambda store, folder: make(store, folder.joinpath(*names))


# Without the reference.
ALONE = (
    Repeated(
        "accuracy.csv",
        ("case", "model", "around"),
        ((PAST, "paper", 24), (PAST, "coupled", 24)),
        past_runs,
        lambda store, folder: accuracy.make_table(
            store, [case_named(PAST)], folder / "accuracy.csv"
        ),
    ),
    Repeated(
        inflated_bends.FILE,
        inflated_bends.KEYS,
        BENDS,
        lambda: [inflated_bends.run(*bend) for bend in BENDS],
        with_folder(inflated_bends.make_table, inflated_bends.FILE),
        ("moment",),
    ),
    Repeated(
        widening.FILE,
        widening.KEYS,
        (("section", 0.5, 5), ("coupled", 0.5, 1)),
        lambda: [widening.empty(0.5)]
        + [widening.run("section", 0.5, 5), widening.run("coupled", 0.5, 1)],
        with_folder(widening.make_table, widening.FILE),
    ),
    Repeated(
        kinks.FILE,
        inflated_bends.KEYS,
        KINK,
        lambda: [inflated_bends.run(*bend) for bend in KINK],
        with_folder(kinks.make_table, kinks.FILE),
        ("moment",),
    ),
    Repeated(
        prestress_drift.FILE,
        prestress_drift.KEYS,
        (("curved", "neo-hookean", "section"), ("curved", "neo-hookean", "coupled")),
        lambda: [prestress_drift.run("curved", "neo-hookean", "coupled", seen=False)]
        + [prestress_drift.run("curved", "neo-hookean", model) for model in prestress_drift.HYBRID],
        with_folder(prestress_drift.make_table, prestress_drift.FILE),
    ),
    Repeated(
        glenn_mouths.FILE,
        glenn_mouths.KEYS,
        ((1.25, 10),),
        lambda: [glenn_mouths.run(1.25, 10)],
        with_folder(glenn_mouths.make_table, glenn_mouths.FILE),
    ),
    Repeated(
        "extremes_wall.csv",
        ("fidelity", "family", "case"),
        wall_rows(),
        wall_runs,
        lambda store, folder: extremes.make_tables(store, folder, whole=False),
    ),
    Repeated(
        sizes.FILE,
        ("fidelity", "vertices"),
        tuple((fidelity, sizes.vertices(40)) for fidelity in sizes.FIDELITIES),
        lambda: [sizes.run(fidelity, 40) for fidelity in sizes.FIDELITIES],
        lambda store, folder: sizes.make_table(store, folder / sizes.FILE, whole=False),
    ),
    Repeated(
        sections.REFINEMENT,
        ("harmonics", "spans"),
        ((10, 6), (10, 13)),
        lambda: [sections.refinement_run()],
        lambda store, folder: sections.make_refinement(store, folder / sections.REFINEMENT),
    ),
    Repeated(
        "extremes_rod.csv",
        ("group",),
        (("slenderness, end pose",), ("moduli, end pose",), ("trees",), ("size",)),
        lambda: [extremes.rod_run()],
        lambda store, folder: extremes.make_tables(store, folder, whole=False),
    ),
)


def prestressed(pairs, case, law):
    """The straight tube's run and that of its reference."""
    return [
        one
        for name, shape, of, hybrid, shell in pairs
        for one in (hybrid, shell)
        if (name, shape, of) == (case, "straight", law)
    ]


# The anatomy is not part of the project.
ANATOMY = (
    Repeated(
        glenns.FILE,
        ("cut", "incision", "rotation"),
        (("low", "upper side", "auto"),),
        lambda: [glenns.run("low", "upper side", "auto")],
        lambda store, folder: glenns.make_table(store, folder / glenns.FILE, whole=False),
    ),
    Repeated(
        glenns.FOLDED_FILE,
        ("pressure", "cut", "incision", "rotation"),
        ((12, "low", "towards the vein", "auto"),),
        lambda: [glenns.folded_run(12, "low", "towards the vein", "auto")],
        lambda store, folder: glenns.make_folded_table(
            store, folder / glenns.FOLDED_FILE, whole=False
        ),
    ),
)
# Against the reference.
AGAINST = (
    Repeated(
        "accuracy.csv",
        ("case", "model", "around"),
        tuple((BEND, model, 24) for model in ("rod", "skin", "paper", "coupled"))
        + ((BEND, "paper", 48), (BEND, "coupled", 48)),
        bend_runs,
        lambda store, folder: accuracy.make_table(
            store, [case_named(BEND)], folder / "accuracy.csv"
        ),
    ),
    Repeated(
        "trade.csv",
        ("model", "settings"),
        (("skin", 24), ("paper", 24), ("coupled", 24), ("coupled", 48))
        + (("shell", "p3-6x8"), ("solid", "p2-12x16")),
        trade_runs,
        with_folder(trade.make_table, "trade.csv"),
    ),
    Repeated(
        sections.FILE,
        ("case", "surface"),
        ((BEND, "24 around"), (BEND, "48 around"), (BEND, "blue-noise")),
        section_runs,
        lambda store, folder: sections.make_tables(store, [case_named(BEND)], folder),
    ),
    Repeated(
        sections.SPEED,
        ("case", "model", "settings"),
        ((BEND, "section", 24), (BEND, "coupled", 24), (BEND, "shell", "p3-6x8")),
        speed_runs,
        lambda store, folder: sections.make_tables(store, [], folder),
    ),
    Repeated(
        "irregular.csv",
        ("case", "mesh"),
        ((BEND, "blue-noise"),),
        lambda: [*bend_runs(), irregular.run(case_named(BEND), "blue-noise")],
        lambda store, folder: irregular.make_table(
            store, [case_named(BEND)], folder / "irregular.csv"
        ),
    ),
    Repeated(
        "laws.csv",
        ("case", "difference", "law"),
        ((BEND, "kinematics", "biot"), (BEND, "kinematics", "svk"), (BEND, "law", "svk")),
        laws_runs,
        with_folder(laws.make_table, "laws.csv"),
    ),
    Repeated(
        "promise.csv",
        ("case", "wanted"),
        ((FRESH, 0.05), (FRESH, 0.01)),
        promise_runs,
        lambda store, folder: promise.make_table(
            store,
            [case_named(FRESH)],
            folder / "promise.csv",
            promise.measurements(BASELINES),
        ),
    ),
    Repeated(
        prestress.FILES[0],
        ("case", "shape", "law"),
        (("inflate", "straight", "biot"), ("shorten", "straight", prestress.LAW)),
        lambda: prestressed(prestress.tube_pairs(), "inflate", "biot")
        + prestressed(prestress.tube_pairs(), "shorten", prestress.LAW),
        prestress.make_tables,
    ),
    Repeated(
        prestress.FILES[1],
        ("opening", "length", "stretch"),
        (("ellipse", 1, 1),),
        lambda: [
            one
            for *key, hybrid, shell in prestress.join_pairs()
            for one in (hybrid, shell)
            if key == ["ellipse", 1.0, 1.0]
        ],
        prestress.make_tables,
    ),
    Repeated(
        "shear_gap.csv",
        ("thickness", "around"),
        ((1, 48),),
        lambda: [shear_gap.hybrid_run(1, 48), shear_gap.reference_run(1)],
        with_folder(shear_gap.make_table, "shear_gap.csv"),
        ("force",),
    ),
    Repeated(
        inflated.FILE,
        ("load", "pressure", "fidelity"),
        tuple(("bend", 5, fidelity) for fidelity in inflated.FIDELITIES),
        lambda: [inflated.hybrid_run("bend", 5, name) for name in inflated.FIDELITIES]
        + [inflated.shell_run("bend", 5)],
        with_folder(inflated.make_table, inflated.FILE),
    ),
    Repeated(
        join.FILE,
        join.KEYS,
        (JOIN,),
        lambda: [join.hybrid_run("ellipse", 1.0, "biot", around=40)]
        + [join.shell_run("ellipse", 1.0, "biot")],
        with_folder(join.make_table, join.FILE),
    ),
    Repeated(
        pressure.FILE,
        pressure.KEYS,
        (UNDER_PRESSURE,),
        lambda: [pressure.hybrid_run(*UNDER_PRESSURE), pressure.shell_run(*UNDER_PRESSURE[:3])],
        pressure.make_tables,
    ),
    Repeated(
        pressure.SHELL_FILE,
        ("cells",),
        ((3 * pressure.CELLS // 2,),),
        lambda: [pressure.shell_run(*pressure.SHELL)],
        pressure.make_tables,
    ),
    Repeated(
        "sensitivity.csv",
        ("load", "modulus", "factor", "fidelity"),
        (("stretch", "E", 0.01, "shell"),),
        sensitivity_shells,
        with_folder(sensitivity.make_shells, "sensitivity.csv"),
        ("force", "moment"),
    ),
)


def by_key(rows, keys):
    return {tuple(row[key] for key in keys): row for row in rows}


def repeat(store, baselines, one, again=False):
    """Runs the rows anew: [(key, the baseline's row, the row as it is now)]. None where the row is
    not there."""
    for run in one.runs():
        # The study keeps the reference's runs when the program is rebuilt; a check does not.
        store.ensure(replace(run, keep=False), again)
    old = by_key(read_table(baselines / one.file)[0], one.keys)
    with tempfile.TemporaryDirectory() as folder:
        one.make(store, Path(folder))
        made = Path(folder) / one.file
        new = by_key(read_table(made)[0], one.keys) if made.exists() else {}
    return [(row, old.get(row), new.get(row)) for row in one.rows]


def tolerances_of(one):
    return TOLERANCES | dict.fromkeys(one.values, VALUE)


def unchecked(row):
    """Its times and the like, which were measured under the conditions of the other rows."""
    return {name: row[name] for name in row if isinstance(TOLERANCES.get(name), Unchecked)}


def grown(old, new):
    """Whether the new row has a count that the old one, from before the counts, has not."""
    return any(old.get(name) is None and new.get(name) is not None for name in counts.COLUMNS)


def check_table(store, baselines, one, again=False):
    """Sentences of what drifted in the table's repeated rows."""
    found = []
    for row, old, new in repeat(store, baselines, one, again):
        if old is None or new is None:
            name = ", ".join(map(str, row))
            where = "the baseline has" if old is None else "the runs now give"
            found.append(f"{one.file}: {name}: {where} no such row")
            continue
        found += [
            sentence(one.file, row, moved)
            for moved in drifts(one.keys, old, new, tolerances_of(one))
        ]
    return found


def tables(fem):
    """Those to check, with or without the reference; says which it leaves out for want of their
    data."""
    if fem:
        return AGAINST
    if not glenns.has_anatomy():
        print(f"{glenns.FILE}, {glenns.FOLDED_FILE}: left out, the anatomy is not there")
        return ALONE
    return ALONE + ANATOMY


def accept(store, baselines, fem, reason):
    """Takes the numbers of the repeated rows that drifted for the baseline, with the reason in the
    table."""
    for one in tables(fem):
        moved = [
            {**new, **unchecked(old)}
            for _, old, new in repeat(store, baselines, one)
            if old and new and (drifts(one.keys, old, new, tolerances_of(one)) or grown(old, new))
        ]
        if moved:
            note = f"{len(moved)} rows {accepted(reason)}"
            replace_rows(baselines / one.file, one.keys, moved, note)
            print(f"{one.file}: {note}")


def check(store, baselines, fem, again=False):
    """True where no repeated row drifted; else says what did."""
    good = True
    for one in tables(fem):
        found = check_table(store, baselines, one, again)
        for text in found:
            print(text, flush=True)
        if not found:
            print(f"{len(one.rows)} rows of {one.file}: no drift", flush=True)
        good = good and not found
    return good
