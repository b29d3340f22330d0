"""The scenes of the panels are what their names say; the coefficients held in Fig. 3(d) are those
that the program derives itself. Usage: scenes.py SOURCE_FOLDER VASOROD."""

import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path

import yaml

SOURCE, PROGRAM = Path(sys.argv[1]), sys.argv[2]
sys.path.insert(0, str(SOURCE / "benchmarks" / "reproduce"))
import work  # noqa: E402, F401  it finds the study's modules
import moduli  # noqa: E402
import scenes  # noqa: E402


def scene_of(run):
    return yaml.safe_load(run.contents()["scene.yaml"])


# The moduli that vary, those that do not, and k_s, which follows E alone.
base, stiff, sheared = (
    scene_of(scenes.moduli_run(*pair))["vessels"][0] for pair in ((1, 1), (10, 1), (1, 10))
)
assert math.isclose(stiff["wall"]["young"], 10 * base["wall"]["young"])
assert stiff["wall"]["shear"] == base["wall"]["shear"]
assert math.isclose(sheared["wall"]["shear"], 10 * base["wall"]["shear"])
assert sheared["coefficients"] == base["coefficients"]
assert stiff["coefficients"]["binding"] == base["coefficients"]["binding"]
assert stiff["coefficients"]["bending"] == base["coefficients"]["bending"]
assert math.isclose(stiff["coefficients"]["stretching"], 10 * base["coefficients"]["stretching"])
together = scene_of(scenes.moduli_run(10, 1, held=False))["vessels"][0]["coefficients"]
assert all(math.isclose(together[k], 10 * base["coefficients"][k]) for k in together)

# The reference is run only where a wall of these moduli does not wrinkle: the angle of
# tau_cr = 0.747 E (t/R)^1.25 (R/L)^0.5 is above that of the scene.
limit = 0.747 * 0.2**1.25 * 0.1**0.5 * 10 * 2.6
for quick in (True, False):
    for modulus, factors in moduli.reference_factors(quick).items():
        for factor in factors:
            young, shear = moduli.pair(modulus, factor)
            assert math.degrees(limit * young / shear) > 23, (modulus, factor)

with tempfile.TemporaryDirectory() as scratch:
    scratch = Path(scratch)
    # A rod on either side of the limit that the page names: twisted and straight, and buckled. It
    # buckles into one of a family of shapes, of which the solver may find a minimum or a saddle.
    for factor, buckled in ((1.2, False), (0.8, True)):
        (scratch / "rod.yaml").write_text(scenes.with_moduli(factor * moduli.buckling_ratio(), 1))
        words = [PROGRAM, "solve", "rod.yaml", "-o", "rod", "--json", "--fidelity", "rod"]
        done = subprocess.run([*words, "--no-report"], cwd=scratch, capture_output=True, text=True)
        curvature = json.loads(done.stdout)["metrics"][0]["largest_curvature"]
        if buckled:
            assert done.returncode == 1 or curvature > 1e-3, (factor, curvature)
        else:
            assert done.returncode == 0 and curvature < 1e-9, (factor, curvature)
    given = scene_of(scenes.moduli_run(1, 1))
    derived = scene_of(scenes.moduli_run(1, 1))
    del derived["vessels"][0]["coefficients"]
    for name, scene in (("given", given), ("derived", derived)):
        (scratch / f"{name}.yaml").write_text(yaml.safe_dump(scene))
        subprocess.run(
            [PROGRAM, "solve", f"{name}.yaml", "-o", name, "--quiet", "--no-report"]
            + ["--fidelity", "paper", "--threads", "1"],
            cwd=scratch,
            check=True,
            stdout=subprocess.DEVNULL,
        )
    done = subprocess.run(
        [PROGRAM, "compare", "given", "derived", "--json"],
        cwd=scratch,
        check=True,
        capture_output=True,
        text=True,
    )
    apart = json.loads(done.stdout)["vessels"][0]["surface"]["rms"]
    assert apart < 1e-5, f"{apart} of R: the mesh is equilateral to a few per mille"
