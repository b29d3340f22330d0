#include "wall/shear_pairs.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/triangle_surface.h"

namespace vasorod {

namespace {

// Defects that differ by less than this fraction of an edge (1/20) count as equal; the order of the
// edges decides.
constexpr double defect_steps = 20;

// Deviation of an edge's two triangles from a parallelogram, in steps.
int defect(const Points& points, const Edge& e) {
  const Vec3 middle = (points.row(e.a) + points.row(e.b)).transpose() / 2;
  const Vec3 across = (points.row(e.opposite[0]) + points.row(e.opposite[1])).transpose() / 2;
  const double length = (points.row(e.a) - points.row(e.b)).norm();
  return static_cast<int>(
      std::min(1e6, std::round(defect_steps * (middle - across).norm() / length)));
}

}  // namespace

std::vector<int> shear_pairs(const TriangleSurface& surface) {
  std::vector<Edge> edges = edges_of(surface.triangles);
  std::erase_if(edges, [](const Edge& e) { return e.boundary(); });
  std::vector<int> partner(static_cast<size_t>(surface.triangles.rows()), -1),
      free(partner.size(), 0);
  std::vector<std::vector<int>> around(partner.size());
  for (const Edge& e : edges)
    for (size_t w = 0; w < 2; ++w) {
      around[static_cast<size_t>(e.triangle[w])].push_back(e.triangle[1 - w]);
      ++free[static_cast<size_t>(e.triangle[w])];
    }
  std::vector<size_t> order(edges.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::vector<int> defects;
  defects.reserve(edges.size());
  for (const Edge& e : edges) defects.push_back(defect(surface.points, e));
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t i, size_t j) { return defects[i] < defects[j]; });

  std::vector<int> leaves;  // triangles with one free neighbour left
  const auto is_free = [&](int t) { return partner[static_cast<size_t>(t)] < 0; };
  const auto join = [&](int s, int t) {
    partner[static_cast<size_t>(s)] = t;
    partner[static_cast<size_t>(t)] = s;
    for (const int gone : {s, t})
      for (const int n : around[static_cast<size_t>(gone)])
        if (is_free(n) && --free[static_cast<size_t>(n)] == 1) leaves.push_back(n);
  };
  for (const size_t next : order) {
    if (is_free(edges[next].triangle[0]) && is_free(edges[next].triangle[1]))
      join(edges[next].triangle[0], edges[next].triangle[1]);
    while (!leaves.empty()) {
      const int t = leaves.back();
      leaves.pop_back();
      if (!is_free(t)) continue;
      const auto& candidates = around[static_cast<size_t>(t)];
      const auto last = std::find_if(candidates.begin(), candidates.end(), is_free);
      if (last != candidates.end()) join(t, *last);
    }
  }
  return partner;
}

}  // namespace vasorod
