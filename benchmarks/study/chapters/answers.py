"""docs/comparison.md: questions, answers and four figures. Each number is computed from the tables,
and each is also in docs/comparison_tables.md."""

import inflated_bends
import promise
from chapters.accuracy import summary
from chapters.inflated import kink_line, kinks_of, softening, unsettled
from chapters.join import over
from chapters.sensitivity import worst_of_curves
from chapters.trade import AIM_OF_TIME, cheapest_as_near, front_of
from names import title, titles
from prestress import FAR
from tables import IMAGES, markdown, paragraph, percent, signed, value_or_range

TABLES = "comparison_tables.md"
AROUND = 48


def link(text, anchor):
    return f"[{text}]({TABLES}#{anchor})"


def figure(name, text):
    return paragraph(f"![{text}]({IMAGES}/{name}.svg)") + "\n" + paragraph(f"*{text}*")


def head(accuracy):
    counted = {row["case"]: row for row in accuracy if row["counted"]}
    walls = value_or_range([r["thickness_over_radius"] for r in counted.values()], "{:g}".format)
    bent = [r["ratio"] for r in counted.values() if r["family"] == "bend"]
    return [
        "# Accuracy and cost against finite elements\n",
        paragraph(
            f"Questions, answers and four figures. {link('All tables', 'cases')} are",
            "on their own page. Both pages are written by `./run report` from the tables in",
            "`benchmarks/baselines`; no number is typed by hand. How to add a case:",
            "[adding_a_case.md](adding_a_case.md). Where the solvers end:",
            "[extremes.md](extremes.md).",
        ),
        paragraph(
            f"{len(counted)} tubes (radius R, wall t, t/R {walls}) are twisted, moved sideways,",
            f"pressed, pulled and bent to up to {max(bent):g} of Brazier's curvature, one load or",
            "several, one tube tapered, one curved at rest. `rod`, `skin`, `paper` and `coupled`",
            "are the fidelities of `vasorod`; the reference is `vasorod-fem`, shell or solid",
            "elements of order 4, of the same law (Biot) on two meshes. It is a comparison with a",
            "higher-fidelity model, not a validation by experiment.",
        ),
    ]


def shapes(accuracy):
    lines, texts = [], {}
    for model in ("skin", "paper", "coupled"):
        of = summary(accuracy, model, AROUND)
        if of is None:
            continue
        worst, case = of["worst_rms"]
        texts[model] = (percent(worst, 3), title(case))
        lines.append(
            [
                f"`{model}`",
                percent(of["rms"], 3),
                f"{percent(worst, 3)} ({title(case)})",
                percent(of["worst_point"][0]),
                percent(of["worst_reaction"][0]),
            ]
        )
    return [
        "## How near are the shapes?\n",
        paragraph(
            f"`coupled` with {AROUND} points around is within {texts['coupled'][0]} % of the",
            "radius (RMS over material points) on every tube, `paper` within",
            f"{texts['paper'][0]} % and",
            f"`skin` within {texts['skin'][0]} %. `skin` and `paper` miss mostly that bent",
            "sections flatten and, for `skin`, that pulled ones narrow.",
            link("Every case", "rms-distance-by-case") + ".",
        ),
        figure("shapes", "RMS distance of each tube; a mark left of the axis' end stands at it."),
        markdown(
            ("fidelity", "RMS over all tubes, % R", "worst RMS, % R", "worst point, % R")
            + ("worst reaction, %",),
            lines,
        ),
    ]


def reactions(accuracy):
    mine, rod = summary(accuracy, "coupled", AROUND), summary(accuracy, "rod", AROUND)
    (worst, case), (far, curved) = mine["worst_reaction"], rod["worst_reaction"]
    return [
        "## How near are forces and moments?\n",
        paragraph(
            f"Those of `coupled` within {percent(worst)} % ({title(case)}). `rod`, `skin` and",
            f"`paper` report the rod's, which is linear: {percent(far)} % off at worst",
            f"({title(curved)}), since a rod's section does not flatten.",
            link("Every case", "reaction-by-case") + ".",
        ),
        figure(
            "reactions", "The larger difference of force and moment / R, over the larger of both."
        ),
    ]


