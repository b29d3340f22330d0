// A manifold triangle surface whose edges can be collapsed and turned; triangle and point numbers
// stay until the end.
#pragma once

#include <set>
#include <vector>

#include <vasorod/types.h>

namespace vasorod {

class EditableMesh {
 public:
  /// Edits `surface` in place; it must outlive this. Dead triangles and unused points stay in it.
  explicit EditableMesh(TriangleSurface& surface);

  int triangles() const { return static_cast<int>(surface_.triangles.rows()); }
  bool alive(int triangle) const { return alive_[static_cast<size_t>(triangle)] != 0; }
  std::vector<int> alive() const;
  int corner(int triangle, int k) const { return surface_.triangles(triangle, k % 3); }
  Vec3 point(int i) const { return surface_.points.row(i); }
  double length(int a, int b) const { return (point(a) - point(b)).norm(); }
  /// Height over the longest side.
  double height(int triangle) const;
  /// Twice the area vector.
  Vec3 normal(int triangle) const;

  std::vector<int> on_edge(int a, int b) const;  ///< its one or two triangles
  bool on_boundary(int point) const;

  /// Whether the surface stays manifold and keeps its topology (link condition, Dey et al. 1999).
  bool may_collapse(int a, int b) const;
  /// Whether no other triangle turns by more than 60 degrees or gets a side longer than `longest`.
  bool collapse_keeps_shape(int a, int b, double longest) const;
  /// Onto the lower point number; it takes the other's position when only that one is on an end.
  void collapse(int a, int b);
  /// Joins the opposite corners of triangles t, u instead of a, b. False, and nothing changed,
  /// where that edge exists or one of the two would get a height of `least` or less.
  bool turn(int t, int u, int a, int b, double least);
  void remove(int triangle);

 private:
  std::set<int>& around(int i) { return around_[static_cast<size_t>(i)]; }
  const std::set<int>& around(int i) const { return around_[static_cast<size_t>(i)]; }
  std::set<int> neighbours(int i) const;
  int opposite(int triangle, int a, int b) const;
  Vec3 collapsed_position(int a, int b) const;
  void replace(int triangle, int from, int to);

  TriangleSurface& surface_;
  std::vector<std::set<int>> around_;  // triangles at each point
  std::vector<char> alive_;
};

}  // namespace vasorod
