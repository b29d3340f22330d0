#!/usr/bin/env python3
"""Runs `vasorod` on tubes with extreme walls and loads, and counts how the runs end.

    wall_extremes.py build/bin/vasorod [--fidelity paper section coupled] [--only NAME]
                     [--time-limit S] [--csv FILE]

A case is certified when its status is `converged`. Another status is a named ending, and so is a
refusal with one sentence. Anything else (a crash, a number in the result that is not finite) is a
failure; the exit code is then 1.
"""
import argparse
import csv
import json
import math
import os
import subprocess
import sys
import tempfile
from dataclasses import dataclass

LENGTH, RADIUS = 100.0, 10.0
STATUSES = {
    "converged",
    "equilibrium_only",
    "unstable",
    "buckled",
    "not_unique",
    "self_intersecting",
    "iteration_limit",
    "interrupted",
}


@dataclass
class Case:
    family: str
    name: str
    scene: str
    fidelities: tuple = ("paper", "section", "coupled")


def brazier(thickness, poisson=0.3):
    """Curvature at the Brazier limit of a long tube, 1/length:
    k_cr = 0.471 t / (R^2 sqrt(1 - nu^2))."""
    return 0.471 * thickness / (RADIUS**2 * math.sqrt(1 - poisson**2))


def scene(
    around=24,
    along=44,
    thickness=1.0,
    wall="young: 1.0, poisson: 0.3",
    bend=0.0,
    twist=0.0,
    stretch=1.0,
    coefficients=None,
):
    """A tube held at its start; its end follows the arc of `bend` radians, turned by `twist`
    radians, length times `stretch`."""
    arc = LENGTH * stretch
    x, z = (arc / bend * (1 - math.cos(bend)), arc / bend * math.sin(bend)) if bend else (0.0, arc)
    ends = [
        f"  - {{vessel: tube, end: end, rotate_deg: [0, {math.degrees(bend):.10g},"
        f" {math.degrees(twist):.10g}], move: [{x:.10g}, 0, {z - LENGTH:.10g}]}}"
    ]
    lines = [
        "scene: extreme",
        "units: {length: mm, stress: MPa}",
        "vessels:",
        "  - name: tube",
        f"    tube: {{length: {LENGTH}, radius: {RADIUS}, around: {around}, along: {along}}}",
        f"    wall: {{thickness: {thickness}, {wall}}}",
    ]
    if coefficients:
        lines.append(
            "    coefficients: {{binding: {}, bending: {}, stretching: {}}}".format(*coefficients)
        )
    return "\n".join(
        lines
        + ["ends:", "  - {vessel: tube, end: start, hold: true}"]
        + ends
        + ["fidelity: paper", ""]
    )


def cases():
    quarter = 0.25 * brazier(1.0) * LENGTH
    factors = (1e-6, 1e-3, 1.0, 1e3, 1e6)
    for e in factors:
        for g in factors:
            wall = (
                f"young: {e:g}, shear: {g / 2.6:.10g},"
                f" transverse: {{young: {e:g}, poisson: 0.3, coupling: 0.0}}"
            )
            yield Case(
                "moduli",
                f"E x {e:g}, G x {g:g}",
                scene(wall=wall, bend=quarter, twist=0.01, stretch=1.02),
                ("section", "coupled") if g != 1.0 else ("paper", "section", "coupled"),
            )
    for ratio in (1e-4, 1e-3, 1e-2, 0.1, 1.0, 10.0, 100.0, 1e3, 1e4):
        for binding in (1e-3, 0.1, 10.0):
            yield Case(
                "coefficients",
                f"k_s/k_b {ratio:g}, k_c/k_b {binding:g}",
                scene(
                    bend=math.pi / 2,
                    twist=math.pi / 3,
                    stretch=1.05,
                    coefficients=(binding, 1.0, ratio),
                ),
                ("paper",),
            )
    yield Case("aspect", "100 along the axis", scene(around=1256, along=20, bend=quarter))
    yield Case("aspect", "100 along the axis, three rows", scene(around=200, along=3, bend=quarter))
    yield Case("aspect", "100 around", scene(around=8, along=1270, bend=quarter))
    for around in (10, 30, 84, 168, 532):
        along = round(LENGTH / (2 * math.pi * RADIUS / around * math.sqrt(3) / 2))
        yield Case(
            "vertices", f"{around * (along + 1)}", scene(around=around, along=along, bend=quarter)
        )
    for turns in (0.25, 0.5, 1.0, 2.0, 3.0):
        yield Case("twist", f"{turns:g} turns", scene(twist=2 * math.pi * turns))
    for thickness in (1.0, 2.0):
        for ratio in (0.7, 0.9, 1.0, 1.2, 1.5, 2.0):
            yield Case(
                "bend",
                f"t/R {thickness / RADIUS:g}, Brazier ratio {ratio:g}",
                scene(thickness=thickness, bend=ratio * brazier(thickness) * LENGTH),
            )


