#include "geometry/closest_point.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>
#include <mutex>
#include <numeric>
#include <optional>
#include <utility>

#include <vasorod/error.h>

#include "data/index.h"
#include "geometry/box_tree.h"
#include "geometry/triangle_surface.h"

namespace vasorod {
namespace {

// Parameter of the point of segment a-b closest to p.
double closest_on_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const double squared = (b - a).squaredNorm();
  return squared > 0 ? std::clamp((p - a).dot(b - a) / squared, 0.0, 1.0) : 0.0;
}

Vec3 closest_on_edges(const Vec3& p, const std::array<Vec3, 3>& corner) {
  Vec3 best = Vec3::UnitX();
  double best_distance = std::numeric_limits<double>::infinity();
  for (size_t k = 0; k < 3; ++k) {
    const size_t l = (k + 1) % 3;
    const double t = closest_on_segment(p, corner[k], corner[l]);
    const double distance = (p - (1 - t) * corner[k] - t * corner[l]).squaredNorm();
    if (distance >= best_distance) continue;
    best_distance = distance;
    best.setZero();
    best[static_cast<int>(k)] = 1 - t;
    best[static_cast<int>(l)] = t;
  }
  return best;
}

}  // namespace

Vec3 closest_in_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, n = ab.cross(ac);
  const double squared = n.squaredNorm();
  if (squared > 0) {
    const double v = (p - a).cross(ac).dot(n) / squared, w = ab.cross(p - a).dot(n) / squared;
    if (v > 0 && w > 0 && v + w < 1) return {1 - v - w, v, w};
  }
  return closest_on_edges(p, {a, b, c});
}

namespace {

double squared_distance(const TriangleSurface& surface, const Vec3& p, int t) {
  const Vec3 a = surface.points.row(surface.triangles(t, 0)),
             b = surface.points.row(surface.triangles(t, 1)),
             c = surface.points.row(surface.triangles(t, 2));
  const Vec3 share = closest_in_triangle(p, a, b, c);
  return (p - share[0] * a - share[1] * b - share[2] * c).squaredNorm();
}

}  // namespace

// What stays the same when the points move.
struct ClosestPoint::Links {
  explicit Links(const TriangleSurface& surface)
      : first(index(surface.points.rows()) + 1, 0),
        around(index(surface.triangles.size())),
        neighbour(index(surface.triangles.rows()), {-1, -1, -1}),
        on_boundary(index(surface.points.rows()), 0) {
    const Triangles& triangles = surface.triangles;
    for (const int v : triangles.reshaped()) ++first[index(v) + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<int> next(first.begin(), first.end() - 1);
    for (int t = 0; t < triangles.rows(); ++t)
      for (int k = 0; k < 3; ++k) around[index(next[index(triangles(t, k))]++)] = t;
    for (const Edge& e : edges_of(triangles)) {
      if (e.boundary()) on_boundary[index(e.a)] = on_boundary[index(e.b)] = 1;
      for (size_t side = 0; side < 2; ++side) {
        if (e.triangle[side] < 0) continue;
        for (int k = 0; k < 3; ++k)
          if (triangles(e.triangle[side], k) == e.opposite[side])
            neighbour[index(e.triangle[side])][index(k)] = e.triangle[1 - side];
      }
    }
  }

  std::vector<int> first, around;             // triangles of vertex v: first[v] up to first[v + 1]
  std::vector<std::array<int, 3>> neighbour;  // across the edge opposite to a triangle's corner
  std::vector<char> on_boundary;              // per vertex
};

struct ClosestPoint::Tree {
  Tree(TriangleSurface given, std::shared_ptr<const Links> its)
      : surface(std::move(given)), links(std::move(its)) {
    if (surface.triangles.rows() == 0)
      throw InputError("a surface without triangles has no closest point");
    if (!links) links = std::make_shared<Links>(surface);
  }

  void move(const Points& moved) {
    surface.points = moved;
    fits = false;
  }

  // Made or moved by the first query: not every wall is asked wherever it goes.
  const BoxTree& boxes() {
    if (!fits.load(std::memory_order_acquire)) {
      const std::lock_guard lock(fitting);
      if (!fits.load(std::memory_order_relaxed)) {
        const std::vector<Box> now = triangle_boxes(surface);
        if (tree)
          tree->refit(now);
        else
          tree.emplace(now);
        fits.store(true, std::memory_order_release);
      }
    }
    return *tree;
  }

  // Unit, zero where degenerate.
  Vec3 normal(int t) const {
    const Vec3 n = triangle_normal(surface, t);
    const double length = n.norm();
    return length > 0 ? Vec3(n / length) : Vec3(Vec3::Zero());
  }

  Vec3 vertex_normal(int vertex) const {
    Vec3 sum = Vec3::Zero();
    for (int i = links->first[index(vertex)]; i < links->first[index(vertex) + 1]; ++i) {
      const int t = links->around[index(i)];
      const Vec3 n = triangle_normal(surface, t);
      const double twice_area = n.norm();
      for (int k = 0; k < 3 && twice_area > 0; ++k)
        if (surface.triangles(t, k) == vertex)
          sum += corner_angle(surface, t, k, twice_area) / twice_area * n;
    }
    const double length = sum.norm();
    if (length > 0) sum /= length;
    return sum;
  }

  Vec3 corner(int t, int k) const { return surface.points.row(surface.triangles(t, k)); }

  TriangleSurface surface;
  std::shared_ptr<const Links> links;

