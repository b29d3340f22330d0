#include <gtest/gtest.h>

#include "bodies/joining_energy.h"
#include "paper/paper_tubes.h"

namespace vasorod {
namespace {

using namespace testing;

TEST(JoiningEnergy, GradientAndHessianMatchDifferences) {
  std::vector<Join> joins{
      {0, 3, Vec3(1, -2, 0.5)}, {1, 4, Vec3::Zero()}, {2, 5, Vec3(0, 1, 1), Vec3(0.3, -0.2, 0.7)}};
  const Points p = random_points(6, 1);
  const auto gradient = [&](const Points& at) {
    Points g = Points::Zero(6, 3);
    joining_energy_gradient(0.7, joins, at, g);
    return g;
  };
  EXPECT_LT(gradient_error([&](const Points& at) { return joining_energy(0.7, joins, at); }, p,
                           gradient(p)),
            1e-8);
  EXPECT_LT(hessian_error(gradient, p, for_xyz(joining_energy_hessian(0.7, joins, 6))), 1e-8);
}

// Springs connect two points to anchors of their own and pull them apart. Every update reduces the
// gap by the ratio of anchor stiffness to anchor + joining stiffness, for any joining stiffness.
TEST(JoiningEnergy, MultipliersCloseTheGapAtAFiniteStiffness) {
  const double k_j = 2;
  std::vector<Join> joins{{0, 1, Vec3::Zero()}};
  Points p = Points::Zero(2, 3);
  double gap = 2;
  for (int update = 0; update < 6; ++update) {
    // minimum of (x0 - 1)^2 + (x1 + 1)^2 + k_j d^2 + m d, d = x0 - x1: by symmetry x0 = -x1 = d / 2
    const double m = joins[0].multiplier.x();
    const double d = (2 - m) / (1 + 2 * k_j);
    EXPECT_NEAR(d, gap / (1 + 2 * k_j), 1e-12);
    gap = d;
    p(0, 0) = d / 2;
    p(1, 0) = -d / 2;
    update_join_multipliers(k_j, joins, p);
  }
  EXPECT_NEAR(joins[0].multiplier.x(), 2, 1e-3);
}

// At its offset a pair costs nothing, and no update changes its multiplier.
TEST(JoiningEnergy, AnOffsetIsWhereThePairIsToBe) {
  const Vec3 offset(0.3, -0.2, 0.7);
  std::vector<Join> joins{{0, 1, Vec3::Zero(), offset}};
  Points p(2, 3);
  p.row(1) = Vec3(1, 2, 3).transpose();
  p.row(0) = p.row(1) + offset.transpose();
  EXPECT_NEAR(joining_energy(2, joins, p), 0, 1e-15);
  update_join_multipliers(2, joins, p);
  EXPECT_LT(joins[0].multiplier.norm(), 1e-14);
  p.row(0).array() += 1;
  EXPECT_NEAR(joining_energy(2, joins, p), 6, 1e-12);
}

}  // namespace
}  // namespace vasorod
