#!/usr/bin/env python3
"""Writes docs/scene.md and docs/result.md from schema/scene.schema.json and
schema/result.schema.json.

    docs/make_reference.py            write both pages
    docs/make_reference.py --check    exit 1 where a page is not what would be written
"""

import argparse
import json
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

NOTE = "<!-- Written by docs/make_reference.py from\n{}; change those and run it. -->"

SCENE_INTRO = """
A scene is one YAML file. It names the vessels, says what happens at their ends, which operation is
done, and how much of it is modelled. `vasorod solve SCENE -o DIR` reads it.

The keys are also described for programs in
[`schema/scene.schema.json`](../schema/scene.schema.json). An editor that knows YAML schemas
completes and checks a scene that begins with

```text
# yaml-language-server: $schema=PATH/TO/schema/scene.schema.json
```

The program stops with exit code 2 and one sentence where a scene is wrong: file, line, key, what
was found, what was expected. A key that is not listed here is refused. Some rules need the whole
scene or its surfaces, so only the program knows them: that a name is that of a vessel, or that a
picked point lies near its surface.

A number is written without quotes. Its unit follows from [`units`](#units): with mm and MPa a force
is in N (force = stress * length^2) and a moment in N mm. Axes are those of space unless said
otherwise.
"""

SCENE_EXAMPLE = """
## Example

This is [`examples/scene.yaml`](../examples/scene.yaml). The Glenn shunt on the bundled anatomy is
`benchmarks/cases/glenn/infant.yaml`, two tubes joined end to end are
`benchmarks/cases/end_to_end/tubes.yaml`, and `benchmarks/cases/rod` has bare rods.
"""

RESULT_INTRO = """
`vasorod solve`, `vasorod fit` and `vasorod-fem solve` write a result folder. The folder is replaced
as a whole, and only if it is absent, empty, or holds an earlier `result.json`.
"""

RESULT_FILES = """
## Files

| file | holds |
| --- | --- |
| `result.json` | everything with a number, described [below](#resultjson) and in [`schema/result.schema.json`](../schema/result.schema.json) |
| `NAME.vtp` | the deformed surface of vessel NAME, obstacles too: points in the order of the input, points that an incision adds after them |
| `NAME_centerline.vtp` | the nodes of its rod in order, one polyline for each branch; not for obstacles |
| `NAME_stump.vtp` | what a cut left behind, closed: points and triangles alone |
| `scene.pvd` | the list of these files, for ParaView |
| `picture_*.png` | the pictures of the report |
| `report.html` | one page that needs no network: pictures, a view in three dimensions, tables |

Point arrays of `NAME.vtp`; all are 64-bit floating-point numbers:

| array | components | unit | meaning |
| --- | --- | --- | --- |
| `RestPosition` | 3 | length | the point at rest |
| `Displacement` | 3 | length | the point minus `RestPosition` |
| `AxialStretch` | 1 | none | stretch of the fibre along the axis through the point; 1 at rest |
| `TwistShear` | 1 | none | change of twist times the point's distance from the axis at rest |
| `ContactPressure` | 1 | stress | pressure of contact; 0 where there is none, and where contact is not modelled |

The point and cell arrays of a surface file come along with their types. One that has the name of an
array above is kept as `NAME_input`.

Field data of every VTP file; each is one text:

| array | meaning |
| --- | --- |
| `Units` | the units of its numbers, as `length mm, stress MPa` |
| `Program` | name and version of the program that wrote it |
| `SceneHash` | SHA-256 of the scene file; with `vasorod fit` of the surface |
| `SPACE` | `LPS` or `RAS`; only where the surface file of the vessel says so, as those of 3D Slicer do. A scene whose vessels lie in different spaces is refused |

Point arrays of `NAME_centerline.vtp`:

| array | components | unit | meaning |
| --- | --- | --- | --- |
| `Abscissas` | 1 | length | arc length at rest from the start of the branch |
| `MaximumInscribedSphereRadius` | 1 | length | radius at rest; only where there is a surface |
| `Director1`, `Director2`, `Director3` | 3 | none | the section's frame; the third is along the axis |
| `RestPosition` | 3 | length | the node at rest |
| `u`, `u0` | 3 | 1/length | curvatures and twist, now and at rest |
| `v`, `v0` | 3 | none | shears and stretch, now and at rest |
| `LumenArea` | 1 | length^2 | area of the lumen now; nan where the section is not one closed curve (forks, ends, the incision); not at fidelity `rod` |
| `Flattening` | 1 | none | 1 - H / H_rest, H the narrowest mid-wall width; nan as `LumenArea` |
| `SectionForce`, `SectionMoment` | 3 | force, force\\*length | force and moment of the section in its own axes; bare rods only |
"""  # noqa: E501