 private:
  std::optional<BoxTree> tree;  // of the triangles' boxes
  std::atomic<bool> fits = false;
  std::mutex fitting;
};

ClosestPoint::ClosestPoint(const TriangleSurface& surface)
    : tree_(std::make_unique<Tree>(surface, nullptr)) {}
ClosestPoint::ClosestPoint(std::unique_ptr<Tree> tree) : tree_(std::move(tree)) {}
ClosestPoint::~ClosestPoint() = default;
ClosestPoint::ClosestPoint(ClosestPoint&&) noexcept = default;
ClosestPoint& ClosestPoint::operator=(ClosestPoint&&) noexcept = default;

ClosestPoint::Hit ClosestPoint::query(const Vec3& point, int near) const {
  Tree& tree = *tree_;
  Hit hit;
  const int found = tree.boxes().nearest(
      point, [&](int t) { return squared_distance(tree.surface, point, t); }, near);
  const int t = hit.triangle = std::max(found, 0);  // -1 where a point is not finite
  hit.barycentric =
      closest_in_triangle(point, tree.corner(t, 0), tree.corner(t, 1), tree.corner(t, 2));
  hit.point = hit.barycentric[0] * tree.corner(t, 0) + hit.barycentric[1] * tree.corner(t, 1) +
              hit.barycentric[2] * tree.corner(t, 2);

  const auto zeros = (hit.barycentric.array() <= 0).count();
  const auto& neighbour = tree.links->neighbour[index(t)];
  if (zeros == 0) {
    hit.normal = tree.normal(t);
  } else if (zeros == 1) {
    int k = 0;
    hit.barycentric.minCoeff(&k);
    const int across = neighbour[static_cast<size_t>(k)];
    hit.on_boundary = across < 0;
    hit.normal = tree.normal(t);
    if (across >= 0) hit.normal += tree.normal(across);
  } else {
    int k = 0;
    hit.barycentric.maxCoeff(&k);
    const int vertex = tree.surface.triangles(t, k);
    hit.on_boundary = tree.links->on_boundary[index(vertex)] != 0;
    hit.normal = tree.vertex_normal(vertex);
  }
  // A degenerate triangle, or two triangles folded onto each other, has no normal: use the vertex
  // normals.
  if (hit.normal.squaredNorm() < 1e-24) {
    int k = 0;
    hit.barycentric.maxCoeff(&k);
    hit.normal = tree.vertex_normal(tree.surface.triangles(t, k));
  }
  if (hit.normal.squaredNorm() > 0) hit.normal.normalize();
  const Vec3 away = point - hit.point;
  hit.signed_distance = away.dot(hit.normal) < 0 ? -away.norm() : away.norm();
  return hit;
}

namespace {

int closest_triangle(const TriangleSurface& surface, const Vec3& point) {
  const std::vector<Box> boxes = triangle_boxes(surface);
  int closest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int t = 0; t < surface.triangles.rows(); ++t) {
    const Box& box = boxes[static_cast<size_t>(t)];
    if (!(box.squared_distance(point) < least)) continue;
    const double squared = squared_distance(surface, point, t);
    if (!(squared < least)) continue;
    least = squared;
    closest = t;
  }
  return closest;
}

}  // namespace

ClosestPoint::Hit closest_on(const TriangleSurface& surface, const Vec3& point) {
  if (surface.triangles.rows() == 0)
    throw InputError("a surface without triangles has no closest point");
  // The triangles around its corners have all that the hit's normal comes from.
  const auto corners = surface.triangles.row(closest_triangle(surface, point));
  std::vector<int> near;
  for (int t = 0; t < surface.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k)
      if ((corners.array() == surface.triangles(t, k)).any()) {
        near.push_back(t);
        break;
      }
  TriangleSurface patch;
  patch.triangles.resize(static_cast<Eigen::Index>(near.size()), 3);
  std::vector<int> known;  // vertices of the surface, by those of the patch
  for (size_t n = 0; n < near.size(); ++n)
    for (int k = 0; k < 3; ++k) {
      const int vertex = surface.triangles(near[n], k);
      const auto found = std::find(known.begin(), known.end(), vertex);
      patch.triangles(static_cast<Eigen::Index>(n), k) = static_cast<int>(found - known.begin());
      if (found == known.end()) known.push_back(vertex);
    }
  patch.points.resize(static_cast<Eigen::Index>(known.size()), 3);
  for (size_t v = 0; v < known.size(); ++v)
    patch.points.row(static_cast<Eigen::Index>(v)) = surface.points.row(known[v]);
  ClosestPoint::Hit hit = ClosestPoint(patch).query(point);
  hit.triangle = near[static_cast<size_t>(hit.triangle)];
  return hit;
}

void ClosestPoint::refit(const Points& points) {
  // Bit for bit: also where a solver has lost the wall and its points are no numbers, it moves
  // once.
  const Points& here = tree_->surface.points;
  const size_t bytes = index(points.size()) * sizeof(double);
  if (here.size() == points.size() && std::memcmp(here.data(), points.data(), bytes) == 0) return;
  tree_->move(points);
}

ClosestPoint ClosestPoint::moved(const Points& points) const {
  return ClosestPoint(
      std::make_unique<Tree>(TriangleSurface{points, tree_->surface.triangles}, tree_->links));
}

const TriangleSurface& ClosestPoint::surface() const {
  return tree_->surface;
}

Vec3 ClosestPoint::vertex_normal(int vertex) const {
  return tree_->vertex_normal(vertex);
}

std::vector<std::array<int, 2>> ClosestPoint::boundary_edges() const {
  std::vector<std::array<int, 2>> edges;
  const Triangles& triangles = tree_->surface.triangles;
  for (int t = 0; t < triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      if (tree_->links->neighbour[index(t)][index(k)] >= 0) continue;
      const auto [a, b] = std::minmax(triangles(t, (k + 1) % 3), triangles(t, (k + 2) % 3));
      edges.push_back({a, b});
    }
  std::sort(edges.begin(), edges.end());
  return edges;
}

}  // namespace vasorod
