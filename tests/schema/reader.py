"""The program's reader and schema/scene.schema.json know the same keys, types, ranges, words and
defaults. Scenes that use every key are changed in one place at a time, and both must say the same
of each change. Usage: reader.py SOURCE_FOLDER VASOROD."""

import copy
import itertools
import re
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from tree import HERE, Schema, read_scene, run, scene_text, walk
from tree import write_lidded_tube, write_markups, write_tube

source, program = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
schema = Schema(source / "schema" / "scene.schema.json")
scratch = tempfile.TemporaryDirectory()
folder = Path(scratch.name)
write_tube(folder / "tube.obj")
write_tube(folder / "aside.obj", beside=40)
write_lidded_tube(folder / "lidded.vtp")
write_markups(folder / "picks.mrk.json", {"cut": [3.3, 0, 10], "slit": [0, 0, 4]})
files = ("tube.obj", "aside.obj", "lidded.vtp", "picks.mrk.json")
bases = {
    name: read_scene(Path(HERE) / f"{name}.yaml")
    for name in (
        "rods",
        "pressed",
        "surfaces",
        "tubes",
        "opened",
        "picked",
        "inflated",
        "sewn",
        "explored",
    )
}

# Rules that no schema can say, by the program's sentence: they need other parts of the scene, or
# arithmetic.
BEYOND = [
    r"unknown vessel",
    r"the name of another rod of this scene|a ring of parents",
    r"a name no other vessel has",
    r"pair a second time|two different vessels|another vessel",
    r"obstacles never move",
    r"the bare rod .* expected a vessel with a surface",
    r"expected start, end, \{near",
    r"no such file|a label of ",  # of markups
    r"a second condition for the end",
    r"a wall thicker than",
    r"degrees to the tangent|found \[0, 0, 0\], expected a direction",
    r"where the tube meets itself",
    r"a symmetric matrix|positive definite",
    r"a stretch v3 above 0",
    r"nu_LT\^2",
    r"the neo-Hookean law is isotropic|neo-hookean with nu",
    r"on an obstacle",
    r"elements up to here",  # of a rod's pieces together
    r"points around and",  # of a tube's mesh
    r"which belong to one vessel|a vessel without a wall",  # of what is uncertain
    r"pressure in a scene without one",
    r"(factor|offset): \[low, high\] or sd: number|not below the high one|of a factor",
]


REMOVED = object()
WRONG = [None, "wrong", "1", 7.25, True, [7.25], {"wrong": 1}]
numbers = itertools.count()


def get(value, path):
    for step in path:
        value = value[step]
    return value


def changed(scene, path, new):
    """A copy with the value at the path replaced, or removed where `new` is REMOVED."""
    scene = copy.deepcopy(scene)
    inside = get(scene, path[:-1])
    if new is REMOVED:
        del inside[path[-1]]
    else:
        inside[path[-1]] = new
    return scene


def solve(scene, *arguments):
    """The whole program on a scene."""
    k = next(numbers)
    (folder / f"{k}").mkdir()
    for name in files:
        (folder / f"{k}" / name).symlink_to(folder / name)
    file = folder / f"{k}" / "scene.yaml"
    file.write_text(scene_text(scene))
    return run(program, "solve", file, "-o", folder / f"{k}" / "out", "--json", *arguments)


def refusal(scene, whole):
    """What the program says against a scene; None where it takes it. `extrapolate` is read last, so
    a word there stops the program before it solves anything: that is enough unless `whole`."""
    done = solve(scene if whole else {**scene, "extrapolate": "here"})
    if not whole and 'extrapolate: found "here"' in done.error:
        return None
    return done.error if done.code == 2 else None


def samples():
    """For each key of each object a value that a scene has."""
    values = {}
    for scene in bases.values():
        for place in walk(schema, scene):
            if place.key and isinstance(place.path[-1], str):
                values.setdefault((place.title, place.key), place.value)
    return values


