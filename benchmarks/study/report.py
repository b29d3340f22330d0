"""docs/comparison.md and docs/extremes.md (questions, answers, figures), and beside them
comparison_tables.md and extremes_tables.md (every table), from benchmarks/baselines alone: no
number in them is typed, and no finished run is needed. A chapter without its table is absent."""

from chapters import answers, limits, limits_answers
from chapters.accuracy import accuracy_section, cases_section
from chapters.inflated import bends_section, kinks_section, loads_section, widening_section
from chapters.irregular import irregular_section
from chapters.join import join_section
from chapters.laws import laws_section
from chapters.pressure import infant_section, pressure_section, shells_section
from chapters.prestress import drift_section, joins_section, tubes_section
from chapters.promise import promise_section
from chapters.sections import refinement_section, sections_section, speed_section
from chapters.sensitivity import sensitivity_section
from chapters.trade import front_of, trade_section
from sections import beside
from tables import IMAGES, paragraph, read_table

TABLES = (
    "accuracy",
    "irregular",
    "sections",
    "sections_speed",
    "sections_refinement",
    "laws",
    "promise",
    "sensitivity",
    "shear_gap",
    "trade",
    "inflated",
    "widening",
    "inflated_bends",
    "kinks",
    "join",
    "pressure",
    "pressure_shells",
    "prestress",
    "prestress_drift",
    "prestress_joins",
    "glenn_mouths",
    "extremes_rod",
    "extremes_wall",
    "sizes",
    "glenns",
    "glenns_coupled",
)


def read_tables(baselines):
    """{name: (rows, notes)} of those that are there; accuracy with the rows of sections."""
    tables = {
        name: read_table(baselines / f"{name}.csv")
        for name in TABLES
        if (baselines / f"{name}.csv").exists()
    }
    if "accuracy" in tables and "sections" in tables:
        (rows, notes), (more, made) = tables["accuracy"], tables["sections"]
        both = [*notes, *(f"section: {note}" for note in made[1:])]
        tables["accuracy"] = rows + beside(rows, more), both
    return tables


def tables_page(tables):
    accuracy, notes = tables["accuracy"]
    text = [
        "# All tables of the comparison\n",
        paragraph(
            "Questions, answers and figures: [comparison.md](comparison.md). Written by `./run",
            "report` from the tables in `benchmarks/baselines`; no number here is typed by hand.",
        ),
        cases_section(accuracy),
        accuracy_section(accuracy, notes, tables.get("irregular", ([],))[0]),
    ]
    if "irregular" in tables:
        text.append(irregular_section(*tables["irregular"]))
    if "sections" in tables:
        text.append(sections_section(*tables["sections"]))
    if "sections_speed" in tables:
        text.append(speed_section(*tables["sections_speed"]))
    if "sections_refinement" in tables:
        text.append(refinement_section(*tables["sections_refinement"]))
    if "laws" in tables:
        text.append(laws_section(*tables["laws"]))
    text.append(promise_section(accuracy, tables.get("promise")))
    if "sensitivity" in tables:
        text.append(sensitivity_section(*tables["sensitivity"], tables.get("shear_gap")))
    for name, section in (
        ("trade", trade_section),
        ("inflated", loads_section),
        ("widening", widening_section),
        ("inflated_bends", bends_section),
        ("kinks", kinks_section),
        ("prestress", tubes_section),
        ("prestress_drift", drift_section),
        ("join", join_section),
        ("pressure", pressure_section),
        ("pressure_shells", shells_section),
        ("prestress_joins", joins_section),
        ("glenn_mouths", infant_section),
    ):
        if name in tables:
            text.append(section(*tables[name]))
    return "\n".join(part for part in text if part).rstrip() + "\n"


def pages(baselines):
    """{file: text}; needs no matplotlib."""
    tables = read_tables(baselines)
    return {
        "comparison.md": answers.page(tables),
        "comparison_tables.md": tables_page(tables),
        "extremes.md": limits_answers.page(tables),
        "extremes_tables.md": limits.page(tables),
    }


def drawn(baselines):
    """{file: figure}"""
    import figures  # needs matplotlib

    tables = read_tables(baselines)
    accuracy = tables["accuracy"][0]
    made = {
        "shapes.svg": figures.errors_figure(accuracy),
        "reactions.svg": figures.reactions_figure(accuracy),
    }
    if "trade" in tables:
        rows = [row for row in tables["trade"][0] if row["rms"] is not None]
        made["cost.svg"] = figures.cost_figure(rows, front_of(rows))
    if "sensitivity" in tables:
        made["moduli.svg"] = figures.moduli_figure(tables["sensitivity"][0])
    names = ("extremes_wall", "extremes_rod", "sensitivity", "glenns", "glenns_coupled")
    counts = limits_answers.counts_of(*(tables.get(name, ([],))[0] for name in names))
    made["endings.svg"] = figures.endings_figure(counts)
    return {f"{IMAGES}/{name}": figure for name, figure in made.items()}


def write_report(baselines, docs):
    from figures import save

    for name, text in pages(baselines).items():
        (docs / name).write_text(text)
    for name, figure in drawn(baselines).items():
        save(figure, docs / name)
