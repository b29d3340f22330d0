#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>

#include "geometry/flat_chart.h"
#include "geometry/noisy_tube.h"
#include "geometry/triangle_surface.h"

namespace vasorod {
namespace {

using testing::TubeShape;

// The triangles of the tube around (theta, s), and its axis in each.
ChartRequest around(const TubeShape& shape, const TriangleSurface& tube, double theta, double s,
                    double angle, double along) {
  ChartRequest request;
  double nearest = 1e300;
  const Vec3 origin = testing::on_tube(shape, theta, s, shape.radius);
  for (int t = 0; t < tube.triangles.rows(); ++t) {
    Vec3 middle = Vec3::Zero();
    for (int k = 0; k < 3; ++k) middle += tube.points.row(tube.triangles(t, k)).transpose() / 3;
    const double off = std::remainder(std::atan2(middle.y(), middle.x()) - theta, 2 * M_PI);
    if (std::abs(off) > angle || std::abs(middle.z() - s) > along) continue;
    request.patch.push_back(t);
    if ((middle - origin).norm() >= nearest) continue;
    nearest = (middle - origin).norm();
    request.triangle = t;
  }
  request.along = Points::Zero(static_cast<Eigen::Index>(request.patch.size()), 3);
  request.along.col(2).setOnes();
  return request;
}

// On a cylinder x is the way along it and y the way around it (clockwise seen against x), to second
// order in the edge.
TEST(FlatChart, ACylinderIsUnrolledWithoutStretch) {
  double before = 0;
  for (const int n : {24, 48, 96}) {
    TubeShape shape;
    shape.around = n;
    shape.along = n * 5 / 4;
    shape.jitter = 0.25;
    const auto tube = testing::noisy_tube(shape);
    for (const double theta : {0.4, 3.0}) {  // across the jump of the angle too
      const auto request = around(shape, tube, theta, 20, 1.9, 8);
      const auto chart = unroll(tube, request);
      Vec3 origin = Vec3::Zero();
      for (int k = 0; k < 3; ++k)
        origin += tube.points.row(tube.triangles(request.triangle, k)).transpose() / 3;
      const double at = std::atan2(origin.y(), origin.x());
      double worst = 0;
      int count = 0;
      for (int v = 0; v < chart.rows(); ++v) {
        if (std::isnan(chart(v, 0))) continue;
        ++count;
        const Vec3 p = tube.points.row(v);
        const double turn = std::remainder(std::atan2(p.y(), p.x()) - at, 2 * M_PI);
        worst = std::max(worst, std::hypot(chart(v, 0) - (p.z() - origin.z()),
                                           chart(v, 1) + shape.radius * turn));
      }
      EXPECT_GT(count, n * n / 4);
      EXPECT_LT(worst, 120.0 / (n * n)) << n;
      if (theta < 1) continue;
      if (before > 0) {
        EXPECT_LT(worst, before / 2.5);
      }
      before = worst;
    }
  }
}

// A cap of a sphere cannot be unrolled without stretch: lengths are right in the mean.
TEST(FlatChart, OfACapOfASphereLengthsAreRightInTheMean) {
  const int rings = 16, n = 48;
  const double radius = 10, opening = 0.6;
  TriangleSurface cap;
  cap.points.resize(1 + rings * n, 3);
  cap.points.row(0) << 0, 0, radius;
  for (int j = 0; j < rings; ++j)
    for (int i = 0; i < n; ++i) {
      const double polar = opening * (j + 1) / rings, angle = 2 * M_PI * (i + 0.5 * j) / n;
      cap.points.row(1 + j * n + i) << radius * std::sin(polar) * std::cos(angle),
          radius * std::sin(polar) * std::sin(angle), radius * std::cos(polar);
    }
  std::vector<std::array<int, 3>> triangles;
  for (int i = 0; i < n; ++i) triangles.push_back({0, 1 + i, 1 + (i + 1) % n});
  for (int j = 0; j + 1 < rings; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = 1 + j * n + i, b = 1 + j * n + (i + 1) % n;
      triangles.push_back({a, a + n, b});
      triangles.push_back({b, a + n, b + n});
    }
  ChartRequest request;
  cap.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (size_t t = 0; t < triangles.size(); ++t) {
    request.patch.push_back(static_cast<int>(t));
    for (int k = 0; k < 3; ++k)
      cap.triangles(static_cast<Eigen::Index>(t), k) = triangles[t][static_cast<size_t>(k)];
  }
  request.along = Points::Zero(cap.triangles.rows(), 3);
  request.along.col(0).setOnes();
  request.barycentric = Vec3::UnitX();
  const auto chart = unroll(cap, request);
  // Without stretch along the meridians the rim would be radius * opening away, and stretched by
  // opening / sin(opening); an unrolled cap lies between.
  for (int i = 0; i < n; ++i) {
    const double away = chart.row(1 + (rings - 1) * n + i).norm();
    EXPECT_LT(away, radius * opening);
    EXPECT_GT(away, radius * std::sin(opening));
  }
  double area = 0;
  for (int t = 0; t < cap.triangles.rows(); ++t) {
    const Vec2 a = chart.row(cap.triangles(t, 0)), b = chart.row(cap.triangles(t, 1)),
               c = chart.row(cap.triangles(t, 2));
    const double own = ((b - a).x() * (c - a).y() - (b - a).y() * (c - a).x()) / 2;
    EXPECT_GT(own, 0) << t;
    area += own;
  }
  EXPECT_NEAR(area / total_area(cap), 1, 0.005);
}

TEST(FlatChart, FollowsTheSurfaceAndTheWantedDirection) {
  TubeShape shape;
  shape.jitter = 0.25;
  const auto tube = testing::noisy_tube(shape);
  auto request = around(shape, tube, 1, 20, 1.5, 8);
  const auto chart = unroll(tube, request);

  // A turned and moved surface has the same chart, a mirrored one the mirrored chart.
  const Mat3 turn = Eigen::AngleAxisd(2.2, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
  TriangleSurface moved = tube, mirrored = tube;
  moved.points = ((tube.points * turn.transpose()).rowwise() + Vec3(30, -5, 7).transpose()).eval();
  mirrored.points.col(1) *= -1;
  mirrored.triangles.col(0).swap(mirrored.triangles.col(1));
  const Points along = request.along;
  request.along = along * turn.transpose();
  const auto of_moved = unroll(moved, request);
  request.along = along;
  const auto of_mirrored = unroll(mirrored, request);
  // A direction that is not the axis: 0.3 radians from it within the wall, counter-clockwise.
  for (size_t i = 0; i < request.patch.size(); ++i) {
    Vec3 middle = Vec3::Zero();
    for (int k = 0; k < 3; ++k)
      middle += tube.points.row(tube.triangles(request.patch[i], k)).transpose() / 3;
    const Vec3 outward = Vec3(middle.x(), middle.y(), 0).normalized();
    request.along.row(static_cast<Eigen::Index>(i)) =
        (Eigen::AngleAxisd(0.3, outward) * Vec3::UnitZ()).transpose();
  }
  const auto of_oblique = unroll(tube, request);
  const Eigen::Rotation2Dd back(-0.3);
  for (int v = 0; v < chart.rows(); ++v) {
    if (std::isnan(chart(v, 0))) continue;
    EXPECT_LT((of_moved.row(v) - chart.row(v)).norm(), 1e-6);
    EXPECT_NEAR(of_mirrored(v, 0), chart(v, 0), 1e-6);
    EXPECT_NEAR(of_mirrored(v, 1), -chart(v, 1), 1e-6);
    const Vec2 turned = back * Vec2(chart.row(v));
    EXPECT_LT((Vec2(of_oblique.row(v)) - turned).norm(), 0.02 * shape.radius);
  }
}

}  // namespace
}  // namespace vasorod
