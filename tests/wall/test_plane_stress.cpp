#include <Eigen/LU>
#include <gtest/gtest.h>

#include "wall/plane_stress.h"

namespace vasorod {
namespace {

TEST(PlaneStress, IsotropicPlaneStress) {
  const double e = 2, nu = 0.3;
  Mat3 expected;
  expected << 1, nu, 0, nu, 1, 0, 0, 0, (1 - nu) / 2;
  expected *= e / (1 - nu * nu);
  EXPECT_LT((plane_stress(Material::isotropic(e, nu)) - expected).norm(), 1e-15);
}

TEST(PlaneStress, TransverselyIsotropicIsInverseOfCompliance) {
  const Material m{Law::biot, 10, 2, 0.5, 0.4, 0.6};
  Mat3 compliance;
  compliance << 1 / m.young_axial, -m.poisson_lt / m.young_axial, 0,  //
      -m.poisson_lt / m.young_axial, 1 / m.young_transverse, 0,       //
      0, 0, 1 / m.shear_axial;
  EXPECT_LT((plane_stress(m) * compliance - Mat3::Identity()).norm(), 1e-15);
}

}  // namespace
}  // namespace vasorod
