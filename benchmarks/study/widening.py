"""How far a pressure in its lumen widens a tube from a wall without stress, by every wall model and
both reference models, beside Lame's thick tube in plane strain."""

import inflated_bends
from cases import text_of
from measure import failed_of, vessels_apart
from pressure import solved
from runs import Run, hybrid_arguments
from tables import extended, provenance, write_table

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
    words = ("solve", "scene.yaml", "-o", "result", "--quiet", "--model", model, "--law", "biot")
    cells = ("--cells", str(CELLS[0]), str(CELLS[1]), "--refine", "0")
    return Run(name, "vasorod-fem", (*words, *cells), files, keep=True)


def empty(poisson):
    """The tube as it is, which the others are compared with."""
    return run("section", poisson, 0)


def plan():
    """(model, poisson, ratio)"""
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
    found, records = [], []
    for model, poisson, ratio in plan():
        both = [empty(poisson), run(model, poisson, ratio)]
        its = [store.record(one.identity) for one in both]
        if None in its:
            continue
        records += its
        row = {"poisson": poisson, "ratio": ratio, "model": model, "widening": None}
        row["closed_form"] = closed_form(poisson, ratio)
        row |= {"seconds": its[1]["processor_seconds"], "failure": failed_of(store, its, solved)}
        if row["failure"] is None:
            names = [one.identity for one in both]
            # Every point moves outwards by the same distance.
            row["widening"] = vessels_apart(store, *names)[0]["surface"]["rms"]
        found.append(row)
    return found, records


def make_table(store, path):
    found, records = rows(store)
    if found:
        note = "A tube (R 10, t 1, soft ends held along the axis, Biot) widened by a pressure over"
        note += " p_c: displacement of its middle surface over R, and Lame's in plane strain"
        keys = ("model", "poisson", "ratio")
        notes = [note, *provenance(records)]
        write_table(path, *extended(path, keys, plan(), found, notes))
