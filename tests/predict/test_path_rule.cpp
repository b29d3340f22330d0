#include <cmath>
#include <gtest/gtest.h>

#include "judge/judged_tube.h"
#include "predict/path_rule.h"

namespace vasorod {
namespace {

TEST(PathRule, BelowSevenTenthsOfTheLimitNothingIsFollowed) {
  for (const double share : {0.0, 0.1, 0.5, 0.699999})
    EXPECT_EQ(path_times(share), std::vector<double>{1}) << share;
  EXPECT_GT(path_times(0.7).size(), 1u);
}

TEST(PathRule, TimesRiseToOneInBoundedSteps) {
  for (double share = 0.7; share < 60; share *= 1.03) {
    const std::vector<double> times = path_times(share);
    ASSERT_GE(times.size(), 3u);
    EXPECT_LE(times.size(), 42u) << share;
    EXPECT_EQ(times.back(), 1);
    EXPECT_GT(times.front(), 0);
    for (size_t i = 1; i < times.size(); ++i) EXPECT_LT(times[i - 1], times[i]) << share;
    EXPECT_NEAR(times[0] * share, 0.25, 1e-12);
    EXPECT_NEAR(times[1] * share, 0.5, 1e-12);
    // From half the limit on equal steps of at most 0.05 of it, as long as forty of them do.
    const double step = (times[2] - times[1]) * share;
    for (size_t i = 3; i < times.size(); ++i)
      EXPECT_NEAR((times[i] - times[i - 1]) * share, step, 1e-9 * share);
    if (share <= 2.5) {
      EXPECT_LE(step, 0.05 + 1e-12) << share;
    } else {
      EXPECT_EQ(times.size(), 42u) << share;
    }
  }
}

// A tube whose rod is bent to a constant curvature, or twisted at a constant rate.
Prediction strained_tube(const Vec3& u, bool rigid_ends) {
  Prediction prediction;
  PredictedVessel& vessel = prediction.vessels.emplace_back();
  vessel.prepared = shapes::judged_tube();
  const RodTree& rod = vessel.prepared.vessel.rod;
  vessel.rod.poses = shapes::strained(rod, shapes::change_of(0, u));
  vessel.rod_solved = true;
  for (int end = 0; end < 2; ++end) {
    RodSupport support;
    support.node = vessel.prepared.vessel.ends[static_cast<size_t>(end)].node;
    vessel.conditions.rod.supports.push_back(support);
    vessel.conditions.ends.push_back({end == 0 ? "start" : "end", end, rigid_ends});
  }
  return prediction;
}

// R = 10, t = 1, nu = 0.3.
const double braziers_curvature = 0.471 / (100 * std::sqrt(1 - 0.09));

TEST(PathRule, TheShareIsTheCurvatureOverBraziers) {
  for (const double share : {0.3, 0.8, 1.2}) {
    const Vec3 u(0, share * braziers_curvature, 0);
    EXPECT_NEAR(share_of_limit(strained_tube(u, true)), share, 1e-3 * share);
  }
}

TEST(PathRule, SectionsFreeToFlattenCountDouble) {
  const Vec3 u(0.4 * braziers_curvature, 0, 0);
  EXPECT_NEAR(share_of_limit(strained_tube(u, false)), 0.8, 1e-3);
  EXPECT_EQ(path_times(strained_tube(u, true)).size(), 1u);
  EXPECT_GT(path_times(strained_tube(u, false)).size(), 1u);
}

TEST(PathRule, ATwistCountsAgainstWrinkling) {
  // tau_cr / G R = 0.747 * 2.6 (t/R)^1.25 (R/L)^0.5 / R, L = 100.
  const double limit = 0.747 * 2.6 * std::pow(0.1, 1.25) * std::pow(0.1, 0.5) / 10;
  EXPECT_NEAR(share_of_limit(strained_tube({0, 0, 0.75 * limit}, true)), 0.75, 0.01);
}

TEST(PathRule, WhatDoesNotMoveHasNoPathAndAnOperationJumps) {
  Prediction prediction = strained_tube({0, 0.9 * braziers_curvature, 0}, true);
  EXPECT_GT(path_times(prediction).size(), 1u);
  prediction.glenn.emplace();
  EXPECT_EQ(path_times(prediction), std::vector<double>{1});
  prediction.glenn.reset();
  prediction.vessels[0].rod_solved = false;
  EXPECT_EQ(share_of_limit(prediction), 0);
  EXPECT_EQ(path_times(prediction), std::vector<double>{1});
}

}  // namespace
}  // namespace vasorod
