"""Tubes and joins whose walls carried a stress when they were seen."""

from chapters.join import pressed_table
from prestress import PRESSURES
from tables import outcomes, paragraph, percent, provenance_text, signed

CASES = {
    "inflate": "seen at 5, taken to 12 mmHg",
    "bend": "seen at 10, bent by 10 degrees",
    "shorten": "stretched by 1.05, its end moved back by half of that",
    "release": "stretched by 1.05, its end released, half of the force left",
    "both": "seen at 5 and stretched by 1.05, taken to 12 mmHg and bent",
    "deflate": "seen at 75, taken to 5 mmHg",
    "far": "seen at 40 and stretched by 1.2, taken to 12 mmHg, shortened and bent",
}


def tubes_table(rows):
    def numbers(row):
        shares = [percent(row[name], 3) for name in ("rms", "largest", "force", "moment")]
        return [*shares, signed(row["energy"]), percent(row["own_error"], 3)]

    head = ("tube", "shape", "law", "RMS, % of R", "largest, % of R", "force, %", "moment, %")
    return outcomes(
        (*head, "energy, %", "shell's own error, %"),
        rows,
        lambda row: [CASES[row["case"]], row["shape"], row["law"]],
        numbers,
    )


def joins_table(rows):
    return pressed_table(
        rows,
        ("opening", "`incision_length`", "`axial_prestretch`"),
        lambda row: [row["opening"], *(f"{row[name]:g}" for name in ("length", "stretch"))],
    )


def tubes_section(rows, notes):
    return "\n".join(
        [
            "## Seen under pressure or stretched\n",
            paragraph(
                "The tube of [the loads under",
                "pressure](comparison_tables.md#tubes-under-pressure) (R 3.3, t 0.33, L 30 mm),",
                "and one bent by 40 degrees and narrowing to R",
                "2.8, with the stress that it carried when it was seen, against the reference's",
                "shell with its own prestress, which is computed independently",
                "([reference.md](reference.md#prestress)). 60 points around. Of those seen at",
                "40 mmHg and more, both look for the shape without stress. Force and moment:",
                "differences over the larger of the reaction's force and moment / R; a released",
                "tube's follow from its load.",
            ),
            tubes_table(rows),
            provenance_text(notes),
        ]
    )


DRIFTS = {
    "straight": "tube at 12 mmHg",
    "curved": "curved tube at 12 mmHg",
    "stretched": "curved tube stretched by 1.2",
    "both": "curved tube at 60 mmHg and stretched by 1.2",
    "infant": "the infant's vein and artery",
    "adult": "the adult's vein and artery",
}


def drift_section(rows, notes):
    head = ("vessel", "law", "model", "drift / R", "s")
    return "\n".join(
        [
            "## Does a vessel stay where it was seen?\n",
            paragraph(
                "Held at its ends, at the pressure and the axial stretch it was seen with: the",
                "largest displacement of a point over the radius. The tubes are those of the",
                "chapter before; the anatomies are those of",
                "`infant_physiological.yaml` and `adult_physiological.yaml` before the operation.",
                "By construction nothing moves; rounding and the solvers' tolerances are left.",
            ),
            outcomes(
                head,
                rows,
                lambda row: [DRIFTS[row["case"]], row["law"], f"`{row['model']}`"],
                lambda row: [f"{row['drift']:.1e}", f"{row['seconds']:.1f}"],
            ),
            provenance_text(notes),
        ]
    )


def joins_section(rows, notes):
    seen = " and ".join(f"the {name} at {both['scan']:g}" for name, both in PRESSURES.items())
    (after,) = {both["after"] for both in PRESSURES.values()}
    return "\n".join(
        [
            "## The join of vessels seen under pressure\n",
            paragraph(
                f"The T of the chapter before, neo-Hookean, {seen} mmHg when they were seen, and",
                f"joined to one lumen at {after:g} mmHg; without and with an axial prestretch of",
                "both, which draws the cut vein and the slit's lips back. Against the reference's",
                "shell, whose vessels carry their own prestress through cut and slit. Stretched by",
                "1.2, both look for the shape without stress.",
            ),
            joins_table(rows),
            provenance_text(notes),
        ]
    )
