// Flat caps of tubes of known size.
#include <gtest/gtest.h>

#include "prepare/find_caps.h"
#include "prepare/tube_shapes.h"

namespace vasorod::testing {
namespace {

constexpr double radius = 5, length = 40;

TEST(FindCaps, AFlatEndIsOneWithItsPlaceAndSize) {
  const TriangleSurface tube = closed_tube(length, radius, false);
  const auto caps = find_caps(tube, 0.2 * radius);
  ASSERT_EQ(caps.size(), 2U);
  for (const FlatCap& cap : caps) {
    const double side = cap.normal.z() > 0 ? 1 : -1;
    EXPECT_NEAR(side * cap.normal.z(), 1, 1e-9);
    EXPECT_LT((cap.center - Vec3(0, 0, side > 0 ? length : 0)).norm(), 1e-9);
    EXPECT_NEAR(cap.radius, radius, 0.01 * radius);  // 32 sides
    EXPECT_NEAR(depth_behind(tube, cap), length / cap.radius, 1e-9);
  }
}

// The fan over an end as a cone of height h is h / sqrt(18) off its plane.
TEST(FindCaps, AFlatEndWasSurelyCutABulgingOneWasNot) {
  for (const auto& [height, cut] : {std::pair{0.0, true}, {0.25, false}}) {
    TriangleSurface tube = closed_tube(length, radius, false);
    tube.points(tube.points.rows() - 1, 2) += height * radius;
    int bulging = 0;
    for (const FlatCap& cap : find_caps(tube, 0.2 * radius))
      if (cap.center.z() > 0.5 * length) {
        ++bulging;
        EXPECT_NEAR(cap.unevenness, height / std::sqrt(18), 0.05 * height + 1e-12);
        EXPECT_EQ(surely_cut(cap), cut) << height;
      }
    EXPECT_EQ(bulging, 1) << height;
  }
}

TEST(FindCaps, ABallIsNone) {
  EXPECT_TRUE(find_caps(closed_tube(length, radius, true), 0.2 * radius).empty());
}

TEST(FindCaps, AnOpenTubeHasNoneAndItsSideHasTheOtherSideBehindIt) {
  TubeSpec spec;
  spec.length = length;
  spec.radius = radius;
  const TriangleSurface tube = tube_surface(spec);
  EXPECT_TRUE(find_caps(tube, 0.2 * radius).empty());
  const FlatCap side{{radius, 0, 0.51 * length}, Vec3::UnitX(), radius};
  EXPECT_NEAR(depth_behind(tube, side), 2, 0.01);
}

// A mask's border may lean.
TEST(FindCaps, ALeaningEndIsOne) {
  TriangleSurface tube = closed_tube(length, radius, false);
  const double slope = std::tan(M_PI / 6);
  for (Eigen::Index v = 0; v < tube.points.rows(); ++v)
    tube.points(v, 2) += slope * tube.points(v, 0) * tube.points(v, 2) / length;
  int leaning = 0;
  for (const FlatCap& cap : find_caps(tube, 0.2 * radius))
    if (cap.center.z() > 0.5 * length) {
      ++leaning;
      EXPECT_NEAR(std::acos(cap.normal.z()), M_PI / 6, 1e-6);
    }
  EXPECT_EQ(leaning, 1);
}

}  // namespace
}  // namespace vasorod::testing
