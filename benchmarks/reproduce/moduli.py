"""Fig. 3(d): how far the mesh moves when Young's or the shear modulus changes alone."""

import json
import math

import scenes
from work import Figure, Number, Panel

from figures import COLOURS, plotting, save
from measure import shapes

RADIUS, LENGTH = 10, 100
DATA = "fig3d_variation.json"


def factors(quick):
    return (
        [10 ** (k / 2 - 2) for k in range(9)] if quick else [10 ** (k / 5 - 2) for k in range(21)]
    )


def reference_factors(quick):
    """Where the tube of these moduli does not wrinkle: 23 degrees are half of its limit at factor
    1, and the limit goes with E / G."""
    some = (1, 10, 100) if quick else (1, 2.5, 10, 25, 100)
    return {"E": some, "G": tuple(sorted(1 / factor for factor in some))}


def buckling_ratio():
    """E / G over that of the base where a clamped rod twisted by 23 degrees buckles: at the moment
    8.987 E I / L (Greenhill), which is the angle 8.987 E I / (G Jp); Jp = 2 I, E / G = 2.6."""
    return math.radians(23) / (8.987 * 2.6 / 2)


def pair(modulus, factor):
    return (factor, 1) if modulus == "E" else (1, factor)


def runs(quick):
    found = {}
    for modulus in ("E", "G"):
        for factor in factors(quick):
            run = scenes.moduli_run(*pair(modulus, factor))
            found[run.identity] = run
        for factor in reference_factors(quick)[modulus]:
            run = scenes.moduli_reference(*pair(modulus, factor))
            found[run.identity] = run
    together = scenes.moduli_run(10, 1, held=False)
    return [*found.values(), together]


def points(work):
    """Per modulus and model (factor, status, RMS distance to factor 1 over R or None)."""
    store, found = work.store, {}
    models = {
        "paper": (scenes.moduli_run, {m: factors(work.quick) for m in ("E", "G")}),
        "shell": (scenes.moduli_reference, reference_factors(work.quick)),
    }
    for model, (make, where) in models.items():
        base = make(1, 1)
        work.solved(base)
        for modulus in ("E", "G"):
            line = found.setdefault(modulus, {}).setdefault(model, [])
            for factor in where[modulus]:
                run = make(*pair(modulus, factor))
                work.solved(run, also=(1, 2))
                exit_code = store.record(run.identity)["exit"]
                status = work.result(run)["status"] if exit_code in (0, 1) else "no result"
                apart = None
                if exit_code == 0:
                    apart = shapes(store, run.identity, base.identity, RADIUS, LENGTH)["rms"]
                line.append({"factor": factor, "status": status, "variation": apart})
    return found


def picture(found, path):
    plt = plotting()
    figure, axes = plt.subplots(1, 2, figsize=(9, 3.4), sharey=True)
    names = {"E": "Young's modulus", "G": "shear modulus"}
    for axis, (modulus, models) in zip(axes, found.items()):
        low, high = (0.01, 0.5) if modulus == "E" else (2, 100)
        axis.axvspan(low, high, color="#eeeeee", label="a continuous wall would wrinkle")
        for model, line in models.items():
            good = [point for point in line if point["variation"] is not None]
            style = {"paper": "-o", "shell": "s"}[model]
            axis.plot(
                [point["factor"] for point in good],
                [100 * point["variation"] for point in good],
                style,
                color=COLOURS[model],
                markersize=4 if model == "paper" else 6,
                fillstyle="full" if model == "paper" else "none",
                label={"paper": "the paper's energies", "shell": "finite-element shell"}[model],
            )
            for point in line:
                if point["variation"] is None:
                    axis.axvline(point["factor"], color=COLOURS[model], linestyle=":", linewidth=1)
        axis.set_xscale("log")
        axis.set_yscale("symlog", linthresh=0.01)
        axis.set_ylim(bottom=-0.002)
        axis.set_xlabel(f"factor on {names[modulus]}")
    axes[0].set_ylabel("RMS distance to factor 1, % of R")
    axes[1].legend(fontsize=7, loc="upper left")
    save(figure, path)
    plt.close(figure)


def sentence(found):
    """Where the paper's energies found no minimum."""
    lost = [
        f"{modulus} x {point['factor']:.3g} ({point['status']})"
        for modulus, models in found.items()
        for point in models["paper"]
        if point["variation"] is None
    ]
    if not lost:
        return "Every run found its minimum."
    return (
        f"No minimum, and so no point but a dotted line, at {', '.join(lost)}: where E / G is below"
        f" {buckling_ratio():.2g} of its base a rod buckles under this twist (Greenhill)."
    )


def panel(work):
    found = points(work)
    work.write(DATA, json.dumps(found, indent=1) + "\n")
    picture(found, work.folder / "fig3d_variation.png")
    together = scenes.moduli_run(10, 1, held=False)
    work.solved(together)
    same = work.compared(together, scenes.moduli_run(1, 1), "fig3d_all_together")
    numbers = [
        Number(
            "E, k_c, k_b and k_s all times 10: RMS distance",
            same,
            "vessels/0/surface/rms",
            "% of R",
            100,
        )
    ]
    for modulus, models in found.items():
        for model, line in models.items():
            named = "paper" if model == "paper" else "finite-element shell"
            for k, point in enumerate(line):
                decade = any(abs(point["factor"] / f - 1) < 1e-9 for f in (0.01, 0.1, 10, 100))
                if decade and point["variation"] is not None:
                    numbers.append(
                        Number(
                            f"{named}, {modulus} x {point['factor']:.3g}: RMS distance",
                            DATA,
                            f"{modulus}/{model}/{k}/variation",
                            "% of R",
                            100,
                        )
                    )
    return Panel(
        identity="fig3d",
        title="Fig. 3(d): variation of the mesh with Young's and the shear modulus",
        paper="A plot of the mesh's variation over factors 0.01 to 100 on E and on G.",
        reproduced=(
            "The twisted tube of Fig. 3(c) with each modulus alone times 0.01 to 100, at the"
            " paper's energies, against its own shape at factor 1."
        ),
        missing="The paper's curves and the load and coefficients behind them are not known here.",
        differs=(
            "k_b and k_c are held while the moduli vary, and k_s follows E: scaled together, all"
            " factors give one shape (first number). The rod of a twisted tube turns evenly at any"
            " modulus, and G enters no surface energy, so factors on G leave the mesh where it is."
            " Where k_s is far above k_b compressed edges buckle: the jump at the largest factors"
            " on E. "
            + sentence(found)
            + " The finite-element shell is solved where such a wall does not wrinkle; its E is"
            " that along the axis and around, its G that of twist alone."
        ),
        figures=[
            Figure(
                "fig3d_variation.png",
                "RMS distance of the mesh to that at factor 1; grey: where a wall would wrinkle",
                "benchmarks/reproduce/reproduce.py --only fig3d",
            )
        ],
        numbers=numbers,
    )
