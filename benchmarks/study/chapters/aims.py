"""The aims for `coupled`, and the worst measured value on each kind of surface."""

from tables import markdown, paragraph

# Families whose ratio is to Brazier's curvature.
BENT = ("bend", "tapered", "curved", "offset", "combined", "check", "fresh")


def flattening_share(row):
    """Of what the aim allows: 2 % of the reference's value, or 0.001."""
    return abs(row["flattening"] - row["flattening_reference"]) / max(
        0.02 * row["flattening_reference"], 0.001
    )


def aims(accuracy, irregular):
    """The aims for `coupled`, and the worst measured value on each kind of surface."""
    groups = [
        (
            f"{around} points around",
            [row for row in accuracy if row["model"] == "coupled" and row["around"] == around],
        )
        for around in (48, 96)
    ]
    groups.append(("irregular surfaces", irregular))
    groups = [
        (name, [row for row in rows if row["counted"] and row["rms"] is not None])
        for name, rows in groups
    ]
    groups = [(name, rows) for name, rows in groups if rows]

    def stated(what, limit, bound, belongs, value, form):
        cells = []
        for _, rows in groups:
            worst = max(
                (
                    (value(row), f"{row['case']}, {row['mesh']}" if "mesh" in row else row["case"])
                    for row in rows
                    if belongs(row)
                ),
                default=None,
            )
            cells.append(
                "-"
                if worst is None
                else f"{form(worst[0])} ({worst[1]}): {'held' if worst[0] <= bound else 'missed'}"
            )
        return [what, limit, *cells]

    def low(row):
        return row["family"] not in BENT or row["ratio"] <= 0.5

    lines = [
        stated(
            "RMS over R, up to Brazier ratio 0.5",
            "0.2 %",
            0.002,
            low,
            lambda r: r["rms"],
            lambda v: f"{100 * v:.3f} %",
        ),
        stated(
            "RMS over R, from there to 0.7",
            "0.5 %",
            0.005,
            lambda r: not low(r),
            lambda r: r["rms"],
            lambda v: f"{100 * v:.3f} %",
        ),
        stated(
            "largest distance over R, up to 0.5",
            "1 %",
            0.01,
            low,
            lambda r: r["largest"],
            lambda v: f"{100 * v:.3f} %",
        ),
        stated(
            "reaction",
            "1 %",
            0.01,
            lambda r: True,
            lambda r: max(r["force"], r["moment"]),
            lambda v: f"{100 * v:.2f} %",
        ),
        stated(
            "flattening, over the larger of 2 % of it and 0.001",
            "1",
            1,
            lambda r: True,
            flattening_share,
            lambda v: f"{v:.2f}",
        ),
    ]
    counts = ", ".join(f"{name}: {len(rows)} runs" for name, rows in groups)
    return (
        "### The aims for `coupled`\n\n"
        + paragraph(f"Worst of {counts}; in brackets the case.")
        + "\n"
        + markdown(("quantity", "aim", *(name for name, _ in groups)), lines)
        + "\n"
    )
