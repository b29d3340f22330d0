"""Smooth triangle surfaces of blended bodies: gmsh's OpenCASCADE lofts and fuses them and meshes
the skin; the skin is then moved onto the smooth union of the bodies' distance fields (which rounds
every crotch) and relaxed there."""

import gmsh
import numpy as np
from scipy.interpolate import CubicSpline
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation


class Tube:
    """A tube about a spline through control points (x, y, z, radius). Its ends are planar, normal
    to the centerline; a branch starts inside another tube."""

    def __init__(self, control, branch=False, step=0.02):
        self.branch = branch
        control = np.asarray(control, float)
        chord = np.r_[0, np.cumsum(np.linalg.norm(np.diff(control[:, :3], axis=0), axis=1))]
        curve = CubicSpline(chord, control)
        fine = np.linspace(0, chord[-1], 4001)
        arc = np.r_[0, np.cumsum(np.linalg.norm(np.diff(curve(fine)[:, :3], axis=0), axis=1))]
        self.length = arc[-1]
        self.s = np.linspace(0, self.length, int(np.ceil(self.length / step)) + 1)
        at = np.interp(self.s, arc, fine)
        self.x, self.radius = curve(at)[:, :3], curve(at)[:, 3]
        self.t = curve(at, 1)[:, :3]
        self.t /= np.linalg.norm(self.t, axis=1)[:, None]
        self._tree = cKDTree(self.x)

    def station(self, points):
        """Arc length of the nearest centerline sample."""
        return self.s[self._tree.query(points)[1]]

    def field(self, points):
        """Distance to the tube's wall (negative inside) and its gradient, the tube going on
        straight beyond its ends; a branch begins with a half ball."""
        k = self._tree.query(points)[1]
        d = points - self.x[k]
        along = np.sum(d * self.t[k], axis=1)
        if self.branch:
            along[k == 0] = np.maximum(along[k == 0], 0)
        d -= along[:, None] * self.t[k]
        rho = np.linalg.norm(d, axis=1)
        return rho - self.radius[k], d / np.maximum(rho, 1e-12)[:, None]

    def frames(self, samples):
        """Twist-free frames (columns: two normals, tangent) at the given samples, by double
        reflection."""
        normal = np.cross(self.t[samples[0]], np.eye(3)[np.argmin(abs(self.t[samples[0]]))])
        normal /= np.linalg.norm(normal)
        result = []
        for n, k in enumerate(samples):
            if n:
                j = samples[n - 1]
                v = self.x[k] - self.x[j]
                normal = normal - 2 * v * (v @ normal) / (v @ v)
                reflected = self.t[j] - 2 * v * (v @ self.t[j]) / (v @ v)
                w = self.t[k] - reflected
                normal = normal - 2 * w * (w @ normal) / (w @ w)
            result.append(np.column_stack([normal, np.cross(self.t[k], normal), self.t[k]]))
        return result

    def add_to(self, occ, spacing=3.0):
        """The tube as an OpenCASCADE solid, lofted through circles about `spacing` apart."""
        samples = (
            np.linspace(0, len(self.s) - 1, max(4, round(self.length / spacing)) + 1)
            .round()
            .astype(int)
        )
        wires = []
        for k, frame in zip(samples, self.frames(samples)):
            circle = occ.addCircle(0, 0, 0, self.radius[k])
            turn = Rotation.from_matrix(frame).as_rotvec()
            angle = np.linalg.norm(turn)
            if angle > 0:
                occ.rotate([(1, circle)], 0, 0, 0, *(turn / angle), angle)
            occ.translate([(1, circle)], *self.x[k])
            wires.append(occ.addWire([circle]))
        return [e for e in occ.addThruSections(wires, makeSolid=True, makeRuled=False) if e[0] == 3]


