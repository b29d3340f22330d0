"""Tubes with a pressure in their lumen: inflated, then bent, twisted and stretched, against the
reference's 7-parameter shell of the same law; and bends under pressure past Brazier's curvature."""

import math

from cases import text_of
from measure import compared, failed_of, result_of
from runs import Run, hybrid_arguments
from pressure import solved
from tables import extended, provenance, write_table

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
WALLS = ("section", "coupled")  # of which the bends are
CELLS = (8, 12)  # of the shell, and those refined by 3/2
FILE = "inflated.csv"

BENT = {"radius": 10.0, "thickness": 1.0, "young": 1.0, "poisson": 0.45}
LONG = {"soft": 100.0, "rigid": 200.0}  # lengths by the ends' sections
# Of Brazier's curvature: without pressure (soft), at the pressure (rigid).
SHARES = {"soft": (0.2,), "rigid": (0.4, 0.6, 0.8)}
RATIOS = (0, 0.5, 1, 2, 5)  # of the pressure over p_c
BENT_AROUND = 32
BENDS = "inflated_bends.csv"


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
        (
            *("solve", "scene.yaml", "-o", "result", "--quiet", "--model", "shell"),
            *("--cells", str(CELLS[0]), str(CELLS[1]), "--refine", "1"),
        ),
        {"scene.yaml": text_of(scene(load, pressure))},
        keep=True,
    )


def collapse_pressure():
    """p_c = 3 D / R^3 of a long tube under outer pressure, in MPa."""
    return (
        BENT["young"] * (BENT["thickness"] / BENT["radius"]) ** 3 / (4 * (1 - BENT["poisson"] ** 2))
    )


def brazier_curvature(ratio):
    """At which a long tube's moment is largest (Brazier 1927), with pressure, in 1/mm."""
    empty = 0.471 * BENT["thickness"] / (BENT["radius"] ** 2 * math.sqrt(1 - BENT["poisson"] ** 2))
    return empty * math.sqrt(1 + ratio)


def bend_scene(section, share, ratio):
    """Bent to an arc, seen at the pressure it is solved at, so that the radius stays."""
    length = LONG[section]
    curvature = share * brazier_curvature(0 if section == "soft" else ratio)
    angle = curvature * length
    around = 2 * math.pi * BENT["radius"] / BENT_AROUND
    tube = {"length": length, "radius": BENT["radius"], "around": BENT_AROUND}
    tube["along"] = 2 * round(length / around / 2)
    wall = {key: BENT[key] for key in ("thickness", "young", "poisson")}
    vessel = {"name": "tube", "tube": tube, "wall": wall}
    if ratio:
        pressure = ratio * collapse_pressure()
        vessel["pressure"] = {"scan": pressure, "after": pressure}
    arc = [(1 - math.cos(angle)) / curvature, 0, math.sin(angle) / curvature - length]
    moved = {"rotate_deg": [0, math.degrees(angle), 0], "move": arc}
    return {
        "scene": f"inflated_bend_{section}_{share:g}_{ratio:g}",
        "units": {"length": "mm", "stress": "MPa"},
        "vessels": [vessel],
        "ends": [
            {"vessel": "tube", "end": "start", "hold": True, "section": section},
            {"vessel": "tube", "end": "end", **moved, "section": section},
        ],
        "fidelity": "coupled",
    }


def bend_run(section, share, ratio, fidelity="coupled"):
    return Run(
        f"inflated-bend-{section}-{share:g}-q{ratio:g}/{fidelity}-{BENT_AROUND}",
        "vasorod",
        hybrid_arguments(fidelity),
        {"scene.yaml": text_of(bend_scene(section, share, ratio))},
    )


def bends():
    """(section, share, ratio, fidelity)"""
    return [
        (section, share, ratio, fidelity)
        for section, shares in SHARES.items()
        for share in shares
        for fidelity in WALLS
        for ratio in RATIOS
    ]


def all_runs():
    runs = [bend_run(*bend) for bend in bends()]
    for load in LOADS:
        for pressure in PRESSURES:
            runs += [hybrid_run(load, pressure, fidelity) for fidelity in FIDELITIES]
            runs.append(shell_run(load, pressure))
    return runs


class _Tube:
    """What `compared` asks of a case."""

    tube = TUBE


COLUMNS = ("rms", "largest", "force", "moment", "flattening", "flattening_reference", "own_error")
BEND_COLUMNS = ("flattening", "moment", "wrinkling_ratio")


def tube_row(store, names, run, shell, columns):
    """A row that begins with `names`, with these columns of the run's errors against the shell, and
    its two records; None where one of the two runs is not there."""
    both = [store.record(one.identity) for one in (run, shell)]
    if None in both:
        return None
    row = {**names, **dict.fromkeys(columns), "seconds": both[0]["processor_seconds"]}
    row["failure"] = failed_of(store, both, solved)
    if row["failure"] is None:
        mine, its = (result_of(store, one.identity) for one in (run, shell))
        numbers = compared(store, _Tube, run, shell)
        numbers["own_error"] = its["discretisation"]["error_estimate"]
        if "energy" in columns:
            numbers["energy"] = mine["energy"]["total"] / its["energy"]["total"] - 1
        row |= {name: numbers[name] for name in columns}
    return row, both


def tube_rows(store, pairs, columns):
    """Rows and records of the finished ones of `pairs`: (what a row begins with, run, shell)."""
    found = [tube_row(store, *pair, columns) for pair in pairs]
    found = [one for one in found if one is not None]
    return [row for row, _ in found], [record for _, both in found for record in both]


def load_pairs():
    for fidelity in FIDELITIES:
        for load in LOADS:
            for pressure in PRESSURES:
                names = {"load": load, "pressure": pressure, "fidelity": fidelity}
                yield names, hybrid_run(load, pressure, fidelity), shell_run(load, pressure)


def bend_rows(store):
    rows, records = [], []
    for section, share, ratio, fidelity in bends():
        run = bend_run(section, share, ratio, fidelity)
        record = store.record(run.identity)
        if record is None:
            continue
        records.append(record)
        row = {"fidelity": fidelity, "section": section, "share": share, "ratio": ratio}
        row |= {**dict.fromkeys(BEND_COLUMNS), "seconds": record["processor_seconds"]}
        row["failure"] = failed_of(store, [record])
        if row["failure"] is None:
            result = result_of(store, run.identity)
            row["flattening"] = result["metrics"][0]["flattening"]
            row["moment"] = abs(result["ends"][1]["moment"][1])
            row["wrinkling_ratio"] = result["validity"]["wrinkling_ratio"]
        rows.append(row)
    return rows, records


def make_tables(store, folder):
    rows, records = tube_rows(store, load_pairs(), COLUMNS)
    if rows:
        note = "Tubes from walls without stress to a pressure (mmHg) and a load, neo-hookean,"
        note += " against the reference's shell: RMS over R, force and moment over the"
        note += " larger reaction"
        notes = [note, *provenance(records)]
        plan = [(load, p, name) for name in FIDELITIES for load in LOADS for p in PRESSURES]
        keys = ("load", "pressure", "fidelity")
        write_table(folder / FILE, *extended(folder / FILE, keys, plan, rows, notes))
    rows, records = bend_rows(store)
    if rows:
        note = "Long tubes bent to a share of Brazier's curvature at pressures over p_c"
        notes, keys = [note, *provenance(records)], ("section", "share", "ratio", "fidelity")
        write_table(folder / BENDS, *extended(folder / BENDS, keys, bends(), rows, notes))