def cost(trade, case_title):
    rows = [row for row in trade if row["rms"] is not None]
    front = front_of(rows)
    ratios = [
        (best[column] / row[column], row, best)
        for row in rows
        if row["model"] == "coupled"
        for others, column in (("shell", "seconds"), ("shell", "solve_seconds"))
        for best in [cheapest_as_near(rows, row, others, column)]
        if best is not None and row[column] is not None
    ]
    low, high = min(r[0] for r in ratios), max(r[0] for r in ratios)
    slower = min(ratios, key=lambda r: r[0])[1]["settings"]
    mine = [row for row in front if row["model"] == "coupled"]
    runs = " and ".join(
        f"{row['settings']:g} points around {row['seconds']:.2f} s for {percent(row['rms'], 3)} %"
        for row in mine
    )
    return [
        "## What does it cost?\n",
        paragraph(
            f"One tube ({case_title}), one thread, whole programs: `coupled` with {runs}. At equal",
            f"error the finite-element shell takes {low:.1f} to {high:.1f} times the time of",
            f"`coupled`; the aim of {AIM_OF_TIME} is {'held' if low >= AIM_OF_TIME else 'missed'}.",
            f"Below 1 (`coupled` at {slower:g} points around) the shell is faster."
            if low < 1
            else "",
            link("Times, memory and ratios", "time-against-error") + ".",
        ),
        figure(
            "cost",
            "Numbers: points around; pN-AxB: order N, A x B cells; AxB: cells of CalculiX.",
        ),
    ]


def moduli(sensitivity):
    worst = worst_of_curves(sensitivity, "coupled")
    held = [key for key, (_, _, fine) in worst.items() if fine]
    missed = [key for key in worst if key not in held]
    largest = max((abs(worst[key][0]) for key in held), default=None)
    factors = value_or_range([row["factor"] for row in sensitivity], "{:g}".format)
    parts = [
        f"Twisted, pulled, bent and moved sideways with E or G times {factors},"
        f" the reactions of `coupled` follow the reference within {percent(largest)} % in"
        f" {len(held)} of {len(worst)} curves."
    ]
    for load in dict.fromkeys(key[0] for key in missed):
        key = next(key for key in missed if key[0] == load)
        value, factor, _ = worst[key]
        parts.append(
            f"In the other {sum(one[0] == load for one in missed)} ({load}) the difference is"
            f" {signed(value)} % at {key[1]} x {factor:.3g}."
        )
    return [
        "## Does the prediction follow one modulus alone?\n",
        paragraph(
            *parts,
            "Factors at which both converged count. Shapes under prescribed motions depend on",
            "E / G alone, so the curves over G are these mirrored; a twisted and a pulled tube",
            "keep their shape.",
            link("All curves and what did not converge", "moduli-alone") + ".",
        ),
        figure(
            "moduli", "Where the reference converged; the lower axes are linear in the grey band."
        ),
    ]


def surfaces(irregular, accuracy):
    lines, regular = [], summary(accuracy, "coupled", AROUND)
    for mesh in dict.fromkeys(row["mesh"] for row in irregular):
        mine = [row for row in irregular if row["mesh"] == mesh]
        done = [row for row in mine if row["rms"] is not None]
        lines.append(
            [
                mesh,
                f"{min(row['smallest_angle'] for row in done):.0f}",
                f"{len(done)} of {len(mine)}",
                percent(max(row["rms"] for row in done), 3),
                percent(max(max(row["force"], row["moment"]) for row in done)),
            ]
        )
    return [
        "## Do irregular triangles matter?\n",
        paragraph(
            "The same tubes as surfaces read from a file, with centerlines found by the fit,",
            "`coupled`. On regular triangles its worst shape is",
            f"{percent(regular['worst_rms'][0], 3)} %, its worst reaction",
            f"{percent(regular['worst_reaction'][0])} %.",
            link("Every case", "irregular-surfaces") + ".",
        ),
        markdown(
            ("mesh", "smallest angle, degrees", "converged", "worst RMS, % R", "worst reaction, %"),
            lines,
        ),
    ]


def promised(accuracy):
    fresh = [pair for pair in promise.held_out(accuracy) if pair[0]["family"] == "fresh"]
    kept = sum(row["rms"] <= error for row, error in fresh)
    beyond = promise.held_out(accuracy, within=False)
    broken = sum(row["rms"] > error for row, error in beyond)
    return [
        "## Does `accuracy: x` keep what it promises?\n",
        paragraph(
            f"In {kept} of {len(fresh)} runs of cases written before their first run and after the",
            f"margin of {promise.SAFETY} was fixed. Pressed tubes get no promise: {broken} of",
            f"{len(beyond)} runs would have broken it.",
            link("Every run", "accuracy-x") + ".",
        ),
    ]


