"""Solving scenes, fitting surfaces, comparing results."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, Optional, Union

from . import _core
from ._core import Comparison, Result, Surface
from ._scene import PathLike, Scene, ply, points_and_triangles, read_scene


def fidelities() -> list[str]:
    """The names of the fidelities, from cheap to expensive.

    >>> vasorod.fidelities()
    ['rod', 'skin', 'paper', 'section', 'coupled']
    """
    return _core.fidelities()


def solve(
    scene: Union[Scene, Mapping[str, Any], PathLike],
    *,
    fidelity: Optional[str] = None,
    certify: bool = False,
    threads: int = 1,
    time_limit: Optional[float] = None,
    progress: Optional[Callable[[str], object]] = None,
    out: Optional[PathLike] = None,
    report: bool = True,
) -> Result:
    """Solves a scene with the hybrid model.

    scene: a Scene, a dict with the keys of one, or the path of a scene file.
    fidelity: one of fidelities(); None: the scene's.
    certify: also ask for the sign of the surfaces' smallest curvature (one factorisation more).
    threads: of the dense kernels. With 1, two runs on one machine agree in all but their times. It
        holds for every solve that runs at the same time.
    time_limit: seconds after which the best state so far is returned, its status "interrupted".
    progress: called with one line of text at each stage.
    out: a folder to which the result is written too, as Result.write does; it must be absent, empty
        or an earlier result, which is checked before the solve.
    report: False leaves out the pictures and report.html in `out`.

    A numerical outcome is the result's status, not an error. Other Python threads run meanwhile.
    Ctrl-C raises KeyboardInterrupt within about a second; only the main thread hears it.

    ValueError where the scene cannot be solved as asked, OSError where a file cannot be read or
    `out` cannot be replaced, TimeoutError where the time limit came before there was a state,
    MemoryError where the memory does not suffice; each with one sentence.

    >>> stages = []
    >>> result = vasorod.solve(scene, fidelity="coupled", progress=stages.append)
    >>> result
    <vasorod.Result pulled: converged (coupled)>
    >>> stages[0]
    'reading vessel tube'
    >>> vasorod.solve(scene, fidelity="glass")
    Traceback (most recent call last):
    ValueError: fidelity: found "glass", expected rod, skin, paper, section or coupled
    """
    if isinstance(scene, Mapping):
        scene = Scene(scene)
    elif not isinstance(scene, Scene):
        scene = read_scene(scene)
    if out is not None:
        _core.check_folder(os.fspath(out), scene._core)
    result = _core.solve(scene._core, fidelity, certify, threads, time_limit, progress)
    if out is not None:
        result.write(os.fspath(out), report=report)
    return result


def fit(
    surface: Any,
    *,
    length_unit: str = "mm",
    remesh: Optional[float] = None,
) -> Result:
    """Fits a centerline, radii and a reference rod to one vessel surface.

    surface: the path of a VTP, STL, PLY or OBJ file, or a surface in memory as in Scene.
    length_unit: the surface's unit, mm, cm or m.
    remesh: edge length in that unit to which the surface is remeshed first; None: as it is.

    The result has one vessel at rest with its centerline; ``json["fit"]`` has length, radii,
    branches and ends. ValueError where the surface is missing or no open tubular vessel, OSError
    where it may not be read.

    >>> tube = result.vessels["tube"]
    >>> found = vasorod.fit((tube.rest, tube.triangles))
    >>> round(found.json["fit"]["length"], 6)
    60.0
    """
    if isinstance(surface, (str, os.PathLike)):
        return _core.fit(os.fspath(surface), length_unit, remesh)
    with tempfile.TemporaryDirectory(prefix="vasorod-") as folder:
        path = Path(folder) / "surface.ply"
        path.write_bytes(ply(*points_and_triangles(surface, "surface")))
        return _core.fit(str(path), length_unit, remesh)


def compare(a: Union[Result, PathLike], b: Union[Result, PathLike]) -> Comparison:
    """How far two results of one scene are apart: each rest point of a is looked up on b.

    a, b: results, or their folders. A result in memory is written to a temporary folder.

    ValueError where a folder is no result or the results belong to different scenes.

    >>> skin = vasorod.solve(scene)
    >>> apart = vasorod.compare(skin, vasorod.solve(scene, fidelity="coupled"))
    >>> rms = apart.json["vessels"][0]["surface"]["rms"]  # over the radius
    >>> round(rms, 2)  # `skin` does not narrow: Poisson's ratio * strain = 0.015
    0.01
    """
    with tempfile.TemporaryDirectory(prefix="vasorod-") as scratch:
        folders, in_memory = [], []
        for name, result in (("a", a), ("b", b)):
            in_memory.append(isinstance(result, Result))
            if isinstance(result, Result):
                folders.append(os.path.join(scratch, name))
                result.write(folders[-1], report=False)
            else:
                folders.append(os.fspath(result))
        return _core.compare(*folders, *in_memory)


def read_surface(path: PathLike) -> Surface:
    """Reads a surface file, VTP, STL, PLY or OBJ, as triangles with their arrays.

    The surface is not checked or opened, as solve and fit do. ValueError where the file is missing
    or damaged, OSError where it may not be read.

    >>> folder = tempfile.mkdtemp()
    >>> result.write(folder, report=False)
    >>> vasorod.read_surface(os.path.join(folder, "tube.vtp"))
    <vasorod.Surface: 600 points, 1152 triangles>
    """
    return _core.read_surface(os.fspath(path))
