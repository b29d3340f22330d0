"""The hand-written types of the compiled part are those of the module, and every public name has a
docstring and a type for each argument."""

import ast
import inspect
import re
import unittest
from pathlib import Path

import vasorod
from vasorod import _core

STUB = ast.parse(Path(vasorod.__file__).with_name("_core.pyi").read_text())
PLAIN = {"bool": "bool", "int": "int", "float": "float", "str": "str"}


def signature_in(text, name):
    """The signature that pybind11 writes at the head of a docstring, as Python knows it."""
    line = text.splitlines()[0]
    line = re.sub(r"[\w.]*\b_core\.", "", line)
    return ast.parse(f"def {line}: ...").body[0]


def arguments_of(function):
    """(name, whether by keyword only, whether with a default) of each argument but self."""
    a = function.args
    positional = [(arg.arg, False) for arg in a.posonlyargs + a.args]
    without = len(positional) - len(a.defaults)
    found = [(name, only, k >= without) for k, (name, only) in enumerate(positional)]
    found += [(arg.arg, True, d is not None) for arg, d in zip(a.kwonlyargs, a.kw_defaults)]
    return [argument for argument in found if argument[0] != "self"]


def types_of(function):
    """What of the types can be compared: plain ones, and whether None is accepted."""
    found = {}
    for arg in function.args.args + function.args.kwonlyargs:
        text = ast.unparse(arg.annotation) if arg.annotation else ""
        optional = text.startswith("Optional[")
        inner = text.removeprefix("Optional[").removesuffix("]") if optional else text
        if inner in PLAIN:
            found[arg.arg] = (inner, optional)
    return found


class Stubs(unittest.TestCase):
    def test_every_class_and_function_is_typed_and_nothing_else(self):
        typed = {
            node.name for node in STUB.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))
        }
        there = {name for name in vars(_core) if not name.startswith("_")}
        self.assertEqual(typed, there)

    def test_functions_take_what_they_are_said_to_take(self):
        for node in STUB.body:
            if isinstance(node, ast.FunctionDef):
                self.compare(node, getattr(_core, node.name))

    def test_classes_have_the_members_that_they_are_said_to_have(self):
        for node in STUB.body:
            if not isinstance(node, ast.ClassDef):
                continue
            there = getattr(_core, node.name)
            typed = {member.name: member for member in node.body}
            public = {name for name in vars(there) if not name.startswith("_")}
            self.assertEqual(set(typed), public, node.name)
            for name, member in typed.items():
                is_property = isinstance(vars(there)[name], property)
                said = any(ast.unparse(d) == "property" for d in member.decorator_list)
                self.assertEqual(said, is_property, f"{node.name}.{name}")
                if not is_property:
                    self.compare(member, getattr(there, name))

    def compare(self, typed, there):
        said = signature_in(there.__doc__, typed.name)
        self.assertEqual(arguments_of(typed), arguments_of(said), typed.name)
        mine, module = types_of(typed), types_of(said)
        for name in mine.keys() & module.keys():
            self.assertEqual(mine[name], module[name], f"{typed.name}({name})")
        returned = ast.unparse(typed.returns), ast.unparse(said.returns)
        if "Any" not in returned[0]:
            self.assertEqual(*(text.replace("List", "list") for text in returned), typed.name)

    def test_the_values_have_the_types(self):
        """Every property of a result, with the outermost type that the stub states."""
        scene = {
            "scene": "s",
            "units": {"length": "mm", "stress": "MPa"},
            "vessels": [
                {
                    "name": "tube",
                    "tube": {"length": 50, "radius": 10, "around": 12, "along": 8},
                    "wall": {"thickness": 1, "young": 1, "poisson": 0.3},
                }
            ],
            "ends": [{"vessel": "tube", "end": "end", "hold": True}],
            "fidelity": "skin",
        }
        result = vasorod.solve(scene)
        vessel = result.vessels["tube"]
        objects = {
            "Scene": vasorod.Scene(scene)._core,
            "Result": result,
            "Vessel": vessel,
            "Centerline": vessel.centerline,
            "Comparison": vasorod.compare(result, result),
        }
        for node in STUB.body:
            if not isinstance(node, ast.ClassDef) or node.name not in objects:
                continue
            for member in node.body:
                if not member.decorator_list:
                    continue
                value = getattr(objects[node.name], member.name)
                text = ast.unparse(member.returns)
                if value is None:
                    self.assertTrue(text.startswith("Optional["), f"{node.name}.{member.name}")
                    continue
                text = text.removeprefix("Optional[").split("[")[0].rstrip("]")
                found = type(value).__name__.replace("ndarray", "NDArray")
                self.assertEqual(found, text, f"{node.name}.{member.name}")


class Docstrings(unittest.TestCase):
    def test_every_public_name_has_one(self):
        for name in vasorod.__all__:
            thing = getattr(vasorod, name)
            self.assertTrue(thing.__doc__, name)
            self.assertEqual(thing.__module__, "vasorod", name)
            if inspect.isclass(thing):
                for member, value in vars(thing).items():
                    if not member.startswith("_"):
                        self.assertTrue(value.__doc__, f"{name}.{member}")

    def test_every_argument_has_a_type(self):
        for name in vasorod.__all__:
            thing = getattr(vasorod, name)
            if inspect.isfunction(thing) or thing is vasorod.Scene:
                signature = inspect.signature(thing)
                for argument in signature.parameters.values():
                    self.assertIsNot(argument.annotation, inspect.Parameter.empty, name)

    def test_the_package_says_that_it_is_typed(self):
        self.assertTrue(Path(vasorod.__file__).with_name("py.typed").exists())


if __name__ == "__main__":
    unittest.main()