def laws_answer(laws, accuracy):
    names = titles(accuracy)

    def worst(difference, law):
        mine = [r for r in laws if (r["difference"], r["law"]) == (difference, law)]
        mine = [r for r in mine if not r["failure"]]
        return max(mine, key=lambda r: abs(r["reaction_signed"]))

    kinematics = worst("kinematics", "biot")
    svk, neo = worst("law", "svk"), worst("law", "neo-hookean")
    return [
        "## How much does the law of the wall matter?\n",
        paragraph(
            "Against the shell of Biot's law, the shell of S = C:E answers",
            f"{signed(svk['reaction_signed'])} % at most ({names[svk['case']]}), that of a",
            f"neo-Hookean wall {signed(neo['reaction_signed'])} % ({names[neo['case']]});",
            f"`coupled` against the shell of its own law {signed(kinematics['reaction_signed'])}",
            "%.",
            link("Kinematics and law separately", "kinematics-and-law-separately") + ".",
        ),
    ]


def largest(rows, value):
    return max(value(row) for row in rows if not row["failure"])


def pressures(inflated):
    lines = []
    for fidelity in dict.fromkeys(row["fidelity"] for row in inflated):
        mine = [row for row in inflated if row["fidelity"] == fidelity]
        lines.append(
            [
                f"`{fidelity}`",
                percent(largest(mine, lambda r: r["rms"]), 3),
                percent(largest(mine, lambda r: r["force"]), 3),
                percent(largest(mine, lambda r: r["moment"]), 3),
                percent(largest(mine, lambda r: r["own_error"]), 3),
            ]
        )
    mmhg = value_or_range([row["pressure"] for row in inflated], "{:g}".format)
    return [
        "## And with blood in the vessel?\n",
        paragraph(
            f"A neo-Hookean tube at {mmhg} mmHg, bent, twisted and stretched: the worst of its",
            "runs against the shell with the pressure on its inner face.",
            link("Every run", "tubes-under-pressure"),
            "and " + link("bends towards Brazier's curvature", "bends-under-pressure") + ".",
        ),
        markdown(
            ("fidelity", "RMS, % R", "force, %", "moment, %", "shell's own error, %"),
            lines,
        ),
    ]


def held_open(widening, bends, kinks):
    """What a pressure does to a tube, by `coupled`."""
    poisson = inflated_bends.TUBE["poisson"]
    wide = {0: 0} | {
        row["ratio"]: row["widening"]
        for row in widening
        if (row["model"], row["poisson"]) == ("coupled", poisson) and not row["failure"]
    }
    soft = {
        row["ratio"]: row
        for row in bends
        if (row["fidelity"], row["section"]) == ("coupled", "soft") and not row["failure"]
    }
    kinked = kinks_of(kinks)
    finest = max(around for _, around in kinked)
    lines = [
        [
            f"{ratio:g}",
            f"{wide[ratio]:.6f}" if ratio else "0",
            softening(row, soft[0]),
            f"{1 / (1 + ratio):.3f}",
            f"{row['stiffness']:.4f}",
            kink_line(*kinked[ratio, finest]),
        ]
        for ratio, row in soft.items()
        if ratio in wide and 0 in soft and (ratio, finest) in kinked
    ]
    return [
        "### What does the pressure change?\n",
        paragraph(
            f"`coupled` tubes of t/R 0.1 and nu {poisson:g}: how far the pressure",
            link("widens", "how-far-a-pressure-widens-a-tube"),
            "one without stress, how much a bend to",
            value_or_range([row["share"] for row in soft.values()], "{:g}".format),
            "of Brazier's curvature flattens over one without pressure, its",
            link("stiffness", "bends-under-pressure") + ", and between which curvatures, over",
            "Brazier's without pressure, a tube with rigid ends",
            link("kinks", "at-which-curvature-a-tube-kinks"),
            f"({finest:g} points around). Pressures are over p_c = 3 D / R^3, D = E t^3 / 12 (1 -",
            "nu^2), at which a long tube collapses from outside; 1 / (1 + p / p_c) is what theory",
            "expects of the flattening.",
            unsettled(kinked),
        ),
        markdown(
            ("p / p_c", "widening / R", "flattening over that without", "1 / (1 + p / p_c)")
            + ("stiffness / E I", "kinks between"),
            lines,
        ),
    ]


