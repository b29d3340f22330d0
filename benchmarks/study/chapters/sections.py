"""Fidelity `section`: errors on tubes, and time against the shell's."""

from math import log

from sections import shell_time
from tables import markdown, paragraph, percent, provenance_text


def worst_reaction(row):
    return max(row["force"], row["moment"])


def cell(row):
    if row is None:
        return "-"
    if row["rms"] is None:
        return row["failure"]
    return f"{percent(row['rms'], 3)} / {percent(worst_reaction(row))}"


def sections_section(rows, notes):
    surfaces = list(dict.fromkeys(row["surface"] for row in rows))
    cases = []
    for case in dict.fromkeys(row["case"] for row in rows):
        of = {row["surface"]: row for row in rows if row["case"] == case}
        first = of.get("48 around") or next(iter(of.values()))
        cases.append(
            [
                case,
                *(cell(of.get(surface)) for surface in surfaces),
                *(
                    ("-", "-", "-")
                    if first["rms"] is None
                    else (
                        f"{first['harmonics']:.0f}, {first['spans']:.0f}",
                        percent(first["estimate"], 4),
                        f"{1000 * first['solve_seconds']:.0f}",
                    )
                ),
            ]
        )
    return "\n".join(
        [
            "## Sections of harmonics\n",
            paragraph(
                "Fidelity `section` ([sections.md](sections.md)): RMS distance, % of R / largest",
                "reaction difference, %, from the surface of 24 and 48 points around and from an",
                "irregular one, against the reference of the accuracy table; for 48 points around",
                "the harmonics and spans that it chose, its own estimate of their error in % of R,",
                "and the milliseconds of its solving, all but reading and writing.",
            ),
            markdown(
                (
                    "case",
                    *surfaces,
                    "harmonics, spans",
                    "estimate, % R",
                    "solve, ms",
                ),
                cases,
            ),
            provenance_text(notes),
        ]
    )


def speed_section(rows, notes):
    def ratio(row, column):
        time = None if row["model"] == "shell" else shell_time(rows, row["rms"], column)
        return "-" if time is None or row[column] is None else f"{time / row[column]:.1f}"

    return "\n".join(
        [
            "### Its time against the shell's\n",
            paragraph(
                f"Case {rows[0]['case']}, processor time on one thread: of the whole program, the",
                "hybrid with `--no-report`, and of solving alone. The last columns are the shell's",
                "time at the same RMS distance (on the line through the logarithms of the runs",
                "beside it) over the row's.",
            ),
            markdown(
                (
                    "model",
                    "settings",
                    "RMS, % R",
                    "reaction, %",
                    "whole, s",
                    "solve, s",
                    "shell / whole",
                    "shell / solve",
                ),
                [
                    [
                        row["model"],
                        f"{row['settings']:g}"
                        if isinstance(row["settings"], float)
                        else row["settings"],
                        percent(row["rms"], 4),
                        percent(row["reaction"], 3),
                        f"{row['seconds']:.3f}",
                        "-" if row["solve_seconds"] is None else f"{row['solve_seconds']:.3f}",
                        ratio(row, "seconds"),
                        ratio(row, "solve_seconds"),
                    ]
                    for row in rows
                ],
            ),
            provenance_text(notes),
        ]
    )


def order(before, row, name):
    """By which power of the number of spans the error falls from one row to the next."""
    if before is None or not before[name] or not row[name]:
        return "-"
    return f"{log(before[name] / row[name]) / log(row['spans'] / before['spans']):.1f}"


def refinement_section(rows, notes):
    def line(before, row, with_order):
        cells = [f"{row['harmonics']:.0f}", f"{row['spans']:.0f}", f"{row['unknowns']:.0f}"]
        cells += [percent(row["rms"], 6), order(before, row, "rms") if with_order else "-"]
        cells += [percent(row["moment"], 6), order(before, row, "moment") if with_order else "-"]
        return [*cells, "yes" if row["settled"] else "no"]

    most = max(row["harmonics"] for row in rows)
    along = [row for row in rows if row["harmonics"] == most]
    around = [row for row in rows if row["harmonics"] < most]
    lines = [line(before, row, True) for before, row in zip([None, *along], along)]
    lines += [line(None, row, False) for row in around]
    return "\n".join(
        [
            "### Its convergence\n",
            paragraph(
                "The tube of the time comparison in given spaces against a finer one: RMS distance",
                "of material points, and the moment of the moved end. Order: by which power of the",
                "number of spans the error falls from the row before, with cubic B-splines on",
                "knots that are denser beside the ends.",
            ),
            markdown(
                (
                    "harmonics",
                    "spans",
                    "unknowns",
                    "RMS, % R",
                    "order",
                    "moment, %",
                    "order",
                    "minimum",
                ),
                lines,
            ),
            provenance_text(notes),
        ]
    )
