"""The T-join under pressure: the mouth over pressure and length of the incision, from walls without
stress, against the reference's 7-parameter shell of the same law."""

import yaml

import join
from cases import text_of
from measure import converged, failure_of, finished_rows, result_of
from runs import Run, hybrid_arguments, reference_arguments
from tables import write_extended

LAW = "neo-hookean"
PRESSURES = (0, 5, 10, 15)  # mmHg
LENGTHS = (1.0, 1.25, 1.5)  # of a slit, over half the rim's perimeter
AROUND = (40, 60, 80)  # points around the vein
CELLS = 16  # of the shell around the seam, and those refined by 3/2
FINEST = 120  # points around the vein, of the slit of length 1
SHELL = ("slit", 1.0, 10)  # of which the shell's mesh is refined further
SHELL_CELLS = (CELLS, 24, 32)
FILE = "pressure.csv"
KEYS = ("opening", "length", "pressure", "around")
SHELL_FILE = "pressure_shells.csv"
SHELL_COLUMNS = ("unknowns", "mouth", "support", "energy")


def scene(opening, length, pressure, around):
    made = yaml.safe_load(join.scene(opening, 1.0, LAW, around, length))
    if pressure:
        made["units"]["pressure"] = "mmHg"
        for vessel in made["vessels"]:
            vessel["pressure"] = {"after": pressure}
    return text_of(made)


def name_of(opening, length, pressure):
    return f"pressure-{opening}-l{length:g}-p{pressure:g}"


def hybrid_run(opening, length, pressure, around=60):
    return Run(
        f"{name_of(opening, length, pressure)}/coupled-{around}",
        "vasorod",
        hybrid_arguments(),
        {"scene.yaml": scene(opening, length, pressure, around)},
    )


def shell_run(opening, length, pressure, cells=CELLS):
    """Kept when the program is rebuilt, as the tube's references are. Without pressure it is the
    join's."""
    if not pressure:
        return join.shell_run(opening, 1.0, LAW, length)
    return Run(
        f"{name_of(opening, length, pressure)}/shell-{cells}",
        "vasorod-fem",
        reference_arguments("shell", (cells, 0), 1),
        {"scene.yaml": scene(opening, length, pressure, 60)},
        keep=True,
    )


def pairs():
    """(opening, length, pressure, around, run, the shell it is measured against)"""
    cases = [
        ("slit", length, pressure, around)
        for length in LENGTHS
        for pressure in PRESSURES
        for around in AROUND
    ]
    cases += [("slit", 1.0, pressure, FINEST) for pressure in PRESSURES]
    cases += [("ellipse", 1.0, 10, 60)]
    for opening, length, pressure, around in cases:
        run = hybrid_run(opening, length, pressure, around)
        yield opening, length, pressure, around, run, shell_run(opening, length, pressure)


def all_runs():
    runs = [run for pair in pairs() for run in pair[-2:]]
    runs += [shell_run(*SHELL, cells) for cells in SHELL_CELLS]
    return list({run.identity: run for run in runs}.values())


def solved(store, record):
    """Whether a run has a solution. A pressure that follows the wall has no energy in the
    reference, and so no minimum to certify."""
    if converged(store, record):
        return True
    return record["exit"] == 1 and failure_of(store, record) == "status equilibrium_only"


def shell_rows(store):
    def numbers(run):
        result = result_of(store, run.identity)
        return {
            "unknowns": result["discretisation"]["dofs"],
            "mouth": join.mouth_of(result)["area"],
            "support": join.support(result),
            "energy": result["energy"]["total"],
        }

    named = (({"cells": 3 * cells // 2}, shell_run(*SHELL, cells)) for cells in SHELL_CELLS)
    return finished_rows(store, named, SHELL_COLUMNS, numbers, solved)


def make_tables(store, folder):
    plan = list(pairs())
    named = ((dict(zip(KEYS, pair)), *pair[-2:]) for pair in plan)
    note = "The T-join from walls without stress to a pressure (mmHg) in both lumens, neo-hookean,"
    note += " against the reference's shell; columns as in join.csv"
    keys_of = [pair[: len(KEYS)] for pair in plan]
    write_extended(folder / FILE, KEYS, keys_of, *join.measured(store, named, solved), note)
    note = "The T-join on the slit of length 1 at 10 mmHg by the reference's shell, over its mesh:"
    note += " cells around the seam; units as in join.csv"
    cells = [(3 * cells // 2,) for cells in SHELL_CELLS]
    write_extended(folder / SHELL_FILE, ("cells",), cells, *shell_rows(store), note)
