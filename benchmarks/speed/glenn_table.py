#!/usr/bin/env python3
"""Writes docs/speed.md: the times of the Glenn scenes and of an exploration, and three cuts.

  glenn_table.py PROGRAM      PROGRAM is a built `vasorod`

Every run uses a result folder in a temporary directory. A timed scene runs three times; the run
with the least wall time is reported, of the exploration every run. The adult is left out where its
surfaces are absent. Run it on an idle machine."""

import argparse
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import textwrap
import time

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
SCENES = REPOSITORY / "benchmarks" / "cases" / "glenn"
PAGE = REPOSITORY / "docs" / "speed.md"
TIMED = (
    ("infant", "coupled", 1),
    ("infant", "coupled", 2),
    ("infant", "paper", 1),
    ("infant", "paper", 2),
    ("infant", "skin", 1),
    ("infant", "rod", 1),
    ("adult", "coupled", 1),
    ("adult", "paper", 1),
    ("adult_physiological", "coupled", 1),
)
EXPLORED = "infant_options.yaml"
CUTS = (("short", "infant_short"), ("middle", "infant"), ("long", "infant_long"))
STAGES = ("read", "fit", "surgery", "solve", "collect", "write", "total")
REPEATS = 3


def surfaces(scene):
    """The surface files that a scene names."""
    text = (SCENES / f"{scene}.yaml").read_text()
    return [SCENES / name for name in re.findall(r"^\s*surface:\s*(\S+)", text, re.MULTILINE)]


def points(surface):
    """The number of points that the header of a VTP file states."""
    return int(re.search(rb'NumberOfPoints="(\d+)"', surface.read_bytes()).group(1))


