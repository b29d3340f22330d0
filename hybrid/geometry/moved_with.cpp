#include "geometry/moved_with.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <vector>

#include "data/index.h"
#include "geometry/closest_point.h"
#include "geometry/rigid_motion.h"
#include "geometry/triangle_surface.h"

namespace vasorod {
namespace {

// Share of the way from a point on a rim to the middle of its triangles at which the closest point
// is looked for.
constexpr double into_own_side = 0.5;

// Edges and unit normal of a triangle as columns.
Mat3 frame(const TriangleSurface& surface, const Points& at, Eigen::Index t) {
  const Vec3 a = at.row(surface.triangles(t, 0)), b = at.row(surface.triangles(t, 1)),
             c = at.row(surface.triangles(t, 2));
  Mat3 columns;
  columns << b - a, c - a, (b - a).cross(c - a).normalized();
  return columns;
}

std::vector<Mat3> vertex_gradients(const TriangleSurface& surface, const Points& moved) {
  std::vector<Mat3> sum(index(surface.points.rows()), Mat3::Zero());
  std::vector<double> weight(sum.size(), 0);
  for (Eigen::Index t = 0; t < surface.triangles.rows(); ++t) {
    const Mat3 rest = frame(surface, surface.points, t);
    const double area = rest.col(0).cross(rest.col(1)).norm();
    const Mat3 gradient = frame(surface, moved, t) * rest.inverse();
    for (int k = 0; k < 3; ++k) {
      sum[index(surface.triangles(t, k))] += area * gradient;
      weight[index(surface.triangles(t, k))] += area;
    }
  }
  for (size_t v = 0; v < sum.size(); ++v) sum[v] /= weight[v];
  return sum;
}

// Where the closest point is looked for: a rim's points on their own side.
Points looked_for(const TriangleSurface& surface) {
  Points points = surface.points, middle = Points::Zero(points.rows(), 3);
  std::vector<int> count(index(points.rows()), 0);
  for (Eigen::Index t = 0; t < surface.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      middle.row(surface.triangles(t, k)) +=
          triangle_center(surface, static_cast<int>(t)).transpose();
      ++count[index(surface.triangles(t, k))];
    }
  for (const std::vector<int>& loop : boundary_loops(surface.triangles))
    for (const int v : loop)
      points.row(v) += into_own_side * (middle.row(v) / count[index(v)] - points.row(v));
  return points;
}

// Of the foot of `point` on the plane of a triangle; outside of it, negative ones.
Vec3 barycentric_in_plane(const Vec3& point, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = (b - a).cross(c - a);
  const double area = normal.squaredNorm();
  const double v = (point - a).cross(c - a).dot(normal) / area,
               w = (b - a).cross(point - a).dot(normal) / area;
  return {1 - v - w, v, w};
}

}  // namespace

MovedSurface moved_with(const TriangleSurface& coarse, const Points& moved,
                        const Eigen::VectorXd& values, const TriangleSurface& surface) {
  const ClosestPoint closest(coarse);
  const std::vector<Mat3> gradients = vertex_gradients(coarse, moved);
  const Points queries = looked_for(surface);
  MovedSurface out;
  out.points.resize(queries.rows(), 3);
  out.values.setZero(queries.rows());
  for (Eigen::Index i = 0; i < queries.rows(); ++i) {
    const ClosestPoint::Hit hit = closest.query(queries.row(i));
    const Vec3 rest = surface.points.row(i);
    const auto corner = [&](int k) { return coarse.triangles(hit.triangle, k); };
    const bool on_rim = queries.row(i) != surface.points.row(i);
    const Vec3 b =
        on_rim ? barycentric_in_plane(rest, coarse.points.row(corner(0)),
                                      coarse.points.row(corner(1)), coarse.points.row(corner(2)))
               : hit.barycentric;
    Vec3 foot = Vec3::Zero(), to = Vec3::Zero();
    for (int k = 0; k < 3; ++k) foot += b[k] * coarse.points.row(corner(k)).transpose();
    Mat3 gradient = Mat3::Zero();
    for (int k = 0; k < 3; ++k) {
      const Mat3& own = gradients[index(corner(k))];
      const Vec3 from = coarse.points.row(corner(k));
      gradient += b[k] * own;
      out.values[i] += b[k] * values[corner(k)];
      to +=
          b[k] * (moved.row(corner(k)).transpose() + (own - Mat3::Identity()) * (foot - from) / 2);
    }
    out.points.row(i) = to + gradient * (rest - foot);
    out.rotations.push_back(rotation_part(gradient));
  }
  return out;
}

}  // namespace vasorod
