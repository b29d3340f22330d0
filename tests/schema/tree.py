"""What the schema tests share: scenes as the program reads them, runs of the program, and walks
through a schema beside a value."""

import json
import math
import re
import subprocess
from dataclasses import dataclass

import jsonschema
import yaml

HERE = __file__.rsplit("/", 1)[0]


class SceneLoader(yaml.SafeLoader):
    """Plain scalars as the program and YAML 1.2 read them: 1e-6 is a number, yes is a word."""


SceneLoader.yaml_implicit_resolvers = {}
for tag, pattern, first in [
    ("null", r"~|null|Null|NULL|", "~nN"),
    ("bool", r"true|True|TRUE|false|False|FALSE", "tTfF"),
    ("int", r"[-+]?[0-9]+", "-+0123456789"),
    ("float", r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?", "-+.0123456789"),
]:
    SceneLoader.add_implicit_resolver(
        f"tag:yaml.org,2002:{tag}",
        re.compile(f"^(?:{pattern})$"),
        [*first] + [""] * (tag == "null"),
    )
SceneLoader.add_constructor(
    "tag:yaml.org,2002:float", lambda loader, node: float(loader.construct_scalar(node))
)
SceneLoader.add_constructor(
    "tag:yaml.org,2002:int", lambda loader, node: int(loader.construct_scalar(node))
)


def read_scene(path):
    return yaml.load(path.read_text(), SceneLoader)


def scene_text(scene):
    return yaml.safe_dump(scene, sort_keys=False, default_flow_style=None, width=200)


class Schema:
    def __init__(self, file):
        self.root = json.loads(file.read_text())
        jsonschema.Draft202012Validator.check_schema(self.root)
        self.validator = jsonschema.Draft202012Validator(self.root)

    def fault(self, value):
        """Why a value is not valid, as one sentence; None where it is."""
        error = jsonschema.exceptions.best_match(self.validator.iter_errors(value))
        return f"{error.json_path}: {error.message[:200]}" if error else None

    def resolved(self, node):
        """The node with what it refers to, and the title of the object it is."""
        if not isinstance(node, dict) or "$ref" not in node:
            return node
        target = self.resolved(self.root["$defs"][node["$ref"].rsplit("/", 1)[1]])
        return {**target, **{key: value for key, value in node.items() if key != "$ref"}}

    def objects(self):
        """Every object that lists its keys."""
        yield self.root
        for node in self.root["$defs"].values():
            if "properties" in node:
                yield node


@dataclass
class Place:
    """A value inside a document, with its schema and the way to it."""

    path: tuple
    schema: dict
    value: object
    title: str = ""  # of the object it belongs to
    key: str = ""

    @property
    def label(self):
        return ".".join(str(step) for step in self.path) or "the document"


def walk(schema, value, node=None, path=(), title="", key=""):
    """The value and everything in it, as Places."""
    node = schema.resolved(schema.root if node is None else node)
    for one in node.get("oneOf", []):
        one = schema.resolved(one)
        if isinstance(value, dict) and set(value) <= set(one.get("properties", {})):
            words = {k: v for k, v in node.items() if k != "oneOf"}
            node = {**words, **one}
    yield Place(path, node, value, title, key)
    if isinstance(value, dict):
        for name, inner in value.items():
            if name in node.get("properties", {}):
                below = node["properties"][name]
                yield from walk(schema, inner, below, (*path, name), node["title"], name)
    elif isinstance(value, list) and isinstance(node.get("items"), dict):
        for k, inner in enumerate(value):
            yield from walk(schema, inner, node["items"], (*path, k), title, key)


@dataclass
class Run:
    code: int
    text: str
    error: str

    @property
    def result(self):
        """Without what may differ from run to run."""
        value = json.loads(self.text)
        return {k: v for k, v in value.items() if k not in ("seconds", "environment")}


def run(program, *arguments):
    command = [str(program), *(str(one) for one in arguments)]
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=300)
    return Run(done.returncode, done.stdout, done.stderr.strip())


def write_lidded_tube(path, radius=3.3, low=5.0, high=45.0, around=24, along=40):
    """A closed tube along z as a VTP file: ModelFaceID 1 on its wall, 2 and 3 on its lids."""
    points, triangles, faces = [], [], []
    for j in range(along + 1):
        for i in range(around):
            angle = 2 * math.pi * (i + 0.5 * (j % 2)) / around
            z = low + (high - low) * j / along
            points.append((radius * math.cos(angle), radius * math.sin(angle), z))
    for j in range(along):
        for i in range(around):
            a, b = j * around + i, j * around + (i + 1) % around
            c, d = a + around, b + around
            triangles += [(a, b, c), (b, d, c)] if j % 2 == 0 else [(a, b, d), (a, d, c)]
    faces += [1] * len(triangles)
    for face, ring, z in ((2, 0, low), (3, along * around, high)):
        middle = len(points)
        points.append((0, 0, z))
        for i in range(around):
            edge = (ring + i, ring + (i + 1) % around)
            triangles.append((middle, *(edge if face == 3 else edge[::-1])))
            faces.append(face)

    def array(kind, name, values, rest=""):
        text = " ".join(f"{value:.9g}" for value in values)
        return f'<DataArray type="{kind}" Name="{name}"{rest} format="ascii">{text}</DataArray>'

    path.write_text(
        '<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian"><PolyData>'
        f'<Piece NumberOfPoints="{len(points)}" NumberOfPolys="{len(triangles)}">'
        f'<CellData>{array("Int32", "ModelFaceID", faces)}</CellData><Points>'
        + array("Float64", "Points", sum(points, ()), ' NumberOfComponents="3"')
        + "</Points><Polys>"
        + array("Int64", "connectivity", sum(triangles, ()))
        + array("Int64", "offsets", range(3, 3 * len(triangles) + 1, 3))
        + "</Polys></Piece></PolyData></VTKFile>"
    )


def write_markups(path, points):
    """Points by label, as 3D Slicer saves them."""
    known = [{"label": label, "position": place} for label, place in points.items()]
    markup = {"type": "Fiducial", "coordinateSystem": "LPS", "controlPoints": known}
    path.write_text(json.dumps({"markups": [markup]}))


def write_tube(path, beside=0.0, radius=10.0, length=60.0, around=16, along=16):
    """An open tube of triangles as an OBJ file."""
    lines = []
    for j in range(along + 1):
        for i in range(around):
            angle = 2 * math.pi * (i + 0.5 * (j % 2)) / around
            x, y = beside + radius * math.cos(angle), radius * math.sin(angle)
            lines.append(f"v {x:.9f} {y:.9f} {length * j / along:.9f}")
    for j in range(along):
        for i in range(around):
            a, b = j * around + i + 1, j * around + (i + 1) % around + 1
            c, d = a + around, b + around
            if j % 2 == 0:
                lines += [f"f {a} {b} {c}", f"f {b} {d} {c}"]
            else:
                lines += [f"f {a} {b} {d}", f"f {a} {d} {c}"]
    path.write_text("\n".join(lines) + "\n")
