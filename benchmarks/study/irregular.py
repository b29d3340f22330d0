"""`coupled` on surfaces as segmented vessels have them (meshes/irregular_tube.py), against the
reference of the same case."""

import math
import sys
import tempfile
from functools import lru_cache
from pathlib import Path

from accuracy import COLUMNS, measured
from cases import text_of
from measure import converged, outcome, result_of
from runs import Run, hybrid_arguments
from store import REPOSITORY
from tables import provenance, write_table

MESHES = {
    "blue-noise": 48,
    "jittered": 48,
    "stretched": 96,
}  # points on a rim: triangles five times as long as wide need twice as many


@lru_cache
def surface(kind, around, length, radius, bend_deg):
    """(text of the VTP file, smallest angle in degrees)."""
    sys.path.insert(0, str(REPOSITORY / "meshes"))
    from irregular_tube import irregular_tube, smallest_angle  # needs NumPy and SciPy
    from vtp import write_vtp

    points, triangles = irregular_tube(kind, length, radius, around, bend=math.radians(bend_deg))
    with tempfile.TemporaryDirectory() as scratch:
        write_vtp(f"{scratch}/tube.vtp", points, triangles)
        return Path(f"{scratch}/tube.vtp").read_text(), smallest_angle(points, triangles)


def mesh_of(case, kind):
    tube = case.tube
    return surface(kind, MESHES[kind], tube["length"], tube["radius"], tube.get("bend_deg", 0))


def run(case, kind):
    scene = case.changed().scene
    vessel = scene["vessels"][0]
    del vessel["tube"]
    vessel.update(surface="tube.vtp", surface_is="mid")
    text = text_of(scene)
    return Run(
        f"{case.name}/coupled-{MESHES[kind]}-{kind}",
        "vasorod",
        hybrid_arguments("coupled"),
        {"scene.yaml": text, "tube.vtp": lambda: mesh_of(case, kind)[0]},
    )


def runs_of(case):
    """By kind. A surface that is read has one thickness, so tapered walls are left out."""
    return (
        {kind: run(case, kind) for kind in MESHES}
        if case.counted and "end_thickness" not in case.tube
        else {}
    )


def all_runs(case):
    return list(runs_of(case).values())


def make_table(store, cases, path):
    rows, records = [], []
    for case, kind, one, record, reference in measured(store, cases, runs_of, records):
        vertices = (
            result_of(store, one.identity)["model"]["vertices"]
            if converged(store, record)
            else None
        )
        rows.append(
            {
                "case": case.name,
                "family": case.family,
                "ratio": case.ratio,
                "counted": 1,
                "model": "coupled",
                "mesh": kind,
                "around": MESHES[kind],
                "vertices": vertices,
                "smallest_angle": mesh_of(case, kind)[1],
                "reference": reference.identity.split("/")[1],
                **outcome(store, case, one, reference, COLUMNS),
            }
        )
    if rows:
        write_table(
            path,
            rows,
            [
                (
                    "`coupled` on irregular surfaces against the finite-element reference, law"
                    " Biot; u_: the reference's own error"
                ),
                *provenance(records),
            ],
        )
