"""What follows where one modulus changes and nothing else."""

from figures import reaction_of
from tables import markdown, paragraph, percent, provenance_text, signed


def pairs_of(rows, load, modulus, model):
    """(reaction over the shell's minus one, row, the shell's row) where both converged."""
    reference = {
        f"{row['factor']:.3g}": row
        for row in rows
        if (row["load"], row["modulus"], row["fidelity"]) == (load, modulus, "shell")
        and row["force"] is not None
    }
    mine = [
        row
        for row in rows
        if (row["load"], row["modulus"], row["fidelity"]) == (load, modulus, model)
        and row["force"] is not None
    ]
    both = [(row, reference.get(f"{row['factor']:.3g}")) for row in mine]
    return [
        (reaction_of(row) / reaction_of(other) - 1, row, other)
        for row, other in both
        if other is not None
    ]


def worst_of_curves(rows, model):
    """{(load, modulus): (largest difference of the reaction, its factor, within the aim)}"""
    worst = {}
    for load in ("twist", "bend", "stretch", "offset"):
        for modulus in ("E", "G"):
            pairs = pairs_of(rows, load, modulus, model)
            if pairs:
                difference, row, _ = max(pairs, key=lambda pair: abs(pair[0]))
                held = all(abs(one) <= (other["u_reaction"] or 0) + 0.01 for one, _, other in pairs)
                worst[load, modulus] = (difference, row["factor"], held)
    return worst


def sensitivity_lines(rows, models):
    """Per curve the factor of its largest distance from the shell's: in the reaction, beyond the
    error of the reference, and in the shape."""
    lines = {}
    for model in models:
        for (load, modulus), (difference, factor, held) in worst_of_curves(rows, model).items():
            pairs = pairs_of(rows, load, modulus, model)
            shape = max(
                (abs(row["variation"] - other["variation"]), row["factor"])
                for _, row, other in pairs
            )
            lines[load, modulus, model] = [
                load,
                modulus,
                model,
                len(pairs),
                f"{signed(difference)} at {factor:.3g}",
                "held" if held else "missed",
                f"{percent(shape[0], 3)} at {shape[1]:.3g}",
            ]
    curves = dict.fromkeys(key[:2] for key in lines)
    return [lines[(*key, model)] for key in curves for model in models if (*key, model) in lines]


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
        for m in ("skin", "paper", "section", "coupled")
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
                "the shear modulus of the shell through its thickness. Beside its glued rims the",
                "wall of `coupled` shears there too",
                "([wall.md](wall.md#shear-beside-a-rim)); elsewhere its",
                "normals stay normal. What is left, over thickness and mesh:",
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