def run(*arguments):
    """Processor seconds of a program and its children. Exit codes 0 and 1 write results."""
    process = subprocess.Popen(arguments, stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode not in (0, 1):
        sys.exit(f"{' '.join(arguments)}: exit code {process.returncode}")
    return usage.ru_utime + usage.ru_stime


def solve(program, scene, fidelity, threads=1):
    """(result.json, processor seconds of the whole program)."""
    with tempfile.TemporaryDirectory() as folder:
        arguments = [program, "solve", str(SCENES / f"{scene}.yaml"), "-o", f"{folder}/result"]
        arguments += ["--fidelity", fidelity, "--threads", str(threads), "--quiet"]
        processor = run(*arguments)
        result = json.loads(pathlib.Path(folder, "result", "result.json").read_text())
    return result, processor


def table(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|" + " --- |" * len(header)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def time_row(program, scene, fidelity, threads):
    runs = [solve(program, scene, fidelity, threads) for _ in range(REPEATS)]
    result, processor = min(runs, key=lambda run: run[0]["seconds"]["total"])
    seconds = [f"{result['seconds'][stage]:.2f}" for stage in STAGES]
    vertices = f"{result['model']['vertices']:,}"
    name = f"`{scene}.yaml`, `{fidelity}`"
    return [name, str(threads), result["status"], vertices, *seconds, f"{processor:.2f}"]


def explored(program):
    """(options of both stages, row) of one exploration. A stage ends with its last option."""
    with tempfile.TemporaryDirectory() as folder:
        began = time.time()
        processor = run(program, "explore", str(SCENES / EXPLORED), "-o", folder, "--quiet")
        ended = time.time()
        kept = pathlib.Path(folder, "finished")
        skin, coupled = (
            [file.stat().st_mtime for file in kept.glob(f"*-{fidelity}.json")]
            for fidelity in ("skin", "coupled")
        )
    first, last = max(skin), max(coupled)
    seconds = (first - began, last - first, ended - last, ended - began, processor)
    return (len(skin), len(coupled)), [f"{second:.1f}" for second in seconds]


def length(vector):
    return sum(x * x for x in vector) ** 0.5


def cut_row(name, scene, result):
    """Contact of the vein with the aorta; the gap is the smallest between the outer walls."""
    contact = next(c for c in result["contact"] if {c["a"], c["b"]} == {"svc", "aorta"})
    numbers = [f"{length(contact['force']):.4f}", f"{contact['area']:.2f}"]
    numbers += [f"{contact['largest_pressure']:.4f}", f"{max(0, contact['smallest_gap']):.2f}"]
    wrinkling = f"{result['validity']['wrinkling_ratio']:.2f}"
    return [f"{name} (`{scene}.yaml`)", result["status"], *numbers, wrinkling]


def seam_gap(result):
    """The largest gap of the seam over the vein's radius, both from result.json."""
    glenn = result["glenn"]
    return glenn["join"]["largest_gap"] / (glenn["cut"]["perimeter"] / (2 * 3.141592653589793))


def machine():
    text = pathlib.Path("/proc/cpuinfo").read_text()
    model = re.search(r"^model name\s*:\s*(.*)$", text, re.MULTILINE)
    mhz = re.search(r"^cpu MHz\s*:\s*(.*)$", text, re.MULTILINE)
    name = model.group(1).strip() if model else os.uname().machine
    clock = f" at {float(mhz.group(1)) / 1000:.2f} GHz" if mhz else ""
    return f"{name}{clock}, {os.cpu_count()} processors"


def paragraph(*sentences):
    return textwrap.fill(" ".join(sentences), 100, break_long_words=False, break_on_hyphens=False)


def introduction(load):
    return [
        "# Speed",
        paragraph(
            "Written by `benchmarks/speed/glenn_table.py build/bin/vasorod`; no measured number is",
            "typed by hand. The same command measures again and replaces this page.",
        ),
        paragraph(
            f"Machine: {machine()}. The load average was {load:.1f} when the measurement",
            "began. Other programs on the machine make the wall times longer; the",
            "processor times depend less on them.",
        ),
        paragraph(
            "Other measurements of speed: [rod.md](rod.md) for the rod solver, [wall.md](wall.md)",
            "for the surface solvers, [comparison.md](comparison.md) for time against error,",
            "[reference.md](reference.md) for the finite-element reference.",
        ),
    ]


def times_section(program):
    timed = [run for run in TIMED if all(path.exists() for path in surfaces(run[0]))]
    infant = {path.stem: points(path) for path in surfaces("infant")}
    with_heart = sum(infant.values())
    header = ("scene, fidelity", "threads", "status", "vertices", *STAGES, "processor time")
    return [
        "## Glenn scenes",
        paragraph(
            "Seconds of `vasorod solve SCENE -o DIR --fidelity F --threads N`. The stages are wall",
            "times, `seconds` in `result.json`. The last column is the processor time of the whole",
            f"program. Every scene ran {REPEATS} times; the table has the run with the least wall",
            "time. The results do not depend on the number of threads.",
        ),
        table(header, [time_row(program, *run) for run in timed]),
        paragraph(
            "`read` reads, checks and remeshes the surfaces. `fit` finds the centerlines and the",
            "rods. `surgery` cuts, incises and joins, and solves the rod of the vein. `solve`",
            "solves the surfaces. `collect` computes metrics and validity. `write` writes the",
            "result folder with its pictures.",
        ),
        paragraph(
            "The three vessels of the bundled infant have",
            f"{with_heart - infant['heart']:,} vertices ({with_heart:,} with the heart).",
            "The column `vertices` counts the deformed model without the stump; `rod` has no",
            "surface. The MICCAI 2009 paper states 10 s for 24,393 vertices in the three",
            "vessels that it counts, on a 2.33 GHz Core 2 Duo.",
        ),
    ]


def exploration_section(program):
    runs = [explored(program) for _ in range(REPEATS)]
    skin, coupled = runs[0][0]
    header = [f"fit, {skin} at `skin`", f"{coupled} at `coupled`", "table, page, pictures", "total"]
    return [
        "## An exploration",
        paragraph(
            f"Seconds of `vasorod explore benchmarks/cases/glenn/{EXPLORED} -o DIR`, one row for",
            "each run: wall times of its parts, and the processor time of all its processes.",
        ),
        table([*header, "processor time"], [row for _, row in runs]),
    ]


def cuts_section(program):
    cuts = [(name, scene, solve(program, scene, "paper")[0]) for name, scene in CUTS]
    worst = max(seam_gap(result) for _, _, result in cuts)
    header = ["kept vein", "status", "force, N", "area, mm²", "largest pressure, MPa"]
    return [
        "## Three cuts",
        paragraph(
            "The bundled infant with one incision and three places of the cut (Fig. 4(c-e) of the",
            "paper), fidelity `paper`. Force, area and pressure belong to the contact between the",
            "vein and the aorta. The gap is the smallest distance between their outer walls.",
            "The wrinkling ratio is `validity.wrinkling_ratio` of `result.json`.",
        ),
        table([*header, "gap, mm", "wrinkling ratio"], [cut_row(*cut) for cut in cuts]),
        paragraph(f"The largest gap of a seam is {100 * worst:.3f} % of the vein's radius."),
    ]


def page(program):
    sections = introduction(os.getloadavg()[0]) + times_section(program)
    sections += exploration_section(program) + cuts_section(program)
    return "\n\n".join(part.rstrip() for part in sections) + "\n"


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("program", help="a built vasorod")
    program = str(pathlib.Path(parser.parse_args().program).resolve())
    text = page(program)  # measured whole before the old page is replaced
    PAGE.write_text(text)
    print(PAGE)


if __name__ == "__main__":
    main()
