#include <array>
#include <cmath>
#include <gtest/gtest.h>

#include "wall/neo_hookean.h"
#include "wall/principal_stretches.h"

namespace vasorod {
namespace {

// Energy over mu of the stretches l1 and l2 by the law's two parts.
double energy(double l1, double l2, double nu) {
  return (l1 - l2) * (l1 - l2) / 2 + neo_hookean_area(l1 * l2 - 1, nu).value;
}

TEST(NeoHookean, IsTheSolidsLawWithoutStressAcross) {
  for (const double nu : {0.0, 0.3, 0.45, 0.4999})
    for (const double l1 : {0.4, 0.7, 0.999, 1.3, 2.0})
      for (const double l2 : {0.5, 1.0, 1.6}) {
        const double expected = neo_hookean_of_stretches(l1, l2, nu);
        EXPECT_NEAR(energy(l1, l2, nu), expected, 1e-11 * (1 + expected))
            << l1 << " " << l2 << " " << nu;
      }
}

TEST(NeoHookean, IncompressibleIsTheClassicalLaw) {
  for (const double l1 : {0.4, 1.0, 1.7})
    for (const double l2 : {0.6, 1.2}) {
      const double l3 = 1 / (l1 * l2);
      EXPECT_NEAR(energy(l1, l2, 0.5), (l1 * l1 + l2 * l2 + l3 * l3 - 3) / 2, 1e-12 * l3 * l3);
    }
}

// First Piola stress of a bar, E = 1, nu = 0.3: mu (l - 1/l) + lambda ln J / l with the lateral
// stretch where the lateral stress is zero.
TEST(NeoHookean, UniaxialTension) {
  struct Row {
    double stretch, lateral, stress;
  };
  for (const Row& row :
       {Row{0.5, 1.2107673905, -0.9353520569}, Row{0.7, 1.1079347328, -0.4052304243},
        Row{0.9, 1.0317024344, -0.1087221851}, Row{1.01, 0.9970157966, 0.0099236486},
        Row{1.2, 0.9456326243, 0.1749291474}, Row{2.0, 0.7980775445, 0.6467446602}}) {
    const double mu = 1 / 2.6, nu = 0.3;
    const AreaEnergy u = neo_hookean_area(row.stretch * row.lateral - 1, nu);
    EXPECT_NEAR(mu * (row.lateral - row.stretch + u.first * row.stretch), 0, 1e-9) << row.stretch;
    EXPECT_NEAR(mu * (row.stretch - row.lateral + u.first * row.lateral), row.stress, 1e-9);
  }
}

TEST(NeoHookean, DerivativesAgainstDifferences) {
  const double h = 1e-6;
  for (const double nu : {0.0, 0.3, 0.45, 0.5})
    for (const double j : {-0.5, 0.05, 0.0999, 0.11, 0.3, 0.8, 1.0, 1.2, 3.0}) {
      const AreaEnergy at = neo_hookean_area(j - 1, nu), up = neo_hookean_area(j - 1 + h, nu),
                       down = neo_hookean_area(j - 1 - h, nu);
      EXPECT_NEAR((up.value - down.value) / (2 * h), at.first, 1e-8 * (1 + at.second)) << j;
      EXPECT_NEAR((up.first - down.first) / (2 * h), at.second, 1e-6 * (1 + at.second)) << j;
    }
}

// u is (1 + nu) / (1 - nu) (j - 1)^2 / 2 near rest, to all digits that j has.
TEST(NeoHookean, SmallStrainsLoseNoDigits) {
  for (const double nu : {0.0, 0.3, 0.5})
    for (const double excess : {1e-4, -1e-6, 1e-8}) {
      const AreaEnergy at = neo_hookean_area(excess, nu);
      const double stiffness = (1 + nu) / (1 - nu);
      EXPECT_NEAR(at.first / (stiffness * excess), 1, 5 * std::abs(excess) + 1e-14);
      EXPECT_NEAR(at.value, stiffness * excess * excess / 2,
                  3 * std::abs(excess * excess * excess) + 1e-15 * std::abs(excess));
      EXPECT_NEAR(at.second, stiffness, 20 * std::abs(excess));
    }
}

TEST(NeoHookean, ACollapseIsFiniteAndOpens) {
  for (const double j : {0.0, -1.0, -30.0}) {
    const AreaEnergy at = neo_hookean_area(j - 1, 0.45);
    EXPECT_TRUE(std::isfinite(at.value));
    EXPECT_LT(at.first, 0);
    EXPECT_GT(at.second, 0);
  }
}

}  // namespace
}  // namespace vasorod
