"""The join of two tubes: slit and ellipse, thin and thick walls, longer incisions."""

from tables import markdown, paragraph, percent, provenance_text, signed


def over(row, quantity):
    """A quantity over the shell's, minus one."""
    mine, its = row[quantity], row[f"{quantity}_reference"]
    return None if mine is None or its is None else mine / its - 1


def accuracy_table(rows):
    def line(row):
        start = [row["opening"], f"{row['thickness']:g}", row["law"], row["fidelity"]]
        start.append(f"{row['around']:g}")
        if row["failure"]:
            return [*start, row["failure"], *["-"] * 7]
        return [
            *start,
            f"{row['mouth_reference']:.2f}",
            f"{row['mouth']:.2f}",
            signed(over(row, "mouth")),
            signed(over(row, "energy")),
            signed(over(row, "support")),
            percent(row["rms_vein"]),
            percent(row["rms_artery"]),
            percent(row["own_error"]),
        ]

    head = ("opening", "thickness", "law", "model", "around", "shell, mm2", "mouth, mm2")
    head += ("mouth, %", "energy, %", "support, %", "vein, % of R", "artery, % of R")
    head += ("shell's own error, %",)
    return markdown(head, [line(row) for row in rows if row["length"] == 1])


def length_table(rows):
    chosen = [
        row
        for row in rows
        if (row["opening"], row["thickness"], row["law"]) == ("slit", 1, "neo-hookean")
        and (row["fidelity"], row["around"]) == ("coupled", 60)
    ]
    lines = [
        (
            [f"{row['length']:g}", row["failure"], "-", "-", "-"]
            if row["failure"]
            else [
                f"{row['length']:g}",
                f"{row['mouth_reference']:.2f}",
                f"{row['mouth']:.2f}",
                signed(over(row, "mouth")),
                f"{row['span']:.2f} x {row['width']:.2f}",
            ]
        )
        for row in sorted(chosen, key=lambda row: row["length"])
    ]
    head = ("`incision_length`", "shell, mm2", "`coupled`, mm2", "%", "span x width, mm")
    return markdown(head, lines)


def cost_table(rows):
    """Time and error on the paper's join: full thickness, length 1."""
    lines = [
        [
            row["opening"],
            row["law"],
            row["fidelity"],
            f"{row['around']:g}",
            percent(abs(over(row, "mouth"))),
            f"{row['seconds']:.1f}",
            f"{row['seconds_reference']:.1f}",
        ]
        for row in rows
        if row["thickness"] == 1 and row["length"] == 1 and not row["failure"]
    ]
    head = ("opening", "law", "model", "around", "error of the mouth, %", "s", "the shell's s")
    return markdown(head, lines)


def join_section(rows, notes):
    return "\n".join(
        [
            "## The join\n",
            paragraph(
                "Two tubes in a T (`benchmarks/cases/glenn/tubes.yaml`), the vein's end on a slit",
                "of half its perimeter or on an ellipse of its perimeter, half as wide as it is",
                "long. Against the reference's 7-parameter shell of the same law, whose seam is a",
                "hinge with nodes at equal arc length; its own error is the largest of",
                "displacements, reactions, energy and mouth. Thickness: a factor on both walls.",
                "`paper` has another functional; only its mouth is compared, with the shell by",
                "Biot's law. Tubes joined end to end are in [reference.md](reference.md).",
            ),
            accuracy_table(rows),
            "### The mouth over the length of the slit\n",
            paragraph("Neo-Hookean walls of full thickness, `coupled` at 60 around the vein."),
            length_table(rows),
            "### Time against the error of the mouth\n",
            paragraph(
                "Processor time of the whole program. The shell's is for two meshes, from which it",
                "states its own error.",
            ),
            cost_table(rows),
            provenance_text(notes),
        ]
    )
