"""The Glenn operation of a scene file at `skin`: what became of it, and a picture of the vein.

    PYTHONPATH=build/python python3 examples/python/glenn.py \\
        benchmarks/cases/glenn/infant.yaml glenn.png
"""

import sys

import numpy as np
import vasorod


def along(vein):
    """Abscissa, stretch over rest and twist since rest (degrees) at the nodes of a vein's rod."""
    rod = vein.centerline.point_arrays
    s = rod["Abscissas"]
    twist = rod["u"][:, 2] - rod["u0"][:, 2]  # 1/length
    turned = np.concatenate([[0], np.cumsum((twist[1:] + twist[:-1]) / 2 * np.diff(s))])
    return s, rod["v"][:, 2] / rod["v0"][:, 2], np.degrees(turned)


def plot(result, path):
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure = pyplot.figure(figsize=(10, 5), layout="constrained")
    view = figure.add_subplot(1, 2, 1, projection="3d")
    for name, colour in (("svc", "tab:blue"), ("pulmonary_artery", "tab:red")):
        vessel = result.vessels[name]
        view.plot_trisurf(*vessel.points.T, triangles=vessel.triangles, color=colour, alpha=0.7)
        if vessel.stump is not None:
            stump = vessel.stump
            view.plot_trisurf(*stump.points.T, triangles=stump.triangles, color="silver")
    view.set_aspect("equal")
    view.view_init(elev=10, azim=-80)
    view.set_axis_off()
    s, stretch, turned = along(result.vessels["svc"])
    axes = figure.add_subplot(2, 2, 2)
    axes.plot(s, stretch)
    axes.set(ylabel="axial stretch")
    axes = figure.add_subplot(2, 2, 4)
    axes.plot(s, turned)
    axes.set(xlabel=f"along the vein, {result.length_unit}", ylabel="twist, degrees")
    figure.savefig(path, dpi=120)


def main():
    if len(sys.argv) < 2:
        sys.exit("usage: glenn.py SCENE [PICTURE]; found no scene file")
    result = vasorod.solve(sys.argv[1], fidelity="skin")
    numbers = result.json
    glenn = numbers["glenn"]
    print(
        f"{result.scene}: {result.status}, vein cut at {glenn['cut']['fraction']:.2f} of its"
        f" length, turned by {glenn['join']['rotation_deg']:.1f} degrees,"
        f" {glenn['join']['pairs']} pairs"
    )
    for vessel in numbers["metrics"]:
        low, high = vessel["stretch"]
        print(
            f"{vessel['vessel']:<20} largest twist shear {vessel['largest_twist_shear']:.4f},"
            f" stretch {low:.3f} to {high:.3f}"
        )
    for warning in numbers["validity"]["warnings"]:
        print(" ", warning)
    if len(sys.argv) > 2:
        plot(result, sys.argv[2])


if __name__ == "__main__":
    main()
