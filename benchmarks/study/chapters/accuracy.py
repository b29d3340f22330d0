"""How near each fidelity is to the finite-element reference."""

import figures
from chapters.aims import aims
from tables import IMAGES, markdown, paragraph, percent, provenance_text, signed

MODELS = ("rod", "skin", "paper", "coupled", "shell")


def case_table(rows, models, column, form):
    cases = list(dict.fromkeys(row["case"] for row in rows))
    lines = []
    for case in cases:
        cells = []
        for model in models:
            mine = [
                row
                for row in rows
                if row["case"] == case and row["model"] == model and row["around"] in (48, None)
            ]
            cells.append(form(mine[0]) if mine and mine[0][column] is not None else "-")
        own = next(
            (
                row["u_shape" if column == "rms" else "u_reaction"]
                for row in rows
                if row["case"] == case
            ),
            None,
        )
        lines.append([case, *cells, percent(own, 3)])
    return markdown(("case", *models, "error of the reference"), lines)


def accuracy_section(rows, notes, irregular):
    counted = [row for row in rows if row["counted"]]
    present = [
        m for m in MODELS if any(row["model"] == m and row["force"] is not None for row in rows)
    ]
    surfaces = [m for m in present if m != "rod"]
    references = sorted({row["reference"] for row in rows if row["reference"]})
    text = [
        "## Accuracy\n",
        paragraph(
            "Material points against the finite-element reference, Biot law on both sides.",
            "`vasorod compare` finds each rest point of the model on the rest surface of the",
            "reference and takes the distance of the displacements. The reference of each case is",
            f"the 7-parameter shell or the solid, p = 4, on two meshes ({', '.join(references)}).",
            "The error of the reference itself is its grid convergence index, with assumed order 2",
            "and a safety factor of 3. This is a comparison with a higher-fidelity model, not a",
            "validation by experiment.",
        ),
        "### RMS distance, % of R, 48 points around\n",
        case_table(counted, surfaces, "rms", lambda row: percent(row["rms"], 3)),
        f"![RMS distance]({IMAGES}/accuracy.png)\n",
    ]
    text += [
        "### Reaction at the moved end: force / moment difference over max(|F|, |M|/R), %\n",
        case_table(
            counted,
            present,
            "force",
            lambda row: f"{percent(row['force'])} / {percent(row['moment'])}",
        ),
    ]
    lines = []
    for model in present:
        for around in (24, 48, 96) if model != "shell" else (None,):
            mine = [
                row
                for row in counted
                if row["model"] == model and row["around"] == around and row["force"] is not None
            ]
            if not mine:
                continue
            bias, spread = figures.agreement([row["reaction_signed"] for row in mine])
            line_bias = [row["centerline_rms"] for row in mine if row["centerline_rms"] is not None]
            rms = [row["rms"] for row in mine if row["rms"] is not None]
            lines.append(
                [
                    model,
                    around or "-",
                    len(mine),
                    percent((sum(v * v for v in rms) / len(rms)) ** 0.5, 3) if rms else "-",
                    percent(max(rms), 3) if rms else "-",
                    percent(max(row["largest"] for row in mine if row["largest"] is not None), 2)
                    if rms
                    else "-",
                    percent(max(line_bias), 3) if line_bias else "-",
                    f"{signed(bias)} ± {100 * spread:.2f}",
                ]
            )
    text += [
        "### Over all counted cases\n",
        markdown(
            (
                "model",
                "points around",
                "cases",
                "RMS of RMS, % R",
                "worst RMS, % R",
                "worst point, % R",
                "worst centerline RMS, % L",
                "reaction: bias ± limits of agreement, %",
            ),
            lines,
        ),
        paragraph(
            "Bias is the mean of (model / reference - 1) along the reaction of the reference; the",
            "limits are 1.96 standard deviations over the cases. `rod`, `skin` and `paper` report",
            "the reactions of the rod, so their values are equal.",
        ),
        f"![Limits of agreement]({IMAGES}/agreement.png)\n",
    ]
    flat = [
        row
        for row in counted
        if row["around"] == 48
        and row["flattening"] is not None
        and row["flattening_reference"] > 0.005
        and row["model"] != "rod"
    ]
    if flat:
        models = [m for m in surfaces if m != "shell"]
        cases = list(dict.fromkeys(row["case"] for row in flat))
        lines = []
        for case in cases:
            of = {row["model"]: row for row in flat if row["case"] == case}
            lines.append(
                [
                    case,
                    *(f"{of[m]['flattening']:.4f}" if m in of else "-" for m in models),
                    f"{next(iter(of.values()))['flattening_reference']:.4f}",
                ]
            )
        text += [
            "### Flattening (largest relative loss of a diameter)\n",
            paragraph("Cases in which the flattening of the reference is above 0.005."),
            markdown(("case", *models, "reference"), lines),
        ]
    beyond = [row for row in rows if not row["counted"] and row["around"] in (48, None)]
    if beyond:
        lines = [
            [
                row["case"],
                row["model"],
                percent(row["rms"], 2),
                percent(row["force"]),
                percent(row["moment"]),
                row["failure"] or "",
            ]
            for row in beyond
        ]
        text += [
            "### Outside the range of the model (not counted above)\n",
            markdown(("case", "model", "RMS, % R", "force, %", "moment, %", "failure"), lines),
        ]
    failed = [row for row in counted if row["failure"] and "not there yet" not in row["failure"]]
    if failed:
        text += [
            "### Runs without a converged result\n",
            markdown(
                ("case", "model", "points around", "sentence"),
                [[row["case"], row["model"], row["around"], row["failure"]] for row in failed],
            ),
        ]
    text.insert(2, aims(rows, irregular))
    text.append(provenance_text(notes))
    return "\n".join(part for part in text if part)
