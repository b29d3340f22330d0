// The mouth of a join against closed forms.
#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "reference_fem/mouth.h"

namespace vasorod::fem {
namespace {

constexpr double pi = std::numbers::pi;

Points ellipse(double a, double b, double dent, int n = 720) {
  Points points(n, 3);
  for (int k = 0; k < n; ++k) {
    const double t = 2 * pi * k / n;
    points.row(k) << a * std::cos(t), b * std::sin(t), dent * std::cos(2 * t);
  }
  return points;
}

TEST(Mouth, OfAnEllipse) {
  const Points rest = ellipse(2, 2, 0), seam = ellipse(3, 0.8, 0);
  const MouthReport mouth = mouth_of(seam, rest, 0.4);
  // Ramanujan's perimeter, exact to 1e-5 at this flatness
  const double h = std::pow((3 - 0.8) / (3 + 0.8), 2),
               perimeter = pi * 3.8 * (1 + 3 * h / (10 + std::sqrt(4 - 3 * h)));
  EXPECT_NEAR(mouth.area / (pi * 3 * 0.8), 1, 2e-5);
  EXPECT_NEAR(mouth.perimeter / perimeter, 1, 5e-5);
  EXPECT_NEAR(mouth.perimeter_ratio, perimeter / (4 * pi), 5e-5);
  EXPECT_NEAR(mouth.span, 6, 1e-9);
  EXPECT_NEAR(mouth.width, 1.6, 1e-9);
  EXPECT_NEAR(mouth.lumen, pi * 3 * 0.8 - 0.2 * perimeter + pi * 0.04, 1e-3);
  EXPECT_NEAR(mouth.area_ratio, mouth.lumen / (pi * 1.8 * 1.8), 1e-4);
}

// Out of its plane the projection counts; a motion of the whole changes nothing but the centre.
TEST(Mouth, IsThatOfTheProjection) {
  const Points rest = ellipse(2, 2, 0), flat = ellipse(3, 0.8, 0);
  Points seam = ellipse(3, 0.8, 0.5);
  const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()).toRotationMatrix();
  seam = ((seam * turn.transpose()).rowwise() + Eigen::RowVector3d(5, -1, 2)).eval();
  const MouthReport a = mouth_of(flat, rest, 0.4), b = mouth_of(seam, rest, 0.4);
  EXPECT_NEAR(b.area, a.area, 1e-9);
  EXPECT_NEAR(b.span, a.span, 1e-9);
  EXPECT_NEAR(b.width, a.width, 1e-9);
  EXPECT_GT(b.perimeter, a.perimeter);
  EXPECT_LT((b.center - Vec3(5, -1, 2)).norm(), 1e-9);
}

TEST(Mouth, AClosedMouthHasNoLumen) {
  const MouthReport mouth = mouth_of(ellipse(3, 0.05, 0), ellipse(2, 2, 0), 0.4);
  EXPECT_EQ(mouth.lumen, 0);
  EXPECT_EQ(mouth.area_ratio, 0);
}

}  // namespace
}  // namespace vasorod::fem
