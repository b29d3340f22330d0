// A triangle surface under the knife: the few local operations all surgery is made of, each of
// which keeps the surface manifold and oriented, and remembers where every vertex comes from.
#pragma once

#include <array>
#include <functional>
#include <utility>
#include <vector>

#include <vasorod/types.h>

#include "geometry/vertex_source.h"

namespace vasorod {

/// Lengths below which surgery avoids making edges, as fractions of the surface's mean edge.
struct EditTolerances {
  double snap =
      0.25;  ///< a crossing this near to a vertex moves the vertex instead of making a new one
  double min_edge = 0.08;     ///< no edge made by surgery should be shorter (the promise is 0.05)
  double min_quality = 0.12;  ///< 4 sqrt(3) area / sum of squared edges that a move must leave: 1
                              ///< equilateral, 0 flat
};

class SurfaceEditor {
 public:
  /// A point as weighted mean of current vertices.
  using Blend = std::vector<std::pair<int, double>>;

  explicit SurfaceEditor(const TriangleSurface& surface, const EditTolerances& tolerances = {});

  int vertex_count() const { return static_cast<int>(points_.size()); }  ///< dead ones included
  int input_count() const { return input_count_; }
  const Vec3& point(int v) const { return points_[static_cast<size_t>(v)]; }
  Vec3 point(const Blend& blend) const;
  const VertexSource& source(int v) const { return sources_[static_cast<size_t>(v)]; }
  const std::vector<int>& triangles_of(int v) const { return incident_[static_cast<size_t>(v)]; }
  const std::array<int, 3>& triangle(int t) const { return triangles_[static_cast<size_t>(t)]; }
  int triangle_count() const {
    return static_cast<int>(triangles_.size());
  }  ///< dead ones included
  bool alive(int t) const { return triangles_[static_cast<size_t>(t)][0] >= 0; }
  bool touched(int v) const {
    return touched_[static_cast<size_t>(v)] != 0;
  }  ///< made or moved by surgery
  double length(int a, int b) const { return (point(a) - point(b)).norm(); }
  double mean_edge() const { return mean_edge_; }
  double snap() const { return tolerances_.snap * mean_edge_; }
  double min_edge() const { return tolerances_.min_edge * mean_edge_; }

  /// The triangle with the directed edge a -> b, -1 when there is none.
  int triangle_left_of(int a, int b) const;
  bool joined(int a, int b) const {
    return triangle_left_of(a, b) >= 0 || triangle_left_of(b, a) >= 0;
  }
  bool on_boundary(int v) const;
  /// Neighbours of v counter-clockwise seen from outside; for a boundary vertex from one boundary
  /// edge to the other.
  std::vector<int> ring(int v) const;

  /// New vertex (1 - t) a + t b on an edge; its one or two triangles are split.
  int split_edge(int a, int b, double t);
  /// New vertex inside a triangle, which is split in three.
  int split_triangle(int t, const Vec3& barycentric);
  /// Moves v if no triangle turns over, gets too thin or gets too short an edge; false: nothing
  /// done.
  bool move(int v, const Blend& target);
  /// Merges edge keep-gone into `keep` at `target`, under the same conditions and if the surface
  /// stays manifold.
  bool collapse(int keep, int gone, const Blend& target);
  /// Delaunay flips of the edges at vertices made or moved by surgery, except those `fixed(a, b)`;
  /// nearly flat pairs of triangles only, so the shape stays.
  void improve(const std::function<bool(int, int)>& fixed);
  /// Doubles v: the listed triangles of v take the new vertex.
  int duplicate(int v, const std::vector<int>& triangles);

  /// The surface made of these triangles, vertices in order (input's first); `vertices[i]` is the
  /// editor's index of vertex i.
  struct Part {
    TriangleSurface surface;
    VertexSources sources;
    std::vector<int> vertices;
  };
  Part part(const std::vector<int>& triangles) const;
  Part whole() const;

 private:
  int add_vertex(const Blend& blend);
  int add_triangle(const std::array<int, 3>& corners);
  void remove_triangle(int t);
  VertexSource source_of(const Blend& blend) const;
  bool acceptable(const std::vector<std::array<Vec3, 3>>& before,
                  const std::vector<std::array<Vec3, 3>>& after) const;
  bool flip_improves(int a, int b, int c, int d) const;

  EditTolerances tolerances_;
  double mean_edge_ = 0;
  int input_count_ = 0;
  std::vector<Vec3> points_;
  VertexSources sources_;
  std::vector<std::array<int, 3>> triangles_;  // first corner -1: dead
  std::vector<std::vector<int>> incident_;
  std::vector<char> touched_;
};

}  // namespace vasorod
