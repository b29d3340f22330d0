#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "wall/membrane_strain.h"

namespace vasorod {
namespace {

const Vec3 metric(1.44, 0.7, -0.35);

TEST(MembraneStrain, BiotIsTheSquareRootLessOne) {
  Eigen::Matrix2d c;
  c << metric[0], metric[2], metric[2], metric[1];
  const Eigen::Matrix2d u = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(c).operatorSqrt();
  const Vec3 e = membrane_strain(Law::biot, metric).strain;
  EXPECT_NEAR(e[0], u(0, 0) - 1, 1e-15);
  EXPECT_NEAR(e[1], u(1, 1) - 1, 1e-15);
  EXPECT_NEAR(e[2], 2 * u(0, 1), 1e-15);
}

TEST(MembraneStrain, DerivativesAgainstDifferences) {
  const double h = 1e-5;
  const Vec3 stress(0.3, -1.1, 0.8);
  for (const Law law : {Law::biot, Law::svk}) {
    const MembraneStrain at = membrane_strain(law, metric);
    const Mat3 second = membrane_strain_hessian(law, metric, stress);
    for (int i = 0; i < 3; ++i) {
      const Vec3 step = h * Vec3::Unit(i);
      const MembraneStrain up = membrane_strain(law, metric + step),
                           down = membrane_strain(law, metric - step);
      EXPECT_LT(((up.strain - down.strain) / (2 * h) - at.derivative.col(i)).norm(), 1e-9);
      const Vec3 slope = (up.derivative - down.derivative).transpose() * stress / (2 * h);
      EXPECT_LT((slope - second.col(i)).norm(), 1e-9);
    }
  }
}

}  // namespace
}  // namespace vasorod
