// Facts about a triangle surface: edges, loops, areas, normals, Euler number.
#pragma once

#include <array>
#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// An undirected edge and its one or two triangles (-1: a boundary edge has no second).
struct Edge {
  int a = 0, b = 0;  ///< a < b
  std::array<int, 2> triangle{-1, -1};
  std::array<int, 2> opposite{-1, -1};  ///< the vertex of each triangle that is not on the edge
  bool boundary() const { return triangle[1] < 0; }
};

/// All edges, sorted by (a, b). Throws InputError when an edge has three or more triangles.
std::vector<Edge> edges_of(const Triangles& triangles);

/// Boundary loops: each a cycle of vertices in the direction the boundary has in its triangles (the
/// surface on the left seen from outside); sorted by the lowest vertex index each holds, which
/// stands first. Throws InputError when a vertex joins two loops.
std::vector<std::vector<int>> boundary_loops(const Triangles& triangles);

/// V - E + F over the vertices that triangles use.
int euler_number(const Triangles& triangles);

/// Component index per vertex (-1 for unused vertices), components numbered by lowest vertex.
std::vector<int> components(const Triangles& triangles, int vertex_count);

Eigen::VectorXd triangle_areas(const TriangleSurface& surface);  ///< per triangle
Eigen::VectorXd vertex_areas(
    const TriangleSurface& surface);                    ///< per vertex, a third of its triangles
Points vertex_normals(const TriangleSurface& surface);  ///< angle-weighted, unit, n x 3
double mean_edge_length(const TriangleSurface& surface);
double total_area(const TriangleSurface& surface);

/// Area vector of a closed polygon (half the sum of cross products): its length is the area of the
/// projection on its mean plane, its direction that plane's normal.
Vec3 area_vector(const Points& points, const std::vector<int>& loop);
/// Perimeter of a closed polygon.
double perimeter(const Points& points, const std::vector<int>& loop);

}  // namespace vasorod
