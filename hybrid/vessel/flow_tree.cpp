#include "vessel/flow_tree.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <queue>

#include <vasorod/error.h>

#include "numerics/cholesky.h"

namespace vasorod {
namespace {

// Neighbours of every vertex in one array.
struct Neighbours {
  std::vector<int> offset, index;

  Neighbours(const std::vector<Edge>& edges, size_t vertices) : offset(vertices + 1, 0) {
    for (const Edge& e : edges) {
      ++offset[static_cast<size_t>(e.a) + 1];
      ++offset[static_cast<size_t>(e.b) + 1];
    }
    for (size_t i = 0; i < vertices; ++i) offset[i + 1] += offset[i];
    index.resize(static_cast<size_t>(offset.back()));
    std::vector<int> at(offset.begin(), offset.end() - 1);
    for (const Edge& e : edges) {
      index[static_cast<size_t>(at[static_cast<size_t>(e.a)]++)] = e.b;
      index[static_cast<size_t>(at[static_cast<size_t>(e.b)]++)] = e.a;
    }
  }
};

// Half the sum of the cotangents opposite the edge, kept positive and bounded: positive for the
// maximum principle, bounded for degenerate triangles.
double edge_weight(const Points& points, const Edge& e) {
  double sum = 0;
  for (const int o : e.opposite) {
    if (o < 0) continue;
    const Vec3 f = points.row(e.a) - points.row(o), g = points.row(e.b) - points.row(o);
    const double area = f.cross(g).norm(), dot = f.dot(g);
    sum += area > 1e-3 * std::abs(dot) ? dot / area : std::copysign(1e3, dot);
  }
  return std::clamp(0.5 * sum, 0.05, 5.0);
}

Eigen::VectorXd flow_potential(const TriangleSurface& surface, const std::vector<Edge>& edges,
                               const std::vector<std::vector<int>>& loops) {
  // Unknowns: one per far end (the potential is constant on an end), then the inner vertices. -1:
  // known.
  const auto n = static_cast<size_t>(surface.points.rows());
  std::vector<char> used(n, 0);
  for (const Edge& e : edges) used[static_cast<size_t>(e.a)] = used[static_cast<size_t>(e.b)] = 1;
  std::vector<int> unknown(n, -2);
  for (size_t k = 0; k < loops.size(); ++k)
    for (const int v : loops[k]) unknown[static_cast<size_t>(v)] = static_cast<int>(k) - 1;
  int count = static_cast<int>(loops.size()) - 1;
  for (size_t i = 0; i < n; ++i)
    if (unknown[i] == -2) unknown[i] = used[i] ? count++ : -1;

  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(edges.size() + static_cast<size_t>(count));
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(count);
  for (const Edge& e : edges) {
    const int i = unknown[static_cast<size_t>(e.a)], j = unknown[static_cast<size_t>(e.b)];
    if (i == j) continue;
    const double w = edge_weight(surface.points, e);
    if (i >= 0) diagonal[i] += w;
    if (j >= 0) diagonal[j] += w;
    if (i >= 0 && j >= 0) entries.emplace_back(std::max(i, j), std::min(i, j), -w);
  }
  for (int i = 0; i < count; ++i) entries.emplace_back(i, i, diagonal[i]);
  Eigen::SparseMatrix<double> laplacian(count, count);
  laplacian.setFromTriplets(entries.begin(), entries.end());
  Eigen::VectorXd outflow = Eigen::VectorXd::Zero(count);
  for (size_t k = 1; k < loops.size(); ++k)
    outflow[static_cast<int>(k) - 1] = perimeter(surface.points, loops[k]);
  Cholesky factor;
  factor.analyse(laplacian);
  if (!factor.factorise(laplacian))
    throw InputError("no flow reaches part of the surface, expected one connected wall");
  Eigen::VectorXd solution(count);
  factor.solve(outflow.data(), solution.data(), 1);
  Eigen::VectorXd level = Eigen::VectorXd::Zero(surface.points.rows());
  for (size_t i = 0; i < n; ++i)
    if (unknown[i] >= 0) level[static_cast<Eigen::Index>(i)] = solution[unknown[i]];
  return level;
}

}  // namespace

FlowTree flow_tree(const TriangleSurface& surface, const std::vector<Edge>& edges,
                   const std::vector<std::vector<int>>& loops) {
  const auto n = static_cast<size_t>(surface.points.rows());
  const Neighbours neighbours(edges, n);
  FlowTree tree;
  tree.level = flow_potential(surface, edges, loops);
  tree.arc_of.assign(n, -1);

  // Sweeps down from the far ends. `current` is the arc that a finished arc has merged into.
  std::vector<FlowArc> arcs;
  std::vector<int> current;
  auto find = [&](int arc) {
    while (current[static_cast<size_t>(arc)] != arc) arc = current[static_cast<size_t>(arc)];
    return arc;
  };
  auto new_arc = [&](int end) {
    arcs.push_back({-1, end, {}});
    current.push_back(static_cast<int>(arcs.size()) - 1);
    return current.back();
  };
  std::priority_queue<std::pair<double, int>> front;  // highest level first, then highest index
  std::vector<char> queued(n, 0);
  auto settle = [&](int v, int arc) {
    tree.arc_of[static_cast<size_t>(v)] = arc;
    arcs[static_cast<size_t>(arc)].vertices.push_back(v);
    for (int k = neighbours.offset[static_cast<size_t>(v)];
         k < neighbours.offset[static_cast<size_t>(v) + 1]; ++k) {
      const int w = neighbours.index[static_cast<size_t>(k)];
      if (queued[static_cast<size_t>(w)]) continue;
      queued[static_cast<size_t>(w)] = 1;
      front.emplace(tree.level[w], w);
    }
  };
  for (size_t k = 1; k < loops.size(); ++k)
    for (const int v : loops[k]) queued[static_cast<size_t>(v)] = 1;
  for (size_t k = 1; k < loops.size(); ++k) {
    const int arc = new_arc(static_cast<int>(k));
    for (const int v : loops[k]) settle(v, arc);
  }
  while (!front.empty()) {
    const int v = front.top().second;
    front.pop();
    std::vector<int> meeting;
    for (int k = neighbours.offset[static_cast<size_t>(v)];
         k < neighbours.offset[static_cast<size_t>(v) + 1]; ++k) {
      const int arc = tree.arc_of[static_cast<size_t>(neighbours.index[static_cast<size_t>(k)])];
      if (arc < 0) continue;
      const int root = find(arc);
      if (std::find(meeting.begin(), meeting.end(), root) == meeting.end()) meeting.push_back(root);
    }
    if (meeting.size() > 1) {
      const int merged = new_arc(-1);
      for (const int arc : meeting) {
        arcs[static_cast<size_t>(arc)].parent = merged;
        current[static_cast<size_t>(arc)] = merged;
      }
      meeting = {merged};
    }
    settle(v, meeting.front());
  }

  // The arcs were made from the ends to the root. Reverse the order: parents before children.
  const int count = static_cast<int>(arcs.size());
  for (FlowArc& arc : arcs) {
    if (arc.parent >= 0) arc.parent = count - 1 - arc.parent;
    std::reverse(arc.vertices.begin(), arc.vertices.end());
  }
  std::reverse(arcs.begin(), arcs.end());
  for (int& arc : tree.arc_of)
    if (arc >= 0) arc = count - 1 - arc;
  tree.arcs = std::move(arcs);
  return tree;
}

}  // namespace vasorod
