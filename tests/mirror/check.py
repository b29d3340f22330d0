"""Every .cpp has a test of its name, or a row of the table in tests/README.md that says what covers
it. The tests that docs/trust.md names exist. Usage: check.py SOURCE_FOLDER"""

import re
import sys
from pathlib import Path

ROOTS = ("hybrid", "reference_fem")
ROW = re.compile(r"^\| `([^`]+\.cpp)` \| (.+) \|$")
SOURCE = re.compile(r"`([^`]+\.(?:cpp|py))`")
SUITE = re.compile(r"`([A-Z]\w*)(?:\.(\w+))?`")
CASE = re.compile(r"\bTEST(?:_[FP])?\(\s*(\w+),\s*(\w+)\s*\)")


def sources(root):
    """Every .cpp below the roots, relative to the source folder."""
    return sorted(
        path.relative_to(root).as_posix() for name in ROOTS for path in (root / name).rglob("*.cpp")
    )


def own_test(source):
    """The test that mirrors a source: hybrid/rod/link.cpp has tests/rod/test_link.cpp."""
    path = Path(source)
    room = path.parent
    if room.parts[0] == "hybrid":
        room = Path(*room.parts[1:])
    return (Path("tests") / room / f"test_{path.name}").as_posix()


def is_built(root, test):
    """Whether a CMakeLists of the test's folder names it."""
    text = (root / test).parent.joinpath("CMakeLists.txt")
    return text.is_file() and Path(test).name in text.read_text()


def table(root):
    """The rows of tests/README.md: {source: the cell that says what covers it}."""
    rows, twice = {}, []
    for line in (root / "tests" / "README.md").read_text().splitlines():
        if match := ROW.match(line):
            if match[1] in rows:
                twice.append(f"tests/README.md: {match[1]} stands twice in the table")
            rows[match[1]] = match[2]
    return rows, twice


def row_faults(root, source, cell):
    """What is wrong with one row."""
    tests = SOURCE.findall(cell)
    if not tests:
        yield f"tests/README.md: the row of {source} names no test source"
    cases = set()
    for test in tests:
        path = root / "tests" / test
        if not path.is_file():
            yield f"tests/README.md: {source} is said to be covered by {test}, which is not there"
            continue
        cases.update(CASE.findall(path.read_text()))
        if test.endswith(".cpp") and not is_built(root, f"tests/{test}"):
            yield f"tests/README.md: {test}, which covers {source}, is built by no CMakeLists"
    for suite, case in SUITE.findall(cell):
        if not any(s == suite and case in ("", c) for s, c in cases):
            wanted = f"{suite}.{case}" if case else suite
            yield f"tests/README.md: {wanted} is in none of the tests named for {source}"


def trust_faults(root):
    """The tests that docs/trust.md names and that are not there."""
    page = root / "docs" / "trust.md"
    if not page.is_file():
        return
    cases = {
        c for test in (root / "tests").rglob("test_*.cpp") for c in CASE.findall(test.read_text())
    }
    suites = {suite for suite, _ in cases}
    for suite, case in SUITE.findall(page.read_text()):
        if (suite, case) not in cases and (case or suite not in suites):
            yield f"docs/trust.md: {suite}.{case} is no test"


def faults(root):
    """Everything that is wrong, one sentence each."""
    all_sources = sources(root)
    if len(all_sources) == 0:
        yield f"no sources below {root}"
    rows, twice = table(root)
    yield from twice
    for source in all_sources:
        test = own_test(source)
        if (root / test).is_file():
            if not is_built(root, test):
                yield f"{test} is built by no CMakeLists"
            if source in rows:
                yield f"tests/README.md: {source} has a test of its own and needs no row"
        elif source not in rows:
            yield f"{source} has neither {test} nor a row in tests/README.md"
    for source, cell in rows.items():
        if source not in all_sources:
            yield f"tests/README.md: {source} is not there"
        yield from row_faults(root, source, cell)
    yield from trust_faults(root)


if __name__ == "__main__":
    FOUND = list(faults(Path(sys.argv[1]).resolve()))
    print("\n".join(FOUND) or "every source has its test")
    sys.exit(1 if FOUND else 0)
