"""What `accuracy: x` promises, and whether it was kept."""

import promise
from tables import markdown, paragraph, percent, provenance_text


def promise_table(kept):
    return markdown(
        ("case", "fidelity", "points around", "promised, % R", "measured, % R", ""),
        [
            [
                row["case"],
                row["model"],
                f"{row['around']:.0f}",
                percent(error, 3),
                percent(row["rms"], 3),
                "kept" if row["rms"] <= error else "broken",
            ]
            for row, error in kept
        ],
    )


def promise_section(rows, asked):
    kept = promise.held_out(rows)
    if not kept:
        return ""
    fresh = [pair for pair in kept if pair[0]["family"] == "fresh"]
    text = [
        "## `accuracy: x`\n",
        paragraph(
            "`accuracy: x` uses the table `hybrid/judge/accuracy_table.cpp`, made from the pulled,",
            "twisted and bent straight tubes above. Each level has the largest error over their",
            f"walls plus the error of the reference, times {promise.SAFETY}. The promise",
            "interpolates linearly between levels and adds up the kinds of load. It covers neither",
            "tubes curved at rest nor pressed tubes: for pressed tubes it was too optimistic, as a",
            "fresh case showed.",
        ),
    ]
    if fresh:
        held = sum(row["rms"] <= error for row, error in fresh)
        text += [
            "### Independent cases\n",
            paragraph(
                "Other walls, planes and combinations, written before their first run and after",
                f"the margin was fixed: kept {held} of {len(fresh)}.",
            ),
            promise_table(fresh),
        ]
    beyond = promise.held_out(rows, within=False)
    if beyond:
        text += [
            paragraph(
                "Pressed tubes get no promise. The next table has the promise that the table of",
                "pulled tubes would have given.",
            ),
            promise_table(beyond),
        ]
    if asked:
        lines = [
            [
                row["case"],
                f"{100 * row['wanted']:g}",
                row["chosen"] or "-",
                percent(row["rms"], 3),
                row["failure"] or ("kept" if row["rms"] <= row["wanted"] else "broken"),
            ]
            for row in asked[0]
        ]
        text += [
            paragraph(
                "The same cases with `accuracy: x` in the scene: the chosen fidelity and its",
                "distance from the reference. A refusal states the best accuracy that is promised.",
            ),
            markdown(("case", "x, % R", "chosen", "measured, % R", ""), lines),
            provenance_text(asked[1]),
        ]
    text += [
        "### Cases that set the margin\n",
        paragraph(
            "The table was not made from these cases, but the margin was raised until all of them",
            "kept the promise. They are no independent test.",
        ),
        promise_table([pair for pair in kept if pair[0]["family"] != "fresh"]),
    ]
    return "\n".join(text)
