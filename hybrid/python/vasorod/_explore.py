"""Exploring the options of an operation."""

from __future__ import annotations

import json
import math
import os
import subprocess
import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Optional, Union

from . import _core
from ._scene import PathLike, Scene, read_scene
from ._solve import fidelities

_ERRORS = {"ValueError": ValueError, "TimeoutError": TimeoutError, "MemoryError": MemoryError}


@dataclass(frozen=True)
class Exploration:
    """The options of an operation in the order of their ranking; what ``explore`` returns."""

    folder: Path
    """The folder with options.csv, index.html and the result folders of kept options."""
    finished: bool
    """False where it was stopped before its end."""
    found: int
    """How many solves an earlier exploration of the folder had done."""
    ranking: Optional[dict[str, Any]]
    """Of a scene with ``vary``: in which share of the ``samples`` the first option stays first
    (``first_stays``), Kendall's ``tau``, whether the ranking ``survives``, and a ``text``."""
    options: list[dict[str, Any]]
    """Per option, as a line of options.csv: ``values`` (a dict of the listed keys), ``rank``,
    ``score``, ``mark``, ``fidelity``, ``stage``, ``ending``, ``status``, ``in_range``,
    ``criteria`` (a dict of what is known), ``past``, ``refined``, ``seconds``, ``sentences``,
    ``option`` (its name) and ``folder`` (of its result, below that of the exploration; empty if it
    is not kept). What is not known is None. An option whose uncertainty was carried through has
    ``samples``: how many were ``tried``, ``converged``, in how many it was ``first``, and the
    ``intervals`` of its criteria and score."""

    def __repr__(self) -> str:
        how = "" if self.finished else ", stopped before its end"
        return f"<vasorod.Exploration {self.folder}: {len(self.options)} options{how}>"


def explore(
    scene: Union[Scene, Mapping[str, Any], PathLike],
    folder: PathLike,
    *,
    stages: Optional[Sequence[str]] = None,
    best: Optional[int] = None,
    threads: Optional[int] = None,
    time_limit: Optional[float] = None,
    report: bool = True,
    progress: Optional[Callable[[str], object]] = None,
) -> Exploration:
    """Solves the options that ``explore`` of a scene lists, and ranks them (docs/explore.md).

    scene: a Scene, a dict with the keys of one, or the path of a scene file.
    folder: absent, empty, or that of an earlier exploration. Options that it has already are not
        solved again, so that the same call goes on where an earlier one was stopped.
    stages: fidelities; the first solves every option, each other one the best of the stage before;
        None: the scene's.
    best: how many go on to the next stage, 1 to 1000; None: the scene's.
    threads: options solved at once; None: one for each processor. The numbers do not depend on it.
    time_limit: seconds after which it stops with what is finished.
    report: False leaves out the pictures and report.html of kept options.
    progress: called with one line of text whenever an option has ended.

    It runs in a process of its own, and each option in one more. Ctrl-C raises KeyboardInterrupt
    as soon as the table of what is finished is written, a second one at once.

    ValueError where the scene cannot be explored, OSError where the file system refuses or another
    exploration is at work in the folder, TimeoutError where the time limit came before the vessels
    were fitted, RuntimeError where the process failed; each with one sentence.

    >>> vasorod.explore(scene, "no_folder")
    Traceback (most recent call last):
    ValueError: scene "pulled": found no surgery: glenn, expected the operation whose options are...
    """
    if isinstance(scene, Mapping):
        scene = Scene(scene)
    elif not isinstance(scene, Scene):
        scene = read_scene(scene)
    _check(stages, best, threads, time_limit)
    # Absolute: a thread of the caller may change its working folder meanwhile.
    asked = {
        "core": _core.__file__,
        "file": scene._file,
        "text": scene._text,
        "scene_folder": scene._folder,
        "folder": os.path.abspath(folder),
        "stages": None if stages is None else list(stages),
        "best": best,
        "threads": threads or len(os.sched_getaffinity(0)),
        "time_limit": time_limit,
        "report": report,
    }
    done = _run(asked, progress)
    return Exploration(
        Path(folder), done["finished"], done["found"], done.get("ranking"), done["options"]
    )


def _check(stages, best, threads, time_limit):
    known = [name for name in fidelities() if name != "section"]  # it takes no surgery
    wrong = stages is not None and (isinstance(stages, str) or not stages)
    if wrong or any(name not in known for name in stages or []):
        raise ValueError(f"stages: found {stages!r}, expected a list of {', '.join(known)}")
    for name, value, most in (("best", best, 1000), ("threads", threads, 1024)):
        if value is not None and not 1 <= value <= most:
            raise ValueError(f"{name}: found {value}, expected 1 to {most}, or None")
    if time_limit is not None and not (math.isfinite(time_limit) and time_limit > 0):
        raise ValueError(f"time_limit: found {time_limit}, expected seconds above 0, or None")


def _run(asked, progress):
    """What the process of the exploration says at its end."""
    if not sys.executable:
        raise RuntimeError("found no interpreter in sys.executable, expected one to explore with")
    command = [sys.executable, str(Path(__file__).with_name("_exploring.py"))]
    # A session of its own: Ctrl-C reaches it through this process alone.
    process = subprocess.Popen(
        command,
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        env={**os.environ, "OPENBLAS_NUM_THREADS": "1"},
        start_new_session=True,
    )
    try:
        process.stdin.write(json.dumps(asked).encode() + b"\n")
        process.stdin.flush()
        for line in process.stdout:
            said = json.loads(line)
            if "progress" in said:
                if progress is not None:
                    progress(said["progress"])
            elif "error" in said:
                raise _ERRORS.get(said["error"], OSError)(said["sentence"])
            else:
                return said["done"]
        raise RuntimeError(
            f"the exploration's process ended with code {process.wait()} and without an answer"
        )
    finally:
        _end(process)


def _end(process):
    """Waits for a process that has said its last word, or is asked to end."""
    try:
        process.stdin.close()
    except OSError:  # it ended before it had read everything
        pass
    try:
        process.stdout.read()  # it may have more to say than the pipe holds
        process.wait()
    except BaseException:
        process.kill()
        process.wait()
        raise
    finally:
        process.stdout.close()
