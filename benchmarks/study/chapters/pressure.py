"""The join under pressure."""

from chapters.join import limit_and_order, pressed_table
from pressure import PAPERS
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


def limit_of(rows):
    """Where the mouth of the paper's slit goes with the mesh, a sentence; empty where there are
    fewer than four meshes."""
    meshes = {
        row["around"]: row["mouth"]
        for row in rows
        if (row["opening"], row["length"], row["pressure"]) == PAPERS and not row["failure"]
    }
    if len(meshes) < 4:
        return ""
    limit, order = limit_and_order(meshes)
    return (
        f"The paper's slit at {PAPERS[2]:g} mmHg goes to {limit:.2f} mm2 over its meshes, with"
        f" order {order:.1f}."
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
                limit_of(rows),
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


# One real shunt whose lumen was segmented after the operation, measured by hand.
REAL = {"area_ratio": 1.0, "span": 1.8, "perimeter_ratio": 1.15}


def infant_section(rows, notes):
    def numbers(row):
        shares = [f"{row[name]:.2f}" for name in REAL]
        return [f"{row['mouth']:.1f}", *shares, f"{row['strain']:.2f}", f"{row['seconds']:.1f}"]

    head = ("`incision_length`", "mmHg", "mouth, mm2", "over the vein's lumen", "span / diameter")
    real = ", ".join(f"{value:g}" for value in REAL.values())
    return "\n".join(
        [
            "## The mouth of the infant's shunt\n",
            paragraph(
                "`infant_physiological.yaml` at other pressures after the operation and other",
                "lengths of its incision, a share of half the mouth's perimeter: the mouth's area",
                "over the vein's lumen, its span over the diameter of a circle as long around as",
                "the cut end, and its perimeter over that of the cut end. One real shunt,",
                f"segmented after the operation and measured by hand, has {real}.",
            ),
            outcomes(
                (*head, "perimeter / cut end's", "largest strain", "s"),
                rows,
                lambda row: [f"{row['length']:g}", f"{row['pressure']:g}"],
                numbers,
            ),
            provenance_text(notes),
        ]
    )
