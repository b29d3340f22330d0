#!/usr/bin/env python3
"""The figures and numbers of the MICCAI 2009 paper again: docs/reproduction.md.

    reproduce.py [--quick] [--only PANEL...] [-o results/reproduce] [--programs build/bin]

Finished runs are kept; a panel that fails is absent from the page, which says so."""

import argparse
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from work import REPOSITORY, Work  # first: it finds the study's modules

import cost
import cuts
import hybrid_model
import moduli
import picks
import tube
import twist
import views
from manifest import manifest
from page import page
from store import commit

PANELS = {
    "fig1": hybrid_model,
    "fig2": picks,
    "fig3abc": tube,
    "fig3d": moduli,
    "fig4ab": twist,
    "fig4cde": cuts,
    "fig5": views,
    "section4": cost,
}
FIRST = "section4"  # its time is measured alone, before two runs share the processors


def run_all(work, names, jobs):
    """Runs what the panels need; the sentence of each run that fails."""
    failed = {}

    def ensure(run):
        try:
            work.store.ensure(run)
        except (OSError, SystemExit) as error:
            failed[run.identity] = str(error)

    if FIRST in names:
        for run in PANELS[FIRST].runs(work.quick):
            ensure(run)
    rest = {run.identity: run for name in names for run in PANELS[name].runs(work.quick)}
    with ThreadPoolExecutor(jobs) as pool:
        list(pool.map(ensure, rest.values()))
    return failed


def make_panels(work, names):
    panels, missing = [], {name: "not asked for" for name in PANELS if name not in names}
    for name in names:
        try:
            panels.append(PANELS[name].panel(work))
        except (KeyError, StopIteration, FileNotFoundError, SystemExit) as error:
            missing[name] = str(error) or type(error).__name__
    return panels, missing


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--quick", action="store_true", help="fewer points in Fig. 3(d)")
    parser.add_argument(
        "--only", nargs="+", choices=PANELS, metavar="PANEL", help=", ".join(PANELS)
    )
    parser.add_argument("-o", "--output", default=str(REPOSITORY / "results" / "reproduce"))
    parser.add_argument("--programs", default=str(REPOSITORY / "build" / "bin"))
    parser.add_argument("--jobs", type=int, default=2, help="runs at once")
    options = parser.parse_args()
    programs = {name: Path(options.programs) / name for name in ("vasorod", "vasorod-fem")}
    work = Work(options.output, programs, options.quick)
    names = [name for name in PANELS if not options.only or name in options.only]
    began = time.time()
    for identity, why in run_all(work, names, options.jobs).items():
        print(f"{identity}: {why}", file=sys.stderr)
    panels, missing = make_panels(work, names)
    work.write("index.html", page(work, panels, missing, commit()))
    work.write("codecheck.yml", manifest(work, panels))
    for name, why in missing.items():
        if why != "not asked for":
            print(f"reproduce: {name} is missing: {why}", file=sys.stderr)
    print(f"reproduce: {work.folder}/index.html, {len(panels)} panels, {time.time() - began:.0f} s")
    return 1 if any(why != "not asked for" for why in missing.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
