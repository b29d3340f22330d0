"""Tubes with a pressure in their lumen."""

import inflated_bends
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


def compressed(ratio):
    return f"{percent(inflated_bends.compressed_stiffness(ratio), 1)} %"


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
                "ring that keeps its shape. It is lowered by the flattening (3 / 2 of it, Brazier)",
                "and by the compression of a pressurised tube between held ends, (1 - 2 nu) p pi",
                f"R^2: to first order by {compressed(1)} at p_c and {compressed(5)} at 5 p_c in",
                "the soft bends. Where no equilibrium on the smooth branch was found, the numbers",
                "are left out.",
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
                "every point moves outwards by the same distance. Lame's thick tube in plane",
                "strain is for small displacements; the reference says by how much large ones",
                "differ from it. A thin tube widens by (t / 2 R)^2 = 0.0025 at p_c. The reference",
                "needs a compressible wall: nu 0.5 is without it.",
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
    row, or None where the shares tried have none such. Only a snap into another minimum is a kink;
    a bend that ended otherwise ends the search."""
    found = {}
    for row in sorted(rows, key=lambda row: row["share"]):
        smooth, kinked, ended = found.get((row["ratio"], row["around"]), (None, None, False))
        if not ended and row["failure"] is None:
            smooth = row
        elif not ended and row["failure"] == "status buckled":
            kinked = row
        found[row["ratio"], row["around"]] = smooth, kinked, ended or row["failure"] is not None
    return {key: both for key, (*both, _) in sorted(found.items())}


def kink_line(smooth, kinked):
    """Between which curvatures a tube kinks, over Brazier's without pressure."""

    def over_empty(row):
        return f"{row['share'] * (1 + row['ratio']) ** 0.5:.2f}"

    if kinked is None:
        return f"beyond {over_empty(smooth)}" if smooth else "-"
    if smooth is None:
        return f"below {over_empty(kinked)}"
    return f"{over_empty(smooth)} to {over_empty(kinked)}"


def unsettled(kinks):
    """A sentence about the pressures at which two meshes kink at different curvatures; or empty."""
    lines = {}
    for (ratio, _), both in kinks.items():
        lines.setdefault(ratio, set()).add(kink_line(*both))
    apart = [f"{ratio:g} p_c" for ratio, found in lines.items() if len(found) > 1]
    if not apart:
        return ""
    return f"At {', '.join(apart)} another mesh kinks elsewhere: that number is not settled."


def share_line(smooth, kinked):
    """The same as shares of Brazier's curvature at the pressure."""
    return " to ".join(f"{row['share']:g}" for row in (smooth, kinked) if row) or "-"


def kinks_section(rows, notes):
    lines, kinks = [], kinks_of(rows)
    for (ratio, around), (smooth, kinked) in kinks.items():
        lines.append([f"{ratio:g}", f"{around:g}", kink_line(smooth, kinked)])
        numbers = [share_line(smooth, kinked)]
        numbers += [smooth and f"{smooth[name]:.3g}" for name in ("moment", "flattening")]
        numbers += [smooth and f"{smooth['wrinkling_ratio']:.2f}"]
        lines[-1] += [one or "-" for one in numbers]
    head = ("p / p_c", "around", "kinks between", "of the limit at p", "moment before, N mm")
    return "\n".join(
        [
            "## At which curvature a tube kinks\n",
            paragraph(
                "The tube of the bends above with rigid ends (L 200) at `coupled`: bends from rest",
                "to shares 0.05 apart of Brazier's curvature at the pressure, which is (1 + p /",
                "p_c)^(1/2) times that without. Between the last that stays smooth and the first",
                "that ends `buckled` it kinks: the column gives both over Brazier's curvature",
                "without pressure. A pressure delays the kink, but by less than Brazier's limit;",
                "before it, the ratio to the wrinkling limit is the higher the more pressure there",
                "is.",
                unsettled(kinks),
            ),
            markdown((*head, "flattening before", "wrinkling ratio before"), lines),
            provenance_text(notes),
        ]
    )
