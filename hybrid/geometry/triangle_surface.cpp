#include "geometry/triangle_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <unordered_map>

#include <vasorod/error.h>

namespace vasorod {

std::vector<HalfEdge> half_edges_by_edge(const Triangles& triangles) {
  if (triangles.rows() == 0) return {};
  std::vector<HalfEdge> halves;
  halves.reserve(static_cast<size_t>(triangles.size()));
  for (int t = 0; t < triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k)
      halves.push_back({triangles(t, k), triangles(t, (k + 1) % 3), triangles(t, (k + 2) % 3), t});
  // Counting sorts by the second vertex of the edge, then by the first; each keeps what is alike in
  // its order.
  const int lowest = triangles.minCoeff(), highest = triangles.maxCoeff();
  std::vector<HalfEdge> sorted(halves.size());
  const auto sort_by = [&](auto&& vertex) {
    std::vector<size_t> next(static_cast<size_t>(highest - lowest) + 2, 0);
    for (const HalfEdge& h : halves) ++next[static_cast<size_t>(vertex(h) - lowest) + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    for (const HalfEdge& h : halves) sorted[next[static_cast<size_t>(vertex(h) - lowest)]++] = h;
    halves.swap(sorted);
  };
  sort_by([](const HalfEdge& h) { return std::max(h.from, h.to); });
  sort_by([](const HalfEdge& h) { return std::min(h.from, h.to); });
  return halves;
}

std::vector<Edge> edges_of(const Triangles& triangles) {
  const std::vector<HalfEdge> halves = half_edges_by_edge(triangles);
  std::vector<Edge> edges;
  edges.reserve(halves.size() / 2 + 1);
  for (const HalfEdge& h : halves) {
    const auto [a, b] = std::minmax(h.from, h.to);
    if (edges.empty() || edges.back().a != a || edges.back().b != b) {
      Edge e;
      e.a = a;
      e.b = b;
      e.triangle[0] = h.triangle;
      e.opposite[0] = h.opposite;
      edges.push_back(e);
    } else if (edges.back().boundary()) {
      edges.back().triangle[1] = h.triangle;
      edges.back().opposite[1] = h.opposite;
    } else {
      throw InputError("non-manifold edge: points " + std::to_string(a) + " and " +
                       std::to_string(b) +
                       " are joined by three or more triangles, expected at most two");
    }
  }
  return edges;
}

std::vector<std::vector<int>> boundary_loops(const Triangles& triangles) {
  std::unordered_map<int, int> next;  // the boundary's direction in its triangles
  for (const Edge& e : edges_of(triangles)) {
    if (!e.boundary()) continue;
    const int t = e.triangle[0];
    int from = e.a, to = e.b;
    for (int k = 0; k < 3; ++k)
      if (triangles(t, k) == e.b && triangles(t, (k + 1) % 3) == e.a) std::swap(from, to);
    if (!next.emplace(from, to).second)
      throw InputError("non-manifold boundary: two boundary loops meet in point " +
                       std::to_string(from));
  }
  std::vector<int> starts;
  starts.reserve(next.size());
  for (const auto& [from, to] : next) starts.push_back(from);
  std::sort(starts.begin(), starts.end());
  std::vector<std::vector<int>> loops;
  for (const int start : starts) {
    if (!next.contains(start)) continue;
    std::vector<int> loop;
    int at = start;
    while (next.contains(at)) {
      loop.push_back(at);
      const int to = next.at(at);
      next.erase(at);
      at = to;
    }
    if (at != start)
      throw InputError("inconsistent orientation: the boundary through point " +
                       std::to_string(start) + " does not close");
    loops.push_back(std::move(loop));
  }
  return loops;
}

int euler_number(const Triangles& triangles) {
  if (triangles.rows() == 0) return 0;
  std::vector<char> used(static_cast<size_t>(triangles.maxCoeff()) + 1, 0);
  for (int t = 0; t < triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) used[static_cast<size_t>(triangles(t, k))] = 1;
  const int vertices = static_cast<int>(std::count(used.begin(), used.end(), 1));
  return vertices - static_cast<int>(edges_of(triangles).size()) +
         static_cast<int>(triangles.rows());
}

std::vector<int> components(const Triangles& triangles, int vertex_count) {
  std::vector<int> parent(static_cast<size_t>(vertex_count));
  std::iota(parent.begin(), parent.end(), 0);
  auto find = [&](int i) {
    while (parent[static_cast<size_t>(i)] != i) {
      auto& p = parent[static_cast<size_t>(i)];
      p = parent[static_cast<size_t>(p)];
      i = p;
    }
    return i;
  };
  std::vector<char> used(static_cast<size_t>(vertex_count), 0);
  for (int t = 0; t < triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      used[static_cast<size_t>(triangles(t, k))] = 1;
      const int a = find(triangles(t, k)), b = find(triangles(t, (k + 1) % 3));
      parent[static_cast<size_t>(std::max(a, b))] = std::min(a, b);
    }
  std::vector<int> label(static_cast<size_t>(vertex_count), -1);
  std::map<int, int> number;
  for (int i = 0; i < vertex_count; ++i) {
    if (!used[static_cast<size_t>(i)]) continue;
    const int root = find(i);
    const int next_number = static_cast<int>(number.size());
    label[static_cast<size_t>(i)] = number.emplace(root, next_number).first->second;
  }
  return label;
}

Vec3 triangle_normal(const TriangleSurface& surface, int triangle) {
  const Vec3 a = surface.points.row(surface.triangles(triangle, 0)),
             b = surface.points.row(surface.triangles(triangle, 1)),
             c = surface.points.row(surface.triangles(triangle, 2));
  return (b - a).cross(c - a);
}

Vec3 triangle_center(const TriangleSurface& surface, int triangle) {
  const Vec3 a = surface.points.row(surface.triangles(triangle, 0)),
             b = surface.points.row(surface.triangles(triangle, 1)),
             c = surface.points.row(surface.triangles(triangle, 2));
  return (a + b + c) / 3;
}

Eigen::VectorXd triangle_areas(const TriangleSurface& surface) {
  Eigen::VectorXd area(surface.triangles.rows());
  for (int t = 0; t < surface.triangles.rows(); ++t)
    area[t] = 0.5 * triangle_normal(surface, t).norm();
  return area;
}

Eigen::VectorXd vertex_areas(const TriangleSurface& surface) {
  const Eigen::VectorXd area = triangle_areas(surface);
  Eigen::VectorXd lumped = Eigen::VectorXd::Zero(surface.points.rows());
  for (int t = 0; t < surface.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) lumped[surface.triangles(t, k)] += area[t] / 3;
  return lumped;
}

double corner_angle(const TriangleSurface& surface, int triangle, int corner, double twice_area) {
  const auto point = [&](int k) -> Vec3 {
    return surface.points.row(surface.triangles(triangle, k % 3));
  };
  const Vec3 here = point(corner), e = point(corner + 1) - here, f = point(corner + 2) - here;
  return std::atan2(twice_area, e.dot(f));
}

Points vertex_normals(const TriangleSurface& surface) {
  Points normals = Points::Zero(surface.points.rows(), 3);
  for (int t = 0; t < surface.triangles.rows(); ++t) {
    const Vec3 normal = triangle_normal(surface, t);
    const double length = normal.norm();
    for (int k = 0; k < 3 && length > 0; ++k)
      normals.row(surface.triangles(t, k)) +=
          (corner_angle(surface, t, k, length) / length * normal).transpose();
  }
  for (int i = 0; i < normals.rows(); ++i) {
    const double length = normals.row(i).norm();
    if (length > 0) normals.row(i) /= length;
  }
  return normals;
}

double mean_edge_length(const TriangleSurface& surface) {
  const auto edges = edges_of(surface.triangles);
  double sum = 0;
  for (const Edge& e : edges) sum += (surface.points.row(e.a) - surface.points.row(e.b)).norm();
  return edges.empty() ? 0 : sum / static_cast<double>(edges.size());
}

double total_area(const TriangleSurface& surface) {
  return triangle_areas(surface).sum();
}

TriangleSurface part_with(const TriangleSurface& surface, const std::vector<int>& triangles) {
  TriangleSurface part;
  part.triangles = surface.triangles(triangles, Eigen::all);
  std::vector<int> points(part.triangles.data(), part.triangles.data() + part.triangles.size());
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  part.points = surface.points(points, Eigen::all);
  part.triangles = part.triangles
                       .unaryExpr([&](int v) {
                         const auto found = std::lower_bound(points.begin(), points.end(), v);
                         return static_cast<int>(found - points.begin());
                       })
                       .eval();
  return part;
}

void append(TriangleSurface& surface, const TriangleSurface& more) {
  const Eigen::Index points = surface.points.rows(), triangles = surface.triangles.rows();
  surface.points.conservativeResize(points + more.points.rows(), 3);
  surface.points.bottomRows(more.points.rows()) = more.points;
  surface.triangles.conservativeResize(triangles + more.triangles.rows(), 3);
  surface.triangles.bottomRows(more.triangles.rows()) =
      more.triangles.array() + static_cast<int>(points);
}

Vec3 area_vector(const Points& points, const std::vector<int>& loop) {
  Vec3 sum = Vec3::Zero();
  const Vec3 origin = points.row(loop.front());
  for (size_t k = 0; k < loop.size(); ++k) {
    const Vec3 p = points.row(loop[k]).transpose() - origin;
    const Vec3 q = points.row(loop[(k + 1) % loop.size()]).transpose() - origin;
    sum += 0.5 * p.cross(q);
  }
  return sum;
}

double perimeter(const Points& points, const std::vector<int>& loop) {
  double sum = 0;
  for (size_t k = 0; k < loop.size(); ++k)
    sum += (points.row(loop[(k + 1) % loop.size()]) - points.row(loop[k])).norm();
  return sum;
}

}  // namespace vasorod
