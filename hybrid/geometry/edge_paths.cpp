#include "geometry/edge_paths.h"

#include <functional>
#include <queue>

#include "data/index.h"
#include "geometry/triangle_surface.h"

namespace vasorod {

EdgePaths::EdgePaths(const TriangleSurface& surface, Measure measure)
    : neighbours_(index(surface.points.rows())) {
  for (const Edge& e : edges_of(surface.triangles)) {
    const double step =
        measure == Measure::edges ? 1 : (surface.points.row(e.a) - surface.points.row(e.b)).norm();
    neighbours_[index(e.a)].emplace_back(e.b, step);
    neighbours_[index(e.b)].emplace_back(e.a, step);
  }
}

// Dijkstra 1959.
std::unordered_map<int, double> EdgePaths::within(const std::vector<int>& sources,
                                                  double limit) const {
  std::unordered_map<int, double> way;
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto reach = [&](int vertex, double so_far) {
    if (so_far > limit) return;
    const auto [known, first] = way.try_emplace(vertex, so_far);
    if (!first && known->second <= so_far) return;
    known->second = so_far;
    queue.emplace(so_far, vertex);
  };
  for (const int source : sources) reach(source, 0);
  while (!queue.empty()) {
    const auto [so_far, vertex] = queue.top();
    queue.pop();
    if (so_far > way.at(vertex)) continue;
    for (const auto& [other, step] : neighbours_[index(vertex)]) reach(other, so_far + step);
  }
  return way;
}

}  // namespace vasorod
