"""The CalculiX side and the Pareto front: bricks of positive volume, node sets where they belong, ccx's print read back, reactions summed as a
wrench; nothing on the front is beaten. Usage: trade.py SOURCE_FOLDER VASOROD."""

import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(sys.argv[1]) / "benchmarks" / "study"))
import calculix  # noqa: E402
from cases import case_named  # noqa: E402
from report import front_of  # noqa: E402

case = case_named("bend_t1_0.5")
n, m = 16, 12
bricks = calculix.Bricks(case, n, m)
# corners and mid-edges of a ring of bricks: 20-node counting by Euler, 4 corner columns' worth of edges
corners, edges = 2 * n * (m + 1), n * (m + 1) + 2 * n * (m + 1) + 2 * n * m
assert len(bricks.number) == corners + edges, (len(bricks.number), corners + edges)
point = {number: bricks.point[key] for key, number in bricks.number.items()}


def volume(nodes):
    """Of the parallelepiped at the first corner: positive for a right-handed brick."""
    a, b, d, e = (point[nodes[k]] for k in (0, 1, 3, 4))
    u, v, w = ([y - x for x, y in zip(a, p)] for p in (b, d, e))
    return u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) + u[2] * (v[0] * w[1] - v[1] * w[0])


for j, k in ((0, 0), (n - 1, m - 1), (3, 5)):
    nodes = bricks.element(j, k)
    assert len(set(nodes)) == 20 and volume(nodes) > 0, (j, k)
    for edge, (a, b) in zip(nodes[8:], [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]):
        middle = [(x + y) / 2 for x, y in zip(point[nodes[a]], point[nodes[b]])]
        assert math.dist(middle, point[edge]) < 0.25, "a mid-edge node is not between its corners"  # the sagitta of half a step
for key in bricks.middle():
    x, y, z = bricks.point[key]
    assert abs(math.hypot(x, y) - 10) < 1e-12
text = calculix.input_text(case, n, m)
assert text.count("\n*") + 1 == len([line for line in text.splitlines() if line.startswith("*")])
turn = calculix.rotation([0, 90, 0])
assert max(abs(a - b) for row, want in zip(turn, ((0, 0, 1), (0, 1, 0), (-1, 0, 0))) for a, b in zip(row, want)) < 1e-12

moved, forces = calculix.read_blocks("""
 displacements (vx,vy,vz) for set MIDDLE and time  0.5000000E+00

        18  1.0E+00  0.0E+00  0.0E+00

 displacements (vx,vy,vz) for set MIDDLE and time  0.1000000E+01

        18  1.228099E+01 -1.5E-03  2.0E+00

 forces (fx,fy,fz) for set END and time  0.1000000E+01

         7  1.0E+00  2.0E+00  3.0E+00
""")
assert moved == {18: [12.28099, -0.0015, 2.0]} and forces == {7: [1.0, 2.0, 3.0]}, (moved, forces)

runs = [{"seconds": s, "rms": e} for s, e in ((3, 0.1), (1, 0.5), (2, 0.6), (4, 0.1), (5, 0.01))]
assert [(r["seconds"], r["rms"]) for r in front_of(runs)] == [(1, 0.5), (3, 0.1), (5, 0.01)]
