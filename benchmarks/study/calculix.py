"""CalculiX (ccx) on a case's straight tube: one layer of C3D20R bricks, S = C : E by NLGEOM, rigid ends moved along a straight path of every node."""

import json
import math
import shutil

from runs import Run

PROGRAM = shutil.which("ccx")


def rotation(vector_deg):
    """Rotation matrix of a rotation vector (Rodrigues)."""
    v = [math.radians(a) for a in vector_deg]
    angle = math.sqrt(sum(a * a for a in v))
    k = [a / angle for a in v] if angle else [0.0, 0.0, 1.0]
    c, s = math.cos(angle), math.sin(angle)
    cross = [[0, -k[2], k[1]], [k[2], 0, -k[0]], [-k[1], k[0], 0]]
    return [[(i == j) * c + s * cross[i][j] + (1 - c) * k[i] * k[j] for j in range(3)] for i in range(3)]


class Bricks:
    """Nodes on a half-step grid (radial 0..2, around 0..2n, along 0..2m); those with two odd indices do not exist on a 20-node brick."""

    def __init__(self, case, n, m):
        tube, t = case.tube, case.wall["thickness"]
        self.n, self.m, self.radius, self.length = n, m, tube["radius"], tube["length"]
        self.number, self.point = {}, {}
        for k in range(2 * m + 1):
            for j in range(2 * n):
                for i in range(3):
                    if (i % 2) + (j % 2) + (k % 2) > 1:
                        continue
                    r, angle = self.radius + (i - 1) * t / 2, math.pi * j / n
                    self.number[i, j, k] = len(self.number) + 1
                    self.point[i, j, k] = (r * math.cos(angle), r * math.sin(angle), self.length * k / (2 * m))

    def element(self, j, k):
        """C3D20R node order: bottom corners, top corners, bottom edges, top edges, uprights; `up` is along the axis."""
        def at(i, dj, dk):
            return self.number[i, (2 * j + dj) % (2 * self.n), 2 * k + dk]
        square = [(0, 0), (2, 0), (2, 2), (0, 2)]
        edges = [(1, 0), (2, 1), (1, 2), (0, 1)]
        return [at(*p, 0) for p in square] + [at(*p, 2) for p in square] + [at(*p, 0) for p in edges] + [at(*p, 2) for p in edges] + [at(*p, 1) for p in square]

    def middle(self):
        """Columns (j even, k even) of mid-wall nodes: the radial mid-edges, row by row."""
        return [(1, j, k) for k in range(0, 2 * self.m + 1, 2) for j in range(0, 2 * self.n, 2)]


def input_text(case, n, m):
    bricks, wall, moved = Bricks(case, n, m), case.wall, case.scene["ends"][1]
    out = ["*NODE, NSET=ALL"]
    out += [f"{number},{','.join(f'{x:.12g}' for x in bricks.point[key])}" for key, number in bricks.number.items()]
    out.append("*ELEMENT, TYPE=C3D20R, ELSET=WALL")
    for k in range(m):
        for j in range(n):
            nodes = bricks.element(j, k)
            out.append(",".join(map(str, [k * n + j + 1, *nodes[:14]])) + ",")
            out.append(",".join(map(str, nodes[14:])))
    def node_set(name, keys):
        out.append(f"*NSET, NSET={name}")
        out.extend(f"{bricks.number[key]}," for key in keys)
    end = [key for key in bricks.number if key[2] == 2 * m]
    node_set("END", end)
    node_set("MIDDLE", bricks.middle())
    out += ["*MATERIAL, NAME=M", "*ELASTIC", f"{wall['young']},{wall['poisson']}", "*SOLID SECTION, ELSET=WALL, MATERIAL=M",
            "*STEP, NLGEOM, INC=200", "*STATIC", "0.25,1.,1e-4,0.5", "*BOUNDARY"]
    out += [f"{number},1,3" for key, number in bricks.number.items() if key[2] == 0]
    turn, move = rotation(moved.get("rotate_deg", [0, 0, 0])), moved.get("move", [0, 0, 0])
    for key in end:
        x, y, z = bricks.point[key]
        local = (x, y, z - bricks.length)
        for axis in range(3):
            value = sum(turn[axis][c] * local[c] for c in range(3)) - local[axis] + move[axis]
            out.append(f"{bricks.number[key]},{axis + 1},{axis + 1},{value:.12g}")
    out += ["*NODE PRINT, NSET=MIDDLE, FREQUENCY=1000", "U", "*NODE PRINT, NSET=END, FREQUENCY=1000", "RF", "*END STEP"]
    return "\n".join(out) + "\n"


