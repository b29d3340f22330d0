"""How near `coupled` is to the shell where a wall is soft in shear: G_axial is also the shell's
shear modulus through the thickness. Beside glued rims the wall of `coupled` shears there too
(docs/wall.md), elsewhere its normals stay normal. What of the gap comes from the thickness closes
as the wall gets thinner."""

from measure import converged, moved_end, norm, own_error, result_of, shapes
from runs import hybrid, reference
from sensitivity import varied
from tables import provenance, write_table

LOAD, MODULUS, FACTOR = "offset", "E", 100.0
THICKNESSES = (1, 0.5, 0.25)
AROUND = (48, 96)


def thinner(thickness):
    case = varied(LOAD, MODULUS, FACTOR)
    case.scene["vessels"][0]["wall"]["thickness"] = thickness
    return case


def tag(thickness):
    return f"-shear-gap-t{thickness:g}"


def hybrid_run(thickness, around):
    return hybrid(thinner(thickness), "coupled", around, tag=tag(thickness))


def reference_run(thickness):
    return reference(thinner(thickness), "shell", 4, (8, 12), 1, tag=tag(thickness))


def all_runs():
    return [
        run
        for t in THICKNESSES
        for run in (*(hybrid_run(t, around) for around in AROUND), reference_run(t))
    ]


def make_table(store, path):
    rows, records = [], []
    for t in THICKNESSES:
        truth = reference_run(t)
        for run in (hybrid_run(t, around) for around in AROUND):
            both = [store.record(run.identity), store.record(truth.identity)]
            if not all(converged(store, record) for record in both):
                continue
            records += both
            mine, its = result_of(store, run.identity), result_of(store, truth.identity)
            force, of_reference = norm(moved_end(mine)[0]), norm(moved_end(its)[0])
            rows.append(
                {
                    "load": LOAD,
                    "modulus": MODULUS,
                    "factor": FACTOR,
                    "thickness": t,
                    "around": run.identity.rsplit("-", 1)[1],
                    "force": force,
                    "force_reference": of_reference,
                    "rms": shapes(store, run.identity, truth.identity, 10, 100)["rms"],
                    **own_error(its),
                }
            )
    if rows:
        write_table(
            path,
            rows,
            [
                (
                    "`coupled` against the shell on walls soft in shear, thinner and thinner, law"
                    " Biot; u_: the reference's own error"
                ),
                *provenance(records),
            ],
        )
