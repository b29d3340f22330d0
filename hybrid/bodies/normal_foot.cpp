#include "bodies/normal_foot.h"

#include <Eigen/LU>
#include <cmath>
#include <optional>

namespace vasorod {
namespace {

constexpr int most_triangles = 16;  // visited per point
constexpr int most_steps = 12;      // Newton steps per triangle
// Weights this far outside a triangle are rounding.
constexpr double outside = 1e-10;
// A foot farther away than this many closest distances belongs to another wall.
constexpr double far = 1.5;

// Solves the three equations for b_1, b_2 and d, with the triangle's plane extended. Returns false
// when Newton's method does not converge.
bool solve_in(const Mat3& x, const Mat3& n, const Vec3& p, Vec3& weight, double& d) {
  const double size = (x.col(1) - x.col(0)).norm() + (p - x.col(0)).norm();
  for (int step = 0; step < most_steps; ++step) {
    const Vec3 normal = n * weight, left = p - x * weight - d * normal;
    if (left.norm() <= 1e-14 * size) return true;
    Mat3 jacobian;
    jacobian.col(0) = x.col(1) - x.col(0) + d * (n.col(1) - n.col(0));
    jacobian.col(1) = x.col(2) - x.col(0) + d * (n.col(2) - n.col(0));
    jacobian.col(2) = normal;
    const Vec3 move = jacobian.inverse() * left;
    if (!move.allFinite()) return false;
    weight += Vec3(-move[0] - move[1], move[0], move[1]);
    d += move[2];
    if (move.head<2>().norm() <= 1e-14) return true;
  }
  return false;
}

Mat3 corners(const TriangleSurface& surface, int triangle) {
  Mat3 columns;
  for (int c = 0; c < 3; ++c) columns.col(c) = surface.points.row(surface.triangles(triangle, c));
  return columns;
}

Mat3 normals_at(const TriangleSurface& surface, NormalsOnDemand& normal_of, int triangle) {
  Mat3 columns;
  for (int c = 0; c < 3; ++c) columns.col(c) = normal_of(surface.triangles(triangle, c));
  return columns;
}

std::optional<NormalFoot> walk(const ClosestPoint& finder, NormalsOnDemand& normal_of,
                               const Vec3& p, const ClosestPoint::Hit& closest) {
  const TriangleSurface& surface = finder.surface();
  ClosestPoint::Hit hit = closest;
  for (int k = 0; k < most_triangles; ++k) {
    const Mat3 x = corners(surface, hit.triangle), n = normals_at(surface, normal_of, hit.triangle);
    Vec3 weight = hit.barycentric, normal = n * weight;
    double d = normal.dot(p - hit.point) / normal.squaredNorm();
    if (!std::isfinite(d) || !solve_in(x, n, p, weight, d)) return {};
    normal = n * weight;
    if (weight.minCoeff() >= -outside) {
      const double height = d * normal.norm();
      if (std::abs(height) > far * (p - closest.point).norm() + outside * x.norm()) return {};
      return NormalFoot{hit.triangle, weight, normal, height};
    }
    hit = finder.query(x * weight, hit.triangle);
    if (hit.on_boundary) return {};
  }
  return {};
}

}  // namespace

NormalFoot normal_foot(const ClosestPoint& finder, NormalsOnDemand& normal_of, const Vec3& p,
                       const ClosestPoint::Hit& closest) {
  if (const std::optional<NormalFoot> foot = walk(finder, normal_of, p, closest)) return *foot;
  const Vec3 normal =
      normals_at(finder.surface(), normal_of, closest.triangle) * closest.barycentric;
  return {closest.triangle, closest.barycentric, normal,
          normal.normalized().dot(p - closest.point)};
}

}  // namespace vasorod
