#!/usr/bin/env python3
"""Irregular triangle surfaces of straight or bent tubes, as segmented vessels have them. A wall
model's answer must not depend on them.

  blue-noise   Delaunay triangles of random points at least 0.76 edges apart
  jittered     staggered rows, every point inside shifted by up to a quarter of an edge both ways
  stretched    staggered rows, edges along the axis `--aspect` times as long as around

Points lie on the exact mid-wall surface; the rims are regular. The centerline starts at the origin
along +z and turns towards +x, as a scene's `tube:` does with its default normal. The same arguments
and seed give the same file.
"""

import argparse
import math
from collections import defaultdict

import numpy as np

from vtp import write_vtp

KINDS = ("blue-noise", "jittered", "stretched")
SPACING = (
    0.76  # smallest distance over the edge length: about as many points as the structured mesh has
)
MISSES = 4000  # darts that missed one after the other until the sheet counts as full


def rows_of(around, length, edge, aspect):
    """Staggered rows on the unrolled tube: points (along the circle, along the axis) and triangles,
    counter-clockwise from outside."""
    rows = max(2, 2 * round(length / (edge * math.sqrt(3) / 2 * aspect) / 2))
    points = np.array(
        [
            (edge * (i + 0.5 * (r % 2)), length * r / rows)
            for r in range(rows + 1)
            for i in range(around)
        ]
    )
    triangles = []
    for r in range(rows):
        for i in range(around):
            a, b = r * around + i, r * around + (i + 1) % around
            c, d = a + around, b + around
            triangles += [(a, b, c), (b, d, c)] if r % 2 == 0 else [(a, b, d), (a, d, c)]
    return points, np.array(triangles), rows


class Sheet:
    """The unrolled tube, periodic around, with the points thrown so far in square bins."""

    def __init__(self, circle, spacing):
        self.circle, self.spacing = circle, spacing
        self.columns = int(
            circle / spacing
        )  # bins no narrower than the spacing, so the eight neighbours are enough
        self.bins, self.points = defaultdict(list), []

    def bin_of(self, x, y):
        return int(x / self.circle * self.columns) % self.columns, math.floor(y / self.spacing)

    def free(self, x, y):
        column, row = self.bin_of(x, y)
        for across in (-1, 0, 1):
            for up in (-1, 0, 1):
                for px, py in self.bins[(column + across) % self.columns, row + up]:
                    dx = abs(x - px)
                    dx = min(dx, self.circle - dx)
                    if dx * dx + (y - py) ** 2 < self.spacing**2:
                        return False
        return True

    def add(self, x, y):
        self.bins[self.bin_of(x, y)].append((x, y))
        self.points.append((x, y))


def thrown(around, length, edge, random):
    """Points at random, at least SPACING edges apart, regular rims first."""
    sheet = Sheet(around * edge, SPACING * edge)
    for start, y in ((0.5, 0.0), (0.0, length)):
        for i in range(around):
            sheet.add(edge * (i + start), y)
    missed = 0
    while missed < MISSES:
        x, y = random.uniform(0, sheet.circle), random.uniform(0.45 * edge, length - 0.45 * edge)
        if sheet.free(x, y):
            sheet.add(x, y)
            missed = 0
        else:
            missed += 1
    return np.array(sheet.points)


def joined(points, circle, length, edge):
    """Delaunay triangles of the sheet with a band of copies on either side, each taken once."""
    from scipy.spatial import Delaunay  # here, so that the other kinds need no SciPy

    band, shift, own = 6 * edge, np.array([circle, 0.0]), np.arange(len(points))
    right, left = points[:, 0] > circle - band, points[:, 0] < band
    copies = np.vstack([points, points[right] - shift, points[left] + shift])
    origin = np.concatenate([own, own[right], own[left]])
    taken = {}
    for simplex in Delaunay(copies).simplices:
        a, b, c = copies[simplex]
        at_one_rim = np.ptp(copies[simplex][:, 1]) < 1e-9 * length
        if at_one_rim or not 0 <= (a[0] + b[0] + c[0]) / 3 < circle:
            continue
        if (b - a)[0] * (c - a)[1] < (b - a)[1] * (c - a)[0]:
            simplex = simplex[[0, 2, 1]]
        taken[tuple(sorted(origin[simplex]))] = origin[simplex]
    return np.array([taken[key] for key in sorted(taken)])


def rolled(sheet, radius, length, bend):
    """The sheet on the tube whose centerline turns by `bend` radians."""
    phi, theta = sheet[:, 0] / radius, sheet[:, 1] / length * bend
    x, z = (
        (length / bend * (1 - np.cos(theta)), length / bend * np.sin(theta))
        if bend
        else (0 * theta, sheet[:, 1])
    )
    out = radius * np.cos(phi)
    return np.column_stack([x + out * np.cos(theta), radius * np.sin(phi), z - out * np.sin(theta)])


def irregular_tube(kind, length, radius, around, *, bend=0.0, aspect=5.0, seed=1):
    """(points, triangles) of one of KINDS; `around` counts points on a rim, `bend` is in
    radians."""
    edge, random = 2 * math.pi * radius / around, np.random.default_rng(seed)
    if kind == "blue-noise":
        sheet = thrown(around, length, edge, random)
        triangles = joined(sheet, around * edge, length, edge)
    else:
        sheet, triangles, rows = rows_of(
            around, length, edge, aspect if kind == "stretched" else 1.0
        )
        if kind == "jittered":
            inside = slice(around, len(sheet) - around)
            sheet[inside] += random.uniform(-0.25, 0.25, sheet[inside].shape) * (
                edge,
                length / rows,
            )
    return rolled(sheet, radius, length, bend), triangles


def smallest_angle(points, triangles):
    """Degrees."""
    a, b, c = (points[triangles[:, k]] for k in range(3))
    smallest = np.inf
    for p, q, r in ((a, b, c), (b, c, a), (c, a, b)):
        u, v = q - p, r - p
        cosine = np.sum(u * v, axis=1) / np.linalg.norm(u, axis=1) / np.linalg.norm(v, axis=1)
        smallest = min(smallest, np.degrees(np.arccos(np.clip(cosine, -1, 1))).min())
    return smallest


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("out", help="file to write: .vtp")
    parser.add_argument("--kind", choices=KINDS, required=True)
    parser.add_argument("--length", type=float, required=True, help="of the centerline")
    parser.add_argument("--radius", type=float, required=True, help="mid-wall")
    parser.add_argument("--around", type=int, default=48, help="points on a rim (default: 48)")
    parser.add_argument(
        "--bend-deg", type=float, default=0, help="total angle of the circular centerline"
    )
    parser.add_argument(
        "--aspect", type=float, default=5, help="of the stretched kind (default: 5)"
    )
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    if min(given.length, given.radius, given.aspect) <= 0 or given.around < 6:
        parser.error("--length, --radius and --aspect must be positive, --around 6 or more")
    points, triangles = irregular_tube(
        given.kind,
        given.length,
        given.radius,
        given.around,
        bend=math.radians(given.bend_deg),
        aspect=given.aspect,
        seed=given.seed,
    )
    write_vtp(given.out, points, triangles)
    print(
        f"{given.out}: {len(points)} points, {len(triangles)} triangles, smallest angle"
        f" {smallest_angle(points, triangles):.1f} degrees"
    )


if __name__ == "__main__":
    main()
