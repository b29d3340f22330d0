"""Fig. 3(a-c): a tube at rest, bent and twisted, beside finite elements of the same tube."""

import scenes
from work import Number, Panel

SIDE = ("--from", 0, -1, 0.001, "--up", 1, 0, 0, "--size", 760, 420, "--stripes", 6)
WHAT = {"bent": "28.3 degrees", "twisted": "23 degrees"}


def runs(quick):
    return [
        run
        for motion in WHAT
        for run in (
            scenes.tube_run(motion, "paper"),
            scenes.tube_run(motion, "coupled"),
            scenes.tube_reference(motion),
        )
    ]


def panel(work):
    figures, numbers = [], []
    rest = scenes.tube_run("bent", "paper")
    figures.append(
        work.drawn(rest, "fig3a_rest", "The tube at rest: L / R = 10, t / R = 0.2", "--rest", *SIDE)
    )
    for motion, angle in WHAT.items():
        reference = scenes.tube_reference(motion)
        letter = {"bent": "b", "twisted": "c"}[motion]
        for fidelity in ("paper", "coupled"):
            run = scenes.tube_run(motion, fidelity)
            if fidelity == "paper":
                figures.append(
                    work.drawn(
                        run,
                        f"fig3{letter}_{motion}",
                        f"{motion} by {angle}: the paper's energies",
                        *SIDE,
                    )
                )
            apart = work.compared(run, reference, f"fig3{letter}_{fidelity}_distance")
            for key, name in (("rms", "RMS"), ("largest", "largest")):
                numbers.append(
                    Number(
                        f"{motion}, {fidelity}: {name} distance from the finite elements",
                        apart,
                        f"vessels/0/surface/{key}",
                        "% of R",
                        100,
                    )
                )
        figures.append(
            work.drawn(
                reference, f"fig3{letter}_{motion}_solid", f"{motion}: finite-element solid", *SIDE
            )
        )
        numbers.append(
            Number(
                f"{motion}: the finite elements' own relative error, estimated",
                f"runs/{reference.identity}/result/result.json",
                "discretisation/error_estimate",
                "%",
                100,
            )
        )
    return Panel(
        identity="fig3abc",
        title="Fig. 3(a-c): a tube at rest, bent and twisted",
        paper="Photographs of a tube beside the simulated one.",
        reproduced="The hybrid model's tube at rest, bent and twisted by its ends.",
        missing="The photographed tube: its size and material are not known here.",
        differs=(
            "In place of photographs stands a finite-element solid of the same tube, law and end"
            " motions; so the distance is a number, and it contains the model's error alone."
            " The angles are half of what kinks or wrinkles such a tube."
        ),
        figures=figures,
        numbers=numbers,
    )
