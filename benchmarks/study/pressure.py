"""The T-join under pressure: the mouth over pressure and length of the incision, from walls without
stress, against the reference's 7-parameter shell of the same law."""

import yaml

import join
from cases import text_of
from measure import converged, failure_of
from runs import Run, hybrid_arguments
from tables import provenance, write_table

LAW = "neo-hookean"
PRESSURES = (5, 10, 15)  # mmHg
LENGTHS = (1.0, 1.25)  # of a slit, over half the rim's perimeter
AROUND = (40, 60, 80)  # points around the vein
CELLS = 16  # of the shell around the seam, and those refined by 3/2
FILE = "pressure.csv"


def scene(opening, length, pressure, around):
    made = yaml.safe_load(join.scene(opening, 1.0, LAW, around, length))
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


def shell_run(opening, length, pressure):
    """Kept when the program is rebuilt, as the tube's references are."""
    return Run(
        f"{name_of(opening, length, pressure)}/shell-{CELLS}",
        "vasorod-fem",
        (
            *("solve", "scene.yaml", "-o", "result", "--quiet", "--model", "shell"),
            *("--cells", str(CELLS), "0", "--refine", "1"),
        ),
        {"scene.yaml": scene(opening, length, pressure, 60)},
        keep=True,
    )


def pairs():
    """(opening, length, pressure, around, run, the shell it is measured against)"""
    cases = [("slit", length, pressure, 60) for length in LENGTHS for pressure in PRESSURES]
    cases += [("slit", 1.0, 10, around) for around in AROUND if around != 60]
    cases += [("ellipse", 1.0, 10, 60)]
    for opening, length, pressure, around in cases:
        run = hybrid_run(opening, length, pressure, around)
        yield opening, length, pressure, around, run, shell_run(opening, length, pressure)


def all_runs():
    return list({run.identity: run for pair in pairs() for run in pair[-2:]}.values())


def solved(store, record):
    """Whether a run has a solution. A pressure that follows the wall has no energy in the
    reference, and so no minimum to certify."""
    if converged(store, record):
        return True
    return record["exit"] == 1 and failure_of(store, record) == "status equilibrium_only"


def make_table(store, path):
    keys = ("opening", "length", "pressure", "around")
    named = ((dict(zip(keys, pair)), *pair[-2:]) for pair in pairs())
    rows, records = join.measured(store, named, solved)
    if not rows:
        return
    note = "The T-join from walls without stress to a pressure (mmHg) in both lumens, neo-hookean,"
    note += " against the reference's shell; columns as in join.csv"
    write_table(path, rows, [note, *provenance(records)])
