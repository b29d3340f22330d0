"""check.py on small trees: what it must see, and that it is content where nothing is wrong."""

import tempfile
from pathlib import Path

import check

HEAD = "| file | covered by |\n|---|---|\n"


def tree(root, files):
    """Writes files, {path: text}, below root."""
    for name, text in files.items():
        path = root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


def said(changes):
    """The faults of a good tree with some files changed; None takes one away."""
    files = {
        "hybrid/rod/link.cpp": "",
        "hybrid/rod/newton.cpp": "",
        "reference_fem/law.cpp": "",
        "tests/rod/CMakeLists.txt": "test_newton.cpp",
        "tests/rod/test_newton.cpp": "TEST(Newton, Converges) {}",
        "tests/reference_fem/CMakeLists.txt": "test_law.cpp",
        "tests/reference_fem/test_law.cpp": "TEST(Law, IsOne) {}",
        "tests/README.md": HEAD + "| `hybrid/rod/link.cpp` | `rod/test_newton.cpp`: `Newton` |\n",
    }
    files.update(changes)
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        tree(root, {name: text for name, text in files.items() if text is not None})
        return list(check.faults(root))


def expect(changes, *words):
    """Exactly one fault, with these words in it."""
    found = said(changes)
    assert len(found) == 1, found
    for word in words:
        assert word in found[0], found[0]


def row(cell, source="hybrid/rod/link.cpp"):
    """A README with one row."""
    return {"tests/README.md": f"{HEAD}| `{source}` | {cell} |\n"}


assert said({}) == []
expect({"tests/README.md": HEAD}, "hybrid/rod/link.cpp", "neither")
expect({"hybrid/app/main.cpp": ""}, "hybrid/app/main.cpp", "tests/app/test_main.cpp")
expect({"reference_fem/shell.cpp": ""}, "tests/reference_fem/test_shell.cpp")
expect({"tests/reference_fem/CMakeLists.txt": ""}, "test_law.cpp is built by no")
expect(row("`rod/test_gone.cpp`"), "rod/test_gone.cpp", "not there")
expect(row("`rod/test_newton.cpp`: `Elimination`"), "Elimination is in none")
expect(row("`rod/test_newton.cpp`: `Newton.Diverges`"), "Newton.Diverges is in none")
expect(row("nothing to speak of"), "names no test source")
GOOD = HEAD + "| `hybrid/rod/link.cpp` | `rod/test_newton.cpp`: `Newton.Converges` |\n"
assert said({"tests/README.md": GOOD}) == []
expect({"tests/README.md": GOOD + GOOD.replace(HEAD, "")}, "twice")
EXTRA = "| `hybrid/rod/spring.cpp` | `rod/test_newton.cpp` |\n"
expect({"tests/README.md": GOOD + EXTRA}, "hybrid/rod/spring.cpp is not there")
EXTRA = "| `hybrid/rod/newton.cpp` | `rod/test_newton.cpp` |\n"
expect({"tests/README.md": GOOD + EXTRA}, "needs no row")

assert said({"docs/trust.md": "`Newton.Converges` and `Law`"}) == []
expect({"docs/trust.md": "`Newton.Diverges`"}, "docs/trust.md", "Newton.Diverges")
