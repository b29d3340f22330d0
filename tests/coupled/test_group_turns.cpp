#include <gtest/gtest.h>
#include <random>

#include "coupled/group_turns.h"
#include "geometry/rigid_motion.h"
#include "numerics/block_pattern.h"

namespace vasorod {
namespace {

// Groups of 3, 1, 6, 3 unknowns; the second and the last are not turned.
struct Fixture {
  std::vector<int> sizes{3, 1, 6, 3};
  GroupTurns turns{{0, 3, 4, 10}, 13};
  Eigen::SparseMatrix<double> lower;
  Eigen::MatrixXd d = Eigen::MatrixXd::Identity(13, 13);
  Fixture() {
    const Mat3 a = exp_rotation(Vec3(0.3, 1.1, -0.4)), b = exp_rotation(Vec3(-0.8, 0.2, 0.9));
    Turn six = Turn::Zero(6, 6);
    six.topLeftCorner<3, 3>() = a;
    six.bottomRightCorner<3, 3>() = b;
    turns.set(0, b);
    turns.set(2, six);
    d.block<3, 3>(0, 0) = b;
    d.block<6, 6>(4, 4) = six;

    BlockPattern pattern(sizes);
    pattern.couple(0, 2);
    pattern.couple(0, 3);
    pattern.couple(1, 2);
    pattern.couple(2, 3);
    lower = pattern.build();
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (int k = 0; k < lower.nonZeros(); ++k) lower.valuePtr()[k] = uniform(random);
  }
  static Eigen::MatrixXd full(const Eigen::SparseMatrix<double>& lower) {
    const Eigen::MatrixXd dense(lower);
    return dense.selfadjointView<Eigen::Lower>();
  }
};

TEST(GroupTurns, AppliesItsBlocksAndTheirTransposes) {
  const Fixture f;
  const Eigen::VectorXd z = Eigen::VectorXd::LinSpaced(13, -1, 2);
  Eigen::VectorXd turned = z;
  apply(f.turns, false, turned);
  EXPECT_LT((turned - f.d * z).norm(), 1e-14);
  apply(f.turns, true, turned);
  EXPECT_LT((turned - z).norm(), 1e-14);
}

TEST(GroupTurns, TurnsAStoredLowerTriangleOnBothSides) {
  Fixture f;
  const Eigen::MatrixXd expected = f.d * Fixture::full(f.lower) * f.d.transpose();
  turn_matrix(f.turns, f.lower);
  EXPECT_LT((Fixture::full(f.lower) - expected).norm(), 1e-13);
}

}  // namespace
}  // namespace vasorod
