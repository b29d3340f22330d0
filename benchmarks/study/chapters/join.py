"""Joins of two tubes: slit, ellipse and end to end, thin and thick walls, longer incisions."""

from tables import markdown, outcomes, paragraph, percent, provenance_text, signed


def over(row, quantity):
    """A quantity over the shell's, minus one."""
    mine, its = row[quantity], row[f"{quantity}_reference"]
    return None if mine is None or its is None else mine / its - 1


def pressed_table(rows, names, start):
    """Joins under pressure: per row what start(row) says in the columns `names`, and the mouth."""

    def numbers(row):
        return [
            f"{row['mouth_reference']:.2f}",
            f"{row['mouth']:.2f}",
            signed(over(row, "mouth")),
            f"{row['span']:.2f} x {row['width']:.2f}",
            signed(over(row, "energy")),
            signed(over(row, "support")),
            percent(row["rms_first"]),
            percent(row["rms_second"]),
            percent(row["own_error"]),
            f"{row['seconds']:.1f}",
        ]

    head = (*names, "shell, mm2", "`coupled`, mm2", "mouth, %", "span x width, mm", "energy, %")
    head += ("support, %", "vein, % of R", "artery, % of R", "shell's own error, %", "s")
    return outcomes(head, rows, start, numbers)


def accuracy_table(rows):
    def start(row):
        names = [row["opening"], f"{row['thickness']:g}", row["law"], row["fidelity"]]
        return [*names, f"{row['around']:g}"]

    def numbers(row):
        areas = [f"{row[name]:.2f}" for name in ("mouth_reference", "mouth")]
        shares = [signed(over(row, name)) for name in ("mouth", "energy", "support")]
        errors = [percent(row[name]) for name in ("rms_first", "rms_second", "own_error")]
        return [*areas, *shares, *errors]

    head = ("opening", "thickness", "law", "model", "around", "shell, mm2", "mouth, mm2")
    head += ("mouth, %", "energy, %", "support, %", "first, % of R", "second, % of R")
    head += ("shell's own error, %",)
    return outcomes(head, [row for row in rows if row["length"] == 1], start, numbers)


LEAST_ORDER, LARGEST_ORDER = 0.5, 4.0


def limit_and_order(values):
    """f and p of value = f + c / around^p that fit {around: value} best, p between LEAST_ORDER and
    LARGEST_ORDER; None where the best fit is not between them: the values have no such limit."""

    def fit(p):
        xs, ys = [around**-p for around in values], list(values.values())
        x0, y0 = sum(xs) / len(xs), sum(ys) / len(ys)
        slope = sum((x - x0) * (y - y0) for x, y in zip(xs, ys)) / sum((x - x0) ** 2 for x in xs)
        misfit = sum((y - y0 - slope * (x - x0)) ** 2 for x, y in zip(xs, ys))
        return misfit, y0 - slope * x0, p

    steps = range(round(100 * LEAST_ORDER), round(100 * LARGEST_ORDER) + 1)
    _, limit, order = min(fit(k / 100) for k in steps)
    return (limit, order) if LEAST_ORDER < order < LARGEST_ORDER else None


def mesh_table(head, joins):
    """The mouth of each of `joins`, (its name, its rows), over its meshes, where there are four or
    more."""
    lines = []
    for name, rows in joins:
        if len(rows) < 4:
            continue
        rows = sorted(rows, key=lambda row: row["around"])
        values = ", ".join(f"{row['mouth']:.3f} ({row['around']:g})" for row in rows)
        found = limit_and_order({row["around"]: row["mouth"] for row in rows})
        lines.append([name, values, *["-"] * 3])
        if found is not None:
            limit, order = found
            off = signed(limit / rows[0]["mouth_reference"] - 1)
            lines[-1][2:] = [f"{order:.1f}", f"{limit:.3f}", off]
    head = (head, "mouth, mm2 (points around)", "order", "limit, mm2", "limit - shell, %")
    return markdown(head, lines)


def order_table(rows):
    """Full thickness, neo-Hookean."""
    of = [
        row
        for row in rows
        if (row["thickness"], row["law"]) == (1, "neo-hookean")
        and (row["fidelity"], row["length"]) == ("coupled", 1)
        and not row["failure"]
    ]
    openings = dict.fromkeys(row["opening"] for row in of)
    return mesh_table(
        "opening", [(name, [row for row in of if row["opening"] == name]) for name in openings]
    )


def length_table(rows):
    chosen = [
        row
        for row in rows
        if (row["opening"], row["thickness"], row["law"]) == ("slit", 1, "neo-hookean")
        and (row["fidelity"], row["around"]) == ("coupled", 60)
    ]

    def numbers(row):
        areas = [f"{row[name]:.2f}" for name in ("mouth_reference", "mouth")]
        return [*areas, signed(over(row, "mouth")), f"{row['span']:.2f} x {row['width']:.2f}"]

    head = ("`incision_length`", "shell, mm2", "`coupled`, mm2", "%", "span x width, mm")
    return outcomes(
        head,
        sorted(chosen, key=lambda row: row["length"]),
        lambda row: [f"{row['length']:g}"],
        numbers,
    )


def cost_table(rows):
    """Time and error on the paper's join: full thickness, length 1."""
    lines = [
        [
            row["opening"],
            row["law"],
            row["fidelity"],
            f"{row['around']:g}",
            percent(abs(over(row, "mouth"))),
            f"{row['seconds']:.1f}",
            f"{row['seconds_reference']:.1f}",
        ]
        for row in rows
        if row["thickness"] == 1 and row["length"] == 1 and not row["failure"]
    ]
    head = ("opening", "law", "model", "around", "error of the mouth, %", "s", "the shell's s")
    return markdown(head, lines)


def join_section(rows, notes):
    return "\n".join(
        [
            "## The join\n",
            paragraph(
                "Two tubes in a T (`benchmarks/cases/glenn/tubes.yaml`), the vein's end on a slit",
                "of half its perimeter or on an ellipse of its perimeter, half as wide as it is",
                "long; and two tubes of unequal radius end to end, across a gap and a step aside",
                "and turned by 20 degrees (`benchmarks/cases/end_to_end/tubes.yaml`).",
                "Against the reference's 7-parameter shell of the same law, whose seam is a",
                "hinge with nodes at equal arc length; its own error is the largest of",
                "displacements, reactions, energy and mouth. Thickness: a factor on both walls.",
                "`paper` has another functional; only its mouth is compared, with the shell by",
                "Biot's law. First and second: the vein and the artery, or the wide and the narrow",
                "tube. More of the last join: [reference.md](reference.md#tubes-end-to-end).",
            ),
            accuracy_table(rows),
            "### The mouth over the mesh\n",
            paragraph(
                "Neo-Hookean walls of full thickness, `coupled`. Order p and limit: the best fit",
                "of limit + c / around^p, p from 0.5 to 4. The shell's value is that of its",
                "finest mesh.",
            ),
            order_table(rows),
            "### The mouth over the length of the slit\n",
            paragraph("Neo-Hookean walls of full thickness, `coupled` at 60 around the vein."),
            length_table(rows),
            "### Time against the error of the mouth\n",
            paragraph(
                "Processor time of the whole program. The shell's is for two meshes, from which it",
                "states its own error.",
            ),
            cost_table(rows),
            provenance_text(notes),
        ]
    )
