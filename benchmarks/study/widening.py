"""How far a pressure in its lumen widens a tube from a wall without stress, by every wall model and
both reference models, beside Lame's thick tube in plane strain."""

import inflated_bends
from cases import text_of
from measure import finished_rows, vessels_apart
from pressure import solved
from runs import Run, hybrid_arguments, reference_arguments
from tables import write_extended

RADIUS, THICKNESS = (inflated_bends.TUBE[name] for name in ("radius", "thickness"))
TUBE = {"length": 30, "radius": RADIUS, "around": 60, "along": 28}
RATIOS = (1, 5)  # of the pressure over p_c
HYBRID = ("section", "coupled")
REFERENCE = ("shell", "solid")
# The reference needs a compressible wall; 0.45 is that of the bends.
POISSON = {
    0.3: (*HYBRID, *REFERENCE),
    inflated_bends.TUBE["poisson"]: (*HYBRID, *REFERENCE),
    0.5: HYBRID,
}
CELLS = (4, 6)
FILE = "widening.csv"
KEYS = ("model", "poisson", "ratio")


def pressure_of(poisson, ratio):
    return ratio * inflated_bends.collapse_pressure(poisson)


def scene(poisson, ratio):
    wall = {"thickness": THICKNESS, "young": inflated_bends.TUBE["young"], "poisson": poisson}
    vessel = {"name": "tube", "tube": TUBE, "wall": wall}
    if ratio:
        vessel["pressure"] = {"after": pressure_of(poisson, ratio)}
    return {
        "scene": f"widening_{poisson:g}",
        "units": {"length": "mm", "stress": "MPa"},
        "vessels": [vessel],
        "ends": [
            {"vessel": "tube", "end": end, "hold": True, "section": "soft"}
            for end in ("start", "end")
        ],
        "fidelity": "coupled",
    }


def run(model, poisson, ratio):
    name = f"widening-nu{poisson:g}-q{ratio:g}/{model}"
    files = {"scene.yaml": text_of(scene(poisson, ratio))}
    if model in HYBRID:
        return Run(name, "vasorod", hybrid_arguments(model), files)
    arguments = reference_arguments(model, CELLS, 0, "--law", "biot")
    return Run(name, "vasorod-fem", arguments, files, keep=True)


def empty(poisson):
    """The tube as it is, which the others are compared with."""
    return run("section", poisson, 0)


def plan():
    """What KEYS name."""
    return [
        (model, poisson, ratio)
        for poisson, models in POISSON.items()
        for ratio in RATIOS
        for model in models
    ]


def all_runs():
    return [empty(poisson) for poisson in POISSON] + [run(*one) for one in plan()]


def closed_form(poisson, ratio):
    """Of the middle surface, over R: small displacements of Lame's tube."""
    p, r = pressure_of(poisson, ratio), RADIUS
    a, b = r - THICKNESS / 2, r + THICKNESS / 2
    share = (1 + poisson) * p * a * a / (b * b - a * a) / inflated_bends.TUBE["young"]
    return share * ((1 - 2 * poisson) * r + b * b / r) / r


def rows(store):
    named = (
        (
            {**dict(zip(KEYS, one)), "closed_form": closed_form(*one[1:])},
            run(*one),
            empty(one[1]),
        )
        for one in plan()
    )

    def numbers(*runs):
        # Every point moves outwards by the same distance.
        vessels = vessels_apart(store, *(one.identity for one in reversed(runs)))
        return {"widening": vessels[0]["surface"]["rms"]}

    return finished_rows(store, named, ("widening",), numbers, solved)


def make_table(store, path):
    note = "A tube (R 10, t 1, soft ends held along the axis, Biot) widened by a pressure over p_c:"
    note += " displacement of its middle surface over R, and Lame's in plane strain"
    write_extended(path, KEYS, plan(), *rows(store), note)
