"""docs/comparison.md from the tables in benchmarks/baselines: no number in it is typed. A section
without its table is absent."""

import figures
import promise
from tables import markdown, paragraph, provenance_text, read_table, value_or_range

MODELS = ("rod", "skin", "paper", "coupled", "shell")
IMAGES = "images/comparison"


def percent(value, digits=2):
    return "-" if value is None else f"{100 * value:.{digits}f}"


def signed(value):
    return "-" if value is None else f"{100 * value:+.2f}"


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


BENT = (
    "bend",
    "tapered",
    "curved",
    "offset",
    "combined",
    "check",
    "fresh",
)  # families whose ratio is to Brazier's curvature


def flattening_share(row):
    """Of what the aim allows: 2 % of the reference's value, or 0.001."""
    return abs(row["flattening"] - row["flattening_reference"]) / max(
        0.02 * row["flattening_reference"], 0.001
    )


def aims(accuracy, irregular):
    """The aims for `coupled`, and the worst measured value on each kind of surface."""
    groups = [
        (
            f"{around} points around",
            [row for row in accuracy if row["model"] == "coupled" and row["around"] == around],
        )
        for around in (48, 96)
    ]
    groups.append(("irregular surfaces", irregular))
    groups = [
        (name, [row for row in rows if row["counted"] and row["rms"] is not None])
        for name, rows in groups
    ]
    groups = [(name, rows) for name, rows in groups if rows]

    def stated(what, limit, bound, belongs, value, form):
        cells = []
        for _, rows in groups:
            worst = max(
                (
                    (value(row), f"{row['case']}, {row['mesh']}" if "mesh" in row else row["case"])
                    for row in rows
                    if belongs(row)
                ),
                default=None,
            )
            cells.append(
                "-"
                if worst is None
                else f"{form(worst[0])} ({worst[1]}): {'held' if worst[0] <= bound else 'missed'}"
            )
        return [what, limit, *cells]

    def low(row):
        return row["family"] not in BENT or row["ratio"] <= 0.5

    lines = [
        stated(
            "RMS over R, up to Brazier ratio 0.5",
            "0.2 %",
            0.002,
            low,
            lambda r: r["rms"],
            lambda v: f"{100 * v:.3f} %",
        ),
        stated(
            "RMS over R, from there to 0.7",
            "0.5 %",
            0.005,
            lambda r: not low(r),
            lambda r: r["rms"],
            lambda v: f"{100 * v:.3f} %",
        ),
        stated(
            "largest distance over R, up to 0.5",
            "1 %",
            0.01,
            low,
            lambda r: r["largest"],
            lambda v: f"{100 * v:.3f} %",
        ),
        stated(
            "reaction",
            "1 %",
            0.01,
            lambda r: True,
            lambda r: max(r["force"], r["moment"]),
            lambda v: f"{100 * v:.2f} %",
        ),
        stated(
            "flattening, over the larger of 2 % of it and 0.001",
            "1",
            1,
            lambda r: True,
            flattening_share,
            lambda v: f"{v:.2f}",
        ),
    ]
    counts = ", ".join(f"{name}: {len(rows)} runs" for name, rows in groups)
    return (
        "### The aims for `coupled`\n\n"
        + paragraph(f"Worst of {counts}; in brackets the case.")
        + "\n"
        + markdown(("quantity", "aim", *(name for name, _ in groups)), lines)
        + "\n"
    )


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


