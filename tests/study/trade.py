"""The CalculiX side and the Pareto front: bricks of positive volume, shells whose normals point
outwards, ends that move as rigid disks, ccx's print read back; nothing on the front is beaten.
Usage: trade.py SOURCE_FOLDER VASOROD."""

import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(sys.argv[1]) / "benchmarks" / "study"))
import calculix  # noqa: E402
from cases import case_named  # noqa: E402
from chapters.trade import front_of  # noqa: E402

case = case_named("bend_t1_0.5")
n, m = 16, 12
bricks = calculix.Mesh(case, "C3D20R", n, m)
# corners and mid-edges of a ring of 20-node bricks
corners, edges = 2 * n * (m + 1), n * (m + 1) + 2 * n * (m + 1) + 2 * n * m
assert len(bricks.number) == corners + edges, (len(bricks.number), corners + edges)
point = {number: bricks.point[key] for key, number in bricks.number.items()}


def volume(nodes):
    """Of the parallelepiped at the first corner: positive for a right-handed brick."""
    a, b, d, e = (point[nodes[k]] for k in (0, 1, 3, 4))
    u, v, w = ([y - x for x, y in zip(a, p)] for p in (b, d, e))
    return (
        u[0] * (v[1] * w[2] - v[2] * w[1])
        - u[1] * (v[0] * w[2] - v[2] * w[0])
        + u[2] * (v[0] * w[1] - v[1] * w[0])
    )


for j, k in ((0, 0), (n - 1, m - 1), (3, 5)):
    nodes = bricks.element(j, k)
    assert len(set(nodes)) == 20 and volume(nodes) > 0, (j, k)
    for edge, (a, b) in zip(
        nodes[8:],
        [
            (0, 1),
            (1, 2),
            (2, 3),
            (3, 0),
            (4, 5),
            (5, 6),
            (6, 7),
            (7, 4),
            (0, 4),
            (1, 5),
            (2, 6),
            (3, 7),
        ],
    ):
        middle = [(x + y) / 2 for x, y in zip(point[nodes[a]], point[nodes[b]])]
        assert (
            math.dist(middle, point[edge]) < 0.25
        ), "a mid-edge node is not between its corners"  # the sagitta of half a step
for key in bricks.middle():
    x, y, z = bricks.point[key]
    assert abs(math.hypot(x, y) - 10) < 1e-12

shell = calculix.Mesh(case, "S8R", n, m)
rows = m + 2  # a sleeve beyond either end
assert (
    len(shell.number) == n * (rows + 1) + n * (rows + 1) + n * rows
)  # corners, edges around, edges along
at = {number: shell.point[key] for key, number in shell.number.items()}
for j, k in ((0, 0), (n - 1, rows - 1), (3, 5)):
    a, b, _, d = (at[node] for node in shell.element(j, k)[:4])
    u, v = ([q - p for p, q in zip(a, c)] for c in (b, d))
    outwards = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
    assert sum(x * y for x, y in zip(outwards, a[:2])) > 0, (j, k)
assert {shell.point[key][2] for key in shell.held()} == {-1, -0.5, 0} and {
    shell.point[key][2] for key in shell.moved()
} == {100, 100.5, 101}
for mesh in (bricks, shell):
    middle = [mesh.point[key] for key in mesh.middle()]
    assert (
        len(middle) == n * (m + 1)
        and min(p[2] for p in middle) == 0
        and max(p[2] for p in middle) == 100
    )

for kind, mesh in (("S8R", shell), ("C3D20R", bricks)):
    lines = calculix.input_text(case, kind, n, m).splitlines()
    boundary = lines[
        lines.index("*BOUNDARY") + 1 : lines.index("*NODE PRINT, NSET=MIDDLE, FREQUENCY=1000")
    ]
    target = {}
    for words in (line.split(",") for line in boundary):
        if len(words) == 4:
            target.setdefault(int(words[0]), [0, 0, 0])[int(words[1]) - 1] = float(words[3])
    assert set(target) == {mesh.number[key] for key in mesh.moved()} and len(boundary) == len(
        mesh.held()
    ) + 3 * len(target)
    rest = {mesh.number[key]: mesh.point[key] for key in mesh.moved()}
    now = {node: [p + u for p, u in zip(rest[node], by)] for node, by in target.items()}
    nodes = sorted(now)
    for a, b in zip(nodes, nodes[7:]):  # a rigid motion keeps distances
        assert abs(math.dist(rest[a], rest[b]) - math.dist(now[a], now[b])) < 1e-9
    center = [
        sum(
            now[mesh.number[key]][k] for key in mesh.moved() if abs(mesh.point[key][2] - 100) < 1e-9
        )
        for k in range(3)
    ]
    count = sum(abs(mesh.point[key][2] - 100) < 1e-9 for key in mesh.moved())
    assert math.dist([x / count for x in center], [12.28099101, 0, 100 - 1.012664705]) < 1e-8
turn = calculix.rotation([0, 90, 0])
assert (
    max(
        abs(a - b)
        for row, want in zip(turn, ((0, 0, 1), (0, 1, 0), (-1, 0, 0)))
        for a, b in zip(row, want)
    )
    < 1e-12
)

moved, forces = calculix.read_blocks(
    """
 displacements (vx,vy,vz) for set MIDDLE and time  0.5000000E+00

        18  1.0E+00  0.0E+00  0.0E+00

 displacements (vx,vy,vz) for set MIDDLE and time  0.1000000E+01

        18  1.228099E+01 -1.5E-03  2.0E+00

 forces (fx,fy,fz) for set END and time  0.1000000E+01

         7  1.0E+00  2.0E+00  3.0E+00
"""
)
assert moved == {18: [12.28099, -0.0015, 2.0]} and forces == {7: [1.0, 2.0, 3.0]}, (moved, forces)

runs = [{"seconds": s, "rms": e} for s, e in ((3, 0.1), (1, 0.5), (2, 0.6), (4, 0.1), (5, 0.01))]
assert [(r["seconds"], r["rms"]) for r in front_of(runs)] == [(1, 0.5), (3, 0.1), (5, 0.01)]
