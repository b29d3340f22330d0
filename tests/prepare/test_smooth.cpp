#include <gtest/gtest.h>

#include "mask/mask_surface.h"
#include "prepare/repair.h"
#include "prepare/smooth.h"
#include "prepare/tube_shapes.h"
#include "surface_file/check_surface.h"

namespace vasorod::testing {
namespace {

// The voxels, of side 1, whose centres lie in a slanted cylinder.
Mask slanted_cylinder(double radius) {
  const Vec3 axis = Vec3(0.3, 0.2, 1).normalized(), start(20, 20, 4);
  Mask mask;
  mask.head.size = {50, 50, 50};
  for (int k = 0; k < 50; ++k)
    for (int j = 0; j < 50; ++j)
      for (int i = 0; i < 50; ++i) {
        const Vec3 p = Vec3(i, j, k) - start;
        const double along = p.dot(axis);
        const bool inside = along > 0 && along < 40 && (p - along * axis).norm() < radius;
        mask.label.push_back(inside ? 3 : 0);
        if (inside) ++mask.count[3];
      }
  return mask;
}

TEST(Smooth, StairsGoAndTheVolumeStays) {
  const double radius = 8;
  Mask mask = slanted_cylinder(radius);
  const auto voxels = static_cast<double>(mask.count[3]);
  TriangleSurface surface = mask_surface("m", std::move(mask), {}).surface;
  keep_largest(surface);
  EXPECT_TRUE(has_stairs(surface));
  smooth(surface);
  EXPECT_FALSE(has_stairs(surface));
  EXPECT_NEAR(lidded_volume(surface), voxels, 0.01 * voxels);
  const Vec3 axis = Vec3(0.3, 0.2, 1).normalized(), start(20, 20, 4);
  double square = 0;
  int count = 0;
  for (Eigen::Index i = 0; i < surface.points.rows(); ++i) {
    const Vec3 p = surface.points.row(i).transpose() - start;
    const double along = p.dot(axis);
    if (along < 10 || along > 30) continue;
    square += std::pow((p - along * axis).norm() - radius, 2);
    ++count;
  }
  EXPECT_LT(std::sqrt(square / count), 0.25);  // of a voxel's side
}

TEST(Smooth, ARoundTubeHasNoStairs) {
  EXPECT_FALSE(has_stairs(closed_tube(60, 5, true)));
}

}  // namespace
}  // namespace vasorod::testing
