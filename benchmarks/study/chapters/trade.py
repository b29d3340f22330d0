"""Time and memory against the error."""

from figures import settings_text
from tables import markdown, paragraph, percent, provenance_text, value_or_range

AIM_OF_TIME = 30  # of the other program over that of `coupled`, at equal error


def front_of(rows):
    best, front = float("inf"), []
    for row in sorted(rows, key=lambda r: r["seconds"]):
        if row["rms"] < best:
            best = row["rms"]
            front.append(row)
    return front


def cheapest_as_near(rows, row, others, column):
    """The cheapest run of another program that is at least as near to its reference, or None."""
    near = [
        other
        for other in rows
        if other["model"].startswith(others)
        and other["rms"] <= row["rms"]
        and other[column] is not None
    ]
    return min(near, key=lambda other: other[column], default=None)


def time_ratios(rows):
    """Per resolution of `coupled`: the cheapest run of another program that is at least as near to
    its reference, over the time of `coupled`."""
    lines = []
    for row in sorted(
        (row for row in rows if row["model"] == "coupled"), key=lambda r: r["seconds"]
    ):
        for others, column, what in (
            ("shell", "seconds", "whole program"),
            ("shell", "solve_seconds", "solving alone"),
            ("CalculiX", "seconds", "whole program"),
        ):
            best = cheapest_as_near(rows, row, others, column)
            if best is not None and row[column] is not None:
                ratio = best[column] / row[column]
                lines.append(
                    [
                        settings_text(row["settings"]),
                        f"{best['model']} {best['settings']}",
                        what,
                        f"{row[column]:.2f}",
                        f"{best[column]:.2f}",
                        f"{ratio:.1f}",
                        "held" if ratio >= AIM_OF_TIME else "missed",
                    ]
                )
            else:
                lines.append(
                    [
                        settings_text(row["settings"]),
                        f"{others}: none as near",
                        what,
                        "-" if row[column] is None else f"{row[column]:.2f}",
                        "-",
                        "-",
                        "-",
                    ]
                )
    return (
        f"### Time ratio at equal error (aim: {AIM_OF_TIME})\n\n"
        + markdown(
            (
                "coupled, points around",
                "cheapest at least as accurate",
                "counted",
                "coupled, s",
                "the other, s",
                "ratio",
                "",
            ),
            lines,
        )
        if lines
        else ""
    )


def trade_section(rows, notes):
    rows = [row for row in rows if row["rms"] is not None]
    front = front_of(rows)
    lines = [
        [
            row["model"],
            settings_text(row["settings"]),
            f"{row['seconds']:.2f}",
            "-" if row["solve_seconds"] is None else f"{row['solve_seconds']:.2f}",
            f"{row['peak_bytes'] / 2**20:.0f}",
            percent(row["rms"], 3),
            percent(row["reaction"], 2),
            "front" if row in front else "",
        ]
        for row in sorted(rows, key=lambda r: r["seconds"])
    ]
    references = "; ".join(
        f"{', '.join(sorted({row['model'] for row in rows if row['reference'] == reference}))}: "
        f"{reference}"
        for reference in dict.fromkeys(row["reference"] for row in rows)
    )
    own = max(row["reference_rms"] for row in rows)
    return "\n".join(
        [
            "## Time against error\n",
            paragraph(
                f"Case `{rows[0]['case']}`. Processor time and peak memory, one thread, the least",
                "of",
                value_or_range([row["repeats"] for row in rows], lambda v: f"{v:.0f}"),
                "runs each on a shared machine. Two times: of the whole program, and of solving",
                "alone (its share of the wall time, without reading, pictures and writing;",
                "CalculiX does not report it). Error against the converged reference of the same",
                f"law ({references}). The error of the reference itself is up to {percent(own, 3)}",
                "% of R.",
            ),
            markdown(
                (
                    "model",
                    "settings",
                    "whole program, s",
                    "solving, s",
                    "peak memory, MiB",
                    "RMS, % R",
                    "reaction, %",
                    "",
                ),
                lines,
            ),
            time_ratios(rows),
            provenance_text(notes),
        ]
    )