def other_values(place):
    """Other values for a place, each with whether it must be refused."""
    node, free = place.schema, "type" not in place.schema and "x-type" in place.schema
    # One word and one text are enough for the entries of a list, which are tried as a whole too.
    for wrong in WRONG[1:3] if isinstance(place.path[-1], int) else WRONG:
        if wrong != place.value:
            yield wrong, wrong == {"wrong": 1} and not free
    for word in node.get("enum", []):
        if word != place.value:
            yield word, False
    for key, offsets in {"minimum": (0, -1), "maximum": (0, 1)}.items():
        if key in node:
            factor = 1.5 if abs(node[key]) > 1e15 else 1
            yield node[key], False
            yield factor * (node[key] + offsets[1]), True
    for key in ("exclusiveMinimum", "exclusiveMaximum"):
        if key in node:
            yield node[key], True
    if isinstance(place.value, list) and place.value:
        yield place.value + place.value[-1:], False
        yield place.value[:-1], False


def changes(scene, values):
    """Changed scenes: (what, the keys beside it, scene, whether it must be refused, whether the
    whole program runs). Two with the same words and keys are alike."""
    for place in walk(schema, scene):
        whole = place.path[:1] in (("fidelity",), ("extrapolate",))
        if whole and scene is not bases["rods"]:
            continue  # a wrong word would not stop it, and these are slower to solve
        if isinstance(place.value, dict) and "properties" in place.schema:
            title, keys = place.schema["title"], frozenset(place.value)
            unknown = changed(scene, (*place.path, "unknown_key"), 1)
            yield f"{title}: an unknown key", None, unknown, True, False
            for key in place.value:
                must = key in place.schema.get("required", [])
                less = changed(scene, (*place.path, key), REMOVED)
                yield f"{title}: without {key}", keys, less, must, False
            for key in place.schema["properties"]:
                if key not in place.value:
                    more = changed(scene, (*place.path, key), values[title, key])
                    yield f"{title}: with {key}", keys, more, False, key in (
                        "extrapolate",
                        "fidelity",
                    )
        if place.path:
            for value, must in other_values(place):
                item = " item" if isinstance(place.path[-1], int) else ""
                label = f"{place.title}.{place.key}{item}: {str(value)[:40]}"
                yield label, None, changed(scene, place.path, value), must, whole


def check_changes():
    values = samples()
    chosen = {}
    for base, scene in bases.items():
        for label, keys, new, must, whole in changes(scene, values):
            chosen.setdefault((label, keys), (f"{base}: {label}", new, must, whole))
    chosen = list(chosen.values())

    faults = [schema.fault(new) for _, new, *_ in chosen]

    def judge(change, fault):
        label, new, must, whole = change
        said = refusal(new, whole)
        if must and not fault:
            return f"{label}: the schema takes it"
        if fault and not said:
            return f"{label}: the program takes it, the schema says {fault}"
        beyond = said and any(re.search(rule, said) for rule in BEYOND)
        if said and not fault and not beyond:
            return f"{label}: the schema takes it, the program says {said}"
        return None

    with ThreadPoolExecutor(2) as pool:
        wrong = [one for one in pool.map(judge, chosen, faults) if one]
    assert not wrong, "\n".join([f"{len(wrong)} of {len(chosen)} changes:", *wrong])
    refused = sum(1 for fault in faults if fault)
    print(f"{len(chosen)} changed scenes: both say the same, {refused} are refused by both")


def check_keys_are_read():
    """Every key is in a scene that the program solves, and the reader's own lists are the same."""
    for name, scene in bases.items():
        fault, done = schema.fault(scene), solve(scene)
        assert not fault and done.code in (0, 1), f"{name}: {fault or done.error}"
    used = set(samples())
    known = {(one["title"], key) for one in schema.objects() for key in one["properties"]}
    assert used == known, f"no scene has {sorted(known - used)}"

    text = "".join(
        re.sub(r"//.*", "", path.read_text())
        for path in sorted((source / "hybrid" / "scene").glob("*.cpp"))
        if path.name != "field.cpp"
    )
    lists = [
        frozenset(re.findall(r'"(\w+)"', group))
        for call in re.findall(r"check_keys\((.*?)\);", text, re.DOTALL)
        for group in re.findall(r"\{([^{}]*)\}", call)
    ]
    objects = {frozenset(one["properties"]): one["title"] for one in schema.objects()}
    for keys in lists:
        assert keys in objects, f"no object of the schema has the keys {sorted(keys)}"
    for keys, title in objects.items():
        assert keys in lists, f"no check_keys of the reader is that of {title}: {sorted(keys)}"
    print(f"{len(known)} keys of {len(objects)} objects are those of the reader")


