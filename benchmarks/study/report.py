"""docs/comparison.md from the tables in benchmarks/baselines, chapter by chapter: no number in it
is typed. A chapter without its table is absent."""

import figures
from chapters.accuracy import accuracy_section
from chapters.inflated import bends_section, loads_section
from chapters.irregular import irregular_section
from chapters.join import join_section
from chapters.laws import laws_section
from chapters.pressure import pressure_section
from chapters.promise import promise_section
from chapters.sensitivity import sensitivity_section
from chapters.trade import front_of, trade_section
from tables import IMAGES, paragraph, read_table


def table_if_there(path):
    return read_table(path) if path.exists() else None


def write_report(baselines, docs):
    text = [
        "# Accuracy and cost against finite elements\n",
        paragraph(
            "Written by `./run report` from the tables in `benchmarks/baselines`; no number here",
            "is typed by hand. How to add a case: [adding_a_case.md](adding_a_case.md).",
        ),
    ]
    images = docs / IMAGES
    accuracy, notes = read_table(baselines / "accuracy.csv")
    irregular = table_if_there(baselines / "irregular.csv")
    text.append(accuracy_section(accuracy, notes, irregular[0] if irregular else []))
    figures.errors_picture(accuracy, images / "accuracy.png")
    figures.limits_picture(accuracy, images / "agreement.png")
    if irregular:
        text.append(irregular_section(*irregular))
    laws = table_if_there(baselines / "laws.csv")
    if laws:
        text.append(laws_section(*laws))
    text.append(promise_section(accuracy, table_if_there(baselines / "promise.csv")))
    if (baselines / "sensitivity.csv").exists():
        rows, notes = read_table(baselines / "sensitivity.csv")
        text.append(sensitivity_section(rows, notes, table_if_there(baselines / "shear_gap.csv")))
        figures.sensitivity_picture(rows, images / "sensitivity.png")
    if (baselines / "trade.csv").exists():
        rows, notes = read_table(baselines / "trade.csv")
        text.append(trade_section(rows, notes))
        figures.trade_picture(
            [row for row in rows if row["rms"] is not None],
            images / "trade.png",
            front_of([row for row in rows if row["rms"] is not None]),
        )
    for name, section in (
        ("inflated", loads_section),
        ("inflated_bends", bends_section),
        ("join", join_section),
        ("pressure", pressure_section),
    ):
        table = table_if_there(baselines / f"{name}.csv")
        if table:
            text.append(section(*table))
    (docs / "comparison.md").write_text("\n".join(part for part in text if part).rstrip() + "\n")
