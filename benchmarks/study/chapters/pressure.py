"""The join under pressure."""

from chapters.join import mesh_table, pressed_table
import join
import pressure
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


def order_table(rows):
    """The slit of length 1."""
    of = [
        row for row in rows if (row["opening"], row["length"]) == ("slit", 1) and not row["failure"]
    ]
    pressures = dict.fromkeys(row["pressure"] for row in of)
    return mesh_table(
        "mmHg", [(f"{p:g}", [row for row in of if row["pressure"] == p]) for p in pressures]
    )


def own_errors(rows):
    """The shell's own error at its worst, under pressure and without."""
    worst = {
        pressed: max(
            (
                row["own_error"]
                for row in rows
                if (row["pressure"] > 0) == pressed and not row["failure"]
            ),
            default=None,
        )
        for pressed in (True, False)
    }
    if worst[True] is None:
        return ""
    text = f"The shell's own error is at most {percent(worst[True])} % under pressure"
    return text + (f", {percent(worst[False])} % without." if worst[False] is not None else ".")


def pressure_section(rows, notes):
    return "\n".join(
        [
            "## The join under pressure\n",
            paragraph(
                "The T of the chapter before with a pressure in both lumens, from walls without",
                "stress, neo-Hookean, against the reference's shell with the pressure on its inner",
                "face.",
                f"The shell has {pressure.CELLS} cells around the seam and those refined by 3 / 2,",
                f"without pressure {join.CELLS}, as in that chapter.",
                own_errors(rows),
            ),
            mouth_table(rows),
            "### The mouth under pressure over the mesh\n",
            paragraph(
                "The slit of `incision_length: 1`, `coupled`; order and limit as in the chapter",
                "before. The last column, not the difference on a given mesh, is what remains",
                "between the kinematics of `coupled` and of the shell, with the shell's own error.",
            ),
            order_table(rows),
            provenance_text(notes),
        ]
    )


def shells_section(rows, notes):
    solved = [row for row in rows if not row["failure"]]
    text = ""
    if len(solved) > 1:
        change = max(row["mouth"] for row in solved) / min(row["mouth"] for row in solved) - 1
        text = f"Between the coarsest and the finest mesh the mouth changes by {percent(change)} %."
    head = ("cells around the seam", "unknowns", "mouth, mm2", "support, N", "energy, N mm", "s")
    return "\n".join(
        [
            "## The shell's own mesh of that join\n",
            paragraph("The slit of `incision_length: 1` at 10 mmHg, by the shell.", text),
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

    head = ("`incision_length`", "mmHg", "mouth, mm2", "lumen / vein's lumen", "span / diameter")
    real = ", ".join(f"{value:g}" for value in REAL.values())
    return "\n".join(
        [
            "## The mouth of the infant's shunt\n",
            paragraph(
                "`infant_physiological.yaml` (vessels seen under pressure, stretched by 5 %) at",
                "other pressures after the operation and other lengths of its incision, over half",
                "the perimeter of the vein's cut end: the mouth's area, its lumen over that of",
                "the cut vein, its span over the diameter of a circle as long around as the cut",
                "end, and its perimeter over that of the cut end; area, span and perimeters are of",
                "the middle of the wall. One real shunt, segmented after the operation and",
                f"measured by hand, has {real} of its vein's lumen, diameter and perimeter.",
            ),
            outcomes(
                (*head, "perimeter / cut end's", "largest strain of the scene", "s"),
                rows,
                lambda row: [f"{row['length']:g}", f"{row['pressure']:g}"],
                numbers,
            ),
            provenance_text(notes),
        ]
    )