def seen(tubes, joined):
    near = [row for row in tubes if row["case"] not in FAR]
    far = [row for row in tubes if row["case"] in FAR]

    def apart(rows):
        reacting = [row for row in rows if row["force"] is not None]
        return (
            f"{percent(largest(rows, lambda r: r['rms']), 3)} % of R (root mean square), forces",
            f"within {percent(largest(reacting, lambda r: r['force']), 3)} %.",
        )

    lines = [
        [row["opening"], f"{row['length']:g}", f"{row['stretch']:g}"]
        + [f"{row['mouth_reference']:.2f}", f"{row['mouth']:.2f}", signed(over(row, "mouth"))]
        + [signed(over(row, "support")), percent(row["rms_first"]), percent(row["rms_second"])]
        for row in joined
        if not row["failure"]
    ]
    return [
        "## And if a vessel was seen under pressure?\n",
        paragraph(
            "Tubes that carried a pressure or an axial stretch when they were seen, and are then",
            "pressed, bent, shortened or let go: `coupled` against the shell with its own",
            "prestress, material points within",
            *apart(near),
            "Seen at 40 mmHg and more, where both look for the shape without stress: within",
            *apart(far),
            link("Every run", "seen-under-pressure-or-stretched") + ".",
            "The T of a vein seen at low and an artery seen at high pressure:",
            link("its table", "the-join-of-vessels-seen-under-pressure") + ".",
        ),
        markdown(
            ("opening", "`incision_length`", "`axial_prestretch`", "shell, mm2", "`coupled`, mm2")
            + ("mouth, %", "support, %", "vein, % of R", "artery, % of R"),
            lines,
        ),
    ]


def joins(join, pressure):
    """Mouths at 60 points around the first vessel."""
    lines = []
    for opening in ("slit", "ellipse", "end to end"):
        for law in ("biot", "neo-hookean"):
            mine = [
                row
                for row in join
                if (row["opening"], row["law"], row["fidelity"]) == (opening, law, "coupled")
                and (row["around"], row["thickness"], row["length"]) == (60, 1, 1)
                and not row["failure"]
            ]
            lines += [
                [opening, law, "0", f"{row['mouth_reference']:.2f}", f"{row['mouth']:.2f}"]
                + [signed(over(row, "mouth")), percent(row["own_error"])]
                for row in mine
            ]
        lines += [
            [opening, "neo-hookean", f"{row['pressure']:g}", f"{row['mouth_reference']:.2f}"]
            + [f"{row['mouth']:.2f}", signed(over(row, "mouth")), percent(row["own_error"])]
            for row in pressure
            if (row["opening"], row["around"], row["length"]) == (opening, 60, 1)
            and row["pressure"] > 0
            and not row["failure"]
        ]
    return [
        "## How open is the mouth of a join?\n",
        paragraph(
            "Two tubes in a T, the vein on a slit of half its perimeter or on an ellipse, and two",
            "tubes of unequal radius end to end: `coupled` with 60 points around the vein against",
            "the shell of the same law. Without pressure a slit is nearly shut, which makes its",
            "mouth the hardest number to predict.",
            link("Thinner walls, longer slits, order, forces, times", "the-join"),
            "and " + link("pressures", "the-join-under-pressure") + ".",
        ),
        markdown(
            ("opening", "law", "mmHg", "shell, mm2", "`coupled`, mm2", "difference, %")
            + ("shell's own error, %",),
            lines,
        ),
    ]


def page(tables):
    """tables: {name: (rows, notes)} of the baselines that are there. A question without its tables
    is left out."""
    rows = {name: table[0] for name, table in tables.items()}
    accuracy = rows["accuracy"]
    names = titles(accuracy)
    questions = (
        (shapes, "accuracy"),
        (reactions, "accuracy"),
        (lambda trade: cost(trade, names.get(trade[0]["case"], trade[0]["case"])), "trade"),
        (moduli, "sensitivity"),
        (surfaces, "irregular", "accuracy"),
        (promised, "accuracy"),
        (laws_answer, "laws", "accuracy"),
        (pressures, "inflated"),
        (held_open, "widening", "inflated_bends", "kinks"),
        (seen, "prestress", "prestress_joins"),
        (joins, "join", "pressure"),
    )
    text = head(accuracy)
    for answer, *needed in questions:
        if all(name in rows for name in needed):
            text += answer(*(rows[name] for name in needed))
    return "\n".join(part for part in text if part).rstrip() + "\n"
