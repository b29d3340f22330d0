"""Readable names of the cases, for pages and figures: load, share of its limit, wall."""

import re

# By the first words of a case's name: the row of a figure, and what is done to the tube.
LOADS = {
    "twist": ("twisted", "twisted"),
    "stretch": ("pulled", "pulled"),
    "bend": ("bent", "bent"),
    "offset": ("moved sideways", "moved sideways"),
    "combined": ("several loads at once", "pulled, twisted and bent"),
    "curved": ("curved at rest", "curved at rest, bent on"),
    "tapered": ("tapered", "tapered, twisted and bent"),
    "check_l60": ("several loads at once", "twisted and bent"),
    "check_l150": ("pulled", "pulled"),
    "check_l200": ("bent", "bent"),
    "fresh_back": ("moved sideways", "moved sideways and turned back"),
    "fresh_bend": ("bent", "bent"),
    "fresh_mixed": ("several loads at once", "twisted, pulled and bent"),
    "fresh_offset": ("moved sideways", "moved sideways"),
    "fresh_press": ("pressed", "pressed"),
    "fresh_twist": ("several loads at once", "pulled and twisted"),
}
GROUPS = tuple(
    dict.fromkeys(
        LOADS[name][0]
        for name in ("twist", "offset", "fresh_press", "stretch", "bend", "combined")
        + ("tapered", "curved")
    )
)
USUAL_LENGTH = 10  # L / R that a name does not state


def words_of(case):
    """(row of a figure, what is done); a case of an unknown name is its own word."""
    return LOADS.get(re.split(r"_t[0-9]", case)[0], (case, case))


def title(row):
    """`bent, load 0.5, t/R 0.1` for a row of the accuracy table."""
    if words_of(row["case"])[1] == row["case"]:
        return row["case"]
    group, done = words_of(row["case"])
    load = " to" if group == "pulled" else ", load"
    parts = [f"{done}{load} {row['ratio']:g}", f"t/R {row['thickness_over_radius']:g}"]
    if row["length_over_radius"] != USUAL_LENGTH:
        parts.append(f"L/R {row['length_over_radius']:g}")
    return ", ".join(parts)


def titles(rows):
    """{case: title} of the accuracy table."""
    return {row["case"]: title(row) for row in rows}
