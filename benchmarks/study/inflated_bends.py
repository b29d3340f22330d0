"""Long tubes bent to arcs under pressure, towards Brazier's curvature: how they flatten and how
stiff they are."""

import math

from cases import text_of
from measure import finished_rows, result_of
from runs import Run, hybrid_arguments
from tables import write_extended

TUBE = {"radius": 10.0, "thickness": 1.0, "young": 1.0, "poisson": 0.45}
LONG = {"soft": 100.0, "rigid": 200.0}  # lengths by the ends' sections
# Of Brazier's curvature: without pressure (soft), at the pressure (rigid).
SHARES = {"soft": (0.2,), "rigid": (0.4, 0.6, 0.8)}
RATIOS = (0, 0.5, 1, 2, 5)  # of the pressure over p_c
AROUND = 32
WALLS = ("section", "coupled")
FILE = "inflated_bends.csv"
KEYS = ("section", "share", "ratio", "fidelity", "around")
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
    """What KEYS name."""
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
    """Rows and records of the finished ones of `plan`: what KEYS name, run's arguments."""

    def numbers(one):
        result = result_of(store, one.identity)
        return {
            "flattening": result["metrics"][0]["flattening"],
            "moment": abs(result["ends"][1]["moment"][1]),
            "wrinkling_ratio": result["validity"]["wrinkling_ratio"],
        }

    named = ((dict(zip(KEYS, one)), run(*one)) for one in plan)
    rows, records = finished_rows(store, named, COLUMNS, numbers)
    for row in rows:
        if row["failure"] is None:
            curvature = curvature_of(*(row[name] for name in ("section", "share", "ratio")))
            row["stiffness"] = row["moment"] / curvature / bending_stiffness()
    return rows, records


def make_table(store, path):
    note = "Long tubes bent to a share of Brazier's curvature at pressures over p_c; stiffness:"
    note += " moment over curvature, over E I"
    write_extended(path, KEYS, plan(), *rows_of(store, plan()), note)
