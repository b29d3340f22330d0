#include "bodies/seam_band.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>

#include "data/index.h"
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

// Shortest edge paths to a seam.
struct Paths {
  std::vector<double> edges, length;
  double width = 0;  // of the band, length
};

Paths paths_to(const TriangleSurface& surface, const std::vector<int>& seam, double width) {
  const auto count = static_cast<size_t>(surface.points.rows());
  std::vector<std::vector<std::pair<int, double>>> hops(count), lengths(count);
  for (const Edge& e : edges_of(surface.triangles)) {
    const double length = (surface.points.row(e.a) - surface.points.row(e.b)).norm();
    for (const auto& [from, to] : {std::pair{e.a, e.b}, std::pair{e.b, e.a}}) {
      hops[index(from)].emplace_back(to, 1.0);
      lengths[index(from)].emplace_back(to, length);
    }
  }
  width += 2 * mean_edge_length(surface);
  return {distances(hops, seam, 2), distances(lengths, seam, width), width};
}

}  // namespace

std::vector<char> seam_band(const TriangleSurface& surface, const std::vector<int>& seam,
                            double width) {
  const Paths paths = paths_to(surface, seam, width);
  std::vector<char> band(paths.length.size(), 0);
  for (size_t i = 0; i < band.size(); ++i)
    band[i] = paths.edges[i] <= 2 || paths.length[i] <= paths.width ? 1 : 0;
  return band;
}

std::vector<double> seam_share(const TriangleSurface& surface, const std::vector<int>& seam,
                               double width) {
  const Paths paths = paths_to(surface, seam, width);
  std::vector<double> share(paths.length.size(), 1);
  for (size_t i = 0; i < share.size(); ++i)
    share[i] = paths.edges[i] <= 1 ? 0 : std::min(1.0, paths.length[i] / paths.width);
  return share;
}

}  // namespace vasorod
