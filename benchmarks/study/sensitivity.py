"""How shapes and reactions follow E and G. The wall is transversely isotropic about the tube's
axis; the sweep of E scales E_axial and E_T together, that of G scales G_axial alone. Base: the
isotropic wall's moduli with nu_LT = 0."""

from cases import case_named
from counts import COLUMNS as COUNTS
from counts import counts_of
from measure import converged, failure_of, moved_end, norm, own_error, result_of, shapes
from runs import hybrid, reference
from tables import provenance, write_table

FACTORS = tuple(10 ** (k / 5 - 2) for k in range(21))
# What a quick check runs: three factors of the loads under which no wall wrinkles.
FEW = tuple(FACTORS[k] for k in (5, 10, 15))
QUICK_LOADS = ("twist", "stretch")
REFERENCE_FACTORS = tuple(FACTORS[k] for k in (0, 3, 7, 10, 13, 17, 20))
MODULI = ("E", "G")
FIDELITIES = ("skin", "paper", "section", "coupled")
AROUND = 48
# t / R = 0.1 wrinkles at 20 degrees, at 0.2 with E / G a hundredth of that; surface shear 1.7e-4
TWIST_DEG = 0.1
LOADS = {
    "twist": ("twist_t1_0.5", {"rotate_deg": [0, 0, TWIST_DEG]}),
    "bend": ("bend_t1_0.5", None),
    "stretch": ("stretch_t1_1.05", None),
    "offset": ("offset_t1_0.5", None),
}


def wall(modulus, factor):
    e, g = (factor, 1) if modulus == "E" else (1, factor)
    return {
        "thickness": 1,
        "young": e,
        "shear": g / 2.6,
        "transverse": {"young": e, "poisson": 0.3, "coupling": 0},
    }


def varied(load, modulus, factor):
    name, end = LOADS[load]
    case = case_named(name).changed(study_end=end)
    case.scene["vessels"][0]["wall"] = wall(modulus, factor)
    return case


def tag(load, modulus, factor):
    """Both sweeps share their middle."""
    return f"-{load}-base" if abs(factor - 1) < 1e-9 else f"-{load}-{modulus}-{factor:.3g}"


def hybrid_run(load, modulus, factor, fidelity, around=AROUND):
    return hybrid(varied(load, modulus, factor), fidelity, around, tag=tag(load, modulus, factor))


def reference_run(load, modulus, factor):
    """The shell: t / R = 0.1 is thin enough for it, and forty runs of it cost what five of the
    solid do."""
    return reference(
        varied(load, modulus, factor), "shell", 4, (8, 12), 1, tag=tag(load, modulus, factor)
    )


def runs(load, fidelities=FIDELITIES, factors=FACTORS):
    return [
        hybrid_run(load, modulus, factor, fidelity)
        for fidelity in fidelities
        for modulus in MODULI
        for factor in factors
    ]


def reference_runs(load):
    return [
        reference_run(load, modulus, factor) for modulus in MODULI for factor in REFERENCE_FACTORS
    ]


def point(store, load, modulus, factor, fidelity, run, base, records):
    """One point of a curve, or None where it was not run."""
    record, base_record = store.record(run.identity), store.record(base.identity)
    if record is None or base_record is None:
        return None
    records.append(record)
    row = {
        "load": load,
        "modulus": modulus,
        "factor": factor,
        "fidelity": fidelity,
        "variation": None,
        "force": None,
        "moment": None,
        "energy": None,
        "bending_energy": None,
        "stretching_energy": None,
        "binding_energy": None,
        "flattening": None,
        "u_shape": None,
        "u_reaction": None,
        "failure": None,
        **dict.fromkeys(COUNTS),
    }
    if not (converged(store, record) and converged(store, base_record)):
        row["failure"] = failure_of(store, base_record if converged(store, record) else record)
        return row
    result = result_of(store, run.identity)
    force, moment = moved_end(result)
    energy = result["energy"]
    row.update(
        variation=shapes(store, run.identity, base.identity, 10, 100)["rms"],
        force=norm(force),
        moment=norm(moment),
        energy=energy["total"],
        bending_energy=energy["bending"],
        stretching_energy=energy["stretching"],
        binding_energy=energy["binding"],
        flattening=result["metrics"][0]["flattening"],
        **own_error(result),
        **counts_of(result),
    )
    return row


def make_rows(store, loads=LOADS, fidelities=FIDELITIES, factors=FACTORS, with_reference=True):
    rows, records = [], []
    for load in loads:
        for modulus in MODULI:
            for fidelity in fidelities:
                base = hybrid_run(load, modulus, 1.0, fidelity)
                rows += [
                    point(
                        store,
                        load,
                        modulus,
                        f,
                        fidelity,
                        hybrid_run(load, modulus, f, fidelity),
                        base,
                        records,
                    )
                    for f in factors
                ]
            if with_reference:
                base = reference_run(load, modulus, 1.0)
                rows += [
                    point(
                        store,
                        load,
                        modulus,
                        f,
                        "shell",
                        reference_run(load, modulus, f),
                        base,
                        records,
                    )
                    for f in REFERENCE_FACTORS
                ]
    return [row for row in rows if row is not None], records


def make_shells(store, path):
    """The finished points of the shell alone, without those of the hybrid."""
    rows, records = make_rows(store, fidelities=())
    if rows:
        write_table(path, rows, ["The shell's points", *provenance(records)])
