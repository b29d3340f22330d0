"""Runs the code blocks of one page of the documentation:

    check_page.py SOURCE PROGRAMS PAGE [THING ...]

SOURCE is the project, PROGRAMS the folder of the built programs, THING what is there beyond them:
`vasorod-fem`, `gmsh`, `the Python package`. Every block has a tag, by which it is tried:

    sh      run, all of a page in one scratch folder that looks like the project's (for a page of
            meshes/: in that)
    yaml    a whole scene is solved at fidelity `skin`; a fragment is held against the schema
    python  with >>> run by tests/python/test_docs.py, which this test checks, otherwise compiled
    cpp     one of examples/*.cpp, or built by tests/docs/test_library_block.py
    cmake   as cpp
    json    read
    text    output, formulas and forms with words to fill in: nothing to run

A picture that a block draws (`vasorod draw ... -o pictures/NAME.png`) and the page shows is
compared with the one that the page shows.

A comment in the line before a block says why it is not run (`<!-- not run: REASON -->`), or what it
needs (`<!-- needs vasorod-fem -->`): without it the block is left out and named.
"""

import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import yaml
from blocks import blocks_of
from jsonschema import Draft202012Validator
from pictures import difference, drawn_pictures

COPIED = ("meshes",)  # examples write here
LINKED = ("benchmarks", "examples", "docs", "schema")
SECONDS = 600
# Edges and letters move by rounding; a picture of another state differs by five times as much.
LARGEST_DIFFERENCE = 0.002
AS_CHECKED = {"text": "text", "python": "run by tests/python", "cmake": "built by its own test"}


def without_required(node):
    """A schema for fragments: nothing has to be there, and of alternatives several may hold."""
    if isinstance(node, list):
        return [without_required(item) for item in node]
    if not isinstance(node, dict):
        return node
    renamed = {"oneOf": "anyOf"}
    return {
        renamed.get(key, key): without_required(value)
        for key, value in node.items()
        if not (key == "required" and isinstance(value, list)) and key != "not"
    }


class Checker:
    """The checks of one page's blocks, by tag. A check returns what is wrong, or an empty text."""

    def __init__(self, source, programs, page, scratch):
        self.source, self.page, self.root = source, page, scratch
        for name in COPIED:
            shutil.copytree(source / name, scratch / name)
        for name in LINKED:
            (scratch / name).symlink_to(source / name)
        (scratch / "build").mkdir()
        (scratch / "build" / "bin").symlink_to(programs)
        if (programs.parent / "python").is_dir():
            (scratch / "build" / "python").symlink_to(programs.parent / "python")
        self.folder = scratch / page.parent if page.parts[0] in COPIED else scratch
        self.environment = {**os.environ, "PATH": f"{programs}:{os.environ['PATH']}"}

    def run(self, *command):
        ended = subprocess.run(
            [str(word) for word in command],
            cwd=self.folder,
            env=self.environment,
            capture_output=True,
            text=True,
            timeout=SECONDS,
        )
        return "" if ended.returncode == 0 else f"ended with {ended.returncode}: {ended.stderr}"

    def sh(self, block):
        return self.run("bash", "-euo", "pipefail", "-c", block.text)

    def yaml(self, block):
        keys = yaml.safe_load(block.text)
        if {"scene", "units", "vessels"} <= set(keys):
            scene = self.root / "block.yaml"
            scene.write_text(block.text)
            options = ("--fidelity", "skin", "--no-report", "-o", self.root / "block")
            return self.run("vasorod", "solve", scene, *options)
        schema = json.loads((self.source / "schema" / "scene.schema.json").read_text())
        faults = Draft202012Validator(without_required(schema)).iter_errors(keys)
        return "; ".join(fault.message for fault in faults)

    def python(self, block):
        if ">>>" in block.text:
            tests = (self.source / "tests" / "python" / "test_docs.py").read_text()
            return "" if f'"{self.page}"' in tests else "tests/python/test_docs.py has no such page"
        compile(block.text, str(self.page), "exec")
        return ""

    def cpp(self, block):
        examples = (file.read_text() for file in (self.source / "examples").glob("*.cpp"))
        return self.built(block) if block.text not in examples else ""

    def built(self, block):
        """Whether the test that builds the README's blocks takes this page's."""
        tests = (self.source / "tests" / "docs" / "test_library_block.py").read_text()
        return "" if f'"{self.page}"' in tests else "no example and built by no test"

    cmake = built

    def json(self, block):
        json.loads(block.text)
        return ""

    def text(self, block):
        return ""

    def picture(self, name, shown):
        """Whether the blocks drew the picture that the page shows."""
        apart = difference(self.folder / "pictures" / name, self.source / self.page.parent / shown)
        return f"{apart:.3f} from what the page draws" if apart > LARGEST_DIFFERENCE else ""


def main():
    source, programs, page = Path(sys.argv[1]), Path(sys.argv[2]).resolve(), Path(sys.argv[3])
    there = set(sys.argv[4:])
    found = []
    with tempfile.TemporaryDirectory() as scratch:
        checker = Checker(source, programs, page, Path(scratch))
        for block in blocks_of((source / page).read_text()):
            place = f"{page}:{block.line}: {block.tag or 'no tag'}"
            if not hasattr(checker, block.tag or " "):
                found.append(f"{place}: found this tag, expected sh, yaml, python, cpp or text")
            elif block.not_run:
                print(f"{place}: not run: {block.not_run}")
            elif missing := set(block.needs) - there:
                print(f"{place}: left out, there is no {' and no '.join(sorted(missing))}")
            elif what := getattr(checker, block.tag)(block):
                found.append(f"{place}: {what}")
            else:
                print(f"{place}: {AS_CHECKED.get(block.tag, 'good')}")
        for name, shown in [] if found else drawn_pictures((source / page).read_text()):
            if what := checker.picture(name, shown):
                found.append(f"{page}: {shown}: {what}")
            else:
                print(f"{page}: {shown}: as drawn")
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
