"""Cost against size."""

from math import log

from tables import markdown, paragraph, provenance_text

COUNTS = ("factorisations", "solves", "gradients", "hessians")
GROWING = (
    ("seconds", "processor time"),
    ("peak_bytes", "memory"),
    ("factor_nonzeros", "the factor's entries"),
)


def whole(value):
    return "-" if value is None else f"{value:.0f}"


def over_vertices(row, column):
    value = row[column]
    return "-" if value is None else f"{value / row['vertices']:.3g}"


def converged(rows, fidelity):
    return [r for r in rows if (r["fidelity"], r["ending"]) == (fidelity, "converged")]


def growth(rows, column):
    """The exponent of the column over the vertices between the smallest and the largest of these
    sizes; None where there are not two, or nothing to grow."""
    have = [row for row in rows if row[column]]
    if len(have) < 2:
        return None
    first, last = have[0], have[-1]
    return log(last[column] / first[column]) / log(last["vertices"] / first["vertices"])


def largest(rows):
    """{fidelity: its largest size that converged}"""
    last = {}
    for fidelity in dict.fromkeys(row["fidelity"] for row in rows):
        done = converged(rows, fidelity)
        if done:
            last[fidelity] = done[-1]
    return last


def exponents(rows, fidelity):
    done = converged(rows, fidelity)
    found = [(what, growth(done, column)) for column, what in GROWING]
    return ", ".join(f"{what} {value:.2f}" for what, value in found if value is not None)


def too_large(rows):
    """Per fidelity with sizes that were not run, what the first of them would take."""
    for name, last in largest(rows).items():
        left = [r for r in rows if (r["fidelity"], r["ending"]) == (name, "not run")]
        if left:
            gib = last["peak_bytes"] / last["vertices"] * left[0]["vertices"] / 2**30
            yield (
                f"`{name}` was not run on more vertices: {whole(left[0]['vertices'])} would take at"
                f" least {gib:.0f} GiB, at the bytes a vertex of the size before."
            )


def sizes_section(rows, notes):
    lines = [
        [row["fidelity"], whole(row["vertices"]), row["ending"]]
        + ["-" if row["seconds"] is None else f"{row['seconds']:.1f}"]
        + ["-" if row["peak_bytes"] is None else f"{row['peak_bytes'] / 2**20:.0f}"]
        + [over_vertices(row, "peak_bytes"), *(whole(row[name]) for name in COUNTS)]
        + [over_vertices(row, "factor_nonzeros"), row["sentence"] or "-"]
        for row in rows
    ]
    head = ("fidelity", "vertices", "ending", "processor time, s", "MiB", "bytes a vertex")
    head += (*COUNTS, "factor's entries a vertex", "sentence")
    grown = [(name, exponents(rows, name)) for name in largest(rows)]
    text = [
        "## Cost against size\n",
        paragraph(
            "One tube (L / R = 10, t / R = 0.1), bent to a quarter of Brazier's curvature, with",
            "ever more vertices: whole programs on one thread without report.",
            *too_large(rows),
        ),
        markdown(head, lines),
        paragraph(
            "Growth between the smallest and the largest size that converged, as a power of the",
            "number of vertices:",
            "; ".join(f"`{name}`: {shown}" for name, shown in grown if shown) + ".",
        ),
    ]
    return [*text, provenance_text(notes)]
