"""How near each fidelity is to the finite-element reference."""

import figures
from chapters.aims import aims
from names import title
from tables import markdown, paragraph, percent, provenance_text, signed

MODELS = ("rod", "skin", "paper", "section", "coupled", "shell")


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


def summary(rows, model, around):
    """What a model did over all counted cases; None where it has no run. Shares, not percent."""
    mine = [
        row
        for row in rows
        if (row["model"], row["around"], row["counted"]) == (model, around, 1)
        and row["force"] is not None
    ]
    if not mine:
        return None

    def worst(value):
        found = [(value(row), row) for row in mine if value(row) is not None]
        return max(found, key=lambda pair: pair[0]) if found else (None, None)

    shapes = [row["rms"] for row in mine if row["rms"] is not None]
    return {
        "cases": len(mine),
        "rms": (sum(v * v for v in shapes) / len(shapes)) ** 0.5 if shapes else None,
        "worst_rms": worst(lambda row: row["rms"]),
        "worst_point": worst(lambda row: row["largest"]),
        "worst_centerline": worst(lambda row: row["centerline_rms"]),
        "worst_reaction": worst(lambda row: max(row["force"], row["moment"])),
        "agreement": figures.agreement([row["reaction_signed"] for row in mine]),
    }


def cases_section(rows):
    """The readable names that figures and text use, and the files."""
    first = {row["case"]: row for row in reversed(rows)}
    return "\n".join(
        [
            "## Cases\n",
            paragraph(
                "Load: the share of the limit that the kind of load has (Brazier's curvature, the",
                "twist or the strain at which the wall wrinkles); pulled tubes have their stretch",
                "in its place. The files are in `benchmarks/cases/tube`.",
            ),
            markdown(
                ("file", "case", "counted"),
                [
                    [case, title(first[case]), "yes" if first[case]["counted"] else "no"]
                    for case in sorted(first)
                ],
            ),
        ]
    )


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
            "`section` is compared with the shell in every case.",
            "The error of the reference itself is its grid convergence index, with assumed order 2",
            "and a safety factor of 3. This is a comparison with a higher-fidelity model, not a",
            "validation by experiment.",
        ),
        "### RMS distance by case\n",
        paragraph("In % of R, 48 points around."),
        case_table(counted, surfaces, "rms", lambda row: percent(row["rms"], 3)),
    ]
    text += [
        "### Reaction by case\n",
        paragraph(
            "At the moved end: difference of the force / of the moment over R, over the",
            "reference's max(|F|, |M|/R), in %; 48 points around.",
        ),
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
            over = summary(counted, model, around)
            if over is None:
                continue
            bias, spread = over["agreement"]
            lines.append(
                [
                    model,
                    around or "-",
                    over["cases"],
                    percent(over["rms"], 3),
                    percent(over["worst_rms"][0], 3),
                    percent(over["worst_point"][0]),
                    percent(over["worst_centerline"][0], 3),
                    percent(over["worst_reaction"][0]),
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
                "worst reaction, %",
                "reaction: bias ± limits of agreement, %",
            ),
            lines,
        ),
        paragraph(
            "Bias is the mean of (model / reference - 1) along the reaction of the reference; the",
            "limits are 1.96 standard deviations over the cases. `rod`, `skin` and `paper` report",
            "the reactions of the rod, so their values are equal. The worst reaction is the larger",
            "difference of force and moment / R, over max(|F|, |M|/R).",
        ),
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
