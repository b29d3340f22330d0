#include <cmath>
#include <gtest/gtest.h>

#include "wall/degeneracy_barriers.h"

namespace vasorod {
namespace {

FoldBarrier at(double half_angle) {
  return {std::sin(half_angle), std::cos(half_angle)};
}

TEST(Stops, NothingIsStoppedWhereTheLawHolds) {
  EXPECT_EQ(at(0.78).value, 0);
  EXPECT_EQ(at(-0.78).first, 0);
  EXPECT_EQ(CollapseBarrier(Vec3(0.8, 0.4, 0.1)).value, 0);
}

TEST(Stops, AFoldAgainstDifferences) {
  const double h = 1e-6;
  for (const double half : {-1.5, -1.0, -0.79, 0.79, 1.0, 1.4, 1.55}) {
    const FoldBarrier stop = at(half);
    const double size = std::abs(stop.value) + 1;
    EXPECT_NEAR((at(half + h).value - at(half - h).value) / (2 * h), stop.first, 1e-5 * size * size)
        << half;
    EXPECT_NEAR((at(half + h).first - at(half - h).first) / (2 * h), stop.second,
                1e-3 * size * size * size)
        << half;
    EXPECT_NEAR(at(-half).value, -stop.value, 1e-12 * size);
  }
}

TEST(Stops, ACollapseAgainstDifferences) {
  const double h = 1e-7;
  for (const Vec3& c : {Vec3(0.4, 0.5, 0.1), Vec3(1.2, 0.1, 0.05), Vec3(0.5, 0.5, -0.45)}) {
    const CollapseBarrier stop(c);
    EXPECT_GT(stop.value, 0);
    for (int i = 0; i < 3; ++i) {
      const CollapseBarrier up(c + h * Vec3::Unit(i)), down(c - h * Vec3::Unit(i));
      EXPECT_NEAR((up.value - down.value) / (2 * h), stop.gradient[i],
                  1e-6 * (1 + stop.gradient.norm()));
      EXPECT_LT(((up.gradient - down.gradient) / (2 * h) - stop.hessian.col(i)).norm(),
                1e-6 * (1 + stop.hessian.norm()));
    }
  }
}

TEST(Stops, TheyGrowWithoutBoundAndStayFinite) {
  EXPECT_GT(at(1.57).value, 1e2 * at(1.4).value);
  EXPECT_TRUE(std::isfinite(FoldBarrier(1, 0).second));
  EXPECT_GT(CollapseBarrier(Vec3(1, 1e-8, 0)).value, 1e2 * CollapseBarrier(Vec3(1, 1e-3, 0)).value);
  EXPECT_TRUE(CollapseBarrier(Vec3(1, 0, 0)).hessian.allFinite());
}

}  // namespace
}  // namespace vasorod