EXIT_CODES = """
## Exit codes

| code | meaning |
| --- | --- |
| 0 | the status is `converged` |
| 1 | any other status; the result is written all the same. Stopped before there was a state: one sentence, no result |
| 2 | wrong input or usage, said in one sentence |
| 3 | the file system said no, the memory does not suffice, or an unexpected error |
"""  # noqa: E501

RESULT_JSON = """
## result.json

Numbers read back to the same double. A number that is not finite is `null`. Status and validity are
apart: the status says whether the discrete minimum was found, `validity` whether the model is in
its range there. Forces are stress * length^2, energies stress * length^3.
"""

ONLY = {
    "vasorod-fem": "`vasorod-fem` only",
    "glenn": "with a Glenn shunt only",
    "end_to_end": "with an end-to-end join only",
    "surgery": "with a surgery only",
    "paper": "fidelity `paper` only",
}


def anchor(title):
    return title.lower().replace(" ", "-")


class Page:
    """The Markdown of one schema."""

    def __init__(self, schema):
        self.schema = schema
        self.lines = []

    def resolved(self, node):
        """The node with what it refers to; its own words take precedence."""
        if "$ref" not in node:
            return node
        target = self.schema["$defs"][node["$ref"].rsplit("/", 1)[1]]
        return {**self.resolved(target), **{k: v for k, v in node.items() if k != "$ref"}}

    def object_type(self, node):
        """A link where a node, or each item of it, is an object with its own table."""
        if "$ref" not in node:
            return None
        target = self.schema["$defs"][node["$ref"].rsplit("/", 1)[1]]
        if target.get("type") != "object":
            return None
        return f"[{target['title'].lower()}](#{anchor(target['title'])})"

    def type_of(self, node):
        if link := self.object_type(node):
            return link
        node = self.resolved(node)
        if "x-type" in node:
            return node["x-type"]
        if "const" in node:
            return f"`{node['const']}`"
        if "enum" in node:
            words = [f"`{word}`" for word in node["enum"]]
            return ", ".join(words[:-1]) + " or " + words[-1]
        kind = node["type"]
        if kind == "array":
            return "list of " + self.type_of(node["items"])
        if isinstance(kind, list):
            return " or ".join(self.type_of({"type": one}) for one in kind)
        names = {"string": "text", "boolean": "true or false", "integer": "whole number"}
        return (names.get(kind, kind) + " " + limits(node)).strip()

    def row(self, key, node, required):
        full = self.resolved(node)
        meaning = full["description"]
        only = ONLY.get(full.get("x-only"))
        if only and only.strip("`") not in meaning.replace("`", "") and "only" not in meaning:
            meaning = meaning.rstrip(".") + f"; {only}."
        default = ""
        if required:
            default = "required"
        elif "x-default" in full:
            default = full["x-default"]
        elif "default" in full:
            default = f"`{json.dumps(full['default'])}`".replace('"', "")
        unit = full.get("x-unit", "")
        unit = "" if unit == "none" else unit.replace("*", "\\*")
        cells = [f"`{key}`", self.type_of(node), unit, default, meaning]
        return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"

    def table(self, node, defaults):
        head = ["key", "type", "unit", "default" if defaults else "", "meaning"]
        rows = [
            self.row(key, value, defaults and key in node.get("required", []))
            for key, value in node["properties"].items()
        ]
        if not defaults:  # a result has no defaults: the column says what may be absent
            head[3] = "present"
            rows = []
            for key, value in node["properties"].items():
                cells = self.row(key, value, False).split(" | ")
                cells[3] = "always" if key in node.get("required", []) else "not always"
                rows.append(" | ".join(cells))
        self.add("| " + " | ".join(head) + " |", "| --- | --- | --- | --- | --- |", *rows, "")

    def meanings(self, key, node=None):
        words = (node or self.schema)["properties"][key]["x-meaning"]
        self.add(f"| {key} | meaning |", "| --- | --- |")
        self.add(*(f"| `{word}` | {text} |" for word, text in words.items()), "")

    def objects(self, level, defaults):
        for node in self.schema["$defs"].values():
            if node.get("type") != "object":
                continue
            self.add(f"{level} {node['title']}", "", *wrapped(node["description"]), "")
            self.table(node, defaults)
            for key, value in node["properties"].items():
                if "x-meaning" in value:
                    self.meanings(key, node)

    def add(self, *lines):
        self.lines += lines

    def text(self):
        return "\n".join(self.lines).rstrip() + "\n"


