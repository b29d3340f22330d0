#include "bodies/near_on_surface.h"

#include <functional>
#include <queue>

#include "data/index.h"
#include "geometry/triangle_surface.h"

namespace vasorod {

NearOnSurface::NearOnSurface(const TriangleSurface& rest, double limit)
    : points_(rest.points), limit_(limit), edges_(index(rest.points.rows())) {
  for (const Edge& e : edges_of(rest.triangles)) {
    const double length = (points_.row(e.a) - points_.row(e.b)).norm();
    edges_[index(e.a)].emplace_back(e.b, length);
    edges_[index(e.b)].emplace_back(e.a, length);
  }
}

bool NearOnSurface::are(int a, int b) const {
  if ((points_.row(a) - points_.row(b)).norm() > limit_) return false;
  auto found = within_.find(a);
  if (found == within_.end()) found = within_.emplace(a, around(a)).first;
  return found->second.contains(b);
}

// Dijkstra's shortest paths up to the limit.
std::unordered_set<int> NearOnSurface::around(int source) const {
  std::unordered_map<int, double> distance{{source, 0.0}};
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  queue.emplace(0.0, source);
  while (!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    if (d > distance[v]) continue;
    for (const auto& [w, length] : edges_[index(v)]) {
      const double way = d + length;
      if (way > limit_) continue;
      const auto known = distance.find(w);
      if (known != distance.end() && known->second <= way) continue;
      distance[w] = way;
      queue.emplace(way, w);
    }
  }
  std::unordered_set<int> vertices;
  for (const auto& [v, d] : distance) vertices.insert(v);
  return vertices;
}

}  // namespace vasorod
