#!/usr/bin/env python3
"""The bundled infant anatomy: superior vena cava, pulmonary artery, aorta and heart of a child of 3
to 6 months (body surface about 0.30 m^2), before a Glenn operation. Drawn, not scanned: sizes from
the literature (meshes/README.md), outer walls, in mm.

Frame: x to the patient's left, y to the back, z to the head (LPS); the origin lies in the ascending
aorta at the height of the right pulmonary artery.

Usage: infant_anatomy.py [FOLDER], by default the folder `infant` beside this file.
Needs gmsh, numpy, scipy.
"""

import sys
from pathlib import Path

import numpy as np

from blended_surface import Ellipsoid, Tube, corner_angles, edges_of, surface
from vtp import write_vtp

# Control points of the centerlines: x, y, z and the outer radius there. The first point of the
# first tube is the file's first end.
SVC = Tube(
    [  # from the innominate veins to the right atrium, gently convex to the right
        (-9.2, 2.7, 31, 3.3),
        (-10, 2.55, 24, 3.3),
        (-10.5, 2.4, 16, 3.3),
        (-10.45, 2.25, 8, 3.3),
        (-9.9, 2.05, 0, 3.35),
        (-8.9, 1.9, -8, 3.5),
    ]
)
AORTA = [
    Tube(
        [  # root, ascending part, arch over the pulmonary artery, descending part
            (3, -1.6, -13, 5.0),
            (1, -0.9, -6, 5.0),
            (-0.7, 0.45, 2, 5.0),
            (-1.3, 2.8, 10, 5.0),
            (0.75, 5.45, 16.5, 4.8),
            (4.8, 9.5, 20, 4.5),
            (8.3, 15.3, 18.2, 4.2),
            (9.6, 19.5, 11, 3.9),
            (9.8, 21.2, 2, 3.7),
            (9.5, 21.8, -8, 3.6),
            (9.2, 22, -18, 3.6),
        ]
    ),
    Tube(
        [(2.2, 6.3, 17, 2.2), (0.3, 4.9, 23, 2.1), (-1.5, 3.7, 32, 2.1)], branch=True
    ),  # brachiocephalic trunk
    Tube(
        [(5.2, 8.9, 18, 1.6), (5.3, 8.7, 25, 1.5), (5.2, 7.6, 32, 1.5)], branch=True
    ),  # left common carotid
    Tube([(7.4, 12.5, 18, 1.7), (9.5, 13, 25, 1.6), (13, 12.5, 31, 1.6)], branch=True),
]  # left subclavian
PULMONARY_ARTERY = [
    Tube(
        [  # trunk and left branch, on its way under the arch
            (10, -11, -12, 5.0),
            (11.6, -6, -6.5, 5.0),
            (12.2, 0, -2, 4.9),
            (12.6, 5.5, 0.8, 4.4),
            (14.5, 10.5, 2.2, 3.4),
            (18.5, 14.2, 2, 3.0),
            (24, 17, 0, 2.9),
        ]
    ),
    Tube(
        # right branch, behind the ascending aorta and the superior vena cava, falling to the right
        [
            (11.5, 4.5, 0.6, 3.1),
            (7, 8, 1.4, 3.1),
            (1.5, 9.4, 1.1, 3.1),
            (-5, 9.5, -0.6, 3.3),
            (-12, 9.8, -3, 3.7),
            (-19, 10.8, -6, 4.0),
            (-26, 12, -9.4, 4.1),
        ],
        branch=True,
    ),
]
HEART = [
    Ellipsoid(
        (8.5, -7.5, -36), (17.5, 16, 21), (12, -30, 0)
    ),  # ventricles, the apex to the left, front and down
    Ellipsoid((-10, 2.5, -19.3), (9, 9, 10.5)),  # right atrium
    Ellipsoid((6, 6.5, -25), (12, 10, 10)),
]  # left atrium
HEART_START = [Ellipsoid((2, -2, -30), (22, 20, 22))]

# name, bodies, target edge (mm; sets the vertex counts of README.md), width of the blend at the
# crotches (mm), start of the mesh
PARTS = [
    ("svc", [SVC], 0.4218, 0, None),
    ("pulmonary_artery", PULMONARY_ARTERY, 0.4788, 2.0, None),
    ("aorta", AORTA, 0.592, 1.6, None),
    ("heart", HEART, 1.7, 6.0, HEART_START),
]


def report(name, points, triangles):
    edges, sides, _ = edges_of(triangles)
    length = np.linalg.norm(points[edges[:, 0]] - points[edges[:, 1]], axis=1)
    angle = np.degrees(corner_angles(points, triangles))
    print(
        f"{name}: {len(points)} vertices, {len(triangles)} triangles,"
        f" {np.sum(sides[:, 1] < 0)} edges on ends, edge {length.mean():.3f} ({length.min():.3f} to"
        f" {length.max():.3f}) mm, smallest angle {angle.min():.1f}, largest"
        f" {angle.max():.1f} degrees"
    )


def main():
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent / "infant"
    folder.mkdir(parents=True, exist_ok=True)
    for name, bodies, edge, width, start in PARTS:
        points, triangles = surface(bodies, edge, width, start)
        report(name, points, triangles)
        write_vtp(folder / f"{name}.vtp", points, triangles)


if __name__ == "__main__":
    main()
