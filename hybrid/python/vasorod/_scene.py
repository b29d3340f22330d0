"""Scenes from files, from dicts, and from surfaces in memory."""

from __future__ import annotations

import json
import os
import re
import shutil
import tempfile
import weakref
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Optional, Union

import numpy as np

from . import _core

PathLike = Union[str, "os.PathLike[str]"]


class Scene:
    """A checked scene: vessels, what holds them, what to solve.

    keys: the keys of a scene file (docs/scene.md) as dicts, lists, texts, numbers, NumPy arrays.
    folder: where relative paths of surfaces begin.

    The ``surface`` of a vessel is the path of a file or a surface in memory: a pair of points,
    (n, 3), and triangles, (m, 3) point numbers counter-clockwise seen from outside; a vasorod
    Surface or Vessel (with its current points); or a meshio.Mesh with triangles. One in memory is
    written to a temporary PLY file, which is removed with the scene; its arrays stay behind.

    ValueError where a scene is wrong, with the sentence of the program: key, what was found, what
    was expected. TypeError for values that no scene file could hold.

    >>> vasorod.Scene(scene)
    <vasorod.Scene pulled: tube>
    >>> vasorod.Scene({**scene, "fidelty": "rod"})
    Traceback (most recent call last):
    ValueError: found the unknown key "fidelty", expected "fidelity"
    """

    def __init__(self, keys: Mapping[str, Any], *, folder: PathLike = ".") -> None:
        self._files: Optional[Path] = None  # folder of the surfaces that were in memory
        self._file: Optional[str] = None
        self._text = json.dumps(self._plain(keys, "scene"), ensure_ascii=False)  # JSON is YAML
        self._folder = os.path.abspath(folder)
        self._core = _core.read_scene_text(self._text, os.fspath(folder))

    @classmethod
    def _read(cls, path: PathLike) -> Scene:
        scene = cls.__new__(cls)
        scene._files = None
        scene._file, scene._text, scene._folder = os.path.abspath(path), "", ""
        scene._core = _core.read_scene(os.fspath(path))
        return scene

    @property
    def name(self) -> str:
        """The scene's name in results."""
        return self._core.name

    @property
    def vessels(self) -> list[str]:
        """The names of the vessels, in the scene's order."""
        return self._core.vessels

    @property
    def fidelity(self) -> Optional[str]:
        """The fidelity that the scene asks for; None where it asks for an accuracy."""
        return self._core.fidelity

    @property
    def length_unit(self) -> str:
        """mm, cm or m."""
        return self._core.length_unit

    @property
    def stress_unit(self) -> str:
        """Pa, kPa or MPa; forces are stress * length^2."""
        return self._core.stress_unit

    def __repr__(self) -> str:
        return f"<vasorod.Scene {self.name}: {', '.join(self.vessels)}>"

    def _plain(self, value: Any, place: str) -> Any:
        """The value as JSON knows it; surfaces in memory become files."""
        if isinstance(value, Mapping):
            plain = {}
            for key, item in value.items():
                if not isinstance(key, str):
                    raise TypeError(f"{place}: found the key {key!r}, expected a text")
                in_memory = key == "surface" and not isinstance(item, (str, os.PathLike))
                plain[key] = (
                    self._file_of(item, f"{place}.{key}", value.get("name"))
                    if in_memory
                    else self._plain(item, f"{place}.{key}")
                )
            return plain
        if isinstance(value, (np.ndarray, np.generic)):
            return self._plain(value.tolist(), place)
        if isinstance(value, (list, tuple)):
            return [self._plain(item, f"{place}[{k}]") for k, item in enumerate(value)]
        if isinstance(value, os.PathLike):
            return os.fspath(value)
        if value is None or isinstance(value, (str, bool, int, float)):
            return value
        raise TypeError(f"{place}: found {type(value).__name__}, expected what a scene file holds")

    def _file_of(self, surface: Any, place: str, vessel: Any) -> str:
        """The path of a PLY file with a surface in memory."""
        if self._files is None:
            self._files = Path(tempfile.mkdtemp(prefix="vasorod-"))
            weakref.finalize(self, shutil.rmtree, self._files, ignore_errors=True)
        # A name that is none is refused before the file is read.
        named = isinstance(vessel, str) and re.fullmatch(r"[A-Za-z0-9_-]{1,100}", vessel)
        path = self._files / (f"{vessel}.ply" if named else "surface.ply")
        path.write_bytes(ply(*points_and_triangles(surface, place)))
        return str(path)


def read_scene(path: PathLike) -> Scene:
    """Reads and checks a scene file (YAML, docs/scene.md).

    ValueError with one sentence where the file is missing or wrong: file, line, key, what was
    found, what was expected. OSError where it cannot be read.

    >>> vasorod.read_scene("no.yaml")
    Traceback (most recent call last):
    ValueError: no.yaml: found no such file, expected a scene file
    """
    return Scene._read(path)


def points_and_triangles(surface: Any, place: str) -> tuple[np.ndarray, np.ndarray]:
    """(n, 3) float64 and (m, 3) int32 of a surface in memory; ValueError if it is none."""
    if hasattr(surface, "cells_dict"):  # a meshio.Mesh
        if "triangle" not in surface.cells_dict:
            raise ValueError(f"{place}: found a mesh without triangles, expected some")
        pair = surface.points, surface.cells_dict["triangle"]
    elif hasattr(surface, "triangles"):
        pair = surface.points, surface.triangles
    else:
        pair = surface
    if not isinstance(pair, (tuple, list)) or len(pair) != 2:
        raise ValueError(
            f"{place}: found {type(surface).__name__}, expected a path or (points, triangles)"
        )
    points, triangles = np.asarray(pair[0]), np.asarray(pair[1])
    for name, array, kinds in (("points", points, "fiu"), ("triangles", triangles, "iu")):
        if array.ndim != 2 or array.shape[1] != 3 or array.dtype.kind not in kinds:
            raise ValueError(
                f"{place}: found {name} of shape {array.shape} and type {array.dtype}, expected "
                + ("(n, 3) numbers" if name == "points" else "(m, 3) whole numbers")
            )
    if triangles.size and not 0 <= triangles.min() <= triangles.max() < len(points):
        raise ValueError(
            f"{place}: found triangles of points {triangles.min()} to {triangles.max()}, expected "
            f"0 to {len(points) - 1}"
        )
    return points.astype("<f8"), triangles.astype("<i4")


def ply(points: np.ndarray, triangles: np.ndarray) -> bytes:
    """A surface as a binary PLY file; every coordinate stays the same double."""
    head = (
        "ply\nformat binary_little_endian 1.0\n"
        f"element vertex {len(points)}\nproperty double x\nproperty double y\nproperty double z\n"
        f"element face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    faces = np.empty(len(triangles), dtype=[("count", "u1"), ("points", "<i4", 3)])
    faces["count"] = 3
    faces["points"] = triangles
    return head.encode() + points.tobytes() + faces.tobytes()