def run(case, n, m):
    return Run(f"{case.name}/calculix-C3D20R-{n}x{m}", "ccx", ("tube",), {"tube.inp": input_text(case, n, m)}, keep=True)


def read_blocks(text):
    """The last printed displacements and reactions: {node: vector} each."""
    blocks = {}
    for line in text.splitlines():
        words = line.split()
        if line.lstrip().startswith(("displacements", "forces")):
            blocks[words[0]] = current = {}
        elif len(words) == 4 and words[0].isdigit():
            current[int(words[0])] = [float(w) for w in words[1:]]
    return blocks["displacements"], blocks["forces"]


def array(name, values, kind="Float64"):
    return (f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{3 if kind == "Float64" else 1}" format="ascii">'
            + " ".join(f"{v:.15g}" for v in values) + "</DataArray>")


def write_result(store, case, one, against):
    """A result folder `vasorod compare` reads: mid-wall points as triangles, reactions of the moved end about its centre."""
    n, m = (int(w) for w in one.identity.rsplit("-", 1)[1].split("x"))
    bricks = Bricks(case, n, m)
    moved_by, forces = read_blocks((store.folder(one.identity) / "tube.dat").read_text())
    keys = bricks.middle()
    rest = [bricks.point[key] for key in keys]
    step = [moved_by[bricks.number[key]] for key in keys]
    triangles = []
    for k in range(m):
        for j in range(n):
            a, b = k * n + j, k * n + (j + 1) % n
            triangles += [a, b, a + n, b, b + n, a + n]
    folder = store.folder(one.identity) / "result"
    folder.mkdir(exist_ok=True)
    current = [[p + u for p, u in zip(point, by)] for point, by in zip(rest, step)]
    flat = lambda rows: [x for row in rows for x in row]  # noqa: E731
    (folder / "tube.vtp").write_text(
        '<?xml version="1.0"?><VTKFile type="PolyData" version="0.1" byte_order="LittleEndian"><PolyData>'
        f'<Piece NumberOfPoints="{len(rest)}" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="{len(triangles) // 3}">'
        f'<PointData>{array("RestPosition", flat(rest))}{array("Displacement", flat(step))}</PointData><CellData></CellData>'
        f'<Points>{array("Points", flat(current))}</Points>'
        f'<Polys>{array("connectivity", triangles, "Int64")}{array("offsets", range(3, len(triangles) + 1, 3), "Int64")}</Polys>'
        '</Piece></PolyData></VTKFile>\n')
    result = json.loads((store.folder(against.identity) / "result" / "result.json").read_text())
    center = [x + y for x, y in zip((0, 0, bricks.length), case.scene["ends"][1].get("move", [0, 0, 0]))]
    where = {number: key for key, number in bricks.number.items()}
    force, moment = [0.0] * 3, [0.0] * 3
    turn = rotation(case.scene["ends"][1].get("rotate_deg", [0, 0, 0]))
    for number, f in forces.items():
        x, y, z = bricks.point[where[number]]
        local = (x, y, z - bricks.length)
        arm = [sum(turn[a][c] * local[c] for c in range(3)) for a in range(3)]
        force = [a + b for a, b in zip(force, f)]
        moment = [moment[0] + arm[1] * f[2] - arm[2] * f[1], moment[1] + arm[2] * f[0] - arm[0] * f[2], moment[2] + arm[0] * f[1] - arm[1] * f[0]]
    result["program"], result["fidelity"] = "CalculiX", "C3D20R"
    result["ends"][1].update(force=force, moment=moment, center=center)
    result["vessels"] = [{"name": "tube", "obstacle": False, "surface": "tube.vtp"}]
    (folder / "result.json").write_text(json.dumps(result, indent=1))