def limits(node):
    """ "> 0" and the like; empty where every number is meant."""
    low, high = node.get("minimum"), node.get("maximum")
    above, below = node.get("exclusiveMinimum"), node.get("exclusiveMaximum")
    if low is not None and high is not None:
        return f"{low} to {high}"
    parts = [("≥", low), (">", above), ("≤", high), ("<", below)]
    return ", ".join(f"{sign} {value}" for sign, value in parts if value is not None)


def wrapped(text, width=100):
    lines = [""]
    for word in text.split():
        if len(lines[-1]) + 1 + len(word) > width:
            lines.append("")
        lines[-1] = f"{lines[-1]} {word}".strip()
    return lines


def read(name):
    return json.loads((ROOT / "schema" / name).read_text())


def scene_page():
    page = Page(read("scene.schema.json"))
    page.add("# Scene files", "", NOTE.format("schema/scene.schema.json and examples/scene.yaml"))
    page.add(*SCENE_INTRO.splitlines(), *SCENE_EXAMPLE.splitlines(), "")
    page.add("```yaml", *(ROOT / "examples" / "scene.yaml").read_text().splitlines(), "```", "")
    page.add("## The whole file", "", "Either `fidelity` or `accuracy` is given.", "")
    page.table(page.schema, True)
    page.meanings("fidelity")
    page.objects("##", True)
    return page.text()


def result_page():
    page = Page(read("result.schema.json"))
    page.add("# Results", "", NOTE.format("schema/result.schema.json"))
    page.add(*RESULT_INTRO.splitlines(), *RESULT_FILES.splitlines(), *EXIT_CODES.splitlines())
    page.add(*RESULT_JSON.splitlines(), "")
    page.table(page.schema, False)
    page.meanings("status")
    page.objects("###", False)
    return page.text()


LIBRARY_INTRO = """
The library is the hybrid model without the command line. `vasorod::predict` takes a scene and
returns a result; both are plain data. Build and install it, then link `vasorod::vasorod`:

<!-- not run: builds the project; tests/consumer does the rest -->

```sh
./run build
cmake --install build --prefix DIR
cmake -S examples -B build-examples -DCMAKE_PREFIX_PATH=DIR
cmake --build build-examples
```

The public headers are those of `hybrid/include/vasorod`, included as `<vasorod/...>`:
"""

EXAMPLES = {"rod": "A bare rod", "tube": "A tube, bent and compared", "glenn": "A Glenn operation"}


def library_page():
    lines = ["# The library", "", NOTE.format("hybrid/include/vasorod and examples")]
    lines += [*LIBRARY_INTRO.splitlines(), "", "| header | holds |", "|---|---|"]
    for header in sorted((ROOT / "hybrid" / "include" / "vasorod").glob("*.h")):
        head = header.read_text().split("#pragma once")[0]
        comment = " ".join(line.removeprefix("//").strip() for line in head.splitlines())
        lines.append(f"| `<vasorod/{header.name}>` | {comment.strip()} |")
    lines += [
        "",
        "The tests build these three programs against the installed library and run them.",
    ]
    for name, title in EXAMPLES.items():
        code = (ROOT / "examples" / f"{name}.cpp").read_text().splitlines()
        lines += ["", f"## {title}", "", f"`examples/{name}.cpp`:", "", "```cpp", *code, "```"]
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter
    )
    parser.add_argument("--check", action="store_true", help="write nothing, compare only")
    options = parser.parse_args()
    old = 0
    pages = {"scene.md": scene_page(), "result.md": result_page(), "library.md": library_page()}
    for name, text in pages.items():
        file = ROOT / "docs" / name
        if not options.check:
            file.write_text(text)
        elif not file.exists() or file.read_text() != text:
            print(f"docs/{name} is not up to date: run docs/make_reference.py")
            old = 1
    return old


if __name__ == "__main__":
    sys.exit(main())
