#include <gtest/gtest.h>

#include "paper/binding_energy.h"
#include "paper/paper_tubes.h"

namespace vasorod {
namespace {

using namespace testing;

TEST(BindingEnergy, IsTheSumAsPrinted) {
  Points p(2, 3), carried(2, 3);
  p << 1, 2, 3, 0, 0, 0;
  carried << 1, 0, 3, 3, 4, 0;
  EXPECT_DOUBLE_EQ(binding_energy(0.5, p, carried), 0.5 * (4 + 25));
}

TEST(BindingEnergy, GradientAndHessianMatchDifferences) {
  const Points p = random_points(6, 1), carried = random_points(6, 2);
  const auto gradient = [&](const Points& at) {
    Points g = Points::Zero(6, 3);
    binding_energy_gradient(0.7, at, carried, g);
    return g;
  };
  EXPECT_LT(gradient_error([&](const Points& at) { return binding_energy(0.7, at, carried); }, p,
                           gradient(p)),
            1e-8);
  EXPECT_LT(hessian_error(gradient, p, for_xyz(binding_energy_hessian(0.7, 6))), 1e-8);
  Points g = Points::Zero(6, 3);
  EXPECT_NEAR(binding_energy_gradient(0.7, p, carried, g) / binding_energy(0.7, p, carried), 1,
              1e-14);
}

}  // namespace
}  // namespace vasorod
