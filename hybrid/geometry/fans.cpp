#include "geometry/fans.h"

namespace vasorod {

Points with_centroids(const Points& points, const std::vector<std::vector<int>>& loops) {
  Points all(points.rows() + std::ssize(loops), 3);
  all.topRows(points.rows()) = points;
  Eigen::Index row = points.rows();
  for (const std::vector<int>& loop : loops)
    all.row(row++) = points(loop, Eigen::all).colwise().mean();
  return all;
}

Triangles with_fans(const Triangles& triangles, const std::vector<std::vector<int>>& loops,
                    Eigen::Index vertices) {
  Eigen::Index count = triangles.rows();
  for (const std::vector<int>& loop : loops) count += std::ssize(loop);
  Triangles all(count, 3);
  all.topRows(triangles.rows()) = triangles;
  Eigen::Index row = triangles.rows();
  auto centroid = static_cast<int>(vertices);
  for (const std::vector<int>& loop : loops) {
    for (std::size_t k = 0; k < loop.size(); ++k)
      all.row(row++) << loop[(k + 1) % loop.size()], loop[k], centroid;
    ++centroid;
  }
  return all;
}

}  // namespace vasorod
