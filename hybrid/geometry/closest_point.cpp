#include "geometry/closest_point.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <vasorod/error.h>

#include "geometry/box_tree.h"
#include "geometry/normals_on_demand.h"
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

struct ClosestPoint::Tree {
  explicit Tree(const TriangleSurface& given)
      : surface(given),
        boxes(triangle_boxes(surface)),
        around(surface.triangles, surface.points.rows()) {
    const Triangles& triangles = surface.triangles;
    if (triangles.rows() == 0) throw InputError("a surface without triangles has no closest point");
    const auto count = static_cast<size_t>(triangles.rows());
    neighbour.assign(count, {-1, -1, -1});
    on_boundary.assign(static_cast<size_t>(surface.points.rows()), 0);
    for (const Edge& e : edges_of(triangles)) {
      if (e.boundary())
        on_boundary[static_cast<size_t>(e.a)] = on_boundary[static_cast<size_t>(e.b)] = 1;
      for (size_t side = 0; side < 2; ++side) {
        if (e.triangle[side] < 0) continue;
        for (int k = 0; k < 3; ++k)  // neighbour[k] lies across the edge opposite to corner k
          if (triangles(e.triangle[side], k) == e.opposite[side])
            neighbour[static_cast<size_t>(e.triangle[side])][static_cast<size_t>(k)] =
                e.triangle[1 - side];
      }
    }
  }

  void move(const Points& moved) {
    surface.points = moved;
    boxes.refit(triangle_boxes(surface));
  }

  // Unit, zero where degenerate.
  Vec3 normal(int t) const {
    const Vec3 n = triangle_normal(surface, t);
    const double length = n.norm();
    return length > 0 ? Vec3(n / length) : Vec3(Vec3::Zero());
  }
  Vec3 vertex_normal(int vertex) const { return around.normal(surface, vertex); }

  Vec3 corner(int t, int k) const { return surface.points.row(surface.triangles(t, k)); }

  TriangleSurface surface;
  BoxTree boxes;  // of the triangles
  TrianglesAround around;
  std::vector<std::array<int, 3>> neighbour;
  std::vector<char> on_boundary;  // per vertex
};

ClosestPoint::ClosestPoint(const TriangleSurface& surface)
    : tree_(std::make_unique<Tree>(surface)) {}
ClosestPoint::~ClosestPoint() = default;
ClosestPoint::ClosestPoint(ClosestPoint&&) noexcept = default;
ClosestPoint& ClosestPoint::operator=(ClosestPoint&&) noexcept = default;

ClosestPoint::Hit ClosestPoint::query(const Vec3& point, int near) const {
  const Tree& tree = *tree_;
  Hit hit;
  const int found = tree.boxes.nearest(
      point, [&](int t) { return squared_distance(tree.surface, point, t); }, near);
  const int t = hit.triangle = std::max(found, 0);  // -1 where a point is not finite
  hit.barycentric =
      closest_in_triangle(point, tree.corner(t, 0), tree.corner(t, 1), tree.corner(t, 2));
  hit.point = hit.barycentric[0] * tree.corner(t, 0) + hit.barycentric[1] * tree.corner(t, 1) +
              hit.barycentric[2] * tree.corner(t, 2);

  const auto zeros = (hit.barycentric.array() <= 0).count();
  const auto& neighbour = tree.neighbour[static_cast<size_t>(t)];
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
    hit.on_boundary = tree.on_boundary[static_cast<size_t>(vertex)] != 0;
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
  if (points == tree_->surface.points) return;
  tree_->move(points);
}

}  // namespace vasorod
