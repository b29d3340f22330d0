// A manifold, oriented triangle mesh whose triangles can be removed, merged and turned in place:
// what cleaning, remeshing and surgery (surface_editor.h) are built on. Triangle and vertex numbers
// stay.
#pragma once

#include <array>
#include <vector>

#include <vasorod/types.h>

namespace vasorod {

class EditableMesh {
 public:
  using Triangle = std::array<int, 3>;

  explicit EditableMesh(const TriangleSurface& surface);

  int vertex_count() const { return static_cast<int>(points_.size()); }  ///< unused ones included
  int triangle_count() const {
    return static_cast<int>(triangles_.size());
  }  ///< dead ones included
  bool alive(int t) const { return triangles_[static_cast<size_t>(t)][0] >= 0; }
  /// Numbers of the triangles that are alive, ascending.
  std::vector<int> alive_triangles() const;
  const Vec3& point(int v) const { return points_[static_cast<size_t>(v)]; }
  const Triangle& triangle(int t) const { return triangles_[static_cast<size_t>(t)]; }
  int corner(int t, int k) const { return triangle(t)[static_cast<size_t>(k % 3)]; }
  /// The triangles at a vertex, in the order in which they came to it.
  const std::vector<int>& triangles_of(int v) const { return incident_[static_cast<size_t>(v)]; }
  double length(int a, int b) const { return (point(a) - point(b)).norm(); }
  /// Twice the area vector.
  Vec3 normal(int t) const;
  /// Height over the longest side.
  double height(int t) const;

  /// The triangle with the directed edge a -> b, -1 when there is none.
  int triangle_left_of(int a, int b) const;
  bool joined(int a, int b) const {
    return triangle_left_of(a, b) >= 0 || triangle_left_of(b, a) >= 0;
  }
  /// The one or two triangles of an edge, ascending.
  std::vector<int> on_edge(int a, int b) const;
  bool on_boundary(int v) const;
  /// Neighbours of v counter-clockwise seen from outside; for a boundary vertex from one boundary
  /// edge to the other.
  std::vector<int> ring(int v) const;

  /// Whether the surface stays manifold and keeps its topology when the edge is collapsed (link
  /// condition, Dey et al. 1999).
  bool may_collapse(int a, int b) const;
  /// Whether no other triangle turns by more than 60 degrees or gets a side longer than `longest`
  /// when the edge is collapsed as `collapse` does it.
  bool collapse_keeps_shape(int a, int b, double longest) const;
  /// Merges the edge's vertices into the lower number. The merged vertex takes the other's position
  /// when only that one is on an end.
  void collapse(int a, int b);
  /// Joins the opposite corners of triangles t, u instead of a, b. False, and nothing changed,
  /// where that edge exists or one of the two would get a height of `least` or less.
  bool turn(int t, int u, int a, int b, double least);
  void remove_triangle(int t);

  /// Writes points and triangles back in their numbers; rows of dead triangles are left as they
  /// are.
  void store(TriangleSurface& surface) const;

 protected:
  static int opposite(const Triangle& corners, int a, int b);
  int add_vertex(const Vec3& point);
  int add_triangle(const Triangle& corners);
  /// Vertex `from` of a triangle becomes `to`; the triangle keeps its number.
  void replace_corner(int t, int from, int to);

  std::vector<Vec3> points_;

 private:
  Vec3 collapsed_position(int a, int b) const;

  std::vector<Triangle> triangles_;  // first corner -1: dead
  std::vector<std::vector<int>> incident_;
};

}  // namespace vasorod
