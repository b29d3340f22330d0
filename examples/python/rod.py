"""A cantilever under a dead moment at its end rolls up to a circular arc: the rod alone.

    PYTHONPATH=build/python python3 examples/python/rod.py
"""

import math

import numpy as np
import vasorod

LENGTH, BENDING_STIFFNESS = 100.0, 8.3e5  # mm, N mm^2


def rolled(angle, elements=20):
    """The scene of a straight beam along x whose end is turned by an angle (radians) about z."""
    return {
        "scene": "rolled beam",
        "units": {"length": "mm", "stress": "MPa"},
        "vessels": [
            {
                "name": "beam",
                "rod": {
                    "tangent": [1, 0, 0],
                    "normal": [0, 1, 0],
                    "pieces": [{"length": LENGTH, "elements": elements}],
                    "stiffness": {
                        "axial": 1e7,
                        "shear": [5e6, 5e6],
                        "bending": [BENDING_STIFFNESS, BENDING_STIFFNESS],
                        "torsion": 8.3e5,
                    },
                },
            }
        ],
        "ends": [
            {"vessel": "beam", "end": "start", "hold": True},
            {"vessel": "beam", "end": "end", "moment": [0, 0, BENDING_STIFFNESS * angle / LENGTH]},
        ],
        "fidelity": "rod",
    }


def main():
    print("angle    end x        end y       distance to the arc's closed form, mm")
    for angle in np.linspace(math.pi / 8, math.pi, 8):
        beam = vasorod.solve(rolled(angle)).vessels["beam"].centerline
        radius = LENGTH / angle
        turned = beam.point_arrays["Abscissas"] / radius
        arc = radius * np.column_stack([np.sin(turned), 1 - np.cos(turned), 0 * turned])
        apart = np.linalg.norm(beam.points - arc, axis=1).max()
        x, y, _ = beam.points[-1]
        print(f"{math.degrees(angle):5.1f}  {x:11.6f}  {y:11.6f}  {apart:.1e}")
        if apart > 1e-6 * LENGTH:
            raise SystemExit("rod.py: the beam is no arc")


if __name__ == "__main__":
    main()
