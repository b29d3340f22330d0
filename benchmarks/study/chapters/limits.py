"""docs/extremes_tables.md: every run that pushed a solver to its limit."""

import extremes
from chapters.sizes import sizes_section
from glenns import FIDELITY
from tables import markdown, paragraph, provenance_text, value_or_range


def share(part, whole):
    return f"{part} of {whole} ({100 * part / whole:.1f} %)"


def rod_section(rows, notes):
    lines = [
        [
            row["group"],
            row["range"],
            int(row["cases"]),
            int(row["certified"]),
            row["most_iterations"],
            f"{row['seconds']:.3f}",
            row["other"] or "-",
        ]
        for row in rows
    ]
    certified, cases = int(sum(row["certified"] for row in rows)), int(
        sum(row["cases"] for row in rows)
    )
    return [
        "## Rod\n",
        paragraph(
            f"Certified: {share(certified, cases)}. Certified means `converged`: the residual is",
            "small and the inertia of the true Hessian is that of a minimum.",
        ),
        markdown(
            (
                "group",
                "range tried",
                "cases",
                "certified",
                "most iterations (of)",
                "processor seconds",
                "ended otherwise",
            ),
            lines,
        ),
        provenance_text(notes),
    ]


def wall_section(rows, notes):
    lines, endings = [], []
    rows = [
        {**row, "case": f"{row['case']:.0f}" if isinstance(row["case"], float) else row["case"]}
        for row in rows
    ]  # numbers of vertices
    for fidelity, family in dict.fromkeys((row["fidelity"], row["family"]) for row in rows):
        mine = [row for row in rows if (row["fidelity"], row["family"]) == (fidelity, family)]
        good = [row for row in mine if row["ending"] == "converged"]
        bad = [row for row in mine if row["ending"] == "failed"]
        slowest = max(mine, key=lambda row: row["seconds"])
        lines.append(
            [
                fidelity,
                family,
                f"{mine[0]['case']} to {mine[-1]['case']}",
                len(mine),
                len(good),
                len(mine) - len(good) - len(bad),
                len(bad),
                f"{slowest['seconds']:.1f} s ({slowest['case']})",
                f"{max(row['peak_bytes'] for row in mine) / 2**20:.0f}",
            ]
        )
        endings += [
            [
                fidelity,
                f"{family}: {row['case']}",
                row["ending"],
                f"{row['seconds']:.1f}",
                row["sentence"] or "-",
            ]
            for row in mine
            if row["ending"] != "converged"
        ]
    good = sum(row["ending"] == "converged" for row in rows)
    failed = sum(row["ending"] == "failed" for row in rows)
    left = dict.fromkeys(
        f"{fidelity}, {case.family}"
        for case, fidelity in extremes.wall_cases()
        if (fidelity, case.family) not in {(row["fidelity"], row["family"]) for row in rows}
    )
    missing = (
        [paragraph(f"Not run in full since the last change, so left out: {'; '.join(left)}.")]
        if left
        else []
    )
    return [
        "## Walls\n",
        paragraph(
            f"Whole programs on a tube with L / R = 10; `converged`: {share(good, len(rows))};",
            f"named otherwise: {len(rows) - good - failed}, failed: {failed}.",
            "Past Brazier's curvature or the wrinkling twist, `buckled` and `unstable` are the",
            "right answers. Named otherwise: another status, or a refusal with one sentence.",
            "Failed: a crash, or a number that is not finite.",
        ),
        markdown(
            (
                "fidelity",
                "family",
                "range tried",
                "runs",
                "converged",
                "named otherwise",
                "failed",
                "slowest, processor time",
                "most MiB",
            ),
            lines,
        ),
        *missing,
        *sizes(rows),
        "### Every run that did not converge\n",
        markdown(("fidelity", "case", "ending", "s", "sentence"), endings),
        provenance_text(notes),
    ]


def sizes(rows):
    """Time and memory over the number of vertices."""
    lines = [
        [row["fidelity"], row["case"], row["ending"], f"{row['seconds']:.1f}"]
        + [f"{row['peak_bytes'] / 2**20:.0f}"]
        for row in rows
        if row["family"] == "vertices"
    ]
    head = ("fidelity", "vertices", "ending", "processor time, s", "MiB")
    return ["### Large surfaces\n", markdown(head, lines)] if lines else []