def laws_section(rows, notes):
    def cell(case, difference, law, value):
        row = next(
            (r for r in rows if (r["case"], r["difference"], r["law"]) == (case, difference, law)),
            None,
        )
        return "-" if row is None else row["failure"] or value(row)

    columns = (
        ("kinematics", "biot"),
        ("kinematics", "svk"),
        ("law", "svk"),
        ("law", "neo-hookean"),
    )
    names = ("kinematics, Biot", "kinematics, S = C:E", "law, S = C:E", "law, neo-Hookean")
    cases = list(dict.fromkeys(row["case"] for row in rows))

    def table(value):
        return markdown(
            ("case", *names),
            [[case, *(cell(case, *column, value) for column in columns)] for case in cases],
        )

    return "\n".join(
        [
            "## Kinematics and law separately\n",
            paragraph(
                "Kinematics: `coupled`, 48 points around, against the 7-parameter shell of the",
                "same law. Law: the shell of another law against the shell of Biot's law, on the",
                "same cells. The second difference shows how much the choice of a law matters on a",
                "scene; it is no error of a model. The two differences must not be added.",
            ),
            "### RMS distance, % of R\n",
            table(lambda row: percent(row["rms"], 3)),
            "### Reaction along the reference's reaction, minus one, %\n",
            table(lambda row: signed(row["reaction_signed"])),
            provenance_text(notes),
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


def promise_table(kept):
    return markdown(
        ("case", "fidelity", "points around", "promised, % R", "measured, % R", ""),
        [
            [
                row["case"],
                row["model"],
                f"{row['around']:.0f}",
                percent(error, 3),
                percent(row["rms"], 3),
                "kept" if row["rms"] <= error else "broken",
            ]
            for row, error in kept
        ],
    )


def promise_section(rows, asked):
    kept = promise.held_out(rows)
    if not kept:
        return ""
    fresh = [pair for pair in kept if pair[0]["family"] == "fresh"]
    text = [
        "## `accuracy: x`\n",
        paragraph(
            "`accuracy: x` uses the table `hybrid/judge/accuracy_table.cpp`, made from the pulled,",
            "twisted and bent straight tubes above. Each level has the largest error over their",
            f"walls plus the error of the reference, times {promise.SAFETY}. The promise",
            "interpolates linearly between levels and adds up the kinds of load. It covers neither",
            "tubes curved at rest nor pressed tubes: for pressed tubes it was too optimistic, as a",
            "fresh case showed.",
        ),
    ]
    if fresh:
        held = sum(row["rms"] <= error for row, error in fresh)
        text += [
            "### Independent cases\n",
            paragraph(
                "Other walls, planes and combinations, written before their first run and after",
                f"the margin was fixed: kept {held} of {len(fresh)}.",
            ),
            promise_table(fresh),
        ]
    beyond = promise.held_out(rows, within=False)
    if beyond:
        text += [
            paragraph(
                "Pressed tubes get no promise. The next table has the promise that the table of",
                "pulled tubes would have given.",
            ),
            promise_table(beyond),
        ]
    if asked:
        lines = [
            [
                row["case"],
                f"{100 * row['wanted']:g}",
                row["chosen"] or "-",
                percent(row["rms"], 3),
                row["failure"] or ("kept" if row["rms"] <= row["wanted"] else "broken"),
            ]
            for row in asked[0]
        ]
        text += [
            paragraph(
                "The same cases with `accuracy: x` in the scene: the chosen fidelity and its",
                "distance from the reference. A refusal states the best accuracy that is promised.",
            ),
            markdown(("case", "x, % R", "chosen", "measured, % R", ""), lines),
            provenance_text(asked[1]),
        ]
    text += [
        "### Cases that set the margin\n",
        paragraph(
            "The table was not made from these cases, but the margin was raised until all of them",
            "kept the promise. They are no independent test.",
        ),
        promise_table([pair for pair in kept if pair[0]["family"] != "fresh"]),
    ]
    return "\n".join(text)


def reaction_of(row):
    return max(row["force"], row["moment"] / 10)


def sensitivity_lines(rows, models):
    """Per curve the factor of its largest distance from the shell's: in the reaction, beyond the
    error of the reference, and in the shape."""
    reference = {
        (row["load"], row["modulus"], f"{row['factor']:.3g}"): row
        for row in rows
        if row["fidelity"] == "shell" and row["force"] is not None
    }
    lines = []
    for load in ("twist", "bend", "stretch", "offset"):
        for modulus in ("E", "G"):
            for model in models:
                mine = [
                    row
                    for row in rows
                    if (row["load"], row["modulus"], row["fidelity"]) == (load, modulus, model)
                    and row["force"] is not None
                ]
                pairs = [
                    (row, reference.get((load, modulus, f"{row['factor']:.3g}"))) for row in mine
                ]
                pairs = [
                    (reaction_of(row) / reaction_of(other) - 1, row, other)
                    for row, other in pairs
                    if other is not None
                ]
                if not pairs:
                    continue
                worst = max(pairs, key=lambda pair: abs(pair[0]))
                shape = max(
                    (
                        (abs(row["variation"] - other["variation"]), row["factor"])
                        for _, row, other in pairs
                    )
                )
                held = all(
                    abs(difference) <= (other["u_reaction"] or 0) + 0.01
                    for difference, _, other in pairs
                )
                lines.append(
                    [
                        load,
                        modulus,
                        model,
                        len(pairs),
                        f"{signed(worst[0])} at {worst[1]['factor']:.3g}",
                        "held" if held else "missed",
                        f"{percent(shape[0], 3)} at {shape[1]:.3g}",
                    ]
                )
    return lines


def sensitivity_failures(rows):
    """Per curve the factors at which a run did not converge, and how it ended."""
    ended = {}
    for row in rows:
        if row["failure"]:
            ended.setdefault(
                (row["load"], row["modulus"], row["fidelity"], row["failure"]), []
            ).append(row["factor"])
    return [
        [load, modulus, model, ", ".join(f"{factor:.3g}" for factor in sorted(factors)), failure]
        for (load, modulus, model, failure), factors in ended.items()
    ]


def sensitivity_section(rows, notes, parted):
    models = [
        m
        for m in ("skin", "paper", "coupled")
        if any(row["fidelity"] == m and row["force"] is not None for row in rows)
    ]
    text = [
        "## Moduli alone\n",
        paragraph(
            "The wall is transversely isotropic about the axis of the tube. E scales E_axial and",
            "E_T together, G scales G_axial alone. t / R = 0.1, L / R = 10, Biot law. Variation:",
            "RMS distance of material points to the shape at factor 1, over R. The twist is a",
            "tenth of a degree (surface shear 1.7e-4); with E / G at a hundredth of the base the",
            "tube wrinkles at 0.2 degrees. Shapes under prescribed motions depend on E / G alone.",
            "Aim: reactions within the error of the reference plus 1 %.",
        ),
        f"![Sensitivity]({IMAGES}/sensitivity.png)\n",
    ]
    lines = sensitivity_lines(rows, models)
    if lines:
        text.append(
            markdown(
                (
                    "load",
                    "modulus",
                    "model",
                    "factors compared",
                    "largest reaction difference, %, at factor",
                    "aim",
                    "largest difference of the variation, % R, at factor",
                ),
                lines,
            )
        )
    failures = sensitivity_failures(rows)
    if failures:
        text += [
            "### Not converged\n",
            paragraph(
                "A wall soft in shear wrinkles earlier, by (G / G0)^(1/2). Half of Brazier's",
                "curvature is beyond that limit where E is more than four times the base.",
            ),
            markdown(("load", "modulus", "model", "at factors", "ended"), failures),
        ]
    text.append(provenance_text(notes))
    if parted:
        text += [
            "### Walls soft in shear\n",
            paragraph(
                f"`{parted[0][0]['load']}` at {parted[0][0]['modulus']} x",
                f"{parted[0][0]['factor']:g}, where the wall is softest in shear. G_axial is also",
                "the shear modulus of the shell through its thickness; the normals of `coupled`",
                "stay normal. The gap that remains on a fine mesh falls with the thickness:",
            ),
            markdown(
                (
                    "thickness / R",
                    "coupled, points around",
                    "force, coupled",
                    "force, shell",
                    "difference, %",
                    "RMS, % R",
                    "error of the reference, %",
                ),
                [
                    [
                        f"{row['thickness'] / 10:g}",
                        f"{row['around']:.0f}",
                        f"{row['force']:.4f}",
                        f"{row['force_reference']:.4f}",
                        signed(row["force"] / row["force_reference"] - 1),
                        percent(row["rms"], 3),
                        percent(row["u_reaction"], 3),
                    ]
                    for row in parted[0]
                ],
            ),
            provenance_text(parted[1]),
        ]
    return "\n".join(text)


def front_of(rows):
    best, front = float("inf"), []
    for row in sorted(rows, key=lambda r: r["seconds"]):
        if row["rms"] < best:
            best = row["rms"]
            front.append(row)
    return front


def settings_text(value):
    return f"{value:g}" if isinstance(value, float) else str(value)


def time_ratios(rows):
    """Per resolution of `coupled`: the cheapest run of another program that is at least as near to
    its reference, over the time of `coupled`."""
    lines = []
    for row in sorted(
        (row for row in rows if row["model"] == "coupled"), key=lambda r: r["seconds"]
    ):
        for others, column, what in (
            ("shell", "seconds", "whole program"),
            ("shell", "solve_seconds", "solving alone"),
            ("CalculiX", "seconds", "whole program"),
        ):
            near = [
                other
                for other in rows
                if other["model"].startswith(others)
                and other["rms"] <= row["rms"]
                and other[column] is not None
            ]
            if near and row[column] is not None:
                best = min(near, key=lambda r: r[column])
                ratio = best[column] / row[column]
                lines.append(
                    [
                        settings_text(row["settings"]),
                        f"{best['model']} {best['settings']}",
                        what,
                        f"{row[column]:.2f}",
                        f"{best[column]:.2f}",
                        f"{ratio:.1f}",
                        "held" if ratio >= 30 else "missed",
                    ]
                )
            else:
                lines.append(
                    [
                        settings_text(row["settings"]),
                        f"{others}: none as near",
                        what,
                        "-" if row[column] is None else f"{row[column]:.2f}",
                        "-",
                        "-",
                        "-",
                    ]
                )
    return (
        "### Time ratio at equal error (aim: 30)\n\n"
        + markdown(
            (
                "coupled, points around",
                "cheapest at least as accurate",
                "counted",
                "coupled, s",
                "the other, s",
                "ratio",
                "",
            ),
            lines,
        )
        if lines
        else ""
    )


def trade_section(rows, notes):
    rows = [row for row in rows if row["rms"] is not None]
    front = front_of(rows)
    lines = [
        [
            row["model"],
            settings_text(row["settings"]),
            f"{row['seconds']:.2f}",
            "-" if row["solve_seconds"] is None else f"{row['solve_seconds']:.2f}",
            f"{row['peak_bytes'] / 2**20:.0f}",
            percent(row["rms"], 3),
            percent(row["reaction"], 2),
            "front" if row in front else "",
        ]
        for row in sorted(rows, key=lambda r: r["seconds"])
    ]
    references = "; ".join(
        f"{', '.join(sorted({row['model'] for row in rows if row['reference'] == reference}))}: "
        f"{reference}"
        for reference in dict.fromkeys(row["reference"] for row in rows)
    )
    own = max(row["reference_rms"] for row in rows)
    return "\n".join(
        [
            "## Time against error\n",
            paragraph(
                f"Case `{rows[0]['case']}`. Processor time and peak memory, one thread, the least",
                "of",
                value_or_range([row["repeats"] for row in rows], lambda v: f"{v:.0f}"),
                "runs each on a shared machine. Two times: of the whole program, and of solving",
                "alone (its share of the wall time, without reading, pictures and writing;",
                "CalculiX does not report it). Error against the converged reference of the same",
                f"law ({references}). The error of the reference itself is up to {percent(own, 3)}",
                "% of R.",
            ),
            f"![Trade]({IMAGES}/trade.png)\n",
            markdown(
                (
                    "model",
                    "settings",
                    "whole program, s",
                    "solving, s",
                    "peak memory, MiB",
                    "RMS, % R",
                    "reaction, %",
                    "",
                ),
                lines,
            ),
            time_ratios(rows),
            provenance_text(notes),
        ]
    )


def table_if_there(path):
    return read_table(path) if path.exists() else None


def write_report(baselines, docs):
    text = [
        "# Accuracy and cost against finite elements\n",
        paragraph(
            "Written by `./run report` from the tables in `benchmarks/baselines`; no number here",
            "is typed by hand. How to add a case: [adding_a_case.md](adding_a_case.md).",
        ),
    ]
    images = docs / IMAGES
    accuracy, notes = read_table(baselines / "accuracy.csv")
    irregular = table_if_there(baselines / "irregular.csv")
    text.append(accuracy_section(accuracy, notes, irregular[0] if irregular else []))
    figures.errors_picture(accuracy, images / "accuracy.png")
    figures.limits_picture(accuracy, images / "agreement.png")
    if irregular:
        text.append(irregular_section(*irregular))
    laws = table_if_there(baselines / "laws.csv")
    if laws:
        text.append(laws_section(*laws))
    text.append(promise_section(accuracy, table_if_there(baselines / "promise.csv")))
    if (baselines / "sensitivity.csv").exists():
        rows, notes = read_table(baselines / "sensitivity.csv")
        text.append(sensitivity_section(rows, notes, table_if_there(baselines / "shear_gap.csv")))
        figures.sensitivity_picture(rows, images / "sensitivity.png")
    if (baselines / "trade.csv").exists():
        rows, notes = read_table(baselines / "trade.csv")
        text.append(trade_section(rows, notes))
        figures.trade_picture(
            [row for row in rows if row["rms"] is not None],
            images / "trade.png",
            front_of([row for row in rows if row["rms"] is not None]),
        )
    (docs / "comparison.md").write_text("\n".join(part for part in text if part).rstrip() + "\n")
