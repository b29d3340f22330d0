#!/usr/bin/env python3
"""Do two builds of vasorod give the same results? Run it before and after a restructuring.

    tests/same_results.py BEFORE AFTER [SCENE...]

BEFORE and AFTER are programs (vasorod), or folders that an earlier run of this script filled
(--keep DIR). Every scene below benchmarks/cases is solved with one thread; result.json must be
equal in every key and number but `seconds`, `program` and `environment`, and so must exit codes.
Results may gain keys; none may be lost. Words that differ (notes, refusals) are listed for review.
"""

import argparse
import json
import math
import os
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
LEFT_OUT = {"seconds", "program", "environment"}


def solve(program, scene, folder):
    """Solves one scene into `folder` and keeps what the program said beside it."""
    command = [program, "solve", str(scene), "-o", str(folder / "result"), "--threads", "1"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    said = {"exit": done.returncode, "error": done.stderr.replace(str(ROOT), "")}
    (folder / "said.json").write_text(json.dumps(said))


def results(source, scenes, keep):
    """Scene -> folder with said.json and, where there is one, result/result.json."""
    if Path(source).is_dir():
        return {scene: Path(source) / name_of(scene) for scene in scenes}
    folders = {}
    for scene in scenes:
        folders[scene] = Path(keep) / name_of(scene)
        folders[scene].mkdir(parents=True, exist_ok=True)
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        list(pool.map(lambda scene: solve(source, scene, folders[scene]), scenes))
    return folders


def name_of(scene):
    return str(scene.relative_to(ROOT)).replace("/", "_")


def differences(a, b, place=""):
    """Where two JSON values differ, as sentences."""
    if isinstance(a, dict) and isinstance(b, dict):
        for key in a:
            if not place and key in LEFT_OUT:
                continue
            if key not in b:
                yield f"{place}/{key}: gone"
            else:
                yield from differences(a[key], b[key], f"{place}/{key}")
    elif isinstance(a, list) and isinstance(b, list):
        if len(a) != len(b):
            yield f"{place}: {len(a)} entries, now {len(b)}"
        for k, (x, y) in enumerate(zip(a, b)):
            yield from differences(x, y, f"{place}[{k}]")
    elif isinstance(a, float) and isinstance(b, float) and math.isnan(a) and math.isnan(b):
        return
    elif a != b:
        yield f"{place}: {a!r}, now {b!r}"


def is_wording(line):
    """Whether only a sentence differs: a note, a warning, a refusal."""
    return any(word in line.split(":")[0] for word in ("/notes[", "/warnings[", "said/error"))


def compare(before, after):
    said = [json.loads((folder / "said.json").read_text()) for folder in (before, after)]
    yield from differences(said[0], said[1], "said")
    files = [folder / "result" / "result.json" for folder in (before, after)]
    if files[0].exists() != files[1].exists():
        yield "result.json exists in one only"
    elif files[0].exists():
        yield from differences(*(json.loads(file.read_text()) for file in files))


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter
    )
    parser.add_argument("before")
    parser.add_argument("after")
    parser.add_argument("scenes", nargs="*", type=Path)
    parser.add_argument("--keep", help="keep the results below this folder (before/, after/)")
    options = parser.parse_args()
    scenes = [s.resolve() for s in options.scenes] or sorted(
        ROOT.glob("benchmarks/cases/**/*.yaml")
    )
    with tempfile.TemporaryDirectory() as scratch:
        keep = Path(options.keep or scratch)
        before = results(options.before, scenes, keep / "before")
        after = results(options.after, scenes, keep / "after")
        bad = 0
        for scene in scenes:
            lines = list(compare(before[scene], after[scene]))
            bad += any(not is_wording(line) for line in lines)
            for line in lines[:10]:
                print(f"{name_of(scene)}: {line}")
        print(f"{len(scenes) - bad} of {len(scenes)} scenes equal in every number")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
