"""Predicts how blood vessels bend, twist, stretch and touch when a surgeon re-joins them.

A scene goes in, a result comes out:

>>> import vasorod
>>> scene = {
...     "scene": "pulled",
...     "units": {"length": "mm", "stress": "MPa"},
...     "vessels": [
...         {
...             "name": "tube",
...             "tube": {"length": 60, "radius": 10, "around": 24, "along": 24},
...             "wall": {"thickness": 1, "young": 1, "poisson": 0.3},
...         }
...     ],
...     "ends": [
...         {"vessel": "tube", "end": "start", "hold": True},
...         {"vessel": "tube", "end": "end", "move": [0, 0, 3]},
...     ],
...     "fidelity": "skin",
... }
>>> result = vasorod.solve(scene)
>>> result.status
'converged'
>>> force = result.json["ends"][1]["force"][2]
>>> round(force, 3)  # E A strain = 1 MPa * 2 pi 10 mm 1 mm * 0.05, in N
3.142
>>> result.vessels["tube"].points.shape
(600, 3)

The examples of the other docstrings go on with this ``scene`` and this ``result``.

Research software, not for clinical use. docs/python.md is the manual.
"""

from ._core import Centerline, Comparison, Result, Surface, Vessel
from ._core import version as _version
from ._explore import Exploration, explore
from ._meshio import to_meshio
from ._scene import Scene, read_scene
from ._solve import compare, fidelities, fit, read_surface, solve

__version__ = _version()
__all__ = [
    "Centerline",
    "Comparison",
    "Exploration",
    "Result",
    "Scene",
    "Surface",
    "Vessel",
    "compare",
    "explore",
    "fidelities",
    "fit",
    "read_scene",
    "read_surface",
    "solve",
    "to_meshio",
]
for _name in __all__:  # as users know them
    globals()[_name].__module__ = __name__
del _name
