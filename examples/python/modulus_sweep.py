"""A short tube is moved sideways between two clamps: how its force depends on the shear modulus G
at a given Young's modulus E, beside Timoshenko's beam. E and G of a wall are free of each other.

    PYTHONPATH=build/python python3 examples/python/modulus_sweep.py sweep.png
"""

import math
import sys

import numpy as np
import vasorod

LENGTH, RADIUS, THICKNESS, YOUNG, POISSON = 60.0, 5.0, 0.5, 1.0, 0.3  # mm, MPa
MOVE = 0.1  # mm sideways
MODULI = YOUNG * np.geomspace(0.02, 1, 12)  # of shear; isotropic: 0.385


def moved_sideways(shear):
    return {
        "scene": "sweep",
        "units": {"length": "mm", "stress": "MPa"},
        "vessels": [
            {
                "name": "tube",
                "tube": {"length": LENGTH, "radius": RADIUS, "around": 24, "along": 48},
                "wall": {
                    "thickness": THICKNESS,
                    "young": YOUNG,
                    "shear": float(shear),
                    "transverse": {"poisson": POISSON},
                },
            }
        ],
        "ends": [
            {"vessel": "tube", "end": "start", "hold": True},
            {"vessel": "tube", "end": "end", "move": [MOVE, 0, 0]},
        ],
        "fidelity": "rod",
    }


def timoshenko(shear):
    """Force of a beam between two clamps: 12 E I / (L^3 (1 + 12 E I / (k G A L^2))), N."""
    outer, inner = RADIUS + THICKNESS / 2, RADIUS - THICKNESS / 2
    area, inertia = math.pi * (outer**2 - inner**2), math.pi / 4 * (outer**4 - inner**4)
    m = (inner / outer) ** 2  # Cowper's shear coefficient of a hollow circle (1966)
    k = 6 * (1 + POISSON) * (1 + m) ** 2
    k /= (7 + 6 * POISSON) * (1 + m) ** 2 + (20 + 12 * POISSON) * m
    softening = 12 * YOUNG * inertia / (k * shear * area * LENGTH**2)
    return 12 * YOUNG * inertia / (LENGTH**3 * (1 + softening)) * MOVE


def force(shear):
    """Force of the support that moves the tube's end, N."""
    result = vasorod.solve(moved_sideways(shear))
    if result.status != "converged":
        raise SystemExit(f"modulus_sweep.py: {result.status} at G = {shear}")
    return result.json["ends"][1]["force"][0]


def plot(forces, path):
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(6, 4), layout="constrained")
    fine = np.geomspace(MODULI[0], MODULI[-1], 200)
    axes.semilogx(fine / YOUNG, [1e3 * timoshenko(shear) for shear in fine], label="Timoshenko")
    axes.semilogx(MODULI / YOUNG, 1e3 * np.array(forces), "o", label="vasorod, fidelity rod")
    axes.axvline(1 / (2 * (1 + POISSON)), color="grey", linewidth=0.8, label="isotropic")
    axes.set(xlabel="G / E", ylabel=f"force at {MOVE} mm sideways, mN")
    axes.legend()
    figure.savefig(path, dpi=150)


def main():
    forces = [force(shear) for shear in MODULI]
    print("G / E   force, mN  Timoshenko, mN")
    for shear, found in zip(MODULI, forces):
        print(f"{shear / YOUNG:5.3f}  {1e3 * found:9.5f}  {1e3 * timoshenko(shear):9.5f}")
    if len(sys.argv) > 1:
        plot(forces, sys.argv[1])


if __name__ == "__main__":
    main()
