"""The Python reference of the site, Markdown made from the sources: docstrings of the Python files
and the type stub of the compiled part, so nothing has to be built."""

import ast
import inspect
import re

ARGUMENT = re.compile(r"^(\w+(?:, \w+)*): ")
HEAD = """# Python reference

What `import vasorod` has. [The Python package](../docs/python.md) is the manual and has tables of
the attributes of results and vessels. The examples go on from each other, as the tests run them.
"""


def is_list(lines):
    """Whether a paragraph says what arguments are: `name: text`, further lines indented."""
    return ARGUMENT.match(lines[0]) and all(
        ARGUMENT.match(line) or line.startswith(" ") for line in lines
    )


def markdown(text):
    """A docstring as Markdown: arguments as a list, examples as blocks."""
    parts = []
    for paragraph in inspect.cleandoc(text).split("\n\n"):
        lines = paragraph.splitlines()
        if lines[0].startswith(">>>"):
            parts.append("\n".join(["```python", *lines, "```"]))
        elif is_list(lines):
            items = [ARGUMENT.sub(r"- `\1`: ", line) for line in lines]
            parts.append("\n".join(re.sub(r"^ +", "  ", line) for line in items))
        else:
            parts.append(paragraph.replace("``", "`"))
    return "\n\n".join(parts)


def head(function):
    """`name(arguments) -> type`, an argument a line where there are several."""
    arguments = ast.unparse(function.args)
    if len(arguments) > 60:
        arguments = re.sub(r", (?=\w+: |\*, )", ",\n    ", arguments)
        arguments = f"\n    {arguments},\n"
    result = f" -> {ast.unparse(function.returns)}" if function.returns else ""
    return f"```text\n{function.name}({arguments}){result}\n```"


def is_property(function):
    return any(ast.unparse(decorator) == "property" for decorator in function.decorator_list)


def class_members(node):
    """A table of attributes, then the methods, of a class of a stub or a source file."""
    functions = [
        item
        for item in node.body
        if isinstance(item, ast.FunctionDef) and not item.name.startswith("_")
    ]
    rows = [
        f"| `{item.name}` | `{ast.unparse(item.returns)}` |".replace("np.", "")
        for item in functions
        if is_property(item)
    ]
    parts = ["\n".join(["| attribute | type |", "|---|---|", *rows])] if rows else []
    for item in functions:
        if not is_property(item):
            parts.append(head(item))
            if text := ast.get_docstring(item):
                parts.append(markdown(text))
    return parts


def page(package):
    """The reference of the package whose sources are in a folder."""
    start = ast.parse((package / "__init__.py").read_text())
    public = next(
        [name.value for name in node.value.elts]
        for node in start.body
        if isinstance(node, ast.Assign) and node.targets[0].id == "__all__"
    )
    found = {}
    for file in [*sorted(package.glob("*.pyi")), *sorted(package.glob("*.py"))]:
        for node in ast.parse(file.read_text()).body:
            if isinstance(node, (ast.FunctionDef, ast.ClassDef)) and node.name in public:
                found[node.name] = node  # the Python files come last: they have docstrings
    parts = [HEAD.strip(), markdown(ast.get_docstring(start))]
    missing = set(public) - set(found)
    if missing:
        raise ValueError(f"{package}: no source of {', '.join(sorted(missing))}")
    for name in sorted(public, key=lambda name: (isinstance(found[name], ast.ClassDef), name)):
        node = found[name]
        parts.append(f"## {name}")
        if isinstance(node, ast.FunctionDef):
            parts.append(head(node))
        if text := ast.get_docstring(node):
            parts.append(markdown(text))
        if isinstance(node, ast.ClassDef):
            parts += class_members(node)
    return "\n\n".join(parts) + "\n"
