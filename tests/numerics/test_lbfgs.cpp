#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <vector>

#include "numerics/lbfgs.h"

namespace vasorod {
namespace {

using Eigen::VectorXd;

const Preconditioner identity = [](const VectorXd& g, VectorXd& d) { d = g; };

// Rosenbrock's valley in n dimensions, minimum 0 at (1, ..., 1).
double rosenbrock(const VectorXd& x, VectorXd& g, double& residual) {
  double sum = 0;
  g.setZero();
  for (Eigen::Index i = 0; i + 1 < x.size(); ++i) {
    const double a = x[i + 1] - x[i] * x[i], b = 1 - x[i];
    sum += 100 * a * a + b * b;
    g[i] += -400 * a * x[i] - 2 * b;
    g[i + 1] += 200 * a;
  }
  residual = g.norm();
  return sum;
}

TEST(Lbfgs, FindsTheMinimumOfRosenbrocksValleyAndNeverRises) {
  VectorXd x = VectorXd::Constant(10, -1.2);
  std::vector<double> energies;
  LbfgsOptions options;
  options.stop = [&](int, double energy, double) {
    energies.push_back(energy);
    return false;
  };
  const LbfgsSummary summary = lbfgs(rosenbrock, identity, x, options);
  EXPECT_EQ(summary.status, LbfgsStatus::converged);
  EXPECT_LT((x - VectorXd::Ones(10)).norm(), 1e-7);
  for (size_t i = 1; i < energies.size(); ++i) EXPECT_LE(energies[i], energies[i - 1]);
}

TEST(Lbfgs, AnExactPreconditionerSolvesAQuadraticInOneStep) {
  VectorXd diagonal = VectorXd::LinSpaced(20, 1, 1e6), x = VectorXd::Ones(20);
  const auto quadratic = [&](const VectorXd& at, VectorXd& g, double& residual) {
    g = diagonal.cwiseProduct(at);
    residual = g.norm();
    return 0.5 * at.dot(g);
  };
  const LbfgsSummary summary = lbfgs(
      quadratic, [&](const VectorXd& g, VectorXd& d) { d = g.cwiseQuotient(diagonal); }, x);
  EXPECT_EQ(summary.status, LbfgsStatus::converged);
  EXPECT_EQ(summary.iterations, 1);
}

TEST(Lbfgs, BacksOutOfWhereTheEnergyIsNotANumber) {
  VectorXd x = VectorXd::Constant(1, 1e-3);  // x - log x: undefined for x <= 0, minimum at 1
  const auto barrier = [](const VectorXd& at, VectorXd& g, double& residual) {
    g[0] = 1 - 1 / at[0];
    residual = std::abs(g[0]);
    return at[0] > 0 ? at[0] - std::log(at[0]) : std::numeric_limits<double>::quiet_NaN();
  };
  const LbfgsSummary summary = lbfgs(
      barrier,
      [](const VectorXd& g, VectorXd& d) {
        d = -50.0 * g.cwiseAbs(), d = d.cwiseProduct(-g.cwiseSign());
      },
      x);
  EXPECT_EQ(summary.status, LbfgsStatus::converged);
  EXPECT_NEAR(x[0], 1, 1e-7);
}

// x + 1 / x has its minimum at 1; a step beyond 0 would leave its domain.
TEST(Lbfgs, AStepIsNoLongerThanItMayBe) {
  VectorXd x = VectorXd::Constant(1, 4);
  double smallest = x[0];
  const auto energy = [&](const VectorXd& at, VectorXd& g, double& residual) {
    smallest = std::min(smallest, at[0]);
    g[0] = 1 - 1 / (at[0] * at[0]);
    residual = std::abs(g[0]);
    return at[0] + 1 / at[0];
  };
  LbfgsOptions options;
  options.longest_share = [](const VectorXd& at, const VectorXd& direction) {
    return std::min(1.0, 0.9 * at[0] / std::abs(direction[0]));
  };
  const auto far = [](const VectorXd& g, VectorXd& d) { d = 50 * g; };
  const LbfgsSummary summary = lbfgs(energy, far, x, options);
  EXPECT_EQ(summary.status, LbfgsStatus::converged);
  EXPECT_NEAR(x[0], 1, 1e-7);
  EXPECT_GT(smallest, 0);
}

// A run that is cut in two takes the steps of one: the second begins with the pairs of the first.
TEST(Lbfgs, GoesOnWithThePairsOfAnEarlierRun) {
  const int cut = 7, more = 9;
  VectorXd whole = VectorXd::Constant(10, -1.2), parts = whole, forgetful = whole;
  LbfgsOptions options;
  options.max_iterations = cut + more;
  lbfgs(rosenbrock, identity, whole, options);
  LbfgsPairs pairs;
  for (const int iterations : {cut, more}) {
    options.max_iterations = iterations;
    options.pairs = nullptr;
    lbfgs(rosenbrock, identity, forgetful, options);
    options.pairs = &pairs;
    lbfgs(rosenbrock, identity, parts, options);
  }
  EXPECT_LT((parts - whole).norm(), 1e-9 * whole.norm());
  EXPECT_GT((forgetful - whole).norm(), 1e-2 * whole.norm());
}

// A quadratic with a dent of the size of rounding, in which no step is seen to lower the energy,
// and a preconditioner that overshoots twenty times.
TEST(Lbfgs, BySlopesItGoesOnWhereEnergiesHaveNoDigitsLeft) {
  const VectorXd diagonal = VectorXd::LinSpaced(20, 1, 3), start = VectorXd::Constant(20, 1e-6);
  const auto dented = [&](const VectorXd& at, VectorXd& g, double& residual) {
    g = diagonal.cwiseProduct(at);
    residual = g.norm();
    return 1 + 0.5 * at.dot(g) - ((at - start).norm() < 1e-15 ? 1e-9 : 0);
  };
  const Preconditioner overshoots = [](const VectorXd& g, VectorXd& d) { d = 20 * g; };
  LbfgsOptions options;
  options.tolerance = 1e-9;
  VectorXd x = start;
  EXPECT_EQ(lbfgs(dented, overshoots, x, options).status, LbfgsStatus::stalled);
  options.by_slopes = true;
  EXPECT_EQ(lbfgs(dented, overshoots, x, options).status, LbfgsStatus::converged);
  EXPECT_LT(x.norm(), 1e-9);
}

// A valley of curvatures 1 to 100. Its energy has lost its last digits, as a sum of many terms
// has: below a residual of 1e-5 it is noise.
TEST(Lbfgs, FindsTheMinimumOfAnEnergyThatIsNoiseThere) {
  const VectorXd curvature =
      VectorXd::LinSpaced(30, 0, 2).unaryExpr([](double power) { return std::pow(10, power); });
  const auto run = [&](double rounding, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> noise(-rounding, rounding);
    const Evaluation valley = [&](const VectorXd& at, VectorXd& g, double& residual) {
      g = curvature.cwiseProduct(at);
      residual = g.norm();
      return 1 + 0.5 * at.dot(g) + noise(random);
    };
    VectorXd x = VectorXd::Ones(30);
    LbfgsOptions options;
    options.tolerance = 1e-9;
    return lbfgs(valley, identity, x, options);
  };
  const LbfgsSummary exact = run(0, 1);
  EXPECT_EQ(exact.status, LbfgsStatus::converged) << exact.brief_report();
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const LbfgsSummary noisy = run(1e-13, seed);
    EXPECT_EQ(noisy.status, LbfgsStatus::converged) << noisy.brief_report();
    EXPECT_LT(noisy.evaluations, 2 * exact.evaluations) << noisy.brief_report();
  }
}

// A gradient with rounding of its own has a floor, which the run finds and says so: it does not go
// on in the noise, and ends in the best of the points there.
TEST(Lbfgs, StallsAtTheGradientsOwnRounding) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> noise(-1e-11, 1e-11);
  double least = 1;
  const Evaluation valley = [&](const VectorXd& at, VectorXd& g, double& residual) {
    g = at;
    for (double& one : g) one += noise(random);
    residual = g.norm();
    least = std::min(least, residual);
    return 1 + 0.5 * at.squaredNorm();
  };
  VectorXd x = VectorXd::Ones(30);
  LbfgsOptions options;
  options.tolerance = 1e-14;
  const LbfgsSummary summary = lbfgs(valley, identity, x, options);
  EXPECT_EQ(summary.status, LbfgsStatus::stalled) << summary.brief_report();
  EXPECT_LT(summary.iterations, 60);
  EXPECT_LT(summary.residual, 1.2 * least);

