"""Fig. 4(c-e): three cuts of the vein, from shorter to longer, and its contact with the aorta."""

import scenes
from work import Number, Panel

CUTS = {"c": ("infant_short", 27.0), "d": ("infant", 30.2), "e": ("infant_long", 31.6)}


def run_of(letter):
    return scenes.glenn_run(CUTS[letter][0])


def runs(quick):
    return [run_of(letter) for letter in CUTS]


def contact(result):
    """The index of the contact between vein and aorta."""
    return next(
        k for k, one in enumerate(result["contact"]) if {one["a"], one["b"]} == {"svc", "aorta"}
    )


def place(result):
    """Where the vein is pressed most."""
    metrics = next(one for one in result["metrics"] if one["vessel"] == "svc")
    return metrics["where"]["largest_pressure"]


def panel(work):
    results = {}
    for letter in CUTS:
        work.solved(run_of(letter))
        results[letter] = work.result(run_of(letter))
    most = max(r["contact"][contact(r)]["largest_pressure"] for r in results.values())
    scale = ("--colour", "contact_pressure", "--range", 0, most)
    spot = place(results["c"])
    figures, numbers = [], []
    for letter, (name, length) in CUTS.items():
        run = run_of(letter)
        figures.append(
            work.drawn(
                run,
                f"fig4{letter}",
                f"4({letter}): {length} mm of the vein are kept",
                *scale,
                *scenes.FRONTAL,
            )
        )
        figures.append(
            work.drawn(
                run,
                f"fig4{letter}_inset",
                f"4({letter}), inset: the vein alone, seen from the aorta",
                *scale,
                *("--only", "svc", "--from", 1, 0, 0, "--up", 0, 0, 1),
                *("--centre", *spot, "--height", 14),
            )
        )
        file, k = f"runs/{run.identity}/result/result.json", contact(results[letter])
        for key, what, unit in (
            ("largest_pressure", "largest contact pressure", "MPa"),
            ("area", "contact area", "mm2"),
            ("smallest_gap", "smallest gap between vein and aorta", "mm"),
        ):
            numbers.append(
                Number(f"({letter}) {length} mm: {what}", file, f"contact/{k}/{key}", unit)
            )
    return Panel(
        identity="fig4cde",
        title="Fig. 4(c-e): three cuts of the vein, shorter to longer",
        paper="Three cuts of the vein, shorter to longer, and its contact pressure.",
        reproduced=(
            "The trend: a shorter vein presses harder, a longer one less, and the longest not at"
            " all: its contact pressure is exactly 0. One scale of colours for all pictures."
        ),
        missing="The patient's vessels, the paper's lengths and its pressures.",
        differs=(
            "The contact is with the ascending aorta of a drawn anatomy with assumed walls, so the"
            " values show the trend and no patient. Contact is a constraint on the gap between"
            " outer walls, its pressure the multiplier, which is 0 where walls are apart."
        ),
        figures=figures,
        numbers=numbers,
    )
