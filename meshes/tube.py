#!/usr/bin/env python3
"""Meshes of tubes by gmsh: straight, bent to a circular arc, tapered in radius and thickness.

  hex       hexahedra of the wall, `--layers` through its thickness      (finite-element solid)
  quad      quadrilaterals of the mid-wall surface                       (finite-element shell)
  triangle  near-equilateral triangles of the mid-wall surface           (hybrid model)

The centerline starts at the origin along +z and turns towards +x, as a scene's `tube:` does with
its default normal. Written by the file's ending: .msh (gmsh 4.1, or 2.2 with --msh2; deal.II's
GridIn::read_msh reads both) or, triangles only, .vtp. Physical tags: cells 10, start 1, end 2; of
hexahedra also inner 3 and outer wall 4. Lengths in whatever unit the numbers are in.
"""

import argparse
import math

import gmsh
import numpy as np

from vtp import write_vtp

CELLS, START, END, INNER, OUTER = 10, 1, 2, 3, 4


def arguments():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("out", help="file to write: .msh or .vtp")
    parser.add_argument("--cells", choices=["hex", "quad", "triangle"], default="hex")
    parser.add_argument("--length", type=float, required=True, help="of the centerline")
    parser.add_argument("--radius", type=float, required=True, help="mid-wall")
    parser.add_argument("--thickness", type=float, default=0, help="of the wall (hex only)")
    parser.add_argument("--end-radius", type=float, help="default: --radius")
    parser.add_argument("--end-thickness", type=float, help="default: --thickness")
    parser.add_argument(
        "--bend-deg", type=float, default=0, help="total angle of the circular centerline"
    )
    parser.add_argument("--around", type=int, default=16, help="cells around, a multiple of 4")
    parser.add_argument("--along", type=int, default=16, help="cells along (hex and quad)")
    parser.add_argument("--layers", type=int, default=1, help="cells through the wall (hex)")
    parser.add_argument("--msh2", action="store_true", help="write gmsh format 2.2")
    given = parser.parse_args()
    given.end_radius = given.radius if given.end_radius is None else given.end_radius
    given.end_thickness = given.thickness if given.end_thickness is None else given.end_thickness
    if given.around % 4 or min(given.around, given.along, given.layers) < 1:
        parser.error("--around must be a positive multiple of 4, --along and --layers positive")
    if min(given.length, given.radius, given.end_radius) <= 0:
        parser.error("--length and radii must be positive")
    if given.cells == "hex":
        for radius, thickness in (
            (given.radius, given.thickness),
            (given.end_radius, given.end_thickness),
        ):
            if not 0 < thickness < 2 * radius:
                parser.error(
                    f"a wall of thickness {thickness} does not fit mid-wall radius {radius}"
                )
    if (
        given.out.endswith(".vtp")
        and given.cells != "triangle"
        or not given.out.endswith((".vtp", ".msh"))
    ):
        parser.error("write .msh, or .vtp with --cells triangle")
    return given


def circle(geo, radius):
    """Four quarter arcs about the origin in the plane z = 0, and their start points."""
    center = geo.addPoint(0, 0, 0)
    points = [
        geo.addPoint(radius * x, radius * y, 0) for x, y in ((1, 0), (0, 1), (-1, 0), (0, -1))
    ]
    return [geo.addCircleArc(points[k], center, points[(k + 1) % 4]) for k in range(4)], points


