#!/usr/bin/env python3
"""The comparison's driver.

  study.py run PLAN [--case NAME ...]   what is not there yet is run, the rest is kept
  study.py tables                       tables from finished runs, into benchmarks/baselines
  study.py promise                      the table behind `accuracy: x`, from those
  study.py report                       docs/comparison.md, docs/extremes.md and the pages of their
                                        tables, from the tables alone
  study.py check [--quick] [--fem]      has a number of a table moved? exit 1 says where; --fem: in
                                        the rows that compare with the reference
  study.py accept --reason TEXT         yes, and this is why; --quick: for the rows that a quick
                                        check repeats
"""

import argparse
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

import accuracy  # noqa: E402
import calculix  # noqa: E402
import extremes  # noqa: E402
import glenn_mouths  # noqa: E402
import glenns  # noqa: E402
import inflated  # noqa: E402
import inflated_bends  # noqa: E402
import irregular  # noqa: E402
import join  # noqa: E402
import kinks  # noqa: E402
import laws  # noqa: E402
import pressure  # noqa: E402
import prestress  # noqa: E402
import prestress_drift  # noqa: E402
import promise  # noqa: E402
import regression  # noqa: E402
import repeated  # noqa: E402
import sections  # noqa: E402
import sensitivity  # noqa: E402
import shear_gap  # noqa: E402
import sizes  # noqa: E402
import trade  # noqa: E402
import widening  # noqa: E402
from cases import all_cases, case_named  # noqa: E402
from runs import accuracy_reference, accuracy_shell  # noqa: E402
from store import REPOSITORY, Store  # noqa: E402

BASELINES = REPOSITORY / "benchmarks" / "baselines"

PLANS = {  # per case
    "accuracy": accuracy.hybrid_runs,
    "shell": lambda case: [accuracy_shell(case)],
    "solid": lambda case: [accuracy_reference(case)],
    "trade": trade.all_runs,
    "irregular": irregular.all_runs,
    "laws": laws.all_runs,
    "promise": promise.all_runs,
    "sections": sections.all_runs,
}
SWEEPS = {
    "sensitivity": sensitivity.runs,
    "sensitivity-reference": sensitivity.reference_runs,
}  # per load
WHOLE = {
    "extremes": extremes.all_runs,
    "shear-gap": shear_gap.all_runs,
    "join": join.all_runs,
    "pressure": pressure.all_runs,
    "inflated": inflated.all_runs,
    "widening": widening.all_runs,
    "inflated-bends": inflated_bends.all_runs,
    "kinks": kinks.all_runs,
    "prestress": prestress.all_runs,
    "prestress-drift": prestress_drift.all_runs,
    "glenns": glenns.all_runs,
    "glenn-mouths": glenn_mouths.all_runs,
    "sizes": sizes.all_runs,
    "section-refinement": lambda: [sections.refinement_run()],
}  # of no case


def open_store(arguments):
    names = ("vasorod", "vasorod-fem", "rod_extremes", "section_refinement")
    programs = {name: arguments.build / "bin" / name for name in names}
    if calculix.PROGRAM:
        programs["ccx"] = calculix.PROGRAM
    return Store(arguments.results, programs)


def chosen_cases(arguments):
    return [case_named(name) for name in arguments.case] if arguments.case else all_cases()


def every_run():
    """All runs of the study by identity."""
    runs = [one for case in all_cases() for plan in PLANS.values() for one in plan(case)]
    runs += [one for load in sensitivity.LOADS for sweep in SWEEPS.values() for one in sweep(load)]
    runs += [one for plan in WHOLE.values() for one in plan()]
    return {one.identity: one for one in runs}


def run_one(arguments):
    one = every_run().get(arguments.identity)
    if one is None:
        raise SystemExit(
            f"{arguments.identity}: found no such run, expected CASE/RUN as in results/study"
        )
    open_store(arguments).ensure(one, repeats=repeats_of(one))


def repeats_of(one):
    return trade.REPEATS if one.identity in trade.timed() | sections.timed() else 1


def runs_of(arguments):
    if arguments.plan in WHOLE:
        return WHOLE[arguments.plan]()
    if arguments.plan in SWEEPS:
        return [one for load in sensitivity.LOADS for one in SWEEPS[arguments.plan](load)]
    return [one for case in chosen_cases(arguments) for one in PLANS[arguments.plan](case)]


def run(arguments):
    store = open_store(arguments)
    for one in runs_of(arguments):
        record = store.ensure(one, arguments.again, repeats_of(one))
        print(
            (
                f"{one.identity}: exit {record['exit']}, {record['user_seconds']:.2f} s,"
                f" {record['peak_bytes'] / 2**20:.0f} MiB {record['sentence']}"
            ),
            flush=True,
        )


