"""Fig. 5: the prediction from the front and from the side; a join with a reference solution."""

import scenes
from work import Number, Panel

import join

SIDES = {"frontal": scenes.FRONTAL, "lateral": scenes.LATERAL}


def joined():
    """The T of two tubes: the hybrid model, and the finite-element shell of the same law."""
    return join.hybrid_run("slit", 1.0, "biot"), join.shell_run("slit", 1.0, "biot")


def runs(quick):
    return [scenes.glenn_run("infant"), *joined()]


def panel(work):
    prediction = scenes.glenn_run("infant")
    hybrid, shell = joined()
    file = f"{work.solved(prediction)}/result/result.json"
    mine, its = (f"{work.solved(run)}/result/result.json" for run in (hybrid, shell))
    figures = [
        work.drawn(prediction, f"fig5_{side}", f"{side} view of the prediction", *where)
        for side, where in SIDES.items()
    ]
    for name, run, what in (
        ("hybrid", hybrid, "hybrid model (coupled)"),
        ("shell", shell, "finite-element shell"),
    ):
        figures += [
            work.drawn(
                run,
                f"fig5_join_{name}_{side}",
                f"two tubes joined, {what}, {side}",
                *("--only", "vein", "artery", *where),
            )
            for side, where in SIDES.items()
        ]
    apart = work.compared(hybrid, shell, "fig5_join_distance")
    return Panel(
        identity="fig5",
        title="Fig. 5: frontal and lateral views of the prediction",
        paper="Frontal and lateral views of the prediction.",
        reproduced="Both views of the predicted shunt on the bundled infant anatomy.",
        missing=(
            "The patient's vessels: their CT is not public, and so the prediction is compared with"
            " no patient."
        ),
        differs=(
            "Beside the prediction stands a join that has a reference solution: two tubes in a T,"
            " the vein's end on a slit, by this program and by a finite-element shell. The opening"
            " differs most: at the tips of a slit the wall folds more sharply than a mesh follows."
        ),
        figures=figures,
        numbers=[
            Number("prediction: largest gap of the seam", file, "glenn/join/largest_gap", "mm"),
            Number(
                "tubes: RMS distance of the vein to the shell",
                apart,
                "vessels/0/surface/rms",
                "% of R",
                100,
            ),
            Number(
                "tubes: RMS distance of the artery to the shell",
                apart,
                "vessels/1/surface/rms",
                "% of R",
                100,
            ),
            Number("tubes: area of the mouth, hybrid", mine, "glenn/mouth/area", "mm2"),
            Number("tubes: area of the mouth, shell", its, "glenn/mouth/area", "mm2"),
            Number("tubes: energy, hybrid", mine, "energy/total", "N mm"),
            Number("tubes: energy, shell", its, "energy/total", "N mm"),
            Number(
                "tubes: the shell's own relative error, estimated",
                its,
                "discretisation/error_estimate",
                "%",
                100,
            ),
        ],
    )