class Ellipsoid:
    """An ellipsoid: center, semi-axes, and a rotation vector in degrees."""

    def __init__(self, center, semi_axes, rotate_deg=(0, 0, 0)):
        self.center, self.semi_axes = np.asarray(center, float), np.asarray(semi_axes, float)
        self.turn = Rotation.from_rotvec(np.radians(rotate_deg))

    def station(self, points):
        return -(points - self.center)[:, 2]

    def field(self, points):
        """Distance to first order near the surface, and its unit gradient."""
        local = self.turn.inv().apply(points - self.center)
        scaled = np.linalg.norm(local / self.semi_axes, axis=1)
        slope = local / self.semi_axes**2 / scaled[:, None]
        steep = np.linalg.norm(slope, axis=1)
        return (scaled - 1) / steep, self.turn.apply(slope / steep[:, None])

    def add_to(self, occ):
        ball = occ.addSphere(0, 0, 0, 1)
        occ.dilate([(3, ball)], 0, 0, 0, *self.semi_axes)
        turn = self.turn.as_rotvec()
        angle = np.linalg.norm(turn)
        if angle > 0:
            occ.rotate([(3, ball)], 0, 0, 0, *(turn / angle), angle)
        occ.translate([(3, ball)], *self.center)
        return [(3, ball)]


def blend(bodies, width):
    """The smooth union: minimum of the fields, lowered by up to width / 6 where two differ by less
    than `width` (cubic, so C2)."""

    def field(points):
        value, slope = bodies[0].field(points)
        for body in bodies[1:]:
            other, other_slope = body.field(points)
            near = np.maximum(width - abs(value - other), 0) / width
            share = np.where(value < other, 1 - near**2 / 2, near**2 / 2)[:, None]
            value = np.minimum(value, other) - near**3 * width / 6
            slope = share * slope + (1 - share) * other_slope
        return value, slope

    return field


def skin(bodies, edge):
    """gmsh's frontal mesh of the fused bodies' surface without end caps: points, triangles."""
    gmsh.initialize()
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.option.setNumber("General.NumThreads", 1)
        occ = gmsh.model.occ
        solids = [body.add_to(occ) for body in bodies]
        if len(solids) > 1:
            occ.fuse(solids[0], sum(solids[1:], []))
        occ.synchronize()
        gmsh.option.setNumber("Mesh.MeshSizeMin", edge)
        gmsh.option.setNumber("Mesh.MeshSizeMax", edge)
        gmsh.option.setNumber("Mesh.Algorithm", 6)
        gmsh.model.mesh.generate(2)
        tags, xyz, _ = gmsh.model.mesh.getNodes()
        walls = [
            tag for _, tag in gmsh.model.getEntities(2) if gmsh.model.getType(2, tag) != "Plane"
        ]
        triangles = np.vstack(
            [gmsh.model.mesh.getElementsByType(2, tag)[1].reshape(-1, 3) for tag in walls]
        )
    finally:
        gmsh.finalize()
    row = np.zeros(int(tags.max()) + 1, int)
    row[tags] = np.arange(len(tags))
    used, triangles = np.unique(row[triangles], return_inverse=True)
    return xyz.reshape(-1, 3)[used], triangles.reshape(-1, 3)


def edges_of(triangles):
    """Undirected edges (sorted pairs), and for each its one or two triangles and their opposite
    vertices (-1 where none)."""
    half = np.vstack([triangles[:, [1, 2]], triangles[:, [2, 0]], triangles[:, [0, 1]]])
    owner = np.tile(np.arange(len(triangles)), 3)
    opposite = np.concatenate([triangles[:, 0], triangles[:, 1], triangles[:, 2]])
    edges, inverse, count = np.unique(
        np.sort(half, axis=1), axis=0, return_inverse=True, return_counts=True
    )
    if count.max() > 2:
        raise SystemExit("blended_surface: an edge has more than two triangles")
    order = np.argsort(inverse.ravel(), kind="stable")
    first = np.r_[0, np.cumsum(count)[:-1]]
    sides = np.full((len(edges), 2), -1)
    across = np.full((len(edges), 2), -1)
    for side in (0, 1):
        has = count > side
        sides[has, side] = owner[order[first[has] + side]]
        across[has, side] = opposite[order[first[has] + side]]
    return edges, sides, across


