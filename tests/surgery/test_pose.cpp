#include <gtest/gtest.h>

#include "geometry/noisy_tube.h"
#include "surgery/pose.h"

namespace vasorod {
namespace {

TEST(Pose, OutwardNormalOfANoisyTubeIsRadialWhateverTheRadius) {
  testing::TubeShape shape;
  shape.around = 40;
  shape.along = 50;
  shape.jitter = 0.25;
  const auto tube = testing::noisy_tube(shape);
  for (const double theta : {0.3, 2.0, 4.4})
    for (const double radius :
         {0.01, 3.0, 5.0, 9.0}) {  // from within one triangle to around the whole tube
      const Vec3 exact(std::cos(theta), std::sin(theta), 0);
      const Vec3 normal = outward_normal(tube, 5 * exact + Vec3(0, 0, 20), radius);
      EXPECT_NEAR(normal.norm(), 1, 1e-12);
      EXPECT_GT(normal.dot(exact), radius < 1 ? 0.98 : 0.999);
    }
}

TEST(Pose, TheMouthFacesTheSurfaceAndTurnsByPhi) {
  const Vec3 pick(1, 2, 3), outward = Vec3(0.2, 1, 0.1).normalized(), tangent(1, 0, 0);
  for (const bool towards : {true, false})
    for (const double phi : {-1.0, 0.0, 0.7}) {
      const Pose pose = mouth_pose(pick, outward, tangent, phi, towards);
      EXPECT_NEAR((pose.rotation.transpose() * pose.rotation - Mat3::Identity()).norm(), 0, 1e-14);
      EXPECT_NEAR(pose.rotation.determinant(), 1, 1e-14);
      EXPECT_EQ(pose.position, pick);
      EXPECT_NEAR((pose.director(3) - (towards ? -1 : 1) * outward).norm(), 0, 1e-14);
      const Vec3 along = (tangent - tangent.dot(outward) * outward).normalized();
      EXPECT_NEAR(pose.director(1).dot(along), std::cos(phi), 1e-14);
      EXPECT_NEAR(along.cross(pose.director(1)).dot(-outward), std::sin(phi), 1e-14);
    }
}

TEST(Pose, MinimumOnTheCircleIsFoundAndNeverWorseThanTheBestSample) {
  const auto smooth = [](double a) {
    return 2 - std::cos(a - 3.0) - 0.3 * std::cos(2 * (a - 3.0));
  };
  const auto found = minimise_on_circle(smooth);
  EXPECT_NEAR(std::remainder(found.angle - 3.0, 2 * M_PI), 0, 1e-4);
  EXPECT_NEAR(found.value, 0.7, 1e-8);
  // A kinked function, like a maximum of shears; and a function that is nowhere smooth and
  // sometimes NaN.
  const auto kinked = [](double a) {
    return std::max(std::abs(std::remainder(a + 1.234, 2 * M_PI)), 0.01);
  };
  EXPECT_NEAR(minimise_on_circle(kinked).value, 0.01, 1e-4);
  const auto wild = [](double a) {
    return a > 1 && a < 2 ? std::nan("") : std::sin(40 * a) + 0.1 * std::abs(a);
  };
  double best = 1e9;
  for (int k = 0; k < 24; ++k) {
    const double v = wild(std::remainder(k * 2 * M_PI / 24, 2 * M_PI));
    if (std::isfinite(v)) best = std::min(best, v);
  }
  const auto rough = minimise_on_circle(wild);
  EXPECT_LE(rough.value, best);
  EXPECT_EQ(rough.value, wild(rough.angle));
}

}  // namespace
}  // namespace vasorod
