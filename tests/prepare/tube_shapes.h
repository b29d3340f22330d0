// Tubes with round or flat closed ends, for the tests of this room.
#pragma once

#include <cmath>

#include <vasorod/tube.h>

#include "geometry/triangle_surface.h"

namespace vasorod::testing {

/// A straight tube along z; its ends closed by half balls where `round`, else by flat fans.
inline TriangleSurface closed_tube(double length, double radius, bool round) {
  const int around = 32, along = static_cast<int>(length / (0.2 * radius)), cap = round ? 8 : 0;
  const int rows = along + 1 + 2 * cap;
  TriangleSurface out;
  out.points.resize(rows * around + 2, 3);
  for (int i = 0; i < rows; ++i) {
    double z = 0, r = radius;
    if (i < cap || i >= rows - cap) {
      const int k = i < cap ? cap - i : i - (rows - 1 - cap);
      const double angle = 0.5 * M_PI * k / (cap + 1);
      r = radius * std::cos(angle);
      z = i < cap ? -radius * std::sin(angle) : length + radius * std::sin(angle);
    } else {
      z = length * (i - cap) / along;
    }
    for (int j = 0; j < around; ++j)
      out.points.row(i * around + j) << r * std::cos(2 * M_PI * j / around),
          r * std::sin(2 * M_PI * j / around), z;
  }
  const int bottom = rows * around, top = bottom + 1;
  out.points.row(bottom) << 0, 0, round ? -radius : 0;
  out.points.row(top) << 0, 0, length + (round ? radius : 0);
  std::vector<std::array<int, 3>> faces;
  for (int j = 0; j < around; ++j) {
    const int k = (j + 1) % around;
    faces.push_back({bottom, k, j});
    faces.push_back({top, (rows - 1) * around + j, (rows - 1) * around + k});
    for (int i = 0; i + 1 < rows; ++i) {
      const int a = i * around + j, b = i * around + k;
      faces.push_back({a, b, b + around});
      faces.push_back({a, b + around, a + around});
    }
  }
  out.triangles.resize(static_cast<Eigen::Index>(faces.size()), 3);
  for (std::size_t t = 0; t < faces.size(); ++t)
    out.triangles.row(static_cast<Eigen::Index>(t)) << faces[t][0], faces[t][1], faces[t][2];
  return out;
}

/// A wall with an outer face, which is `outer`, and an inner one that lies `thickness` inside along
/// the normals; joined by a ring at each end.
inline TriangleSurface double_wall(const TriangleSurface& outer, double thickness) {
  TriangleSurface out = outer, inner = outer;
  inner.points -= thickness * vertex_normals(outer);
  inner.triangles.col(1).swap(inner.triangles.col(2));
  append(out, inner);
  const int n = static_cast<int>(outer.points.rows());
  TriangleSurface ring;
  for (const auto& loop : boundary_loops(outer.triangles)) {
    const auto first = ring.triangles.rows();
    ring.triangles.conservativeResize(first + 2 * static_cast<Eigen::Index>(loop.size()), 3);
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const int u = loop[k], v = loop[(k + 1) % loop.size()];
      const auto row = first + 2 * static_cast<Eigen::Index>(k);
      ring.triangles.row(row) << v, u, u + n;
      ring.triangles.row(row + 1) << v, u + n, v + n;
    }
  }
  Triangles all(out.triangles.rows() + ring.triangles.rows(), 3);
  all << out.triangles, ring.triangles;
  out.triangles = all;
  return out;
}

}  // namespace vasorod::testing
