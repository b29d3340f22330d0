#!/usr/bin/env python3
"""Instruction counts, which do not vary as times do, by valgrind's callgrind: of the kernels of
kernel_instructions (three runs minus one run, divided by two), and of whole `vasorod solve`s of
small scenes on one thread.

  instructions.py BUILD               prints the counts beside the baseline's; exit code 1 where one
                                      moved beyond its tolerance, up or down
  instructions.py BUILD --write       adds a line per count that moved to the baseline, with the
                                      date and the compiler
  instructions.py BUILD --only NAME   these counts only (may be repeated)

BUILD is a folder with bin/vasorod and bin/kernel_instructions. The baseline
(benchmarks/baselines/instructions.csv) is a history: the last line of a name counts. OpenBLAS takes
the kernels of one old processor, so that a count does not depend on the machine. Another compiler
or C library makes other code: a count then may differ by more."""
import argparse
import csv
import datetime
import os
import pathlib
import platform
import re
import shutil
import subprocess
import sys
import tempfile

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(REPOSITORY / "benchmarks" / "study"))

import join  # noqa: E402
from cases import case_named  # noqa: E402
from runs import hybrid_arguments  # noqa: E402

BASELINE = REPOSITORY / "benchmarks" / "baselines" / "instructions.csv"
FIELDS = ["kernel", "instructions", "date", "compiler"]
MOVED = 0.02  # two builds by one compiler differ by less where nothing changed
OTHER_COMPILER = 0.15  # vectorised or inlined otherwise, another sine or memory copy
MACHINE = "x86_64"  # of the baseline
SKIPPED = 77  # exit code: nothing was counted


def tube(fidelity):
    return fidelity, case_named("bend_t1_0.5").changed(around=24).text()


WHOLE = {  # (fidelity, scene) by name
    "coupled_tube": lambda: tube("coupled"),
    "coupled_join": lambda: ("coupled", join.scene("end to end", 1.0, "biot", 20, 1.0)),
    "section_tube": lambda: tube("section"),
}


def instructions(command, folder=None):
    """Of a program that ends well."""
    environment = {
        **os.environ,
        "OPENBLAS_CORETYPE": "Nehalem",
        "OPENBLAS_NUM_THREADS": "1",
        "OMP_NUM_THREADS": "1",
    }
    with tempfile.NamedTemporaryFile() as out:
        run = subprocess.run(
            ["valgrind", "--tool=callgrind", f"--callgrind-out-file={out.name}", *command],
            capture_output=True,
            text=True,
            env=environment,
            cwd=folder,
        )
    found = re.search(r"Collected : (\d+)", run.stderr)
    if run.returncode != 0 or not found:
        raise SystemExit(f"instructions: {' '.join(command)} failed:\n{run.stderr[-2000:]}")
    return int(found.group(1))


def of_kernel(build, name):
    program = str(build / "bin" / "kernel_instructions")
    once, thrice = (instructions([program, name, str(runs)]) for runs in (1, 3))
    return (thrice - once) // 2


def of_whole(build, name):
    fidelity, scene = WHOLE[name]()
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "scene.yaml").write_text(scene)
        command = [str(build / "bin" / "vasorod"), *hybrid_arguments(fidelity), "--no-report"]
        return instructions(command, folder)


def kernels(build):
    program = build / "bin" / "kernel_instructions"
    return subprocess.run([program], capture_output=True, text=True, check=True).stdout.split()


def measure(build, only):
    counts = {}
    for names, count in ((kernels(build), of_kernel), (WHOLE, of_whole)):
        counts |= {name: count(build, name) for name in names if not only or name in only}
    return counts


def last_known(baseline):
    """{name: (instructions, compiler)}"""
    if not baseline.exists():
        return {}
    with baseline.open(newline="") as lines:
        return {
            row["kernel"]: (int(row["instructions"]), row["compiler"])
            for row in csv.DictReader(lines)
        }


def compiler_of(build):
    """First line of the version of the compiler that made the build."""
    cache = (build / "CMakeCache.txt").read_text()
    program = re.search(r"^CMAKE_CXX_COMPILER:\w+=(.*)$", cache, re.MULTILINE).group(1)
    said = subprocess.run([program, "--version"], capture_output=True, text=True, check=True)
    # The name it was called by says nothing.
    return "c++ " + said.stdout.split("\n")[0].split(" ", 1)[1]


def compare(counts, known, compiler):
    """A line per count, and the names of those that moved."""
    lines, moved = [], []
    for name, count in counts.items():
        if name not in known:
            lines.append(f"{name:16} {count:15,}  not in the baseline")
            moved.append(name)
            continue
        was, by = known[name]
        allowed = MOVED if by == compiler else OTHER_COMPILER
        line = f"{name:16} {count:15,}  was {was:,}: {count / was - 1:+.2%}, allowed {allowed:.0%}"
        if abs(count / was - 1) > allowed:
            moved.append(name)
            line += "  MOVED"
        lines.append(line)
    return lines, moved


def write(baseline, counts, compiler):
    new = not baseline.exists()
    with baseline.open("a", newline="") as lines:
        table = csv.DictWriter(lines, FIELDS, lineterminator="\n")
        if new:
            table.writeheader()
        for name, count in counts.items():
            today = datetime.date.today().isoformat()
            table.writerow(dict(zip(FIELDS, (name, count, today, compiler))))


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("build", type=pathlib.Path, help="the build folder")
    parser.add_argument("--write", action="store_true", help="take the counts for the baseline")
    parser.add_argument("--only", action="append", help="this count only (may be repeated)")
    parser.add_argument("--baseline", type=pathlib.Path, default=BASELINE)
    arguments = parser.parse_args()
    if not shutil.which("valgrind"):
        print("instructions: valgrind is not installed: nothing was counted")
        return SKIPPED
    if platform.machine() != MACHINE:
        print(f"instructions: the baseline is of {MACHINE}, not of {platform.machine()}: left out")
        return SKIPPED
    build = arguments.build.resolve()
    compiler = compiler_of(build)
    counts = measure(build, arguments.only)
    lines, moved = compare(counts, last_known(arguments.baseline), compiler)
    print("\n".join(lines))
    if arguments.write:
        write(arguments.baseline, {name: counts[name] for name in moved}, compiler)
        return 0
    if moved:
        print(f"{len(moved)} counts moved; meant? the same command with --write takes them")
    return 1 if moved else 0


if __name__ == "__main__":
    sys.exit(main())
