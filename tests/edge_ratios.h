// How far a carried or deformed wall is torn.
#pragma once

#include <algorithm>
#include <array>

#include <vasorod/types.h>

namespace vasorod::testing {

/// Smallest and largest length of an edge over that at rest; at most 1 and at least 1.
inline std::array<double, 2> edge_ratios(const Triangles& triangles, const Points& rest,
                                         const Points& current) {
  std::array<double, 2> range{1, 1};
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int a = triangles(t, k), b = triangles(t, (k + 1) % 3);
      const double ratio =
          (current.row(a) - current.row(b)).norm() / (rest.row(a) - rest.row(b)).norm();
      range = {std::min(range[0], ratio), std::max(range[1], ratio)};
    }
  return range;
}

}  // namespace vasorod::testing
