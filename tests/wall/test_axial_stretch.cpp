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

}  // namespace
}  // namespace vasorod
