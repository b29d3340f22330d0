"""What the panels share: finished runs, pictures and numbers with their source."""

import json
import shlex
import subprocess
import sys
from dataclasses import dataclass, field
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "study"))
from measure import failure_of  # noqa: E402
from store import REPOSITORY, Store  # noqa: E402

__all__ = ["Figure", "Number", "Panel", "REPOSITORY", "Work"]


@dataclass
class Figure:
    """A picture of the page, its caption and the command that draws it."""

    file: str
    caption: str
    command: str


@dataclass
class Number:
    """A number of the page: `key`, a path with slashes, in a JSON file; shown times `times`."""

    label: str
    file: str
    key: str
    unit: str = ""
    times: float = 1
    paper: str = ""


@dataclass
class Panel:
    identity: str
    title: str
    paper: str  # what is known of the paper's side
    reproduced: str
    missing: str  # what could not be reproduced
    differs: str
    figures: list = field(default_factory=list)
    numbers: list = field(default_factory=list)


def value_at(folder, number):
    value = json.loads((Path(folder) / number.file).read_text())
    for word in number.key.split("/"):
        value = value[int(word)] if isinstance(value, list) else value[word]
    return value


class Work:
    def __init__(self, folder, programs, quick):
        self.folder, self.quick = Path(folder).resolve(), quick
        self.folder.mkdir(parents=True, exist_ok=True)
        self.store = Store(self.folder / "runs", programs)

    def solved(self, run, also=()):
        """The finished run's folder, relative to the page. Exit codes other than 0 and those in
        `also` end the panel."""
        record = self.store.ensure(run)
        if record["exit"] not in (0, *also):
            raise SystemExit(f"{run.identity}: {failure_of(self.store, record)}")
        return f"runs/{run.identity}"

    def result(self, run):
        return json.loads((self.store.folder(run.identity) / "result" / "result.json").read_text())

    def _program(self, words, cwd=None):
        done = subprocess.run(
            [str(self.store.programs["vasorod"]), *words], capture_output=True, text=True, cwd=cwd
        )
        if done.returncode != 0:
            raise SystemExit(f"vasorod {' '.join(words)}: {done.stderr.strip()}")
        return done.stdout

    def drawn(self, run, name, caption, *options):
        """A picture of a finished run, drawn by the program."""
        words = ["draw", f"runs/{run.identity}/result", "-o", f"{name}.png", *map(str, options)]
        self._program(words, self.folder)
        return Figure(f"{name}.png", caption, "vasorod " + shlex.join(words))

    def compared(self, a, b, name):
        """The file with the distance of two runs."""
        words = ["compare", *(f"runs/{run.identity}/result" for run in (a, b)), "--json"]
        self.write(f"{name}.json", self._program(words, self.folder))
        return f"{name}.json"

    def write(self, name, text):
        (self.folder / name).write_text(text)

    def command_of(self, run):
        return shlex.join(self.store.record(run.identity)["command"])

    def value(self, number):
        return value_at(self.folder, number)
