"""The join under pressure."""

from chapters.join import over
from tables import markdown, paragraph, percent, provenance_text, signed


def mouth_table(rows):
    def line(row):
        start = [row["opening"], f"{row['length']:g}", f"{row['pressure']:g}", f"{row['around']:g}"]
        if row["failure"]:
            return [*start, row["failure"], *["-"] * 9]
        return [
            *start,
            f"{row['mouth_reference']:.2f}",
            f"{row['mouth']:.2f}",
            signed(over(row, "mouth")),
            f"{row['span']:.2f} x {row['width']:.2f}",
            signed(over(row, "energy")),
            signed(over(row, "support")),
            percent(row["rms_first"]),
            percent(row["rms_second"]),
            percent(row["own_error"]),
            f"{row['seconds']:.1f}",
        ]

    head = ("opening", "`incision_length`", "mmHg", "around", "shell, mm2", "`coupled`, mm2")
    head += ("mouth, %", "span x width, mm", "energy, %", "support, %", "vein, % of R")
    head += ("artery, % of R", "shell's own error, %", "s")
    return markdown(head, [line(row) for row in rows])


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
