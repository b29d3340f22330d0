"""Fig. 2: the models, the picked places, the cut and the path of the incision."""

import shutil

import scenes
from work import Figure, Number, Panel


def runs(quick):
    return [scenes.models_run(), scenes.glenn_run("infant")]


def panel(work):
    models, operation = scenes.models_run(), scenes.glenn_run("infant")
    work.solved(models)
    folder = work.solved(operation)
    glenn = scenes.glenn("infant")["surgery"]["glenn"]
    marks = ("--mark", *glenn["cut"], "--mark", *glenn["incision"])
    figures = [
        work.drawn(models, "fig2a_models", "2(a): the models of the vessels", *scenes.OBLIQUE),
        work.drawn(
            models,
            "fig2b_picks",
            "2(b): the two picked places, red, seen from the right and above",
            *scenes.RIGHT,
            *marks,
        ),
    ]
    ends = work.result(operation)["glenn"]["incision"]["ends"]
    figures.append(
        work.drawn(
            operation,
            "fig2c_cut_and_incision",
            "2(c): the cut through the vein and the path of the incision between its two ends, red",
            *("--rest", "--only", "svc", "svc stump", "pulmonary_artery", *scenes.RIGHT),
            *("--mark", *ends[0], "--mark", *ends[1]),
        )
    )
    shutil.copy(
        work.folder / folder / "result" / "picture_incision.png",
        work.folder / "fig2c_opened.png",
    )
    figures.append(
        Figure(
            "fig2c_opened.png",
            "2(c), then: the cut made and the incision opened",
            f"cd {folder} && {work.command_of(operation)}"
            " && cp result/picture_incision.png ../../fig2c_opened.png",
        )
    )
    file = f"{folder}/result/result.json"
    return Panel(
        identity="fig2",
        title="Fig. 2: models, picks, cut and incision",
        paper="The models of the vessels, the picked points, the cut and the incision's path.",
        reproduced="All three steps, as the program makes them from two picked places.",
        missing="The patient's vessels: their CT is not public.",
        differs=(
            "The anatomy is drawn (meshes/README.md). The incision is as long as half the vein's"
            " perimeter and runs along the artery's rod."
        ),
        figures=figures,
        numbers=[
            Number(
                "kept part of the vein, of the rod's length", file, "glenn/cut/fraction", "%", 100
            ),
            Number("perimeter of the cut", file, "glenn/cut/perimeter", "mm"),
            Number("length of the incision", file, "glenn/incision/length", "mm"),
            Number("pairs of vertices in the seam", file, "glenn/join/pairs"),
        ],
    )
