"""Tubes with a pressure in their lumen."""

from tables import markdown, outcomes, paragraph, percent, provenance_text, signed


def loads_section(rows, notes):
    def numbers(row):
        shares = ("rms", "largest", "force", "moment", "own_error")
        sections = [
            "-" if row[name] is None else f"{row[name]:.4f}"
            for name in ("flattening", "flattening_reference")
        ]
        return [*(percent(row[name], 3) for name in shares), *sections]

    head = ("fidelity", "load", "mmHg", "RMS, % of R", "largest, % of R", "force, %", "moment, %")
    head += ("shell's own error, %", "flattening", "the shell's")
    return "\n".join(
        [
            "## Tubes under pressure\n",
            paragraph(
                "A tube (R 3.3, t 0.33, L 30 mm, E 0.5 MPa, nu 0.45, neo-Hookean, rigid ends, 60",
                "points around) from a wall without stress to a pressure and a load, against the",
                "reference's shell with the pressure on its inner face. Force and moment:",
                "differences over the larger of the reaction's force and moment / R. The shell's",
                "own error is its largest grid convergence index: of displacements over the",
                "radius, reactions and energy. The rod of `skin` is linear and keeps the radius",
                "of its sections.",
            ),
            outcomes(
                head,
                rows,
                lambda row: [row["fidelity"], row["load"], f"{row['pressure']:g}"],
                numbers,
            ),
            provenance_text(notes),
        ]
    )


def softening(row, empty):
    """The flattening of a bend under pressure over that of the same bend without."""
    return f"{row['flattening'] / empty['flattening']:.3f}"


def bends_section(rows, notes):
    soft = [row for row in rows if row["section"] == "soft"]
    empty = {
        (row["fidelity"], row["share"]): row
        for row in soft
        if row["ratio"] == 0 and not row["failure"]
    }

    def line(row):
        start = [row["fidelity"], row["section"], f"{row['share']:g}", f"{row['ratio']:g}"]
        start.append(row["failure"] or "converged")
        if row["failure"]:
            return [*start, *["-"] * 6, f"{row['seconds']:.1f}"]
        over, expected = "-", "-"
        if row in soft and (row["fidelity"], row["share"]) in empty:
            over = softening(row, empty[row["fidelity"], row["share"]])
            expected = f"{1 / (1 + row['ratio']):.3f}"
        numbers = [f"{row['moment']:.4g}", f"{row['stiffness']:.4f}"]
        numbers += [f"{row['wrinkling_ratio']:.2f}", f"{row['seconds']:.1f}"]
        return [*start, f"{row['flattening']:.4f}", over, expected, *numbers]

    head = ("fidelity", "ends", "share", "p / p_c", "status", "flattening", "over that without")
    head += ("1 / (1 + p / p_c)", "moment, N mm", "stiffness / E I", "wrinkling ratio", "s")
    return "\n".join(
        [
            "## Bends under pressure\n",
            paragraph(
                "A long tube (R 10, t 1 mm, E 1 MPa, nu 0.45, Biot, 32 points around) in",
                "equilibrium at the pressure it was seen at, given in units of p_c = 3 D / R^3,",
                "and bent to an arc: `soft` ends (L 100) to a share of Brazier's curvature",
                "without pressure, `rigid` ends (L 200) to a share of it at that pressure, (1 + p",
                "/ p_c)^(1/2) times as large. Stiffness: moment over curvature, over the E I of a",
                "ring that keeps its shape. Where no equilibrium on the smooth branch was found,",
                "the numbers are left out.",
            ),
            markdown(head, [line(row) for row in rows]),
            provenance_text(notes),
        ]
    )


def widening_section(rows, notes):
    def numbers(row):
        off = row["widening"] / row["closed_form"] - 1
        return [f"{row['widening']:.6f}", f"{row['closed_form']:.6f}", signed(off)]

    head = ("nu", "p / p_c", "model", "widening / R", "Lame", "off by, %")
    return "\n".join(
        [
            "## How far a pressure widens a tube\n",
            paragraph(
                "A tube (R 10, t 1, L 30 mm, E 1 MPa, Biot) from a wall without stress to a",
                "pressure in units of p_c = 3 D / R^3, its ends soft and held along the axis:",
                "every point moves alike along its radius. Lame's thick tube in plane strain has",
                "small displacements; the models do not, which is what they differ by at 5 p_c.",
                "At p_c and nu 0.5 a thin tube widens by (t / 2 R)^2 = 0.0025.",
            ),
            outcomes(
                head,
                rows,
                lambda row: [f"{row['poisson']:g}", f"{row['ratio']:g}", f"`{row['model']}`"],
                numbers,
            ),
            provenance_text(notes),
        ]
    )


def kinks_of(rows):
    """{(p / p_c, points around): (the last bend on the smooth branch, the first beyond it)}, each a
    row, or None where the shares tried have none such."""
    found = {}
    for row in sorted(rows, key=lambda row: row["share"]):
        smooth, kinked = found.get((row["ratio"], row["around"]), (None, None))
        if row["failure"] is None and kinked is None:
            smooth = row
        elif row["failure"] is not None and kinked is None:
            kinked = row
        found[row["ratio"], row["around"]] = smooth, kinked
    return found


def kink_line(smooth, kinked):
    """Between which shares of Brazier's curvature a tube kinks."""
    if smooth is None or kinked is None:
        return f"below {kinked['share']:g}" if kinked else f"beyond {smooth['share']:g}"
    return f"{smooth['share']:g} to {kinked['share']:g}"


def kinks_section(rows, notes):
    lines = []
    for (ratio, around), (smooth, kinked) in sorted(
        kinks_of(rows).items(), key=lambda pair: pair[0]
    ):
        lines.append([f"{ratio:g}", f"{around:g}", kink_line(smooth, kinked)])
        numbers = [smooth and f"{smooth[name]:.3g}" for name in ("moment", "flattening")]
        numbers += [smooth and f"{smooth['wrinkling_ratio']:.2f}", kinked and kinked["failure"]]
        lines[-1] += [one or "-" for one in numbers]
    head = ("p / p_c", "around", "kinks between", "moment before, N mm", "flattening before")
    return "\n".join(
        [
            "## At which curvature a tube kinks\n",
            paragraph(
                "The tube of the bends above with rigid ends (L 200) at `coupled`, bent in steps",
                "of 0.05 of Brazier's curvature at its pressure, up to where its smooth branch",
                "ends. Brazier's limit, which pressure raises by (1 + p / p_c)^(1/2), is 1 here;",
                "the more pressure holds the section open, the sooner the inner side wrinkles",
                "instead, as the wrinkling ratio says.",
            ),
            markdown((*head, "wrinkling ratio before", "beyond"), lines),
            provenance_text(notes),
        ]
    )
