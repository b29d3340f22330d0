"""docs/extremes.md: how far the solvers go, in questions, answers and one figure. Each number is
computed from the tables, and each is also in docs/extremes_tables.md."""

from chapters.limits import share
from chapters.sizes import exponents, largest
from tables import IMAGES, markdown, paragraph, value_or_range

TABLES = "extremes_tables.md"


def link(text, anchor):
    return f"[{text}]({TABLES}#{anchor})"


def counts_of(rows, rod, sensitivity, glenns, folded=()):
    """(name, converged, named otherwise, failed): the rod, each family of walls, the reference, the
    Glenn shunts at `paper` and at `coupled`."""
    certified = int(sum(row["certified"] for row in rod))
    lines = []
    if rod:
        lines.append(("rod", certified, int(sum(row["cases"] for row in rod)) - certified, 0))
    families = list(dict.fromkeys(row["family"] for row in rows))
    for fidelity, family in sorted(
        {(row["fidelity"], row["family"]) for row in rows},
        key=lambda pair: (families.index(pair[1]), pair[0]),
    ):
        mine = [row for row in rows if (row["fidelity"], row["family"]) == (fidelity, family)]
        lines.append((f"{fidelity}: {family}", *ended(mine)))
    shell = [row for row in sensitivity if row["fidelity"] == "shell"]
    if shell:
        good = sum(row["force"] is not None for row in shell)
        lines.append(("reference: moduli", good, len(shell) - good, 0))
    if glenns:
        lines.append(("paper: adult Glenns", *ended(glenns)))
    if folded:
        lines.append(("coupled: adult Glenns", *ended(folded)))
    return lines


def ended(rows):
    good = sum(row["ending"] == "converged" for row in rows)
    bad = sum(row["ending"] == "failed" for row in rows)
    return good, len(rows) - good - bad, bad


def rods(rows):
    certified = int(sum(row["certified"] for row in rows))
    cases = int(sum(row["cases"] for row in rows))
    lines = [
        [row["group"], row["range"], f"{row['certified']:.0f} of {row['cases']:.0f}"]
        for row in rows
        if row["other"]
    ]
    return [
        "## Does the rod find its minimum?\n",
        paragraph(
            f"In {share(certified, cases)}: slenderness, moduli, elements, poses, twist, trees and",
            f"tapers. {link('Every group', 'rod')}. Groups with a case that ended otherwise, each",
            "with a sentence that says what would do:",
        ),
        markdown(("group", "range tried", "certified"), lines),
    ]


def walls(rows):
    good, other, bad = ended(rows)
    found = {}
    for row in rows:
        if row["ending"] != "converged":
            key = (row["fidelity"], row["family"], row["ending"])
            found.setdefault(key, []).append(text(row["case"]))
    lines = [
        [f"`{fidelity}`", family, ending, len(cases), "; ".join(cases)]
        for (fidelity, family, ending), cases in found.items()
    ]
    large = []
    for fidelity in dict.fromkeys(row["fidelity"] for row in rows):
        mine = [
            row
            for row in rows
            if (row["fidelity"], row["family"], row["ending"])
            == (fidelity, "vertices", "converged")
        ]
        if mine:
            most = max(mine, key=lambda row: float(row["case"]))
            large.append(
                f"`{fidelity}` {text(most['case'])} vertices in {most['seconds']:.1f} s with"
                f" {most['peak_bytes'] / 2**20:.0f} MiB"
            )
    return [
        "## Where do walls stop converging?\n",
        paragraph(
            f"Of {len(rows)} runs {good} converged, {other} ended with another status or one",
            f"sentence, {bad} failed (a crash, or a number that is not finite). Past Brazier's",
            "curvature or the wrinkling twist a wall collapses, so `buckled` and `unstable` are",
            "right there. The largest surfaces that converged:",
            ", ".join(large) + ".",
            link("Every run", "walls") + ".",
        ),
        markdown(("fidelity", "family", "ending", "runs", "cases"), lines),
    ]


def sizes_answer(rows):
    lines = [
        [f"`{name}`", f"{row['vertices']:.0f}", f"{row['seconds']:.1f}"]
        + [f"{row['peak_bytes'] / 2**20:.0f}", exponents(rows, name)]
        for name, row in largest(rows).items()
    ]
    head = ("fidelity", "largest that converged, vertices", "processor time, s", "MiB")
    return [
        "## How does the cost grow with the mesh?\n",
        paragraph(
            "One gently bent tube with ever more vertices, whole programs on one thread without",
            "report. Growth: the power of the number of vertices.",
            link("Every size", "cost-against-size") + ".",
        ),
        markdown((*head, "growth"), lines),
    ]