def check_defaults():
    """A default written out changes no result."""

    def direction(rod, other, with_parent, alone):
        if other in rod:  # it would not stand at right angles to the default
            raise KeyError(other)
        return with_parent if "parent" in rod else alone

    todo = {
        (one["title"], key): schema.resolved(node)["default"]
        for one in schema.objects()
        for key, node in one["properties"].items()
        if "default" in schema.resolved(node)
    }
    # Defaults that depend on other keys: from the scene and the place of the object.
    depends = {
        ("Scene", "contact"): lambda s, p: [["left", "right"]],
        ("Tube", "end_radius"): lambda s, p: get(s, p)["radius"],
        ("Tube", "end_thickness"): lambda s, p: get(s, p[:-1])["wall"]["thickness"],
        ("Transverse moduli", "young"): lambda s, p: get(s, p[:-1])["young"],
        ("Rod", "tangent"): lambda s, p: direction(get(s, p), "normal", [0, 0, 1], [1, 0, 0]),
        ("Rod", "normal"): lambda s, p: direction(get(s, p), "tangent", [1, 0, 0], [0, 1, 0]),
        ("Piece of a rod", "stiffness"): lambda s, p: get(s, p[:-2])["stiffness"],
        ("Natural strain", "u"): lambda s, p: get(s, p[:-1]).get("curvature", [0, 0, 0]),
        ("End", "rotate_deg"): lambda s, p: [0, 0, 0],
        ("End", "move"): lambda s, p: [0, 0, 0],
        ("End", "force"): lambda s, p: [0, 0, 0],
        ("End", "moment"): lambda s, p: [0, 0, 0],
    }
    pairs, left = [], set(todo) | set(depends)
    for base, scene in [*bases.items(), ("pressed", bases["pressed"])]:
        for place in walk(schema, scene):
            if not isinstance(place.value, dict) or "properties" not in place.schema:
                continue
            title = place.schema["title"]
            for key in place.schema["properties"]:
                path = (*place.path, key)
                if (title, key) not in left or (title == "Scene" and base != "pressed"):
                    continue
                without = copy.deepcopy(scene)
                get(without, place.path).pop(key, None)
                try:
                    value = todo.get((title, key), None)
                    if (title, key) in depends:
                        value = depends[title, key](scene, place.path)
                except KeyError:
                    continue
                written = changed(scene, path, value)
                if not schema.fault(without) and not schema.fault(written):
                    pairs.append((f"{base}: {title}.{key} = {value}", without, written))
                    left.discard((title, key))
    assert not left, f"no scene shows the defaults of {sorted(left)}"

    def solved(scene):
        return solve(scene, "--threads", "1")

    def judge(pair):
        label, *scenes = pair
        runs = [alone.get(scene_text(scene)) or solved(scene) for scene in scenes]
        if all(one.code == 2 and "nothing would happen" in one.error for one in runs):
            return None  # without conditions at the ends, as with an empty list of them
        if any(one.code not in (0, 1) for one in runs):
            return f"{label}: {runs[0].error or runs[1].error}"
        return None if runs[0].result == runs[1].result else f"{label}: another result"

    # Most defaults are not written in their scene, which is the same without them.
    with ThreadPoolExecutor(2) as pool:
        alone = dict(
            zip(map(scene_text, bases.values()), pool.map(solved, bases.values()), strict=True)
        )
        wrong = [one for one in pool.map(judge, pairs) if one]
    assert not wrong, "\n".join(wrong)
    print(f"{len(pairs)} defaults written out change no result")


check_keys_are_read()
check_changes()
check_defaults()
