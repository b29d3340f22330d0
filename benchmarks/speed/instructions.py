#!/usr/bin/python3
"""Instruction counts of the kernels, which do not vary as times do: kernel_instructions under
valgrind's callgrind; three runs minus one run, divided by two.

  instructions.py PROGRAM             prints the counts beside the baseline's; exit code 1 where
                                      one is more than 2 % above it
  instructions.py PROGRAM --write     adds a line per kernel to the baseline, with the date and
                                      the compiler

The baseline (benchmarks/baselines/instructions.csv) is a history: the last line of a kernel is what
counts. Counts of another compiler or C library differ by more than 2 %: compare on one machine,
base and head built alike."""
import argparse
import csv
import datetime
import pathlib
import re
import subprocess
import sys
import tempfile

BASELINE = pathlib.Path(__file__).resolve().parent.parent / "baselines" / "instructions.csv"
FIELDS = ["kernel", "instructions", "date", "compiler"]
WORSE = 0.02


def instructions(program, kernel, runs):
    with tempfile.NamedTemporaryFile() as out:
        run = subprocess.run(
            [
                "valgrind",
                "--tool=callgrind",
                f"--callgrind-out-file={out.name}",
                program,
                kernel,
                str(runs),
            ],
            capture_output=True,
            text=True,
            check=True,
        )
    return int(re.search(r"Collected : (\d+)", run.stderr).group(1))


def measure(program):
    names = subprocess.run([program], capture_output=True, text=True, check=True).stdout.split()
    return {
        name: (instructions(program, name, 3) - instructions(program, name, 1)) // 2
        for name in names
    }


def last_known():
    if not BASELINE.exists():
        return {}
    with BASELINE.open(newline="") as lines:
        return {row["kernel"]: int(row["instructions"]) for row in csv.DictReader(lines)}


def write(counts):
    new = not BASELINE.exists()
    compiler = subprocess.run(
        ["c++", "--version"], capture_output=True, text=True, check=True
    ).stdout.split("\n")[0]
    with BASELINE.open("a", newline="") as lines:
        table = csv.DictWriter(lines, FIELDS, lineterminator="\n")
        if new:
            table.writeheader()
        for kernel, count in counts.items():
            table.writerow(
                {
                    "kernel": kernel,
                    "instructions": count,
                    "date": datetime.date.today().isoformat(),
                    "compiler": compiler,
                }
            )


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("program", help="the built kernel_instructions")
    parser.add_argument("--write", action="store_true")
    arguments = parser.parse_args()
    known = last_known()
    counts = measure(str(pathlib.Path(arguments.program).resolve()))
    worse = False
    for kernel, count in counts.items():
        ratio = count / known[kernel] if kernel in known else None
        worse |= ratio is not None and ratio > 1 + WORSE
        print(
            f"{kernel:16} {count:13,}"
            + (f"  {ratio:.4f} of the baseline's" if ratio else "  not in the baseline")
        )
    if arguments.write:
        write(counts)
    return 1 if worse and not arguments.write else 0


if __name__ == "__main__":
    sys.exit(main())
