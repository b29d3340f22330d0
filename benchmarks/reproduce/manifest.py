"""codecheck.yml: the outputs and the command of each, as codecheck.org.uk specifies it; `command`
is an entry of ours. Nobody has checked this yet, so it names no codechecker and no certificate."""

import yaml

from page import TITLE
from work import REPOSITORY

SPECIFICATION = "https://codecheck.org.uk/spec/config/1.0/"


def authors():
    citation = yaml.safe_load((REPOSITORY / "CITATION.cff").read_text())
    reference = next(one for one in citation["references"] if one["title"] == TITLE)
    return [
        {"name": f"{author['given-names']} {author['family-names']}"}
        for author in reference["authors"]
    ]


def entries(work, panels):
    listed = [
        {
            "file": "index.html",
            "comment": "all panels",
            "command": "./run reproduce" + (" --quick" if work.quick else ""),
        }
    ]
    for panel in panels:
        listed += [
            {
                "file": figure.file,
                "comment": f"{panel.title}: {figure.caption}",
                "command": figure.command,
            }
            for figure in panel.figures
        ]
        for file in dict.fromkeys(number.file for number in panel.numbers):
            listed.append(
                {
                    "file": file,
                    "comment": f"{panel.title}: numbers",
                    "command": f"benchmarks/reproduce/reproduce.py --only {panel.identity}",
                }
            )
    return list({entry["file"]: entry for entry in reversed(listed)}.values())[::-1]


def manifest(work, panels):
    return yaml.safe_dump(
        {
            "version": SPECIFICATION,
            "paper": {"title": TITLE, "authors": authors()},
            "manifest": entries(work, panels),
        },
        sort_keys=False,
        width=150,
        explicit_start=True,
    )
