"""One panel through the real program: the page, its pictures, its numbers and the manifest agree,
the page says what is missing, a finished run is kept, and what is wrong would be seen.
Usage: page.py SOURCE_FOLDER VASOROD."""

import shlex
import shutil
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

import yaml

from faults import Page, faults

SOURCE, PROGRAM = Path(sys.argv[1]), Path(sys.argv[2])
DRIVER = SOURCE / "benchmarks" / "reproduce" / "reproduce.py"
PANELS = ("fig1", "fig2", "fig3abc", "fig3d", "fig4ab", "fig4cde", "fig5", "section4")


def reproduce(folder, *options):
    return subprocess.run(
        [sys.executable, str(DRIVER), "--quick", "-o", str(folder), *options],
        capture_output=True,
        text=True,
    )


with tempfile.TemporaryDirectory() as scratch:
    folder = Path(scratch) / "page"
    options = ("--programs", str(PROGRAM.parent), "--only", "fig2")
    done = reproduce(folder, *options)
    assert done.returncode == 0, done.stderr
    assert faults(folder) == [], faults(folder)
    text = (folder / "index.html").read_text()
    page = Page(text)
    assert page.panels == ["fig2", "departures"], page.panels
    for name in PANELS:
        assert (f"<li>{name}: not asked for</li>" in text) == (name != "fig2"), name
    assert len(page.pictures) == 4 and len(page.numbers) == 4
    for file in page.pictures:
        head = (folder / file).read_bytes()[:24]
        assert head[:8] == b"\x89PNG\r\n\x1a\n", file
        assert min(struct.unpack(">II", head[16:24])) >= 400, file
    models, picks = (
        (folder / f"{name}.png").read_bytes() for name in ("fig2a_models", "fig2b_picks")
    )
    assert models != picks, "the picks are drawn"

    # The commands of the manifest make the pictures that stand on the page.
    entries = yaml.safe_load((folder / "codecheck.yml").read_text())["manifest"]
    drawn = [entry for entry in entries if entry["command"].startswith("vasorod draw ")]
    assert len(drawn) == 3
    for entry in drawn:
        picture = (folder / entry["file"]).read_bytes()
        (folder / entry["file"]).unlink()
        words = [str(PROGRAM), *shlex.split(entry["command"])[1:]]
        subprocess.run(words, cwd=folder, check=True)
        assert (folder / entry["file"]).read_bytes() == picture, entry["command"]

    # What the test looks for would be found.
    numbers = next(
        shown for claim, shown in page.numbers if claim["data-key"].endswith("perimeter")
    )
    assert text.count(f">{numbers}<") == 1
    for wrong, why in (
        (text.replace(f">{numbers}<", ">1.234<"), "perimeter"),
        (text.replace("</body>", '<a href="https://example.org">x</a></body>'), "elsewhere"),
        (text.replace("fig2b_picks.png", "fig2b.png"), "fig2b.png is not there"),
    ):
        (folder / "index.html").write_text(wrong)
        assert any(why in fault for fault in faults(folder)), why
    (folder / "index.html").write_text(text)
    (folder / "fig2a_models.png").unlink()
    assert any("of the manifest is not there" in fault for fault in faults(folder))

    # Again: the runs are kept, and the picture is back.
    began = (folder / "runs" / "models" / "record.json").read_text()
    assert reproduce(folder, *options).returncode == 0 and faults(folder) == []
    assert (folder / "runs" / "models" / "record.json").read_text() == began

    # A panel whose run fails is absent, and the page says so. The program is a copy beside one
    # that is no reference: it ends with a sentence.
    programs = Path(scratch) / "programs"
    programs.mkdir()
    shutil.copy("/bin/false", programs / "vasorod")
    broken = Path(scratch) / "broken"
    done = reproduce(broken, "--programs", str(programs), "--only", "fig1", "fig2")
    assert done.returncode == 1 and "fig2 is missing" in done.stderr, done.stderr
    text = (broken / "index.html").read_text()
    assert Page(text).panels == ["departures"] and "<li>fig2: " in text
    assert faults(broken) == [], faults(broken)
