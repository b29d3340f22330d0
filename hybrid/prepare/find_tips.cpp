#include "prepare/find_tips.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "geometry/edge_paths.h"
#include "geometry/triangle_surface.h"
#include "surface_file/check_surface.h"

namespace vasorod {
namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

std::vector<double> distances(const EdgePaths& paths, const std::vector<int>& from, std::size_t n) {
  std::vector<double> all(n, 0);
  for (const auto& [v, d] : paths.within(from, std::numeric_limits<double>::infinity()))
    all[at(v)] = d;
  return all;
}

// Superlevel sets of a function on the vertices, joined from high to low.
class SuperlevelSets {
 public:
  SuperlevelSets(std::size_t n, const Eigen::VectorXd& area)
      : parent_(n), top_(n), size_(area.begin(), area.end()) {
    std::iota(parent_.begin(), parent_.end(), 0);
    std::iota(top_.begin(), top_.end(), 0);
  }
  int root(int v) {
    while (parent_[at(v)] != v) v = parent_[at(v)] = parent_[at(parent_[at(v)])];
    return v;
  }
  int top(int r) const { return top_[at(r)]; }
  double area(int r) const { return size_[at(r)]; }
  // The set `into` keeps its top.
  void join(int into, int other) {
    parent_[at(other)] = into;
    size_[at(into)] += size_[at(other)];
  }

 private:
  std::vector<int> parent_, top_;
  std::vector<double> size_;
};

}  // namespace

std::vector<Tip> find_tips(const TriangleSurface& surface, double least) {
  const auto n = static_cast<std::size_t>(surface.points.rows());
  const EdgePaths paths(surface);
  const Eigen::VectorXd area = vertex_areas(surface);
  const auto loops = boundary_loops(surface.triangles);
  std::vector<Tip> tips;

  std::vector<int> from;
  if (loops.empty()) {
    const auto first = distances(paths, {0}, n);
    from = {static_cast<int>(std::max_element(first.begin(), first.end()) - first.begin())};
  } else {
    from = loops.front();
  }
  const auto far = distances(paths, from, n);
  if (loops.empty()) {
    const double reach = *std::max_element(far.begin(), far.end());
    tips.push_back({surface.points.row(from.front()), reach, typical_radius(surface)});
  }
  std::vector<double> to_end(n, std::numeric_limits<double>::infinity());
  for (const auto& loop : loops) {
    const auto d = distances(paths, loop, n);
    const double radius = perimeter(surface.points, loop) / (2 * M_PI);
    for (std::size_t v = 0; v < n; ++v) to_end[v] = std::min(to_end[v], d[v] / radius);
  }

  std::vector<std::vector<int>> neighbours(n);
  for (const Edge& edge : edges_of(surface.triangles)) {
    neighbours[at(edge.a)].push_back(edge.b);
    neighbours[at(edge.b)].push_back(edge.a);
  }
  std::vector<int> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return far[at(a)] > far[at(b)] || (far[at(a)] == far[at(b)] && a < b);
  });
  std::vector<char> seen(n, 0);
  SuperlevelSets sets(n, area);
  const auto end_branch = [&](int root, double level) {
    const int top = sets.top(root);
    const double length = far[at(top)] - level, radius = sets.area(root) / (2 * M_PI * length);
    if (length > least * radius && !(to_end[at(top)] < 1.5))
      tips.push_back({surface.points.row(top), length, radius});
  };
  int last = order.front();
  for (const int v : order) {
    seen[at(v)] = 1;
    int into = -1;  // of the sets around v, the one with the highest top
    std::vector<int> roots;
    for (const int u : neighbours[at(v)]) {
      if (!seen[at(u)]) continue;
      const int root = sets.root(u);
      if (std::find(roots.begin(), roots.end(), root) != roots.end()) continue;
      roots.push_back(root);
      if (into < 0 || far[at(sets.top(root))] > far[at(sets.top(into))]) into = root;
    }
    for (const int root : roots) {
      if (root == into) continue;
      if (far[at(sets.top(root))] > far[at(v)]) end_branch(root, far[at(v)]);
      sets.join(into, root);
    }
    if (into >= 0) sets.join(into, v);
    last = into >= 0 ? into : v;
  }
  end_branch(sets.root(last), 0);
  return tips;
}

}  // namespace vasorod
