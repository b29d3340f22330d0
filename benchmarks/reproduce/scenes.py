"""The scenes of the panels, made from those of benchmarks/cases."""

import copy
import math

import yaml

from work import REPOSITORY

from cases import case_named, text_of
from runs import Run, accuracy_reference, hybrid_arguments

GLENN = REPOSITORY / "benchmarks" / "cases" / "glenn"
# x to the patient's left, y to the back, z to the head (meshes/README.md)
FRONTAL = ("--from", 0, -1, 0, "--up", 0, 0, 1)
LATERAL = ("--from", -1, 0, 0, "--up", 0, 0, 1)  # the right side, where the vein is
OBLIQUE = ("--from", 0.3, -1, 0.6, "--up", 0, 0, 1)
RIGHT = ("--from", -1, -0.05, 0.7, "--up", 0, 0, 1)  # where both picks are seen


def glenn(name):
    """A scene of cases/glenn, with the places of its surfaces from the root."""
    scene = yaml.safe_load((GLENN / f"{name}.yaml").read_text())
    for vessel in scene["vessels"]:
        vessel["surface"] = str((GLENN / vessel["surface"]).resolve())
    return scene


def glenn_run(name, fidelity="paper", rotation=None):
    scene = glenn(name)
    if rotation is not None:
        scene["surgery"]["glenn"]["rotation_deg"] = rotation
    turned = "" if rotation is None else f"-turned-{rotation}"
    return Run(
        f"{name}{turned}-{fidelity}",
        "vasorod",
        hybrid_arguments(fidelity),
        {"scene.yaml": text_of(scene)},
    )


def models_run():
    """The three vessels before the operation; nothing moves them."""
    scene = glenn("infant")
    del scene["surgery"]
    scene["scene"], scene["vessels"] = "models", scene["vessels"][:3]
    return Run("models", "vasorod", hybrid_arguments("skin"), {"scene.yaml": text_of(scene)})


def tube_case(motion):
    return case_named({"bent": "bend_t2_0.5", "twisted": "twist_t2_0.5"}[motion])


def tube_run(motion, fidelity):
    return Run(
        f"tube-{motion}-{fidelity}",
        "vasorod",
        hybrid_arguments(fidelity),
        {"scene.yaml": tube_case(motion).text()},
    )


def tube_reference(motion):
    """The solid of benchmarks/study: p = 4, 8 x 12 cells, and those refined by 3/2."""
    run = accuracy_reference(tube_case(motion))
    return Run(f"tube-{motion}-solid", run.program, run.arguments, run.files, keep=True)


def coefficients(tube, wall, young):
    """k_c, k_b and k_s as the program derives them (bodies/spring_coefficients.h) on a mesh of
    equilateral triangles, for the moduli at rest of the sweep; k_s follows `young`."""
    edge = 2 * math.pi * tube["radius"] / tube["around"]
    area = math.sqrt(3) / 2 * edge**2
    t, nu = wall["thickness"], wall["transverse"]["poisson"]
    stiffness = t**3 / (12 * (1 - nu**2))  # of a plate with E = 1
    return {
        "binding": 0.01 * t / tube["radius"] ** 2 * area,
        "bending": 4 * math.sqrt(3) * stiffness / edge**2,
        "stretching": math.sqrt(3) / 4 * young * t,
    }


def with_moduli(young, shear, held=True):
    """The twisted tube with E and G times these factors. `held`: k_b and k_c stay those of the
    factors 1 and only k_s follows E; else all three follow it."""
    scene = copy.deepcopy(tube_case("twisted").scene)
    vessel = scene["vessels"][0]
    thickness = vessel["wall"]["thickness"]
    vessel["wall"] = {
        "thickness": thickness,
        "young": young,
        "shear": shear / 2.6,
        "transverse": {"young": young, "poisson": 0.3, "coupling": 0},
    }
    k = coefficients(vessel["tube"], vessel["wall"], young)
    if not held:
        k = {**coefficients(vessel["tube"], vessel["wall"], 1)}
        k = {name: young * value for name, value in k.items()}
    vessel["coefficients"] = k
    return text_of(scene)


def moduli_run(young, shear, held=True):
    return Run(
        f"moduli-{'held' if held else 'all'}-E{young:.3g}-G{shear:.3g}",
        "vasorod",
        hybrid_arguments("paper"),
        {"scene.yaml": with_moduli(young, shear, held)},
    )


def moduli_reference(young, shear):
    """The finite-element shell, on the cells that the study's sweeps have."""
    return Run(
        f"moduli-shell-E{young:.3g}-G{shear:.3g}",
        "vasorod-fem",
        (
            *("solve", "scene.yaml", "-o", "result", "--quiet", "--model", "shell"),
            *("--law", "biot", "--degree", "4", "--cells", "8", "12", "--refine", "1"),
            *("--first-step", "0.34", "--largest-step", "1.0", "--no-jumps"),
            *("--time-limit", "300"),
        ),
        {"scene.yaml": with_moduli(young, shear)},
        keep=True,
    )
