"""The join under pressure."""

from chapters.join import pressed_table
from tables import paragraph, percent, provenance_text


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