  // From there also a run that ends before, whichever end that is.
  options.max_iterations = 4;
  EXPECT_EQ(lbfgs(valley, identity, x, options).status, LbfgsStatus::stalled);
  options.max_iterations = 3000;
  options.patience = 4;
  EXPECT_EQ(lbfgs(valley, identity, x, options).status, LbfgsStatus::stalled);
}

// On a slope that is as steep everywhere the residual never falls, but each step gains as much as
// the one before; and where steps become shorter, the rest gains less than a new preconditioner.
TEST(Lbfgs, GoesOnWhereEachIterationStillGains) {
  const auto slope = [](const VectorXd& at, VectorXd& g, double& residual) {
    const double height = std::sqrt(1 + at.squaredNorm());
    g = at / height;
    residual = g.norm();
    return height;
  };
  LbfgsOptions options;
  options.largest_step = 1;
  options.patience = 5;
  VectorXd x = VectorXd::Constant(1, 40);
  LbfgsSummary summary = lbfgs(slope, identity, x, options);
  EXPECT_EQ(summary.status, LbfgsStatus::slow);
  EXPECT_EQ(summary.iterations, options.patience);
  options.worth = 10;
  x[0] = 40;
  summary = lbfgs(slope, identity, x, options);
  EXPECT_EQ(summary.status, LbfgsStatus::converged);
  EXPECT_GT(summary.iterations, 40);

  // The energy falls by half of what is left of it, the residual stays.
  int shorter = 0;
  const auto halved = [&](const VectorXd& at, VectorXd& g, double& residual) {
    g = VectorXd::Ones(1);
    residual = 1;
    return at[0] > 0 ? std::log2(at[0]) : std::numeric_limits<double>::quiet_NaN();
  };
  const Preconditioner half_way = [&](const VectorXd&, VectorXd& d) {
    d = VectorXd::Constant(1, std::ldexp(1.0, -++shorter));
  };
  x[0] = 2;
  summary = lbfgs(halved, half_way, x, options);
  EXPECT_EQ(summary.status, LbfgsStatus::slow);
  EXPECT_LT(summary.iterations, 3 * options.patience);
}