def straight_hex(given):
    geo = gmsh.model.geo
    inner, inner_points = circle(geo, given.radius - given.thickness / 2)
    outer, outer_points = circle(geo, given.radius + given.thickness / 2)
    spokes = [geo.addLine(a, b) for a, b in zip(inner_points, outer_points)]
    for curve in inner + outer:
        geo.mesh.setTransfiniteCurve(curve, given.around // 4 + 1)
    for curve in spokes:
        geo.mesh.setTransfiniteCurve(curve, given.layers + 1)
    groups = {START: [], END: [], INNER: [], OUTER: [], CELLS: []}
    for k in range(4):
        loop = geo.addCurveLoop([spokes[k], outer[k], -spokes[(k + 1) % 4], -inner[k]])
        face = geo.addPlaneSurface([loop])
        geo.mesh.setTransfiniteSurface(face)
        geo.mesh.setRecombine(2, face)
        top, volume, _, wall, _, lumen = geo.extrude(
            [(2, face)], 0, 0, given.length, [given.along], recombine=True
        )
        for tag, entity in (
            (START, face),
            (END, top[1]),
            (INNER, lumen[1]),
            (OUTER, wall[1]),
            (CELLS, volume[1]),
        ):
            groups[tag].append(entity)
    geo.synchronize()
    for tag, entities in groups.items():
        gmsh.model.addPhysicalGroup(3 if tag == CELLS else 2, entities, tag)
    gmsh.model.mesh.generate(3)


def straight_quad(given):
    geo = gmsh.model.geo
    arcs, _ = circle(geo, given.radius)
    for curve in arcs:
        geo.mesh.setTransfiniteCurve(curve, given.around // 4 + 1)
    swept = [
        geo.extrude([(1, arc)], 0, 0, given.length, [given.along], recombine=True) for arc in arcs
    ]
    geo.synchronize()
    gmsh.model.addPhysicalGroup(2, [s[1][1] for s in swept], CELLS)
    gmsh.model.addPhysicalGroup(1, arcs, START)
    gmsh.model.addPhysicalGroup(1, [s[0][1] for s in swept], END)
    gmsh.model.mesh.generate(2)


def straight_triangle(given):
    occ = gmsh.model.occ
    occ.addCylinder(0, 0, 0, 0, 0, given.length, given.radius)
    occ.synchronize()
    edge = 2 * math.pi * given.radius / given.around
    gmsh.option.setNumber("Mesh.MeshSizeMin", edge)
    gmsh.option.setNumber("Mesh.MeshSizeMax", edge)
    gmsh.option.setNumber("Mesh.Algorithm", 6)
    walls = [
        tag for _, tag in gmsh.model.getEntities(2) if gmsh.model.getType(2, tag) == "Cylinder"
    ]
    rims = {START: [], END: []}
    for _, tag in gmsh.model.getEntities(1):
        box = gmsh.model.getBoundingBox(1, tag)
        if box[5] - box[2] < 1e-3 * given.length:  # a circle, not the seam along the tube
            rims[START if box[2] < given.length / 2 else END].append(tag)
    gmsh.model.addPhysicalGroup(2, walls, CELLS)
    for tag, curves in rims.items():
        gmsh.model.addPhysicalGroup(1, curves, tag)
    gmsh.model.mesh.generate(2)


def shaped(points, given):
    """Straight, even tube -> its taper and bend: (radial share of the wall, angle, z) keep their
    meaning."""
    rho, phi = np.hypot(points[:, 0], points[:, 1]), np.arctan2(points[:, 1], points[:, 0])
    f = points[:, 2] / given.length
    depth = (rho - given.radius) / given.thickness if given.cells == "hex" else 0 * rho
    rho = (
        given.radius
        + f * (given.end_radius - given.radius)
        + depth * (given.thickness + f * (given.end_thickness - given.thickness))
    )
    theta = f * math.radians(given.bend_deg)
    x, z = 0 * theta, points[:, 2]
    if given.bend_deg:
        turn = given.length / math.radians(given.bend_deg)
        x, z = turn * (1 - np.cos(theta)), turn * np.sin(theta)
    return np.column_stack(
        [
            x + rho * np.cos(phi) * np.cos(theta),
            rho * np.sin(phi),
            z - rho * np.cos(phi) * np.sin(theta),
        ]
    )


def main():
    given = arguments()
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.option.setNumber("General.NumThreads", 1)
    {"hex": straight_hex, "quad": straight_quad, "triangle": straight_triangle}[given.cells](given)
    tags, xyz, _ = gmsh.model.mesh.getNodes()
    points = shaped(xyz.reshape(-1, 3), given)
    for tag, point in zip(tags, points):
        gmsh.model.mesh.setNode(tag, point, [])
    if given.out.endswith(".vtp"):
        cells = np.vstack(
            [
                gmsh.model.mesh.getElementsByType(2, tag)[1].reshape(-1, 3)
                for tag in gmsh.model.getEntitiesForPhysicalGroup(2, CELLS)
            ]
        )
        used, triangles = np.unique(cells, return_inverse=True)
        row = {int(tag): k for k, tag in enumerate(tags)}
        points, triangles = points[[row[int(tag)] for tag in used]], triangles.reshape(-1, 3)
        write_vtp(given.out, points, triangles)
    else:
        gmsh.option.setNumber("Mesh.MshFileVersion", 2.2 if given.msh2 else 4.1)
        gmsh.write(given.out)
    gmsh.finalize()


if __name__ == "__main__":
    main()
