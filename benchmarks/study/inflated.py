"""Tubes with a pressure in their lumen: inflated, then bent, twisted and stretched, against the
reference's 7-parameter shell of the same law."""

from cases import text_of
from measure import compared, finished_rows, result_of
from runs import Run, hybrid_arguments, reference_arguments
from pressure import solved
from tables import write_extended

LAW = "neo-hookean"
TUBE = {"length": 30, "radius": 3.3, "around": 60, "along": 96}
WALL = {"thickness": 0.33, "young": 0.5, "poisson": 0.45}
LOADS = {
    "none": {"hold": True},
    "bend": {"rotate_deg": [10, 0, 0], "move": [0, -2.6, -0.15]},
    "twist": {"rotate_deg": [0, 0, 20]},
    "stretch": {"move": [0, 0, 2]},
}
PRESSURES = (5, 10)  # mmHg, from a wall without stress
FIDELITIES = ("section", "coupled", "skin")
CELLS = (8, 12)  # of the shell, and those refined by 3/2
FILE = "inflated.csv"


def scene(load, pressure):
    tube = {"name": "tube", "tube": TUBE, "wall": WALL, "law": LAW, "pressure": {"after": pressure}}
    return {
        "scene": f"inflated_{load}_{pressure}",
        "units": {"length": "mm", "stress": "MPa", "pressure": "mmHg"},
        "vessels": [tube],
        "ends": [
            {"vessel": "tube", "end": "start", "hold": True},
            {"vessel": "tube", "end": "end", **LOADS[load]},
        ],
        "fidelity": "coupled",
    }


def hybrid_run(load, pressure, fidelity="coupled"):
    return Run(
        f"inflated-{load}-p{pressure}/{fidelity}-{TUBE['around']}",
        "vasorod",
        hybrid_arguments(fidelity),
        {"scene.yaml": text_of(scene(load, pressure))},
    )


def shell_run(load, pressure):
    """Kept when the program is rebuilt, as the tube's references are."""
    return Run(
        f"inflated-{load}-p{pressure}/shell-{CELLS[0]}x{CELLS[1]}",
        "vasorod-fem",
        reference_arguments("shell", CELLS, 1),
        {"scene.yaml": text_of(scene(load, pressure))},
        keep=True,
    )


def all_runs():
    runs = [run for pair in load_pairs() for run in pair[-2:]]
    return list({run.identity: run for run in runs}.values())


class _Tube:
    """What `compared` asks of a case."""

    tube = TUBE


COLUMNS = ("rms", "largest", "force", "moment", "flattening", "flattening_reference", "own_error")


def tube_rows(store, pairs, columns):
    """Rows and records of the finished ones of `pairs` (what a row begins with, run, shell), with
    these columns of the run's errors against the shell."""

    def numbers(run, shell):
        mine, its = (result_of(store, one.identity) for one in (run, shell))
        found = compared(store, _Tube, run, shell)
        found["own_error"] = its["discretisation"]["error_estimate"]
        if "energy" in columns:
            found["energy"] = mine["energy"]["total"] / its["energy"]["total"] - 1
        return {name: found[name] for name in columns}

    return finished_rows(store, pairs, columns, numbers, solved)


def load_pairs():
    for fidelity in FIDELITIES:
        for load in LOADS:
            for pressure in PRESSURES:
                names = {"load": load, "pressure": pressure, "fidelity": fidelity}
                yield names, hybrid_run(load, pressure, fidelity), shell_run(load, pressure)


def make_table(store, path):
    note = "Tubes from walls without stress to a pressure (mmHg) and a load, neo-hookean, against"
    note += " the reference's shell: RMS over R, force and moment over the larger reaction"
    plan = [(load, p, name) for name in FIDELITIES for load in LOADS for p in PRESSURES]
    keys = ("load", "pressure", "fidelity")
    write_extended(path, keys, plan, *tube_rows(store, load_pairs(), COLUMNS), note)
