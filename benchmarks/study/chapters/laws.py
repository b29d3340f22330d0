"""How far the kinematics and the law of the material matter."""

from tables import markdown, paragraph, percent, provenance_text, signed


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
