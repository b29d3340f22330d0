"""Glenn shunts on the adult anatomy: three cuts, two incisions, four rotations at `paper`, and how
each ends. The anatomy is not part of the project (benchmarks/cases/glenn/adult.yaml); without it
the plan is empty and the table stays as it is."""

import yaml

from cases import text_of
from extremes import TIME_LIMIT, ending_of
from measure import result_of
from runs import Run, hybrid_arguments
from store import REPOSITORY
from tables import provenance, write_table

FILE = "glenns.csv"
SCENE = REPOSITORY / "benchmarks" / "cases" / "glenn" / "adult.yaml"
CUTS = {"high": [-31, 499, -55], "middle": [-30, 495, -55], "low": [-29.7, 491, -55]}
INCISIONS = {"upper side": [-17, 500, -78], "towards the vein": [-14, 500, -70]}
ROTATIONS = ("auto", 45, 90, -60)
FIDELITY = "paper"


def scene(cut, incision, rotation):
    made = yaml.safe_load(SCENE.read_text())
    for vessel in made["vessels"]:
        vessel["surface"] = str((SCENE.parent / vessel["surface"]).resolve())
    made["surgery"]["glenn"].update(
        cut=CUTS[cut], incision=INCISIONS[incision], rotation_deg=rotation
    )
    return made


def run(cut, incision, rotation):
    return Run(
        f"glenns/{FIDELITY}-{cut}-{incision.replace(' ', '_')}-{rotation}",
        "vasorod",
        (*hybrid_arguments(FIDELITY), "--time-limit", str(TIME_LIMIT)),
        {"scene.yaml": text_of(scene(cut, incision, rotation))},
    )


def picks():
    return [
        (cut, incision, rotation)
        for cut in CUTS
        for incision in INCISIONS
        for rotation in ROTATIONS
    ]


def has_anatomy():
    made = yaml.safe_load(SCENE.read_text())
    return all((SCENE.parent / vessel["surface"]).exists() for vessel in made["vessels"])


def all_runs():
    return [run(*pick) for pick in picks()] if has_anatomy() else []


def row_of(store, pick, record):
    ending, sentence = ending_of(store, record)
    row = {"cut": pick[0], "incision": pick[1], "rotation": pick[2], "ending": ending}
    row |= {"seconds": record["processor_seconds"]}
    solved = record["exit"] in (0, 1)
    result = result_of(store, record["identity"]) if solved else {}
    crossings = result.get("self_intersections", [])
    row["crossings"] = (
        "; ".join(f"{one['a']}, {one['b']}: {one['depth']:.2f}" for one in crossings) or None
    )
    row["strain"] = result["validity"]["largest_strain"] if ending == "converged" else None
    row["sentence"] = sentence or None
    return row


def make_table(store, path, whole=True):
    """whole: not before all runs are finished."""
    if not has_anatomy():
        return
    found = [(pick, store.record(run(*pick).identity)) for pick in picks()]
    if whole and any(record is None for _, record in found):
        return
    found = [(pick, record) for pick, record in found if record is not None]
    write_table(
        path,
        [row_of(store, pick, record) for pick, record in found],
        [
            f"Glenn shunts on the adult anatomy, {FIDELITY}, {TIME_LIMIT} s each at most",
            *provenance([record for _, record in found]),
        ],
    )