def reference(sensitivity):
    shell = [row for row in sensitivity if row["fidelity"] == "shell"]
    good = sum(row["force"] is not None for row in shell)
    endings = {row["failure"] for row in shell if row["failure"]}
    factors = value_or_range([row["factor"] for row in shell], "{:g}".format)
    return [
        "## And the finite-element reference?\n",
        paragraph(
            f"Its shell converged on both meshes in {good} of {len(shell)} runs with one modulus",
            f"times {factors}; the others ended with {' or '.join(sorted(endings))}.",
            link("Every sweep", "reference") + ".",
        ),
    ]


def glenns_answer(rows):
    columns = list(dict.fromkeys(row["rotation"] for row in rows))
    good, _, _ = ended(rows)
    crossed = sum(row["ending"] == "self_intersecting" for row in rows)
    ends = [f"2 mm: {share(good, len(rows))} converged, with walls that pass through nothing."]
    if crossed:
        ends.append(
            f"In {share(crossed, len(rows))} walls pass through each other, and the result says so:"
        )
        ends.append("the kept vein is short for its width.")
    lines = []
    for cut, incision in dict.fromkeys((row["cut"], row["incision"]) for row in rows):
        of = {r["rotation"]: r for r in rows if (r["cut"], r["incision"]) == (cut, incision)}
        lines.append(
            [cut, incision, *(of[column]["ending"] if column in of else "-" for column in columns)]
        )
    return [
        "## And on a real anatomy?\n",
        paragraph(
            "An adult's vessels with other cuts, incisions and rotations, at `paper` on edges of",
            *ends,
            link("Every run with its sentence", "glenn-shunts-on-the-adult-anatomy") + ".",
        ),
        markdown(
            ("cut", "incision", *(f"rotation {text(column)}" for column in columns)),
            lines,
        ),
    ]


def folded_answer(rows):
    text = [
        paragraph(
            "At `coupled` such a vein is also joined inflated and let out. It ended in a certified",
            "minimum whose walls pass through nothing (`converged` or `buckled`):",
            link("every run", "folding-veins-on-the-adult-anatomy") + ".",
        )
    ]
    lines = []
    for pressure in dict.fromkeys(row["pressure"] for row in rows):
        for rotation in dict.fromkeys(row["rotation"] for row in rows):
            mine = [r for r in rows if (r["pressure"], r["rotation"]) == (pressure, rotation)]
            if not mine:
                continue
            good = [row for row in mine if row["ending"] in ("converged", "buckled")]
            mouths = [row["mouth"] for row in good]
            times = [row["seconds"] for row in mine]
            lines.append(
                [
                    f"{pressure:g} mmHg" if pressure else "none",
                    f"{rotation:g}" if rotation != "auto" else "auto",
                    f"{len(good)} of {len(mine)}",
                    value_or_range(mouths, "{:.2f}".format) if mouths else "-",
                    value_or_range(times, "{:.1f}".format),
                ]
            )
    header = ("pressure", "rotation", "ended so", "mouth over the vein's lumen", "processor s")
    return [*text, markdown(header, lines)]


def text(value):
    return f"{value:.0f}" if isinstance(value, float) else value


def page(tables):
    """tables: {name: (rows, notes)} of the baselines that are there."""
    rows = {name: table[0] for name, table in tables.items()}
    parts = [
        "# How far each solver was pushed\n",
        paragraph(
            f"Questions, answers and one figure; {link('all tables', 'rod')} are on their own",
            "page. Both are written by `./run report` from `benchmarks/baselines`; no number is",
            "typed by",
            "hand. The statuses are explained in [guide.md](guide.md), the errors inside the range",
            "of the models in [comparison.md](comparison.md).",
        ),
        f"![How the runs ended]({IMAGES}/endings.svg)\n",
        paragraph(
            "*Runs at and beyond the limits of the models, by family: moduli (E and G alone and",
            "together), twist, bend, coefficients of the paper's energies, long triangles",
            "(aspect), many vertices.*",
        ),
    ]
    for name, answer in (
        ("extremes_rod", rods),
        ("extremes_wall", walls),
        ("sizes", sizes_answer),
        ("sensitivity", reference),
        ("glenns", glenns_answer),
        ("glenns_coupled", folded_answer),
    ):
        if name in rows:
            parts += answer(rows[name])
    return "\n".join(parts).rstrip() + "\n"
