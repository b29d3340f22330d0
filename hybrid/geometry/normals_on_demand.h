// Angle-weighted normals of single vertices, for surfaces that move and of which few vertices are
// asked for: those of the whole surface cost more than all else that is done with these few.
#pragma once

#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// The triangles around each vertex of a surface.
class TrianglesAround {
 public:
  TrianglesAround(const Triangles& triangles, Eigen::Index vertices);

  /// That vertex's row of vertex_normals(), bit for bit. `surface` has these triangles.
  Vec3 normal(const TriangleSurface& surface, int vertex) const;

 private:
  std::vector<int> first_, triangle_;  // those of vertex v: first_[v] up to first_[v + 1]
};

/// The same of one surface, each computed once until the surface moves. Not thread-safe.
class NormalsOnDemand {
 public:
  explicit NormalsOnDemand(const TriangleSurface& surface);

  /// Moves the points (n x 3, as many as before).
  void move(const Points& points);
  /// Unit normal, zero where the triangles around the vertex have no area.
  Vec3 operator()(int vertex);

 private:
  TriangleSurface surface_;
  TrianglesAround around_;
  Points normals_;
  std::vector<char> known_;
};

}  // namespace vasorod
