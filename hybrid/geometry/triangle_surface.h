// Properties of a triangle surface: edges, loops, areas, normals, Euler number.
#pragma once

#include <array>
#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// An undirected edge and its one or two triangles (-1: a boundary edge has one).
struct Edge {
  int a = 0, b = 0;  ///< a < b
  std::array<int, 2> triangle{-1, -1};
  std::array<int, 2> opposite{-1, -1};  ///< the vertex of each triangle that is not on the edge
  bool boundary() const { return triangle[1] < 0; }
};

/// One side of a triangle, in the triangle's direction.
struct HalfEdge {
  int from = 0, to = 0;
  int opposite = 0;  ///< the triangle's third vertex
  int triangle = 0;
};

/// The three sides of every triangle, sorted by the edge's lower vertex, by the other, and by the
/// triangle: those of one edge are neighbours.
std::vector<HalfEdge> half_edges_by_edge(const Triangles& triangles);

/// All edges, sorted by (a, b). Throws InputError if an edge has three or more triangles.
std::vector<Edge> edges_of(const Triangles& triangles);

/// Boundary loops. Each is a cycle of vertices in the direction of the boundary in its triangles,
/// with the surface on the left seen from outside. A loop starts with its lowest vertex index;
/// loops are sorted by that index. Throws InputError if a vertex joins two loops.
std::vector<std::vector<int>> boundary_loops(const Triangles& triangles);

/// Euler number V - E + F, over the vertices that triangles use.
int euler_number(const Triangles& triangles);

/// Component index per vertex (-1 for unused vertices), components numbered by lowest vertex.
std::vector<int> components(const Triangles& triangles, int vertex_count);

/// Normal of one triangle, outward in an outward surface; its length is twice the area, length^2.
Vec3 triangle_normal(const TriangleSurface& surface, int triangle);
/// Angle of one triangle at its corner (0 to 2), radians. `twice_area`: the length of its
/// triangle_normal().
double corner_angle(const TriangleSurface& surface, int triangle, int corner, double twice_area);
/// Centre of one triangle, length.
Vec3 triangle_center(const TriangleSurface& surface, int triangle);
/// Areas of the triangles, length^2.
Eigen::VectorXd triangle_areas(const TriangleSurface& surface);
/// Area per vertex, a third of its triangles' areas, length^2.
Eigen::VectorXd vertex_areas(const TriangleSurface& surface);
/// Angle-weighted unit normals of the vertices, n x 3.
Points vertex_normals(const TriangleSurface& surface);
/// Mean edge length, length.
double mean_edge_length(const TriangleSurface& surface);
/// Sum of the triangles' areas, length^2.
double total_area(const TriangleSurface& surface);

/// Some triangles of a surface, in the order given, with their points, in the surface's order.
TriangleSurface part_with(const TriangleSurface& surface, const std::vector<int>& triangles);

/// Adds the points and triangles of another surface.
void append(TriangleSurface& surface, const TriangleSurface& more);

/// Area vector of a closed polygon (half the sum of cross products), length^2. Its length is the
/// area of the projection onto the mean plane, its direction the normal of that plane.
Vec3 area_vector(const Points& points, const std::vector<int>& loop);
/// Perimeter of a closed polygon, length.
double perimeter(const Points& points, const std::vector<int>& loop);

}  // namespace vasorod
