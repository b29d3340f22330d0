// A triangle surface under the knife: the few local operations all surgery is made of, each of
// which keeps the surface manifold and oriented, and remembers where every vertex comes from.
#pragma once

#include <array>
#include <functional>
#include <utility>
#include <vector>

#include <vasorod/types.h>

#include "geometry/editable_mesh.h"
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
