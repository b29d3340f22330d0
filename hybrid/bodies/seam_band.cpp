#include "bodies/seam_band.h"

#include <functional>
#include <limits>
#include <queue>

#include "geometry/triangle_surface.h"

namespace vasorod {
namespace {

// Shortest edge-path distance, with the given edge lengths, from any of `sources`, up to `limit`.
std::vector<double> distances(const std::vector<std::vector<std::pair<int, double>>>& graph,
                              const std::vector<int>& sources, double limit) {
  std::vector<double> distance(graph.size(), std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (const int s : sources) {
    distance[static_cast<size_t>(s)] = 0;
    queue.emplace(0.0, s);
  }
  while (!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    if (d > distance[static_cast<size_t>(v)]) continue;
    for (const auto& [w, length] : graph[static_cast<size_t>(v)])
      if (d + length <= limit && d + length < distance[static_cast<size_t>(w)]) {
        distance[static_cast<size_t>(w)] = d + length;
        queue.emplace(d + length, w);
      }
  }
  return distance;
}

}  // namespace

std::vector<char> seam_band(const TriangleSurface& surface, const std::vector<int>& seam,
                            double width) {
  const auto count = static_cast<size_t>(surface.points.rows());
  std::vector<std::vector<std::pair<int, double>>> hops(count), lengths(count);
  double total = 0;
  const auto edges = edges_of(surface.triangles);
  for (const Edge& e : edges) {
    const double length = (surface.points.row(e.a) - surface.points.row(e.b)).norm();
    total += length;
    for (const auto& [from, to] : {std::pair{e.a, e.b}, std::pair{e.b, e.a}}) {
      hops[static_cast<size_t>(from)].emplace_back(to, 1.0);
      lengths[static_cast<size_t>(from)].emplace_back(to, length);
    }
  }
  const double mean = edges.empty() ? 0 : total / static_cast<double>(edges.size());
  const std::vector<double> near = distances(hops, seam, 2),
                            way = distances(lengths, seam, width + 2 * mean);
  std::vector<char> band(count, 0);
  for (size_t i = 0; i < count; ++i) band[i] = near[i] <= 2 || way[i] <= width + 2 * mean ? 1 : 0;
  return band;
}

}  // namespace vasorod
