#include "surgery/pose.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "geometry/closest_point.h"
#include "geometry/triangle_surface.h"

namespace vasorod {

namespace {

// The hit's triangle, those with a corner within the radius of the hit, and all that share a corner
// with one of them; sorted.
std::vector<int> triangles_near(const TriangleSurface& surface, const ClosestPoint::Hit& hit,
                                double radius) {
  std::vector<char> within(static_cast<size_t>(surface.points.rows())), around(within.size(), 0);
  for (Eigen::Index v = 0; v < surface.points.rows(); ++v)
    within[static_cast<size_t>(v)] =
        (surface.points.row(v).transpose() - hit.point).norm() <= radius ? 1 : 0;
  const auto any = [&](const std::vector<char>& marked, int t) {
    return marked[static_cast<size_t>(surface.triangles(t, 0))] ||
           marked[static_cast<size_t>(surface.triangles(t, 1))] ||
           marked[static_cast<size_t>(surface.triangles(t, 2))];
  };
  std::vector<int> near;
  for (int t = 0; t < surface.triangles.rows(); ++t)
    if (t == hit.triangle || any(within, t))
      for (int k = 0; k < 3; ++k) around[static_cast<size_t>(surface.triangles(t, k))] = 1;
  for (int t = 0; t < surface.triangles.rows(); ++t)
    if (any(around, t)) near.push_back(t);
  return near;
}

}  // namespace

Vec3 outward_normal(const TriangleSurface& surface, const Vec3& point, double radius) {
  const auto hit = closest_on(surface, point);
  const auto near = triangles_near(surface, hit, radius);
  Triangles triangles(static_cast<Eigen::Index>(near.size()), 3);
  for (size_t n = 0; n < near.size(); ++n)
    triangles.row(static_cast<Eigen::Index>(n)) = surface.triangles.row(near[n]);
  std::vector<std::vector<int>> neighbours(near.size());
  for (const Edge& e : edges_of(triangles)) {
    if (e.boundary()) continue;
    neighbours[static_cast<size_t>(e.triangle[0])].push_back(e.triangle[1]);
    neighbours[static_cast<size_t>(e.triangle[1])].push_back(e.triangle[0]);
  }
  // The patch: triangles with a corner within the radius, reached from the hit's triangle.
  Vec3 sum = hit.normal * 1e-12 * radius * radius;
  std::vector<char> seen(neighbours.size(), 0);
  std::vector<int> patch{
      static_cast<int>(std::find(near.begin(), near.end(), hit.triangle) - near.begin())};
  seen[static_cast<size_t>(patch.front())] = 1;
  for (size_t i = 0; i < patch.size(); ++i) {
    const int t = patch[i];
    const Vec3 a = surface.points.row(triangles(t, 0)), b = surface.points.row(triangles(t, 1)),
               c = surface.points.row(triangles(t, 2));
    const Vec3 n = (b - a).cross(c - a);
    const double far = ((a + b + c) / 3 - hit.point).norm() / radius;
    if (far < 1 && n.dot(hit.normal) > 0) sum += (1 - far * far) * n;
    const double nearest =
        std::min({(a - hit.point).norm(), (b - hit.point).norm(), (c - hit.point).norm()});
    if (nearest > radius && i > 0) continue;
    for (const int next : neighbours[static_cast<size_t>(t)]) {
      if (seen[static_cast<size_t>(next)]) continue;
      seen[static_cast<size_t>(next)] = 1;
      patch.push_back(next);
    }
  }
  return sum.normalized();
}

Pose mouth_pose(const Vec3& pick, const Vec3& outward, const Vec3& recipient_tangent, double phi,
                bool towards_mouth) {
  const Vec3 axis = -outward.normalized();
  Vec3 along = recipient_tangent - recipient_tangent.dot(axis) * axis;
  along =
      along.norm() > 1e-9 * recipient_tangent.norm() ? along.normalized() : axis.unitOrthogonal();
  Pose pose;
  pose.position = pick;
  const Vec3 d1 = Eigen::AngleAxisd(phi, axis) * along;
  const Vec3 d3 = towards_mouth ? axis : Vec3(-axis);
  pose.rotation.col(0) = d1;
  pose.rotation.col(1) = d3.cross(d1);
  pose.rotation.col(2) = d3;
  return pose;
}

CircleMinimum minimise_on_circle(const std::function<double(double)>& function, int samples,
                                 double tolerance) {
  const auto value = [&](double angle) {
    const double v = function(std::remainder(angle, 2 * M_PI));
    return std::isfinite(v) ? v : std::numeric_limits<double>::infinity();
  };
  const double step = 2 * M_PI / samples;
  CircleMinimum best{0, std::numeric_limits<double>::infinity()};
  for (int k = 0; k < samples; ++k) {
    const double v = value(k * step);
    if (v < best.value) best = {k * step, v};
  }
  const double golden = (std::sqrt(5.0) - 1) / 2;
  double low = best.angle - step, high = best.angle + step;
  double left = high - golden * (high - low), right = low + golden * (high - low);
  double at_left = value(left), at_right = value(right);
  while (high - low > tolerance) {
    if (at_left < best.value) best = {left, at_left};
    if (at_right < best.value) best = {right, at_right};
    if (at_left < at_right) {
      high = right;
      right = left;
      at_right = at_left;
      left = high - golden * (high - low);
      at_left = value(left);
    } else {
      low = left;
      left = right;
      at_left = at_right;
      right = low + golden * (high - low);
      at_right = value(right);
    }
  }
  if (at_left < best.value) best = {left, at_left};
  if (at_right < best.value) best = {right, at_right};
  best.angle = std::remainder(best.angle, 2 * M_PI);
  return best;
}

}  // namespace vasorod
