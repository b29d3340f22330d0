// The local mesh operations that surgery consists of. Each operation keeps the surface manifold and
// oriented and records the source of every vertex.
#pragma once

#include <array>
#include <functional>
#include <utility>
#include <vector>

#include <vasorod/types.h>

#include "geometry/editable_mesh.h"
#include "geometry/vertex_source.h"

namespace vasorod {

/// Tolerances of mesh editing, as fractions of the surface's mean edge.
struct EditTolerances {
  /// A crossing closer than this to a vertex moves the vertex; no new vertex is made.
  double snap = 0.25;
  double min_edge = 0.08;  ///< target for the shortest edge made by surgery (0.05 is guaranteed)
  /// 4 sqrt(3) area / sum of squared edges that a move must leave: 1 equilateral, 0 flat.
  double min_quality = 0.12;
};

/// An editable mesh that remembers where its vertices come from.
class SurfaceEditor : public EditableMesh {
 public:
  /// A point as weighted mean of current vertices.
  using Blend = std::vector<std::pair<int, double>>;

  explicit SurfaceEditor(const TriangleSurface& surface, const EditTolerances& tolerances = {});

  int input_count() const { return input_count_; }
  using EditableMesh::point;
  Vec3 point(const Blend& blend) const;
  const VertexSource& source(int v) const { return sources_[static_cast<size_t>(v)]; }
  /// Whether surgery made or moved the vertex.
  bool touched(int v) const { return touched_[static_cast<size_t>(v)] != 0; }
  double mean_edge() const { return mean_edge_; }
  double snap() const { return tolerances_.snap * mean_edge_; }
  double min_edge() const { return tolerances_.min_edge * mean_edge_; }

  /// New vertex (1 - t) a + t b on an edge. Its one or two triangles are split.
  int split_edge(int a, int b, double t);
  /// New vertex inside a triangle, which is split into three.
  int split_triangle(int t, const Vec3& barycentric);
  /// Moves v unless a triangle would turn over, become too thin or get too short an edge. False: no
  /// change.
  bool move(int v, const Blend& target);
  /// The same, to the point `to` that is the mean of input vertices `from`.
  bool move(int v, const Vec3& to, const VertexSource& from);
  /// Collapses the edge keep-gone into `keep` at `target`, under the conditions of `move` and if
  /// the surface stays manifold.
  bool collapse(int keep, int gone, const Blend& target);
  /// Delaunay flips of the edges at vertices made or moved by surgery, except those with
  /// `fixed(a, b)`. Only nearly flat pairs of triangles are flipped, so the shape does not change.
  void improve(const std::function<bool(int, int)>& fixed);
  /// Duplicates v: the listed triangles of v get the new vertex.
  int duplicate(int v, const std::vector<int>& triangles);

  /// A part of the surface.
  struct Part {
    TriangleSurface surface;    ///< vertices in the editor's order, the input's first
    VertexSources sources;      ///< in the input surface
    std::vector<int> vertices;  ///< the editor's index of each vertex
  };
  Part part(const std::vector<int>& triangles) const;
  Part whole() const;

 private:
  int add_blend(const Blend& blend);
  VertexSource source_of(const Blend& blend) const;
  bool acceptable(const std::vector<std::array<Vec3, 3>>& before,
                  const std::vector<std::array<Vec3, 3>>& after) const;
  bool flip_improves(int a, int b, int c, int d) const;

  EditTolerances tolerances_;
  double mean_edge_ = 0;
  int input_count_ = 0;
  VertexSources sources_;
  std::vector<char> touched_;
};

}  // namespace vasorod
