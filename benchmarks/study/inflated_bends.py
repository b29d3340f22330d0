"""Long tubes bent to arcs under pressure, towards Brazier's curvature: how they flatten and how
stiff they are."""

import math

from cases import text_of
from measure import failed_of, result_of
from runs import Run, hybrid_arguments
from tables import extended, provenance, write_table

TUBE = {"radius": 10.0, "thickness": 1.0, "young": 1.0, "poisson": 0.45}
LONG = {"soft": 100.0, "rigid": 200.0}  # lengths by the ends' sections
# Of Brazier's curvature: without pressure (soft), at the pressure (rigid).
SHARES = {"soft": (0.2,), "rigid": (0.4, 0.6, 0.8)}
RATIOS = (0, 0.5, 1, 2, 5)  # of the pressure over p_c
AROUND = 32
WALLS = ("section", "coupled")
FILE = "inflated_bends.csv"
COLUMNS = ("flattening", "moment", "stiffness", "wrinkling_ratio")


def collapse_pressure(poisson=TUBE["poisson"]):
    """p_c = 3 D / R^3 of a long tube under outer pressure, in MPa."""
    return TUBE["young"] * (TUBE["thickness"] / TUBE["radius"]) ** 3 / (4 * (1 - poisson**2))


def bending_stiffness():
    """E I of the tube as a ring section that keeps its shape, in N mm2."""
    outer, inner = (TUBE["radius"] + sign * TUBE["thickness"] / 2 for sign in (1, -1))
    return TUBE["young"] * math.pi / 4 * (outer**4 - inner**4)


def compressed_stiffness(ratio):
    """By how much the compression N of a pressurised tube between held ends, (1 - 2 nu) p pi R^2
    (Haringx), lowers the moment at the ends of a soft bend: N L^2 / 12 E I, to first order."""
    area = math.pi * TUBE["radius"] ** 2
    force = (1 - 2 * TUBE["poisson"]) * ratio * collapse_pressure() * area
    return force * LONG["soft"] ** 2 / (12 * bending_stiffness())


def brazier_curvature(ratio):
    """At which a long tube's moment is largest (Brazier 1927), with pressure, in 1/mm."""
    empty = 0.471 * TUBE["thickness"] / (TUBE["radius"] ** 2 * math.sqrt(1 - TUBE["poisson"] ** 2))
    return empty * math.sqrt(1 + ratio)


def curvature_of(section, share, ratio):
    return share * brazier_curvature(0 if section == "soft" else ratio)


def scene(section, share, ratio, around=AROUND):
    """Bent to an arc, seen at the pressure it is solved at, so that the radius stays."""
    length = LONG[section]
    curvature = curvature_of(section, share, ratio)
    angle = curvature * length
    edge = 2 * math.pi * TUBE["radius"] / around
    tube = {"length": length, "radius": TUBE["radius"], "around": around}
    tube["along"] = 2 * round(length / edge / 2)
    wall = {key: TUBE[key] for key in ("thickness", "young", "poisson")}
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


def run(section, share, ratio, fidelity="coupled", around=AROUND):
    return Run(
        f"inflated-bend-{section}-{share:g}-q{ratio:g}/{fidelity}-{around}",
        "vasorod",
        hybrid_arguments(fidelity),
        {"scene.yaml": text_of(scene(section, share, ratio, around))},
    )


def plan():
    """(section, share, ratio, fidelity, around)"""
    return [
        (section, share, ratio, fidelity, AROUND)
        for section, shares in SHARES.items()
        for share in shares
        for fidelity in WALLS
        for ratio in RATIOS
    ]


def all_runs():
    return [run(*bend) for bend in plan()]


def rows_of(store, plan):
    """Rows and records of the finished ones of `plan`: arguments of run."""
    rows, records = [], []
    for section, share, ratio, fidelity, around in plan:
        one = run(section, share, ratio, fidelity, around)
        record = store.record(one.identity)
        if record is None:
            continue
        records.append(record)
        row = {"fidelity": fidelity, "section": section, "share": share, "ratio": ratio}
        row["around"] = around
        row |= {**dict.fromkeys(COLUMNS), "seconds": record["processor_seconds"]}
        row["failure"] = failed_of(store, [record])
        if row["failure"] is None:
            result = result_of(store, one.identity)
            row["flattening"] = result["metrics"][0]["flattening"]
            row["moment"] = abs(result["ends"][1]["moment"][1])
            curvature = curvature_of(section, share, ratio)
            row["stiffness"] = row["moment"] / curvature / bending_stiffness()
            row["wrinkling_ratio"] = result["validity"]["wrinkling_ratio"]
        rows.append(row)
    return rows, records


def make_table(store, path):
    rows, records = rows_of(store, plan())
    if rows:
        note = "Long tubes bent to a share of Brazier's curvature at pressures over p_c; stiffness:"
        note += " moment over curvature, over E I"
        notes, keys = [note, *provenance(records)], ("section", "share", "ratio", "fidelity")
        write_table(path, *extended(path, keys, [one[:4] for one in plan()], rows, notes))
