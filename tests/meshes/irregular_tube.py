"""Every kind of irregular tube is a tube: closed around, open at two regular rims, on the exact
surface, oriented outwards, as irregular as its kind says.
Usage: irregular_tube.py MESHES_FOLDER."""

import math
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path

import numpy as np

sys.path.insert(0, sys.argv[1])
from irregular_tube import KINDS, SPACING, irregular_tube, smallest_angle  # noqa: E402
from vtp import read_vtp  # noqa: E402

LENGTH, RADIUS, AROUND = 30.0, 10.0, 36
edge = 2 * math.pi * RADIUS / AROUND
for kind in KINDS:
    for bend in (0.0, 1.2):
        points, triangles = irregular_tube(kind, LENGTH, RADIUS, AROUND, bend=bend)
        edges = Counter(tuple(sorted((t[k], t[(k + 1) % 3]))) for t in triangles for k in range(3))
        directed = Counter((t[k], t[(k + 1) % 3]) for t in triangles for k in range(3))
        assert len(points) - len(edges) + len(triangles) == 0, f"{kind}: no tube"
        assert (
            sum(count == 1 for count in edges.values()) == 2 * AROUND
            and set(edges.values()) == {1, 2}
            and max(directed.values()) == 1
        ), kind
        assert set(triangles.ravel()) == set(range(len(points))), f"{kind}: loose points"
        # back to the straight tube, by the angle at the centre of the bend
        if bend:
            turn = LENGTH / bend
            angle = np.arctan2(points[:, 2], turn - points[:, 0])
            out, s = turn - np.hypot(points[:, 2], turn - points[:, 0]), angle * turn
        else:
            out, s = points[:, 0], points[:, 2]
        assert np.abs(np.hypot(out, points[:, 1]) - RADIUS).max() < 1e-9, f"{kind}: off the surface"
        assert (
            abs(s.min()) < 1e-9 and abs(s.max() - LENGTH) < 1e-9 and s[0] < 1e-9
        ), kind  # the first point is at the start
        for rim in (0.0, LENGTH):
            at = np.sort(np.arctan2(points[:, 1], out)[np.abs(s - rim) < 1e-9])
            assert (
                len(at) == AROUND and np.abs(np.diff(at) - 2 * math.pi / AROUND).max() < 1e-9
            ), f"{kind}: the rim is not regular"
        a, b, c = (points[triangles[:, k]] for k in range(3))
        if not bend:
            outwards = np.cross(b - a, c - a)[:, :2]
            assert (np.sum(outwards * a[:, :2], axis=1) > 0).all(), f"{kind}: inwards"
            lengths = np.linalg.norm(b - a, axis=1)
            if kind == "stretched":
                rise = np.ptp(np.array([a[:, 2], b[:, 2], c[:, 2]]), axis=0)
                assert (
                    np.allclose(rise, rise[0]) and 4 < rise[0] / (edge * math.sqrt(3) / 2) < 6
                ), rise[0]
            else:
                assert lengths.std() > 0.1 * edge and smallest_angle(points, triangles) > 15, kind
            if kind == "blue-noise":
                gaps = np.linalg.norm(points[:, None] - points[None], axis=2)[
                    np.triu_indices(len(points), 1)
                ]
                assert (
                    gaps.min() > 0.99 * SPACING * edge
                ), gaps.min()  # a chord is a little shorter than its arc
                assert (
                    abs(
                        len(points)
                        / (2 * math.pi * RADIUS * LENGTH / (edge**2 * math.sqrt(3) / 2))
                        - 1
                    )
                    < 0.15
                ), len(points)

with tempfile.TemporaryDirectory() as scratch:
    words = [
        sys.executable,
        f"{sys.argv[1]}/irregular_tube.py",
        f"{scratch}/a.vtp",
        "--kind",
        "jittered",
        "--length",
        "30",
        "--radius",
        "10",
        "--around",
        "36",
    ]
    said = subprocess.run(words, check=True, capture_output=True, text=True).stdout
    points, triangles = read_vtp(f"{scratch}/a.vtp")
    assert f"{len(points)} points" in said and np.array_equal(
        points, irregular_tube("jittered", LENGTH, RADIUS, AROUND)[0]
    )
    again = Path(scratch) / "b.vtp"
    subprocess.run([*words[:2], str(again), *words[3:]], check=True, capture_output=True)
    assert (
        again.read_bytes() == (Path(scratch) / "a.vtp").read_bytes()
    ), "the same arguments, another file"
    refused = subprocess.run([*words, "--around", "4"], capture_output=True, text=True)
    assert refused.returncode == 2 and "--around 6 or more" in refused.stderr, refused
