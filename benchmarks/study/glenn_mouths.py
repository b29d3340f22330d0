"""The mouth of the bundled infant's Glenn shunt over the pressure after the operation and the
length of the incision; vessels seen under pressure and stretched as in the scene."""

import math

import yaml

from cases import text_of
from measure import finished_rows, result_of
from runs import Run, hybrid_arguments
from store import REPOSITORY
from tables import write_extended

SCENE = REPOSITORY / "benchmarks" / "cases" / "glenn" / "infant_physiological.yaml"
PRESSURES = (0, 5, 10, 15)  # mmHg after the operation, in both vessels
LENGTHS = (1.0, 1.25, 1.5)  # over half the perimeter of the vein's cut end
FILE = "glenn_mouths.csv"
KEYS = ("length", "pressure")
COLUMNS = ("mouth", "area_ratio", "span", "perimeter_ratio", "strain")


def scene(length, pressure):
    made = yaml.safe_load(SCENE.read_text())
    operation = made["surgery"]["glenn"]
    operation["incision_length"] = length
    for vessel in made["vessels"]:
        vessel["surface"] = str((SCENE.parent / vessel["surface"]).resolve())
        if vessel["name"] in (operation["svc"], operation["rpa"]):
            vessel["pressure"]["after"] = pressure
    return made


def run(length, pressure):
    return Run(
        f"glenn-mouths/infant-l{length:g}-p{pressure:g}",
        "vasorod",
        hybrid_arguments(),
        {"scene.yaml": text_of(scene(length, pressure))},
    )


def plan():
    """What KEYS name."""
    return [(length, pressure) for length in LENGTHS for pressure in PRESSURES]


def all_runs():
    return [run(*one) for one in plan()]


def numbers(result):
    mouth = result["glenn"]["mouth"]
    return {
        "mouth": mouth["area"],
        "area_ratio": mouth["area_ratio"],
        # Over the diameter of a circle that is as long around as the vein's cut end.
        "span": mouth["span"] * math.pi * mouth["perimeter_ratio"] / mouth["perimeter"],
        "perimeter_ratio": mouth["perimeter_ratio"],
        "strain": result["validity"]["largest_strain"],
    }


def make_table(store, path):
    note = "The mouth of infant_physiological.yaml over the pressure after the operation (mmHg) and"
    note += " the length of the incision (over half the perimeter of the cut end): area of the"
    note += (
        " mouth in mm2, its lumen over the cut vein's, its span over the cut end's diameter, its"
    )
    note += " perimeter over the cut end's, largest strain of the scene"
    named = ((dict(zip(KEYS, one)), run(*one)) for one in plan())
    found = finished_rows(
        store, named, COLUMNS, lambda one: numbers(result_of(store, one.identity))
    )
    write_extended(path, KEYS, plan(), *found, note)
