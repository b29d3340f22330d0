"""blocks.py and check_links.py on small pages: what they must see, and that they are content where
nothing is wrong. Usage: sees_faults.py SOURCE"""

import subprocess
import sys
import tempfile
from pathlib import Path

from blocks import blocks_of
from pictures import difference, drawn_pictures

SOURCE = Path(sys.argv[1])
PAGE = """# Title

```sh
echo one
```

<!-- not run: takes hours -->

```sh
echo two
```

1. In a list

   ```yaml
   a: 1
     # deeper
   ```

<!-- needs gmsh and vasorod-fem -->
```
echo three
```
"""

first, second, third, fourth = blocks_of(PAGE)
assert (first.tag, first.text, first.line) == ("sh", "echo one\n", 3)
assert not first.not_run and second.not_run == "takes hours"
assert (third.tag, third.text, third.not_run) == ("yaml", "a: 1\n  # deeper\n", "")
assert (fourth.tag, fourth.needs) == ("", ("gmsh", "vasorod-fem"))
try:
    blocks_of("```sh\necho")
    raise AssertionError("a block without an end is not seen")
except ValueError:
    pass


# Pictures: what a page draws and shows, and how far two of them are apart.
SHOWN = "vasorod draw r -o pictures/a.png\n![A](images/x/a.png)\n![B](images/x/b.png)\n"
assert drawn_pictures(SHOWN) == [("a.png", "images/x/a.png")]
images = SOURCE / "docs" / "images" / "patient"
assert difference(images / "pressure.png", images / "pressure.png") == 0
assert difference(images / "pressure.png", images / "without.png") > 0.01


def said(pages):
    """What check_links.py prints about a site, and its exit code."""
    with tempfile.TemporaryDirectory() as folder:
        for name, text in pages.items():
            (Path(folder) / name).write_text(text)
        run = subprocess.run(
            [sys.executable, str(SOURCE / "docs" / "site" / "check_links.py"), folder],
            capture_output=True,
            text=True,
        )
        return run.returncode, run.stdout


GOOD = {"a.html": '<a href="b.html#x">b</a>', "b.html": '<p id="x"><a href="https://e.org">e</a>'}
assert said(GOOD)[0] == 0, said(GOOD)
for change, words in [
    ({"a.html": '<a href="c.html">c</a>'}, "leads to nothing"),
    ({"a.html": '<a href="../a.html">c</a>'}, "leads to nothing"),
    ({"a.html": '<a href="b.html#y">c</a>'}, "no such anchor"),
    ({"a.html": '<script src="https://e.org/x.js"></script>'}, "another machine"),
    ({"a.html": '<link rel="stylesheet" href="//e.org/x.css">'}, "another machine"),
    ({"a.css": "@font-face { src: url(https://e.org/x.woff) }"}, "another machine"),
]:
    code, text = said({**GOOD, **change})
    assert code == 1 and words in text, (change, code, text)


def checked(text):
    """What check_page.py says about a page of a tree like the project's, and its exit code."""
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        for name in ("meshes", "benchmarks", "examples", "docs", "schema", "tests"):
            (root / name).symlink_to(SOURCE / name)
        (root / "page.md").write_text(text)
        script = Path(__file__).parent / "check_page.py"
        run = subprocess.run(
            [sys.executable, str(script), folder, str(root), "page.md"],
            capture_output=True,
            text=True,
        )
        return run.returncode, run.stdout + run.stderr


assert checked("```sh\ntest -d meshes\n```\n")[0] == 0
assert "left out, there is no gmsh" in checked("<!-- needs gmsh -->\n```sh\nfalse\n```\n")[1]
for block, words in [
    ("```\nls\n```", "no tag"),
    ("```sh\nfalse\necho\n```", "page.md:1: sh: ended with 1"),
    ("```yaml\nvessels:\n  - {name: svc, presure: 5}\n```", "presure"),
    ("```yaml\nunits: {length: inch}\n```", "inch"),
    ("```python\n>>> 1 + 1\n3\n```", "no such page"),
    ("```python\nprint(\n```", "SyntaxError"),
    ("```cpp\nint main() {}\n```", "no example"),
]:
    code, text = checked(f"{block}\n")
    assert code == 1 and words in text, (block, code, text)
