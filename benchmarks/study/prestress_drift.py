"""How far a vessel that is held as it was seen drifts from there: tubes and real vessels under the
pressure and the axial stretch of their scan, by every model that knows them."""

import yaml

import inflated
import prestress
from cases import text_of
from measure import finished_rows, vessels_apart
from pressure import solved
from runs import Run, hybrid_arguments, reference_arguments
from store import REPOSITORY
from tables import write_extended

GLENNS = REPOSITORY / "benchmarks" / "cases" / "glenn"
HYBRID = ("section", "coupled")
REFERENCE = ("shell", "solid")
LAWS = ("biot", "svk", "neo-hookean")
TUBES = {  # shape and what it was seen with
    "straight": ("straight", {"pressure": {"scan": 12, "after": 12}}),
    "curved": ("curved", {"pressure": {"scan": 12, "after": 12}}),
    "stretched": ("curved", {"axial_prestretch": 1.2}),
    "both": ("curved", {"pressure": {"scan": 60, "after": 60}, "axial_prestretch": 1.2}),
}
ANATOMIES = {"infant": "infant_physiological.yaml", "adult": "adult_physiological.yaml"}
SEEN = ("pressure", "axial_prestretch")
CELLS = (8, 12)
FILE = "prestress_drift.csv"
KEYS = ("case", "law", "model")


def tube_scene(case, law):
    shape, seen = TUBES[case]
    tube = {**inflated.TUBE, **prestress.SHAPES[shape]}
    return {
        "scene": f"drift_{case}",
        "units": {"length": "mm", "stress": "MPa", "pressure": "mmHg"},
        "vessels": [{"name": "tube", "tube": tube, "wall": inflated.WALL, "law": law, **seen}],
        "ends": [{"vessel": "tube", "end": end, "hold": True} for end in ("start", "end")],
        "fidelity": "coupled",
    }


def anatomy_scene(anatomy):
    """The two vessels of the operation before it, each as its scan says."""
    made = yaml.safe_load((GLENNS / ANATOMIES[anatomy]).read_text())
    operation = made.pop("surgery")["glenn"]
    kept = (operation["svc"], operation["rpa"])
    made["vessels"] = [vessel for vessel in made["vessels"] if vessel["name"] in kept]
    made["ends"] = [end for end in made["ends"] if end["vessel"] in kept]
    for vessel in made["vessels"]:
        vessel["surface"] = str((GLENNS / vessel["surface"]).resolve())
        vessel["pressure"]["after"] = vessel["pressure"]["scan"]
    return made


def emptied(made):
    """The same vessels with nothing in them, and without a stress."""
    vessels = [
        {key: value for key, value in vessel.items() if key not in SEEN}
        for vessel in made["vessels"]
    ]
    units = {key: value for key, value in made["units"].items() if key != "pressure"}
    return {**made, "vessels": vessels, "units": units}


def has(anatomy):
    made = yaml.safe_load((GLENNS / ANATOMIES[anatomy]).read_text())
    return all((GLENNS / vessel["surface"]).exists() for vessel in made["vessels"])


def plan():
    """What KEYS name."""
    tubes = [
        (case, law, model)
        for case in TUBES
        for law in (LAWS if case == "both" else LAWS[-1:])
        for model in (*HYBRID, *REFERENCE)
    ]
    return tubes + [(anatomy, LAWS[-1], "coupled") for anatomy in ANATOMIES]


def run(case, law, model, seen=True):
    made = anatomy_scene(case) if case in ANATOMIES else tube_scene(case, law)
    files = {"scene.yaml": text_of(made if seen else emptied(made))}
    name = f"drift-{case}-{law}/{model}{'' if seen else '-empty'}"
    if model not in REFERENCE:
        return Run(name, "vasorod", hybrid_arguments(model), files)
    return Run(name, "vasorod-fem", reference_arguments(model, CELLS, 0), files, keep=True)


def pairs():
    """(what a row begins with, the vessel as it was seen, the empty vessel)"""
    for case, law, model in plan():
        if case in ANATOMIES and not has(case):
            continue
        names = dict(zip(KEYS, (case, law, model)))
        yield names, run(case, law, model), run(case, law, "coupled", seen=False)


def all_runs():
    return list({one.identity: one for pair in pairs() for one in pair[-2:]}.values())


def rows(store):
    def numbers(*runs):
        vessels = vessels_apart(store, *(one.identity for one in reversed(runs)))
        return {"drift": max(vessel["surface"]["largest"] for vessel in vessels)}

    return finished_rows(store, pairs(), ("drift",), numbers, solved)


def make_table(store, path):
    note = "Vessels held as they were seen: the largest displacement of a point over the radius"
    write_extended(path, KEYS, plan(), *rows(store), note)