def finite(value):
    """True when no number below is null or not finite."""
    if isinstance(value, dict):
        return all(finite(v) for v in value.values())
    if isinstance(value, list):
        return all(finite(v) for v in value)
    return value is not None and not (isinstance(value, float) and not math.isfinite(value))


def run(program, case, fidelity, time_limit, folder):
    """How one run ends: (ending, seconds of user time, peak MB, iterations, sentence)."""
    path = os.path.join(folder, "extreme.yaml")
    with open(path, "w", encoding="utf-8") as file:
        file.write(case.scene)
    out = os.path.join(folder, "result")
    command = [
        program,
        "solve",
        path,
        "-o",
        out,
        "--fidelity",
        fidelity,
        "--threads",
        "1",
        "--quiet",
        "--time-limit",
        str(time_limit),
    ]
    with subprocess.Popen(
        command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True
    ) as process:
        sentence = process.stderr.read().strip()
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    cost = (usage.ru_utime, usage.ru_maxrss / 1024)
    if process.returncode == 2:
        return "refused", *cost, 0, sentence
    if process.returncode not in (0, 1):
        return "failed", *cost, 0, f"exit code {process.returncode} {sentence}"
    with open(os.path.join(out, "result.json"), encoding="utf-8") as file:
        result = json.load(file)
    checked = {key: result[key] for key in ("ends", "balance", "energy", "metrics")}
    if result["status"] not in STATUSES or not finite(checked):
        return "failed", *cost, 0, "a number that is not finite"
    notes = "; ".join(result["certificate"]["notes"])
    return result["status"], *cost, result["iterations"]["surface"], notes


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("program")
    parser.add_argument("--fidelity", nargs="+", default=["paper", "section", "coupled"])
    parser.add_argument("--only", default="", help="families or names that contain this")
    parser.add_argument("--time-limit", type=float, default=120, help="seconds per run")
    parser.add_argument("--csv", help="every run as a line")
    args = parser.parse_args()
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for fidelity in args.fidelity:
            for case in cases():
                if (
                    fidelity not in case.fidelities
                    or args.only not in f"{case.family}: {case.name}"
                ):
                    continue
                ending = run(os.path.abspath(args.program), case, fidelity, args.time_limit, folder)
                rows.append((fidelity, case.family, case.name, *ending))
                if ending[0] != "converged":
                    print(
                        f"{fidelity}, {case.family}, {case.name}: {ending[0]}  {ending[4]}",
                        flush=True,
                    )
    if args.csv:
        with open(args.csv, "w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file)
            writer.writerow(
                [
                    "fidelity",
                    "family",
                    "case",
                    "ending",
                    "user_seconds",
                    "peak_mb",
                    "iterations",
                    "sentence",
                ]
            )
            writer.writerows((*row[:4], f"{row[4]:.2f}", f"{row[5]:.0f}", *row[6:]) for row in rows)
    print(
        "\n| fidelity | family | runs | converged"
        " | named otherwise | failed | most seconds | most MB |"
    )
    print("|---|---|---|---|---|---|---|---|")
    for key in dict.fromkeys((row[0], row[1]) for row in rows):
        of = [row for row in rows if (row[0], row[1]) == key]
        good = sum(row[3] == "converged" for row in of)
        bad = sum(row[3] == "failed" for row in of)
        print(
            f"| {key[0]} | {key[1]} | {len(of)} | {good} | {len(of) - good - bad} | {bad} | "
            f"{max(row[4] for row in of):.1f} | {max(row[5] for row in of):.0f} |"
        )
    return 1 if any(row[3] == "failed" for row in rows) else 0


if __name__ == "__main__":
    sys.exit(main())
