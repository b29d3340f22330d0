"""Every committed case is the load its note says, by other means than the formula its file was
written with: the arc is integrated, angles are measured on frames.
Usage: cases.py SOURCE_FOLDER VASOROD."""

import math
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(sys.argv[1]) / "benchmarks" / "study"))
from cases import all_cases, read_case  # noqa: E402


def end_of_arc(length, start_angle, angle, steps=20000):
    """Where an axis that starts at start_angle from z (towards x) and turns evenly by `angle` ends:
    midpoint rule."""
    x = z = 0.0
    for k in range(steps):
        a = start_angle + angle * (k + 0.5) / steps
        x += length / steps * math.sin(a)
        z += length / steps * math.cos(a)
    return x, z


def matrix(rotation_deg):
    """Rotation matrix of a rotation vector, by Rodrigues."""
    v = [math.radians(a) for a in rotation_deg]
    angle = math.sqrt(sum(a * a for a in v))
    if angle == 0:
        return [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
    x, y, z = (a / angle for a in v)
    c, s = math.cos(angle), math.sin(angle)
    return [
        [c + x * x * (1 - c), x * y * (1 - c) - z * s, x * z * (1 - c) + y * s],
        [y * x * (1 - c) + z * s, c + y * y * (1 - c), y * z * (1 - c) - x * s],
        [z * x * (1 - c) - y * s, z * y * (1 - c) + x * s, c + z * z * (1 - c)],
    ]


def cubic(length, start, end):
    """Curvature at both ends of a slender beam clamped at its start, its other end at offset
    `start` and slope `end`: w = a s^2 + b s^3."""
    a, b = 3 * start / length**2 - end / length, (end - 2 * start / length) / length**2
    return 2 * a, 2 * a + 6 * b * length


def check_fresh(case, limit, tangent, turned, move, length):
    """The load in the file's comment: which share of which limit."""
    tilt, side = math.hypot(tangent[0], tangent[1]), math.hypot(move[0], move[1])
    bent = math.atan2(tilt, tangent[2])
    what = case.name.split("_")[1]
    wrinkling = math.degrees(
        0.747 * 2.6 * (case.wall["thickness"] / 10) ** 1.25 * math.sqrt(10)
    )  # tau_cr L / (G R), L = 10 R
    if what in ("bend", "mixed"):
        assert abs(bent - case.ratio * limit) < 1e-7, (case.name, bent, case.ratio * limit)
        assert (
            abs(math.atan2(tangent[1], tangent[0]) - math.atan2(move[1], move[0])) < 1e-8
        ), case.name  # one plane
        x, z = end_of_arc(length * (1.03 if what == "mixed" else 1), 0, bent)
        assert abs(x - side) < 1e-5 and abs(z - length - move[2]) < 1e-5, (case.name, move, x, z)
        # d1 undone by the bend alone (about the horizontal axis across the tangent) is what the
        # twist left
        across = [-tangent[1] / tilt, tangent[0] / tilt, 0]
        back = matrix([-math.degrees(bent) * a for a in across])
        d1 = [row[0] for row in turned]
        twisted = [sum(row[k] * d1[k] for k in range(3)) for row in back]
        twist = math.degrees(math.atan2(twisted[1], twisted[0]))
        assert abs(twist / wrinkling - (0.2 if what == "mixed" else 0)) < 1e-6, (
            case.name,
            twist,
            wrinkling,
        )
    elif what == "twist":
        assert abs(
            math.degrees(math.atan2(turned[1][0], turned[0][0])) / wrinkling - case.ratio
        ) < 1e-6 and move == [0, 0, 8], case.name
    elif what == "press":
        assert (
            move == [0, 0, -2]
            and abs(0.02 / (0.605 * case.wall["thickness"] / 10) - case.ratio) < 0.005
        ), case.name
    else:
        slope = -bent if what == "back" else 0
        largest = max(map(abs, cubic(length, side, slope)))
        assert abs(largest * length / limit - case.ratio) < 1e-6 and move[2] == 0, (
            case.name,
            largest * length / limit,
        )


cases = all_cases()
assert len(cases) >= 32 and {case.family for case in cases} >= {
    "stretch",
    "twist",
    "bend",
    "offset",
    "combined",
    "curved",
    "tapered",
    "fresh",
}
wrinkling_deg = {0.5: 8, 1: 20, 2: 47}  # rounded; tau_cr = 0.747 E (t/R)^1.25 (R/L)^0.5
for case in cases:
    tube, wall, moved = case.tube, case.wall, case.scene["ends"][1]
    length, radius, t = tube["length"], tube["radius"], wall["thickness"]
    limit = (
        0.471 * t / (radius**2 * math.sqrt(1 - wall["poisson"] ** 2)) * length
    )  # Brazier's angle
    rest = math.radians(tube.get("bend_deg", 0))
    move, turned = moved.get("move", [0, 0, 0]), matrix(moved.get("rotate_deg", [0, 0, 0]))
    tangent = [row[2] for row in turned]
    bent = math.atan2(tangent[0], tangent[2])
    grown = 1.05 if case.family == "combined" else 1
    if case.family in ("bend", "curved", "combined", "tapered"):
        assert abs(bent - case.ratio * limit) < 1e-7, (case.name, bent, case.ratio * limit)
        if case.family != "curved":
            assert (
                abs(tangent[1]) < 1e-9
            ), case.name  # twisted about its own axis, so the tangent stays in the plane
        x0, z0 = end_of_arc(length, 0, rest)
        x, z = end_of_arc(grown * length, 0, rest + bent)
        assert abs(x - x0 - move[0]) < 1e-5 and abs(z - z0 - move[2]) < 1e-5 and move[1] == 0, (
            case.name,
            move,
            x - x0,
            z - z0,
        )
    if case.family in ("twist", "combined") and case.counted:
        # d1 turned about the tangent, against the normal the bend alone would have
        d1 = [row[0] for row in turned]
        normal = [math.cos(bent), 0, -math.sin(bent)]
        twist = math.degrees(math.acos(sum(a * b for a, b in zip(d1, normal))))
        assert abs(twist / wrinkling_deg[t] - 0.5) < 0.011, (case.name, twist)
    if case.family == "fresh":
        check_fresh(case, limit, tangent, turned, move, length)
        assert t not in wrinkling_deg, case.name  # no wall the table was made from
    if case.family == "stretch":
        assert (
            abs(move[2] - (case.ratio - 1) * length) < 1e-9 and "rotate_deg" not in moved
        ), case.name
    assert tube["around"] == 48 and tube["along"] % 2 == 0, case.name

coarse = cases[0].changed(around=24)
assert (coarse.tube["around"], coarse.tube["along"]) == (24, cases[0].tube["along"] // 2) and cases[
    0
].tube["around"] == 48
stiff = cases[0].changed(wall={"young": 2})
assert (
    stiff.wall["young"] == 2
    and stiff.wall["thickness"] == cases[0].wall["thickness"]
    and cases[0].wall["young"] == 1
)

with tempfile.TemporaryDirectory() as scratch:
    file = Path(scratch) / "other.yaml"
    file.write_text(cases[0].text())
    try:
        read_case(file)
        raise AssertionError("a case whose scene is not named as its file was accepted")
    except SystemExit as refusal:
        assert "expected the file's name other" in str(refusal), refusal
    # vasorod reads the same files, notes and all
    file = Path(scratch) / "scene.yaml"
    file.write_text(coarse.text())
    done = subprocess.run(
        [
            sys.argv[2],
            "solve",
            str(file),
            "-o",
            str(Path(scratch) / "result"),
            "--fidelity",
            "skin",
            "-q",
        ],
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
