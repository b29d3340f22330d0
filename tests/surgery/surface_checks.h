// Properties that every operation guarantees of its surface, checked independently.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <set>
#include <utility>

#include "geometry/triangle_surface.h"
#include "geometry/vertex_source.h"

namespace vasorod::testing {

/// Every directed edge at most once: neighbouring triangles have the same orientation.
inline bool oriented(const Triangles& triangles) {
  std::set<std::pair<int, int>> seen;
  for (int t = 0; t < triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k)
      if (!seen.insert({triangles(t, k), triangles(t, (k + 1) % 3)}).second) return false;
  return true;
}

/// An oriented tube with three boundary loops, one of which is `rim`.
inline ::testing::AssertionResult tube_with_a_hole(const Triangles& triangles,
                                                   std::vector<int> rim) {
  if (!oriented(triangles)) return ::testing::AssertionFailure() << "not oriented";
  if (const int euler = euler_number(triangles); euler != -1)
    return ::testing::AssertionFailure() << "Euler number " << euler;
  const auto loops = boundary_loops(triangles);
  if (loops.size() != 3) return ::testing::AssertionFailure() << loops.size() << " loops";
  std::rotate(rim.begin(), std::min_element(rim.begin(), rim.end()), rim.end());
  if (std::count(loops.begin(), loops.end(), rim) != 1)
    return ::testing::AssertionFailure() << "the rim is no loop of the surface";
  return ::testing::AssertionSuccess();
}

struct MadeBySurgery {
  double shortest_edge = std::numeric_limits<double>::infinity();  ///< over the input's mean edge
  double smallest_angle = 180;                                     ///< degrees
};

/// The worst values of edges and triangles that are new (not between unmoved vertices of the
/// input).
inline MadeBySurgery made_by_surgery(const TriangleSurface& before, const TriangleSurface& after,
                                     const VertexSources& sources) {
  std::set<std::pair<int, int>> old_edges;
  std::set<std::array<int, 3>> old_triangles;
  for (const Edge& e : edges_of(before.triangles)) old_edges.insert({e.a, e.b});
  for (int t = 0; t < before.triangles.rows(); ++t) {
    std::array<int, 3> c{before.triangles(t, 0), before.triangles(t, 1), before.triangles(t, 2)};
    std::sort(c.begin(), c.end());
    old_triangles.insert(c);
  }
  const auto origin = [&](int v) {
    const auto& s = sources[static_cast<size_t>(v)];
    return s.is_original() ? s.vertex[0] : -1;
  };
  MadeBySurgery worst;
  const double mean = mean_edge_length(before);
  for (const Edge& e : edges_of(after.triangles)) {
    const int a = origin(e.a), b = origin(e.b);
    if (a >= 0 && b >= 0 && old_edges.contains({std::min(a, b), std::max(a, b)})) continue;
    worst.shortest_edge = std::min(worst.shortest_edge,
                                   (after.points.row(e.a) - after.points.row(e.b)).norm() / mean);
  }
  for (int t = 0; t < after.triangles.rows(); ++t) {
    std::array<int, 3> c{origin(after.triangles(t, 0)), origin(after.triangles(t, 1)),
                         origin(after.triangles(t, 2))};
    std::sort(c.begin(), c.end());
    if (c[0] >= 0 && old_triangles.contains(c)) continue;
    for (int k = 0; k < 3; ++k) {
      const Vec3 p = after.points.row(after.triangles(t, k));
      const Vec3 a = after.points.row(after.triangles(t, (k + 1) % 3)).transpose() - p;
      const Vec3 b = after.points.row(after.triangles(t, (k + 2) % 3)).transpose() - p;
      worst.smallest_angle =
          std::min(worst.smallest_angle, std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / M_PI);
    }
  }
  return worst;
}

/// Largest distance between a vertex and the position given by its source.
inline double source_error(const TriangleSurface& before, const TriangleSurface& after,
                           const VertexSources& sources) {
  return (interpolate(sources, Eigen::MatrixXd(before.points)) - after.points)
      .rowwise()
      .norm()
      .maxCoeff();
}

}  // namespace vasorod::testing
