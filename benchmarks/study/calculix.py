"""CalculiX (ccx), a program a user might choose instead, on a case's straight tube: eight-node
shells (S8R) or one layer of C3D20R bricks, S = C : E by NLGEOM. Both ends are glued to rigid disks
whose points move on straight paths. For a shell only displacements are prescribed: a sleeve, one
row of elements as long as the wall is thick, moves with the disk and holds the rim's directors.
(With rotations prescribed on the rim, ccx 2.20 cut its steps below the smallest.)"""

import json
import math
import shutil

from runs import Run

PROGRAM = shutil.which("ccx")
LAYERS = {
    "S8R": (1,),
    "C3D20R": (0, 1, 2),
}  # of nodes through the wall, in half thicknesses from the inner face


def rotation(vector_deg):
    """Rotation matrix of a rotation vector (Rodrigues)."""
    v = [math.radians(a) for a in vector_deg]
    angle = math.sqrt(sum(a * a for a in v))
    k = [a / angle for a in v] if angle else [0.0, 0.0, 1.0]
    c, s = math.cos(angle), math.sin(angle)
    cross = [[0, -k[2], k[1]], [k[2], 0, -k[0]], [-k[1], k[0], 0]]
    return [
        [(i == j) * c + s * cross[i][j] + (1 - c) * k[i] * k[j] for j in range(3)] for i in range(3)
    ]


