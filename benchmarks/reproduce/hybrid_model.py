"""Fig. 1: the hybrid model: rod, directors and mesh."""

import scenes
from work import Number, Panel


def runs(quick):
    return [scenes.glenn_run("infant"), scenes.tube_run("bent", "paper")]


def panel(work):
    tube, vein = scenes.tube_run("bent", "paper"), scenes.glenn_run("infant")
    work.solved(tube)
    file = f"{work.solved(vein)}/result/result.json"
    side = ("--from", 0.5, -1, 0.5, "--up", 1, 0, 0, "--size", 760, 420)
    return Panel(
        identity="fig1",
        title="Fig. 1: the hybrid model",
        paper="The hybrid model: the rod, its directors and the mesh around it.",
        reproduced="Rod, directors and mesh as the program solved them, of a tube and of a vein.",
        missing="Nothing of these three.",
        differs=(
            "What is drawn is a solution; about a dozen nodes of each rod show their directors."
        ),
        figures=[
            work.drawn(
                tube, "fig1_rod", "The rod (dark), d1 red, d2 green, d3 blue", "--rod", *side
            ),
            work.drawn(
                tube,
                "fig1_mesh",
                "A detail of it with the mesh that is bound to the rod",
                *("--rod", "--mesh", *side, "--centre", 0, 0, 22, "--height", 32),
            ),
            work.drawn(
                vein,
                "fig1_vein",
                "Both, of the joined vein",
                *("--only", "svc", "--rod", "--mesh", *scenes.OBLIQUE),
            ),
        ],
        numbers=[
            Number("nodes of all rods of the Glenn scene", file, "model/rod_nodes"),
            Number("vertices of all meshes of the Glenn scene", file, "model/vertices"),
        ],
    )
