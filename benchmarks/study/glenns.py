"""Glenn shunts on the adult anatomy: three cuts, two incisions, four rotations, and how each ends:
at `paper`, and at `coupled` without pressure and with. The anatomy is not part of the project
(benchmarks/cases/glenn/adult_physiological.yaml); without it the plan is empty and the table stays
as it is."""

import yaml

from cases import text_of
from extremes import ending_of
from measure import result_of
from runs import Run, hybrid_arguments
from store import REPOSITORY
from tables import provenance, write_table

FILE = "glenns.csv"
SCENE = REPOSITORY / "benchmarks" / "cases" / "glenn" / "adult_physiological.yaml"
CUTS = {"high": [-31, 499, -55], "middle": [-30, 495, -55], "low": [-29.7, 491, -55]}
INCISIONS = {"upper side": [-17, 500, -78], "towards the vein": [-14, 500, -70]}
ROTATIONS = ("auto", 45, 90, -60)
FIDELITY = "paper"
FOLDED_FILE = "glenns_coupled.csv"
PRESSURE = 12  # mmHg after the operation
# 115 s, so that a stopped run's last check and writing still end within 120 s of processor time.
TIME_LIMIT = 115


def scene(pressure, cut, incision, rotation):
    """Without pressure, and then with the linear law; or as it stands, without its prestretch."""
    made = yaml.safe_load(SCENE.read_text())
    for vessel in made["vessels"]:
        vessel.pop("axial_prestretch", None)
        vessel["surface"] = str((SCENE.parent / vessel["surface"]).resolve())
    made["surgery"]["glenn"].update(
        cut=CUTS[cut], incision=INCISIONS[incision], rotation_deg=rotation
    )
    if pressure:
        return made
    del made["units"]["pressure"]
    for vessel in made["vessels"]:
        for word in ("pressure", "law"):
            vessel.pop(word, None)
    return made


def run(cut, incision, rotation):
    return Run(
        f"glenns/{FIDELITY}-{cut}-{incision.replace(' ', '_')}-{rotation}",
        "vasorod",
        (*hybrid_arguments(FIDELITY), "--time-limit", str(TIME_LIMIT)),
        {"scene.yaml": text_of(scene(0, cut, incision, rotation))},
    )


def folded_run(pressure, cut, incision, rotation):
    name = f"{pressure}-{cut}-{incision.replace(' ', '_')}-{rotation}"
    return Run(
        f"glenns/coupled-{name}",
        "vasorod",
        (*hybrid_arguments("coupled"), "--time-limit", str(TIME_LIMIT)),
        {"scene.yaml": text_of(scene(pressure, cut, incision, rotation))},
    )


def folded():
    """(pressure in mmHg, 0: without; *pick) of every run."""
    return [(pressure, *pick) for pressure in (0, PRESSURE) for pick in picks()]


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
    if not has_anatomy():
        return []
    return [run(*pick) for pick in picks()] + [folded_run(*pick) for pick in folded()]


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
    good = ending in ("converged", "buckled")
    row["strain"] = result["validity"]["largest_strain"] if good else None
    row["sentence"] = sentence or None
    return row


def finished(store, plan, run_of, whole):
    """[(one of the plan, its record)] of those that are finished; none without the anatomy, and
    where `whole`, none before all are."""
    found = [(one, store.record(run_of(*one).identity)) for one in plan] if has_anatomy() else []
    if whole and any(record is None for _, record in found):
        return []
    return [(one, record) for one, record in found if record is not None]


def folded_row(store, one, record):
    pressure, *pick = one
    row = {"pressure": pressure, **row_of(store, pick, record)}
    solved = record["exit"] in (0, 1)
    mouth = result_of(store, record["identity"])["glenn"]["mouth"] if solved else {}
    good = row["ending"] in ("converged", "buckled")
    row["mouth"] = mouth["area_ratio"] if good else None
    return row


def write(store, path, found, row, what):
    if found:
        note = (
            f"Glenn shunts on the adult anatomy, {what}, {TIME_LIMIT} s of wall time each at most"
        )
        notes = [note, *provenance([record for _, record in found])]
        write_table(path, [row(store, *one) for one in found], notes)


def make_folded_table(store, path, whole=True):
    """whole: not before all runs are finished."""
    what = "coupled, edges of 2 mm, pressure after the operation in mmHg"
    write(store, path, finished(store, folded(), folded_run, whole), folded_row, what)


def make_table(store, path, whole=True):
    """whole: not before all runs are finished."""
    what = f"{FIDELITY}, edges of 2 mm"
    write(store, path, finished(store, picks(), run, whole), row_of, what)