class Mesh:
    """Nodes on a half-step grid (layer, around 0..2n, along 0..2 rows); quadratic elements have
    none with two odd indices."""

    def __init__(self, case, kind, n, m):
        tube, t = case.tube, case.wall["thickness"]
        self.kind, self.n, self.radius, self.length = kind, n, tube["radius"], tube["length"]
        self.sleeve = 1 if kind == "S8R" else 0  # rows of elements beyond either end
        self.rows = m + 2 * self.sleeve
        z = [self.length * k / m for k in range(m + 1)]
        if self.sleeve:
            z = [-t, *z, self.length + t]
        self.number, self.point = {}, {}
        for k in range(2 * self.rows + 1):
            for j in range(2 * n):
                for i in LAYERS[kind]:
                    if (i % 2 if kind == "C3D20R" else 0) + (j % 2) + (k % 2) > 1:
                        continue
                    r, angle = self.radius + (i - 1) * t / 2, math.pi * j / n
                    self.number[i, j, k] = len(self.number) + 1
                    self.point[i, j, k] = (
                        r * math.cos(angle),
                        r * math.sin(angle),
                        (z[k // 2] + z[(k + 1) // 2]) / 2,
                    )

    def element(self, j, k):
        """CalculiX's node order: corners, then mid-edges, of shells with the normal outwards; of
        bricks bottom before top, uprights last."""

        def at(i, dj, dk):
            return self.number[i, (2 * j + dj) % (2 * self.n), 2 * k + dk]

        square, edges = [(0, 0), (2, 0), (2, 2), (0, 2)], [(1, 0), (2, 1), (1, 2), (0, 1)]
        if self.kind == "S8R":
            return [at(1, *p) for p in square + edges]
        return (
            [at(*p, 0) for p in square]
            + [at(*p, 2) for p in square]
            + [at(*p, 0) for p in edges]
            + [at(*p, 2) for p in edges]
            + [at(*p, 1) for p in square]
        )

    def held(self):
        return [key for key in self.number if key[2] <= 2 * self.sleeve]

    def moved(self):
        return [key for key in self.number if key[2] >= 2 * (self.rows - self.sleeve)]

    def middle(self):
        """Mid-wall nodes at the elements' corners between the ends, row by row."""
        return [
            (1, j, k)
            for k in range(2 * self.sleeve, 2 * (self.rows - self.sleeve) + 1, 2)
            for j in range(0, 2 * self.n, 2)
        ]


def input_text(case, kind, n, m):
    mesh, wall, moved = Mesh(case, kind, n, m), case.wall, case.scene["ends"][1]
    out = ["*NODE, NSET=ALL"]
    out += [
        f"{number},{','.join(f'{x:.12g}' for x in mesh.point[key])}"
        for key, number in mesh.number.items()
    ]
    out.append(f"*ELEMENT, TYPE={kind}, ELSET=WALL")
    for k in range(mesh.rows):
        for j in range(n):
            words = [str(k * n + j + 1), *map(str, mesh.element(j, k))]
            out += (
                [",".join(words)]
                if len(words) <= 16
                else [",".join(words[:15]) + ",", ",".join(words[15:])]
            )

    def node_set(name, keys):
        out.append(f"*NSET, NSET={name}")
        out.extend(f"{mesh.number[key]}," for key in keys)

    node_set("END", mesh.moved())
    node_set("MIDDLE", mesh.middle())
    out += ["*MATERIAL, NAME=M", "*ELASTIC", f"{wall['young']},{wall['poisson']}"]
    out += (
        ["*SHELL SECTION, ELSET=WALL, MATERIAL=M", f"{wall['thickness']}"]
        if kind == "S8R"
        else ["*SOLID SECTION, ELSET=WALL, MATERIAL=M"]
    )
    out += ["*STEP, NLGEOM, INC=200", "*STATIC", "0.25,1.,1e-4,0.5", "*BOUNDARY"]
    out += [f"{mesh.number[key]},1,3" for key in mesh.held()]
    turn, move = rotation(moved.get("rotate_deg", [0, 0, 0])), moved.get("move", [0, 0, 0])
    for key in mesh.moved():
        x, y, z = mesh.point[key]
        local = (x, y, z - mesh.length)
        for axis in range(3):
            value = sum(turn[axis][c] * local[c] for c in range(3)) - local[axis] + move[axis]
            out.append(f"{mesh.number[key]},{axis + 1},{axis + 1},{value:.12g}")
    out += [
        "*NODE PRINT, NSET=MIDDLE, FREQUENCY=1000",
        "U",
        "*NODE PRINT, NSET=END, FREQUENCY=1000",
        "RF",
        "*END STEP",
    ]
    return "\n".join(out) + "\n"


def run(case, kind, n, m):
    return Run(
        f"{case.name}/calculix-{kind}-{n}x{m}",
        "ccx",
        ("tube",),
        {"tube.inp": lambda: input_text(case, kind, n, m)},
        keep=True,
    )


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
    return (
        f'<DataArray type="{kind}" Name="{name}"'
        f' NumberOfComponents="{3 if kind == "Float64" else 1}" format="ascii">'
        + " ".join(f"{v:.15g}" for v in values)
        + "</DataArray>"
    )


def write_result(store, case, one, against):
    """A result folder `vasorod compare` reads: mid-wall points as triangles, reactions of the moved
    end about its centre."""
    kind, size = one.identity.rsplit("-", 2)[1:]
    mesh = Mesh(case, kind, *(int(w) for w in size.split("x")))
    n, m = mesh.n, mesh.rows - 2 * mesh.sleeve
    moved_by, forces = read_blocks((store.folder(one.identity) / "tube.dat").read_text())
    keys = mesh.middle()
    rest = [mesh.point[key] for key in keys]
    step = [moved_by[mesh.number[key]] for key in keys]
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
        '<?xml version="1.0"?><VTKFile type="PolyData" version="0.1"'
        ' byte_order="LittleEndian"><PolyData>'
        f'<Piece NumberOfPoints="{len(rest)}" NumberOfVerts="0" NumberOfLines="0"'
        f' NumberOfStrips="0" NumberOfPolys="{len(triangles) // 3}">'
        f'<PointData>{array("RestPosition", flat(rest))}{array("Displacement", flat(step))}'
        "</PointData><CellData></CellData>"
        f'<Points>{array("Points", flat(current))}</Points>'
        f'<Polys>{array("connectivity", triangles, "Int64")}'
        f'{array("offsets", range(3, len(triangles) + 1, 3), "Int64")}</Polys>'
        "</Piece></PolyData></VTKFile>\n"
    )
    result = json.loads((store.folder(against.identity) / "result" / "result.json").read_text())
    moved = case.scene["ends"][1]
    center = [x + y for x, y in zip((0, 0, mesh.length), moved.get("move", [0, 0, 0]))]
    turn = rotation(moved.get("rotate_deg", [0, 0, 0]))
    force, moment = [0.0] * 3, [0.0] * 3
    for key in mesh.moved():
        x, y, z = mesh.point[key]
        f = forces[mesh.number[key]]
        arm = [sum(turn[a][c] * (x, y, z - mesh.length)[c] for c in range(3)) for a in range(3)]
        force = [a + b for a, b in zip(force, f)]
        moment = [
            moment[0] + arm[1] * f[2] - arm[2] * f[1],
            moment[1] + arm[2] * f[0] - arm[0] * f[2],
            moment[2] + arm[0] * f[1] - arm[1] * f[0],
        ]
    result["program"], result["fidelity"] = "vasorod study, from what CalculiX printed", kind
    result["ends"][1].update(force=force, moment=moment, center=center)
    result["vessels"] = [{"name": "tube", "obstacle": False, "surface": "tube.vtp"}]
    (folder / "result.json").write_text(json.dumps(result, indent=1))