def reference_section(sensitivity, accuracy):
    """The shell over the sweep of the moduli, and every reference run of a case outside the range
    of the model that converged."""
    shell = [row for row in sensitivity if row["fidelity"] == "shell"]
    if not shell:
        return []
    lines = []
    for load, modulus in dict.fromkeys((row["load"], row["modulus"]) for row in shell):
        mine = [row for row in shell if (row["load"], row["modulus"]) == (load, modulus)]
        failed = [row for row in mine if row["force"] is None]
        worst = max(
            (row for row in mine if row["u_reaction"] is not None),
            key=lambda row: row["u_reaction"],
            default=None,
        )
        lines.append(
            [
                load,
                modulus,
                value_or_range([row["factor"] for row in mine], "{:g}".format),
                len(mine),
                len(mine) - len(failed),
                "; ".join(
                    f"x {row['factor']:g}: {row['failure'] or 'not converged'}" for row in failed
                )
                or "-",
                f"{worst['u_reaction']:.1g} at x {worst['factor']:g}" if worst else "-",
            ]
        )
    beyond = sorted(
        {
            (row["case"], row["reference"])
            for row in accuracy
            if not row["counted"] and row["reference"]
        }
    )
    text = [
        "## Reference\n",
        paragraph(
            "The 7-parameter shell with its moduli varied: how many runs converged on both meshes,",
            "and the largest error of the reaction that a run states. Together",
            f"{share(sum(row['force'] is not None for row in shell), len(shell))} converged.",
        ),
        markdown(
            (
                "load",
                "modulus",
                "factors",
                "runs",
                "converged",
                "ended otherwise",
                "largest stated error of the reaction",
            ),
            lines,
        ),
    ]
    if beyond:
        text.append(
            paragraph(
                "Outside the range of the hybrid model the reference converged on:",
                ", ".join(f"{case} ({run})" for case, run in beyond) + ".",
            )
        )
    return text


def glenn_section(rows, notes):
    good = sum(row["ending"] == "converged" for row in rows)
    own = sum(row["ending"] == "self_intersecting" for row in rows)
    strains = [row["strain"] for row in rows if row["strain"] is not None]
    header = ("cut", "incision", "rotation", "ending", "s", "walls through each other, mm deep")
    return [
        "## Glenn shunts on the adult anatomy\n",
        paragraph(
            f"`adult_physiological.yaml` at `{FIDELITY}` without its pressures and prestretch, on",
            "edges of 2 mm,",
            f"with other picks: `converged` {share(good, len(rows))}, `self_intersecting`",
            f"{share(own, len(rows))}. The kept vein is short for its width;",
            "`validity.largest_strain` of those that converged is",
            f"{value_or_range(strains, '{:.2f}'.format) if strains else '-'}, and above 0.2 is out",
            "of the model's range. A vein that passes through something from a closed seam goes",
            "the way from rest, on which it feels itself; s has both.",
        ),
        markdown(
            (*header, "sentence"),
            [
                [
                    row["cut"],
                    row["incision"],
                    f"{row['rotation']:g}" if row["rotation"] != "auto" else "auto",
                    row["ending"],
                    f"{row['seconds']:.1f}",
                    row["crossings"] or "-",
                    row["sentence"] or "-",
                ]
                for row in rows
            ],
        ),
        provenance_text(notes),
    ]


def folded_section(rows, notes):
    header = ("cut", "incision", "rotation", "ending", "s", "mouth", "strain")
    text = [
        "## Folding veins on the adult anatomy\n",
        paragraph(
            "`adult_physiological.yaml` without its prestretch at `coupled` on edges of 2 mm, with",
            "other picks. Where the vein does not end in a minimum from a closed seam, it is",
            "joined inflated and let out, or brought to its seam in steps, and feels itself.",
            "`converged` and `buckled` are certified minima whose walls pass through nothing;",
            "mouth: its area over that of the cut vein's lumen; strain:",
            "`validity.largest_strain`; s: processor time, the trial from a closed seam included.",
        ),
    ]
    for pressure in dict.fromkeys(row["pressure"] for row in rows):
        mine = [row for row in rows if row["pressure"] == pressure]
        good = [row for row in mine if row["ending"] in ("converged", "buckled")]
        what = (
            f"With {pressure:g} mmHg after the operation, neo-Hookean"
            if pressure
            else "Without pressure, law Biot"
        )
        text += [
            paragraph(f"{what}: {share(len(good), len(mine))} ended in such a minimum."),
            markdown(
                (*header, "walls through each other, mm deep", "sentence"),
                [
                    [
                        row["cut"],
                        row["incision"],
                        f"{row['rotation']:g}" if row["rotation"] != "auto" else "auto",
                        row["ending"],
                        f"{row['seconds']:.1f}",
                        *(
                            f"{row[column]:.2f}" if row[column] is not None else "-"
                            for column in ("mouth", "strain")
                        ),
                        row["crossings"] or "-",
                        row["sentence"] or "-",
                    ]
                    for row in mine
                ],
            ),
        ]
    return [*text, provenance_text(notes)]


def page(tables):
    """tables: {name: (rows, notes)} of the baselines that are there."""
    text = [
        "# All runs that pushed a solver\n",
        paragraph(
            "Questions and answers: [extremes.md](extremes.md). Written by `./run report` from",
            "`benchmarks/baselines`; no number here is typed by hand. The statuses are explained",
            "in [guide.md](guide.md).",
        ),
    ]
    for name, section in (
        ("extremes_rod", rod_section),
        ("extremes_wall", wall_section),
        ("sizes", sizes_section),
    ):
        if name in tables:
            text += section(*tables[name])
    if "sensitivity" in tables:
        text += reference_section(tables["sensitivity"][0], tables["accuracy"][0])
    if "glenns" in tables:
        text += glenn_section(*tables["glenns"])
    if "glenns_coupled" in tables:
        text += folded_section(*tables["glenns_coupled"])
    return "\n".join(text).rstrip() + "\n"