// Steps on level ground gain nothing, however little the ones before gained.
TEST(Lbfgs, StopsWhereNothingIsGained) {
  double residual_left = 1;
  const auto level = [&](const VectorXd&, VectorXd& g, double& residual) {
    g = VectorXd::Ones(1);
    residual = residual_left *= 0.99;
    return 7.0;
  };
  LbfgsOptions options;
  options.patience = 5;
  options.worth = 10;
  VectorXd x = VectorXd::Zero(1);
  const LbfgsSummary summary = lbfgs(level, identity, x, options);
  EXPECT_EQ(summary.status, LbfgsStatus::slow);
  EXPECT_EQ(summary.iterations, options.patience);
}

TEST(Lbfgs, NamesEveryOtherEnd) {
  LbfgsOptions options;
  options.max_iterations = 3;
  VectorXd x = VectorXd::Constant(10, -1.2);
  EXPECT_EQ(lbfgs(rosenbrock, identity, x, options).status, LbfgsStatus::iteration_limit);
  options.max_iterations = 1000;
  options.patience = 5;
  EXPECT_EQ(lbfgs(rosenbrock, identity, x, options).status, LbfgsStatus::slow);
  options.stop = [](int, double, double) { return true; };
  EXPECT_EQ(lbfgs(rosenbrock, identity, x, options).status, LbfgsStatus::interrupted);
  const auto lying = [](const VectorXd& at, VectorXd& g,
                        double& residual) {  // returns a gradient of the wrong sign
    g = -2 * at;
    residual = 1;
    return at.squaredNorm();
  };
  x.setOnes();
  EXPECT_EQ(lbfgs(lying, identity, x).status, LbfgsStatus::stalled);
  EXPECT_TRUE(x.isOnes());
}

}  // namespace
}  // namespace vasorod