def corner_angles(points, triangles):
    """Angles at the three corners of each triangle, in radians."""
    p = points[triangles]
    angles = []
    for k in range(3):
        a, b = p[:, (k + 1) % 3] - p[:, k], p[:, (k + 2) % 3] - p[:, k]
        angles.append(np.arctan2(np.linalg.norm(np.cross(a, b), axis=1), np.sum(a * b, axis=1)))
    return np.column_stack(angles)


def flip_edges(points, triangles):
    """One sweep of Delaunay flips (opposite angles above 180 degrees together), each triangle
    touched at most once."""
    edges, sides, across = edges_of(triangles)
    angle = corner_angles(points, triangles)
    inner = sides[:, 1] >= 0

    def angle_at(triangle, vertex):
        return angle[triangle, np.argmax(triangles[triangle] == vertex[:, None], axis=1)]

    total = np.zeros(len(edges))
    total[inner] = sum(angle_at(sides[inner, k], across[inner, k]) for k in (0, 1))
    known = set(map(tuple, edges))
    taken = np.zeros(len(triangles), bool)
    triangles = triangles.copy()
    flips = 0
    for e in np.argsort(-total, kind="stable"):
        if total[e] <= np.pi + 1e-6:
            break
        (s, t), (c, d) = sides[e], across[e]
        if taken[s] or taken[t] or (min(c, d), max(c, d)) in known:
            continue
        k = int(np.argmax(triangles[s] == c))
        a, b = triangles[s][(k + 1) % 3], triangles[s][(k + 2) % 3]  # triangle s is c, a, b
        triangles[s], triangles[t] = (c, a, d), (c, d, b)
        taken[s] = taken[t] = True
        known.add((min(c, d), max(c, d)))
        flips += 1
    return triangles, flips


def project(points, field, steps=8):
    """Newton steps along the gradient onto field = 0."""
    for _ in range(steps):
        value, slope = field(points)
        points = points - (value / np.sum(slope**2, axis=1))[:, None] * slope
    return points


def relax(points, triangles, field, sweeps=40):
    """Moves inner vertices onto field = 0 and, along it, towards the mean of their neighbours,
    flipping edges between; ends stay put."""
    edges, sides, _ = edges_of(triangles)
    fixed = np.zeros(len(points), bool)
    fixed[edges[sides[:, 1] < 0].ravel()] = True
    free = ~fixed
    points = points.copy()
    points[free] = project(points[free], field)
    for _ in range(sweeps):
        triangles, _ = flip_edges(points, triangles)
        edges, _, _ = edges_of(triangles)
        total, count = np.zeros_like(points), np.zeros(len(points))
        for a, b in (edges.T, edges.T[::-1]):
            np.add.at(total, a, points[b])
            np.add.at(count, a, 1)
        step = 0.5 * (total / count[:, None] - points)
        slope = field(points)[1]
        slope /= np.linalg.norm(slope, axis=1)[:, None]
        step -= np.sum(step * slope, axis=1)[:, None] * slope
        points[free] = project((points + step)[free], field, 3)
    return points, triangles


def surface(bodies, edge, width, start=None):
    """The blended surface of `bodies`, outward oriented, vertices ordered along the bodies (the
    first body's start comes first). `start`: the bodies that are meshed at first, where the skin of
    the fused `bodies` has seams that meet at a point.
    """
    field = blend(bodies, width)
    points, triangles = relax(*skin(start or bodies, edge), field, 150 if start else 40)
    p = points[triangles]
    normal = np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])
    if np.sum(normal * field(p.mean(axis=1))[1]) < 0:
        triangles = triangles[:, ::-1]
    nearest = np.argmin([body.field(points)[0] for body in bodies], axis=0)
    along = np.choose(nearest, [body.station(points) for body in bodies])
    order = np.lexsort((along.round(6), nearest))
    rank = np.empty(len(points), int)
    rank[order] = np.arange(len(points))
    triangles = rank[triangles]
    lowest = np.argmin(triangles, axis=1)
    triangles = np.take_along_axis(triangles, (lowest[:, None] + np.arange(3)) % 3, axis=1)
    return points[order], triangles[np.lexsort(triangles.T[::-1])]
