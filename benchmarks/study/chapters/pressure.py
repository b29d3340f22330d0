"""The join under pressure."""

from chapters.join import limit_and_order, pressed_table
from tables import outcomes, paragraph, percent, provenance_text


def mouth_table(rows):
    return pressed_table(
        rows,
        ("opening", "`incision_length`", "mmHg", "around"),
        lambda row: [
            row["opening"],
            *(f"{row[name]:g}" for name in ("length", "pressure", "around")),
        ],
    )


def pressure_section(rows, notes):
    errors = [row["own_error"] for row in rows if not row["failure"]]
    own = f"The shell's own error is at most {percent(max(errors))} %." if errors else ""
    return "\n".join(
        [
            "## The join under pressure\n",
            paragraph(
                "The T of the chapter before with a pressure in both lumens, from walls without",
                "stress, neo-Hookean, against the reference's shell with the pressure on its inner",
                "face.",
                own,
            ),
            mouth_table(rows),
            provenance_text(notes),
        ]
    )


def shells_section(rows, notes):
    solved = [row for row in rows if not row["failure"]]
    text = ""
    if len(solved) >= 3:
        limit, order = limit_and_order({row["cells"]: row["mouth"] for row in solved})
        text = f"The mouth goes to {limit:.2f} mm2 with order {order:.1f}."
    head = ("cells around the seam", "unknowns", "mouth, mm2", "support, N", "energy, N mm", "s")
    return "\n".join(
        [
            "## The shell's own mesh of that join\n",
            paragraph("The slit of length 1 at 10 mmHg, by the reference's shell.", text),
            outcomes(
                head,
                rows,
                lambda row: [f"{row['cells']:g}"],
                lambda row: [f"{row['unknowns']:g}", f"{row['mouth']:.3f}"]
                + [f"{row[name]:.5f}" for name in ("support", "energy")]
                + [f"{row['seconds']:.1f}"],
            ),
            provenance_text(notes),
        ]
    )
