"""Lays out what mkdocs builds the documentation site from:

    stage.py FOLDER

FOLDER/pages has every Markdown page of the project at its place in the source tree, so that links
between pages hold as they are, and the files that pages link to. FOLDER/mkdocs.yml is the settings
file. A page of docs/ that no section below names is added to the manual by itself.
"""

import re
import shutil
import sys
from pathlib import Path

import python_reference
import yaml

ROOT = Path(__file__).resolve().parent.parent.parent
SECTIONS = {
    "Manual": [
        "docs/guide.md",
        "docs/patient.md",
        "docs/explore.md",
        "docs/plan.md",
        "docs/prepare.md",
        "docs/scene.md",
        "docs/result.md",
        "docs/python.md",
        "docs/library.md",
        "docs/trust.md",
    ],
    "Accuracy and cost": [
        "docs/comparison.md",
        "docs/comparison_tables.md",
        "docs/extremes.md",
        "docs/extremes_tables.md",
        "docs/speed.md",
        "docs/reproduction.md",
    ],
    "Methods": [
        "docs/notation.md",
        "docs/rod.md",
        "docs/wall.md",
        "docs/sections.md",
        "docs/reference.md",
    ],
    "API": ["api/index.md", "api/python.md"],
    "Development": [
        "ARCHITECTURE.md",
        "CONTRIBUTING.md",
        "CHANGELOG.md",
        "docs/adding_a_case.md",
        "docs/adding_a_fidelity.md",
        "tests/README.md",
        "meshes/README.md",
    ],
}
API = """# C++ reference

The public headers, `hybrid/include/vasorod`, as Doxygen reads them:

- [Classes and functions](cpp/annotated.html)
- [Headers](cpp/files.html)
- [Index of all names](cpp/functions.html)

[The library](../docs/library.md) lists the headers and has three complete programs.
[The Python package](python.md) has its own reference.
"""
LINK = re.compile(r"\]\(([^)#:\s]+)(?:#[^)]*)?\)")
REPRODUCED = "results/reproduce"


def pages():
    """Every Markdown page of the project, relative to its root."""
    folders = ["", "docs", "meshes", "tests", "benchmarks/cases/*", "benchmarks/*", "paper"]
    found = {page for folder in folders for page in ROOT.glob(f"{folder}/*.md".lstrip("/"))}
    return sorted(page.relative_to(ROOT) for page in found if page.name != "paper.md")


def linked_files(page):
    """The files of the project, not pages, that a page links to."""
    for target in LINK.findall((ROOT / page).read_text()):
        file = (ROOT / page).parent / target
        if file.exists() and file.suffix != ".md":
            yield file.resolve().relative_to(ROOT)


def text_of(page):
    """A page's text; a link to a folder goes to the page in it."""

    def to_its_page(match):
        folder = (ROOT / page).parent / match[1]
        if not (folder / "README.md").is_file():
            return match[0]
        return match[0].replace(match[1], f"{match[1].rstrip('/')}/README.md", 1)

    return LINK.sub(to_its_page, (ROOT / page).read_text())


def copy(file, folder):
    """One file of the project, at its place below the folder."""
    target = folder / file
    target.parent.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(ROOT / file, target)


def navigation(there):
    """The menu: the start page, then the sections; new pages of docs/ end the manual."""
    named = {page for section in SECTIONS.values() for page in section}
    sections = {title: list(section) for title, section in SECTIONS.items()}
    sections["Manual"] += [page for page in there if page.startswith("docs/") and page not in named]
    if "reproduce/index.md" in there:
        sections["Accuracy and cost"].append("reproduce/index.md")
    return [{"Start": "README.md"}] + [
        {title: [page for page in section if page in there]} for title, section in sections.items()
    ]


def stage_reproduction(folder):
    """The pages of the last ./run reproduce, where there was one."""
    source = ROOT / REPRODUCED
    if not (source / "index.html").is_file():
        return []
    target = folder / "reproduce" / "run"
    for file in sorted(source.rglob("*")):
        if file.suffix in (".html", ".png", ".svg", ".yml", ".css"):
            (target / file.relative_to(source)).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(file, target / file.relative_to(source))
    (folder / "reproduce" / "index.md").write_text(
        "# The paper's figures\n\nThe last `./run reproduce` on this machine wrote\n"
        "[every figure and number beside the paper's](run/index.html).\n"
    )
    return ["reproduce/index.md"]


def main():
    folder = Path(sys.argv[1])
    source = folder / "pages"
    shutil.rmtree(source, ignore_errors=True)
    there = ["api/index.md", "api/python.md"]
    for page in pages():
        copy(page, source)
        (source / page).write_text(text_of(page))
        there.append(page.as_posix())
        for file in linked_files(page):
            if (ROOT / file).is_file():
                copy(file, source)
    (source / "api").mkdir()
    (source / "api" / "index.md").write_text(API)
    (source / "api" / "python.md").write_text(
        python_reference.page(ROOT / "hybrid" / "python" / "vasorod")
    )
    there += stage_reproduction(source)
    settings = yaml.safe_load((ROOT / "docs" / "site" / "mkdocs.yml").read_text())
    settings["docs_dir"] = "pages"
    settings["nav"] = navigation(there)
    (folder / "mkdocs.yml").write_text(yaml.safe_dump(settings, sort_keys=False))


if __name__ == "__main__":
    main()
