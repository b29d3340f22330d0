#!/usr/bin/env python3
"""The comparison's driver.

  study.py run accuracy|references|... [--case NAME ...]   what is not there yet is run, the rest is kept
  study.py tables                                          tables from finished runs, into benchmarks/baselines
"""

import argparse
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

import accuracy  # noqa: E402
from cases import all_cases, case_named  # noqa: E402
from runs import accuracy_reference, accuracy_shell  # noqa: E402
from store import REPOSITORY, Store  # noqa: E402

BASELINES = REPOSITORY / "benchmarks" / "baselines"

PLANS = {
    "accuracy": accuracy.hybrid_runs,
    "shell": lambda case: [accuracy_shell(case)],
    "solid": lambda case: [accuracy_reference(case)],
}


def open_store(arguments):
    return Store(arguments.results, {"vasorod": arguments.build / "bin" / "vasorod", "vasorod-fem": arguments.build / "bin" / "vasorod-fem"})


def chosen_cases(arguments):
    return [case_named(name) for name in arguments.case] if arguments.case else all_cases()


def run(arguments):
    store = open_store(arguments)
    for case in chosen_cases(arguments):
        for one in PLANS[arguments.plan](case):
            record = store.ensure(one, arguments.again)
            print(f"{one.identity}: exit {record['exit']}, {record['user_seconds']:.2f} s, {record['peak_bytes'] / 2**20:.0f} MiB {record['sentence']}",
                  flush=True)


def tables(arguments):
    accuracy.make_table(open_store(arguments), all_cases(), arguments.baselines / "accuracy.csv")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--results", type=Path, default=REPOSITORY / "results" / "study", help="folder of all runs (default: results/study)")
    parser.add_argument("--build", type=Path, default=REPOSITORY / "build", help="build folder with the programs (default: build)")
    parser.add_argument("--baselines", type=Path, default=BASELINES, help="folder of the tables (default: benchmarks/baselines)")
    commands = parser.add_subparsers(dest="command", required=True)
    command = commands.add_parser("run", help="run what is not there yet")
    command.add_argument("plan", choices=sorted(PLANS))
    command.add_argument("--case", action="append", help="this case only (may be repeated)")
    command.add_argument("--again", action="store_true", help="repeat finished runs too")
    command.set_defaults(call=run)
    command = commands.add_parser("tables", help="tables from finished runs")
    command.set_defaults(call=tables)
    arguments = parser.parse_args()
    arguments.call(arguments)


if __name__ == "__main__":
    main()
