#include <cmath>
#include <gtest/gtest.h>

#include "wall/axial_stretch.h"
#include "wall/plane_stress.h"

namespace vasorod {
namespace {

TEST(AxialStretch, NeedsNoStressAcrossTheFibre) {
  const Material m{Law::biot, 10, 2, 0.5, 0.4, 0.6};
  const Vec3 strain = strain_of_stretch(m, 1.1), stress = plane_stress(m) * strain;
  EXPECT_NEAR(strain[0], 0.1, 1e-15);
  EXPECT_LT((stress - Vec3(m.young_axial * 0.1, 0, 0)).norm(), 1e-14);
}

// Of an incompressible neo-Hookean wall the free contraction is k^-1/2; by Biot's law that of its
// strain; of a small one the same by all.
TEST(AxialStretch, IsTheLawsOwnWhereItIsLarge) {
  const auto across = [](Law law, double stretch, double poisson) {
    const Vec2 both = stretches_along_and_across(Material::isotropic(1, poisson, law), stretch);
    EXPECT_NEAR(both[0], stretch, 1e-15);
    return both[1];
  };
  EXPECT_NEAR(across(Law::neo_hookean, 1.7, 0.5), 1 / std::sqrt(1.7), 1e-14);
  EXPECT_NEAR(across(Law::biot, 1.7, 0.4), 1 - 0.4 * 0.7, 1e-14);
  for (const Law law : {Law::biot, Law::svk, Law::neo_hookean})
    EXPECT_NEAR(across(law, 1 + 1e-5, 0.4), 1 - 0.4e-5, 1e-10);
}

}  // namespace
}  // namespace vasorod
