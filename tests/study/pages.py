"""The committed pages are what the committed tables give, without a finished run; every number of a
reader's page is in the page of its tables; links and figures are there; no label of a figure lies
on another. Usage: pages.py SOURCE_FOLDER VASOROD."""

import re
import sys
import tempfile
from pathlib import Path

SOURCE = Path(sys.argv[1])
sys.path.insert(0, str(SOURCE / "benchmarks" / "study"))
import names  # noqa: E402
import report  # noqa: E402
from cases import all_cases  # noqa: E402

BASELINES, DOCS = SOURCE / "benchmarks" / "baselines", SOURCE / "docs"


def anchors(text):
    """Of the headings of a page, as GitHub and MkDocs make them."""
    found = re.findall(r"^#+ (.*)$", text, re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", head.lower()).strip().replace(" ", "-") for head in found}


def numbers(text):
    """Those written out, without links, names of files and figures, and headings."""
    text = re.sub(r"\]\([^)]*\)|!\[[^]]*\]|`[^`]*`", " ", text)
    text = re.sub(r"^#.*$", " ", text, flags=re.MULTILINE)
    return set(re.findall(r"(?<![\w.])[+-]?\d+(?:\.\d+)?(?:e[+-]?\d+)?(?![\w])", text))


made = report.pages(BASELINES)
for name, text in made.items():
    committed = (DOCS / name).read_text()
    assert committed == text, f"docs/{name} is not what the tables give: study.py report writes it"
    for target, anchor in re.findall(r"\]\(([\w/.-]*)#?([\w-]*)\)", text):
        assert (DOCS / target).exists(), (name, target)
        if anchor:
            assert anchor in anchors((DOCS / target).read_text()), (name, target, anchor)
    assert "nan" not in text.split() and "None" not in text, name

for page in ("comparison", "extremes"):
    every = numbers(made[f"{page}_tables.md"])
    alone = {one for one in numbers(made[f"{page}.md"]) if one not in every}
    alone -= {one for one in alone if f"+{one}" in every or f"-{one}" in every}
    assert not alone, f"{page}.md: in no table of its own: {sorted(alone)}"
changed = report.read_tables(BASELINES)
rows, notes = changed["accuracy"]
changed["accuracy"] = [
    {**row, "rms": 1.5 * row["rms"] if row["model"] == "coupled" and row["rms"] else row["rms"]}
    for row in rows
], notes
assert report.answers.page(changed) != made["comparison.md"], "the page does not follow its table"

titles = names.titles(rows)
assert len(set(titles.values())) == len(titles), "two cases share a name"
assert set(titles) == {case.name for case in all_cases()}
for case, title in titles.items():
    assert title != case, f"{case} has no readable name (benchmarks/study/names.py)"

try:
    import matplotlib
except ImportError:
    sys.exit(0)
import figures  # noqa: E402
import labels  # noqa: E402

drawn = report.drawn(BASELINES)
for name, figure in drawn.items():
    found = labels.overlapping(figure)
    assert not found, f"{name}: {found}"
    assert any(name in text for text in made.values()), f"{name} is on no page"
    assert (DOCS / name).exists(), name
    if f"Matplotlib v{matplotlib.__version__}" in (DOCS / name).read_text():
        with tempfile.TemporaryDirectory() as folder:
            figures.save(figure, Path(folder) / "figure.svg")
            again = (Path(folder) / "figure.svg").read_text()
            assert again == (DOCS / name).read_text(), f"docs/{name}: study.py report draws it anew"
axes = next(iter(drawn.values())).axes[0]
axes.text(0.5, 0.5, "one", transform=axes.transAxes)
axes.text(0.5, 0.5, "two", transform=axes.transAxes)
assert ("one", "two") in labels.overlapping(axes.figure), "labels on one another are found"
