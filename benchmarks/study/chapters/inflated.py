"""Tubes with a pressure in their lumen."""

from tables import markdown, outcomes, paragraph, percent, provenance_text


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


def bends_section(rows, notes):
    soft = [row for row in rows if row["section"] == "soft"]
    empty = {
        (row["fidelity"], row["share"]): row["flattening"]
        for row in soft
        if row["ratio"] == 0 and not row["failure"]
    }

    def line(row):
        start = [row["fidelity"], row["section"], f"{row['share']:g}", f"{row['ratio']:g}"]
        start.append(row["failure"] or "converged")
        if row["failure"]:
            return [*start, *["-"] * 5, f"{row['seconds']:.1f}"]
        over, expected = "-", "-"
        if row in soft and (row["fidelity"], row["share"]) in empty:
            over = f"{row['flattening'] / empty[row['fidelity'], row['share']]:.3f}"
            expected = f"{1 / (1 + row['ratio']):.3f}"
        numbers = [f"{row['moment']:.4g}", f"{row['wrinkling_ratio']:.2f}", f"{row['seconds']:.1f}"]
        return [*start, f"{row['flattening']:.4f}", over, expected, *numbers]

    head = ("fidelity", "ends", "share", "p / p_c", "status", "flattening", "over that without")
    head += ("1 / (1 + p / p_c)", "moment, N mm", "wrinkling ratio", "s")
    return "\n".join(
        [
            "## Bends under pressure\n",
            paragraph(
                "A long tube (R 10, t 1 mm, E 1 MPa, nu 0.45, Biot, 32 points around) in",
                "equilibrium at the pressure it was seen at, given in units of p_c = 3 D / R^3,",
                "and bent to an arc: `soft` ends (L 100) to a share of Brazier's curvature",
                "without pressure, `rigid` ends (L 200) to a share of it at that pressure, (1 + p",
                "/ p_c)^(1/2) times as large. Where no equilibrium on the smooth branch was",
                "found, the numbers are left out.",
            ),
            markdown(head, [line(row) for row in rows]),
            provenance_text(notes),
        ]
    )
