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

// An int does not hold the steps that these would take.
TEST(PathRule, HoweverFarThereAreFortySteps) {
  EXPECT_EQ(path_times(1e12).size(), 42u);
  EXPECT_EQ(pressing_times(1e12, 1).size(), 40u);
}

TEST(PathRule, APressureThatCollapsesNothingIsOneStep) {
  for (const double after : {5.0, 0.0, -0.5, -0.89})
    for (const double scan : {-0.1, 0.0, 3.0})
      EXPECT_EQ(pressure_times(scan, after, 1), std::vector<double>{1}) << after;
  EXPECT_GT(pressure_times(0, -0.9, 1).size(), 1u);
  // Collapsed already when it was seen, and no further after.
  for (const double scan : {-3.0, -4.0})
    EXPECT_EQ(pressure_times(scan, -3, 1), std::vector<double>{1}) << scan;
}

TEST(PathRule, APressurePastCollapseRisesInPortions) {
  for (const double scan : {-0.2, 0.0, 4.0})
    for (double outside = 0.9; outside < 200; outside *= 1.07) {
      const double collapse = 2.5, after = -outside * collapse;
      const std::vector<double> times = pressure_times(scan * collapse, after, collapse);
      const auto outside_at = [&](double t) {
        return -(scan * collapse + t * (after - scan * collapse)) / collapse;
      };
      EXPECT_EQ(times.back(), 1);
      EXPECT_NEAR(outside_at(times.front()), 0.8, 1e-12) << "before the collapse";
      EXPECT_LE(times.size(), 41u);
      for (size_t i = 1; i < times.size(); ++i) {
        ASSERT_LT(times[i - 1], times[i]) << outside;
        const double from = outside_at(times[i - 1]), to = outside_at(times[i]);
        if (outside < 40) {  // as long as forty steps do
          EXPECT_LE(to - from, std::max(1.0 / 6, 0.1 * from) + 1e-9) << outside << " " << i;
        }
      }
    }
}

TEST(PathRule, WhatIsPressedDeepGoesThereInPortionsOfItsRadius) {
  for (const double depth : {0.0, 0.3, 0.5})
    EXPECT_EQ(pressing_times(3, depth), std::vector<double>{1}) << depth;
  for (const double way : {0.6, 1.0, 4.6, 5.9, 40.0}) {
    const std::vector<double> times = pressing_times(way, 0.51);
    EXPECT_EQ(times.back(), 1);
    EXPECT_LE(times.size(), 40u);
    for (size_t k = 0; k < times.size(); ++k) {
      const double step = times[k] - (k > 0 ? times[k - 1] : 0);
      EXPECT_NEAR(step, times[0], 1e-12);
      if (way < 6) {  // as long as forty steps do
        EXPECT_LE(step * way, 0.15 + 1e-12);
      }
    }
  }
}

// A tube whose rod is bent to a constant curvature, or twisted at a constant rate.
Prediction strained_tube(const Vec3& u, bool rigid_ends) {
  static const Scene scene;
  Prediction prediction;
  prediction.scene = &scene;
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
  prediction.operation.emplace();
  EXPECT_EQ(path_times(prediction), std::vector<double>{1});
  prediction.operation.reset();
  prediction.vessels[0].rod_solved = false;
  EXPECT_EQ(share_of_limit(prediction), 0);
  EXPECT_EQ(path_times(prediction), std::vector<double>{1});
}

// Two parallel tubes of radius 10, their axes 25 apart; one is carried towards the other by `way`.
Prediction pressed_tubes(double way) {
  Prediction prediction = strained_tube(Vec3::Zero(), true);
  for (Pose& pose : prediction.vessels[0].rod.poses) pose.position.x() += way;
  PredictedVessel& obstacle = prediction.vessels.emplace_back();
  obstacle.prepared = shapes::judged_tube(140);
  obstacle.prepared.vessel.surface.points.rowwise() += Eigen::RowVector3d(25, 0, -20);
  obstacle.prepared.spec.name = "obstacle";
  obstacle.prepared.spec.role = Role::obstacle;
  return prediction;
}

TEST(PathRule, WhatIsCarriedDeepIntoAnotherVesselIsFollowed) {
  // The nearest point ends way - 5 deep, until it passes the other axis.
  for (const double way : {4.0, 6.0, 9.0, 13.0}) {
    const Prediction prediction = pressed_tubes(way);
    EXPECT_NEAR(carried_depth(prediction, 0), std::max(0.0, way - 5) / 10, 0.01) << way;
    EXPECT_EQ(carried_depth(prediction, 1), 0) << "an obstacle stays";
    EXPECT_EQ(path_times(prediction).size() > 1, way > 10) << way;
  }
}

// `contact` of the scene says who touches whom; what does not touch presses nothing.
TEST(PathRule, OnlyWhatMayTouchIsPressed) {
  Prediction prediction = pressed_tubes(13);
  const double depth = carried_depth(prediction, 0);
  Scene scene;
  prediction.scene = &scene;
  for (const std::array<std::string, 2>& pair :
       {std::array<std::string, 2>{"tube", "obstacle"}, {"obstacle", "tube"}}) {
    scene.contact = {{pair}};
    EXPECT_EQ(carried_depth(prediction, 0), depth);
  }
  scene.contact.emplace();
  EXPECT_EQ(carried_depth(prediction, 0), 0);
  EXPECT_EQ(path_times(prediction), std::vector<double>{1});
}

TEST(PathRule, WhatLayInsideAtRestDoesNotCount) {
  Prediction prediction = pressed_tubes(2);
  prediction.vessels[1].prepared.vessel.surface.points.col(0).array() -= 15;
  EXPECT_LT(carried_depth(prediction, 0), 0.25) << "it moved by 0.2";
}

}  // namespace
}  // namespace vasorod