def tables(arguments):
    store = open_store(arguments)
    accuracy.make_table(store, all_cases(), arguments.baselines / "accuracy.csv")
    trade.make_table(store, arguments.baselines / "trade.csv")
    irregular.make_table(store, all_cases(), arguments.baselines / "irregular.csv")
    laws.make_table(store, arguments.baselines / "laws.csv")
    shear_gap.make_table(store, arguments.baselines / "shear_gap.csv")
    join.make_table(store, arguments.baselines / join.FILE)
    pressure.make_tables(store, arguments.baselines)
    for module in (inflated, widening, inflated_bends, kinks, prestress_drift, glenn_mouths):
        module.make_table(store, arguments.baselines / module.FILE)
    prestress.make_tables(store, arguments.baselines)
    extremes.make_tables(store, arguments.baselines)
    sizes.make_table(store, arguments.baselines / sizes.FILE)
    sections.make_tables(store, all_cases(), arguments.baselines)
    glenns.make_table(store, arguments.baselines / glenns.FILE)
    glenns.make_folded_table(store, arguments.baselines / glenns.FOLDED_FILE)
    promise.make_table(
        store,
        all_cases(),
        arguments.baselines / "promise.csv",
        promise.measurements(arguments.baselines),
    )
    if not (
        arguments.baselines / regression.FILE
    ).exists():  # the first; from then on `accept` alone changes it
        regression.accept(store, arguments.baselines, "first")


def write_promise(arguments):
    promise.write_promise(
        arguments.baselines, REPOSITORY / "hybrid" / "judge" / "accuracy_table.cpp"
    )


def write_report(arguments):
    import report  # needs matplotlib

    report.write_report(arguments.baselines, arguments.docs)


def check(arguments):
    image = arguments.results / "drift.png"
    store = open_store(arguments)
    baselines, quick, again = arguments.baselines, arguments.quick, arguments.again
    if arguments.fem:
        good = repeated.check(store, baselines, True, again)
    else:
        # Each says what moved, so all of them are asked.
        curves = regression.check(store, baselines, quick, again, image)
        joins = join.check(store, baselines, quick, again)
        good = repeated.check(store, baselines, False, again) and curves and joins
    if not good:
        print("meant? study.py accept --reason '...' takes the new numbers")
        raise SystemExit(1)


def accept(arguments):
    store = open_store(arguments)
    if arguments.quick:
        repeated.accept(store, arguments.baselines, arguments.fem, arguments.reason)
        if not arguments.fem:
            regression.accept_quick(store, arguments.baselines, arguments.reason)
            join.accept_quick(store, arguments.baselines, arguments.reason)
        return
    for load in sensitivity.LOADS:
        for one in sensitivity.runs(load):
            store.ensure(one)
    regression.accept(store, arguments.baselines, arguments.reason)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument(
        "--results",
        type=Path,
        default=REPOSITORY / "results" / "study",
        help="folder of all runs (default: results/study)",
    )
    parser.add_argument(
        "--build",
        type=Path,
        default=REPOSITORY / "build",
        help="build folder with the programs (default: build)",
    )
    parser.add_argument(
        "--baselines",
        type=Path,
        default=BASELINES,
        help="folder of the tables (default: benchmarks/baselines)",
    )
    commands = parser.add_subparsers(dest="command", required=True)
    command = commands.add_parser("run", help="run what is not there yet")
    command.add_argument("plan", choices=sorted([*PLANS, *SWEEPS, *WHOLE]))
    command.add_argument("--case", action="append", help="this case only (may be repeated)")
    command.add_argument("--again", action="store_true", help="repeat finished runs too")
    command.set_defaults(call=run)
    command = commands.add_parser("one", help="one run by its identity, for the workflow")
    command.add_argument("identity", help="CASE/RUN")
    command.set_defaults(call=run_one)
    command = commands.add_parser("tables", help="tables from finished runs")
    command.set_defaults(call=tables)
    command = commands.add_parser("promise", help="the table behind accuracy: x")
    command.set_defaults(call=write_promise)
    command = commands.add_parser("report", help="the pages, from the tables alone")
    command.add_argument(
        "--docs",
        type=Path,
        default=REPOSITORY / "docs",
        help="where the pages and their pictures go (default: docs)",
    )
    command.set_defaults(call=write_report)
    fem = "the rows that compare with the reference (vasorod-fem)"
    command = commands.add_parser("check", help="has a number of a baseline table moved?")
    command.add_argument(
        "--quick",
        action="store_true",
        help="few points of few curves and three joins instead of all",
    )
    command.add_argument("--fem", action="store_true", help=f"instead of the others {fem}")
    command.add_argument("--again", action="store_true", help="repeat finished runs too")
    command.set_defaults(call=check)
    command = commands.add_parser(
        "accept", help="take the numbers as they are now for the baseline"
    )
    command.add_argument("--reason", required=True, help="why they moved")
    command.add_argument(
        "--quick", action="store_true", help="the rows that a quick check repeats, not all curves"
    )
    command.add_argument("--fem", action="store_true", help=f"with --quick: {fem}")
    command.set_defaults(call=accept)
    arguments = parser.parse_args()
    arguments.call(arguments)


if __name__ == "__main__":
    main()
