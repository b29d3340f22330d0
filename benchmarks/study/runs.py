"""Every run of the study by its identity, CASE/PROGRAM-SETTINGS: what is written beside it and how
the program is called."""

import json
from dataclasses import dataclass, field

from store import sha256

FIDELITIES = ("rod", "skin", "paper", "coupled")
AROUND = (24, 48, 96)  # points around: the three resolutions of the hybrid's surfaces


@dataclass(frozen=True)
class Run:
    identity: str
    program: str
    arguments: tuple
    files: dict = field(hash=False)  # name: text, or a function that makes it where it is needed
    keep: bool = False  # do not repeat it because the program was rebuilt

    def contents(self):
        return {
            name: text if isinstance(text, str) else text() for name, text in self.files.items()
        }

    def key(self):
        return sha256(
            json.dumps([self.program, list(self.arguments), self.contents()], sort_keys=True)
        )


def hybrid_arguments(fidelity=None):
    """Without a fidelity the scene says which."""
    return (
        "solve",
        "scene.yaml",
        "-o",
        "result",
        "--quiet",
        "--threads",
        "1",
        *(("--fidelity", fidelity) if fidelity else ()),
    )


def reference_arguments(model, cells, refine, *more):
    return (
        *("solve", "scene.yaml", "-o", "result", "--quiet", "--model", model, *more),
        *("--cells", str(cells[0]), str(cells[1]), "--refine", str(refine)),
    )


def hybrid(case, fidelity, around, *, tag=""):
    """vasorod on `around` points around; `tag` tells variations of one case apart."""
    return Run(
        f"{case.name}{tag}/{fidelity}-{around}",
        "vasorod",
        hybrid_arguments(fidelity),
        {"scene.yaml": case.changed(around=around).text},
    )


def reference(case, model, degree, cells, refine, *, law="biot", tag="", steps=(0.34, 1.0)):
    """vasorod-fem; kept when the program is rebuilt, as runs are long: the record says which."""
    return Run(
        f"{case.name}{tag}/{model}-p{degree}-{cells[0]}x{cells[1]}-r{refine}-{law}",
        "vasorod-fem",
        (
            *reference_arguments(model, cells, refine, "--law", law, "--degree", str(degree)),
            *("--first-step", str(steps[0]), "--largest-step", str(steps[1])),
        ),
        {"scene.yaml": case.text},
        keep=True,
    )


def finest(case, model):
    """p = 4, 8 x 12 cells and those refined by 3/2, in small steps where a bend is strong."""
    strong = case.ratio >= 0.7 and case.family != "stretch"
    return reference(case, model, 4, (8, 12), 1, steps=(0.1, 0.25) if strong else (0.34, 1.0))


def accuracy_reference(case):
    """Every fidelity is measured against it."""
    return finest(case, "solid")


def accuracy_shell(case):
    """Beside it, the 7-parameter shell on the same cells: its own kinematics and assembly."""
    return finest(case, "shell")
