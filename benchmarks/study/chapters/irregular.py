"""`coupled` on irregular surfaces."""

import figures
from tables import markdown, paragraph, percent, provenance_text, signed, value_or_range


def irregular_section(rows, notes):
    done = [row for row in rows if row["rms"] is not None]
    lines = []
    for mesh in dict.fromkeys(row["mesh"] for row in rows):
        mine = [row for row in done if row["mesh"] == mesh]
        bias, spread = figures.agreement([row["reaction_signed"] for row in mine])
        lines.append(
            [
                mesh,
                f"{mine[0]['around']:.0f}",
                value_or_range([row["vertices"] for row in mine], lambda v: f"{v:.0f}"),
                f"{min(row['smallest_angle'] for row in mine):.0f}",
                f"{len(mine)} of {sum(row['mesh'] == mesh for row in rows)}",
                percent((sum(row["rms"] ** 2 for row in mine) / len(mine)) ** 0.5, 3),
                percent(max(row["rms"] for row in mine), 3),
                percent(max(row["largest"] for row in mine), 2),
                f"{signed(bias)} ± {100 * spread:.2f}",
            ]
        )
    meshes = list(dict.fromkeys(row["mesh"] for row in rows))
    cases = []
    for case in dict.fromkeys(row["case"] for row in rows):
        of = {row["mesh"]: row for row in rows if row["case"] == case}
        cases.append(
            [
                case,
                *(
                    f"{percent(of[m]['rms'], 3)} / {percent(max(of[m]['force'], of[m]['moment']))}"
                    if m in of and of[m]["rms"] is not None
                    else of[m]["failure"]
                    if m in of
                    else "-"
                    for m in meshes
                ),
            ]
        )
    return "\n".join(
        [
            "## Irregular surfaces\n",
            paragraph(
                "`coupled` on surfaces read from a file, as a segmented vessel is: the centerline",
                "and the frames of the sections come from the fit. `meshes/irregular_tube.py`",
                "makes the surfaces: random points (blue-noise), rows shifted by up to a quarter",
                "of an edge (jittered), triangles five times longer along the axis than wide",
                "(stretched). Tapered walls are left out, because a surface from a file has one",
                "thickness.",
            ),
            markdown(
                (
                    "mesh",
                    "points on a rim",
                    "vertices",
                    "smallest angle, degrees",
                    "converged",
                    "RMS of RMS, % R",
                    "worst RMS, % R",
                    "worst point, % R",
                    "reaction: bias ± limits of agreement, %",
                ),
                lines,
            ),
            "### RMS distance, % of R / largest reaction difference, %\n",
            markdown(("case", *meshes), cases),
            provenance_text(notes),
        ]
    )
