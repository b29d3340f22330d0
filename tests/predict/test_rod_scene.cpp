#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>

#include "predict/rod_scene.h"
#include "predict/small_scenes.h"

namespace vasorod {
namespace {

using namespace testing;
using Kind = EndSelector::Kind;

// A cantilever under a dead tip force across it, large enough to bend it far.
Scene pulled_aside(int elements, bool extrapolate) {
  Scene scene = bent_cantilever(10, 0, elements);
  scene.ends[1].moment.reset();
  scene.ends[1].force = Vec3(0, 1.5, 0);
  scene.extrapolate = extrapolate;
  return scene;
}

Vec3 tip(const Result& result) {
  return result.vessels.at(0).centerline->current.bottomRows(1).transpose();
}

TEST(RodScene, ExtrapolationGainsTwoOrders) {
  const Vec3 exact = tip(solve_rod_scene(pulled_aside(96, true)));
  const auto error = [&](int elements, bool extrapolate) {
    return (tip(solve_rod_scene(pulled_aside(elements, extrapolate))) - exact).norm();
  };
  EXPECT_NEAR(error(8, false) / error(16, false), 4, 0.3);
  EXPECT_NEAR(error(4, true) / error(8, true), 16, 4);
  EXPECT_LT(error(8, true), 0.02 * error(16, false));
}

TEST(RodScene, ReportsForcesOnBranchesThatBalance) {
  Scene scene;
  scene.vessels = {bare_rod("trunk", 10, 10), bare_rod("left", 6, 6), bare_rod("right", 6, 6)};
  for (int k = 1; k <= 2; ++k) {
    RodSpec& rod = *scene.vessels[static_cast<size_t>(k)].rod;
    rod.parent = "trunk";
    rod.tangent = Vec3(k == 1 ? 1 : -1, 0, 1);
    rod.normal = Vec3::UnitY();
  }
  scene.ends = {held("trunk", Kind::start), held("left", Kind::end), at("right", Kind::end)};
  scene.ends[2].force = Vec3(0.2, 0.3, -0.1);
  const Result result = solve_rod_scene(scene);
  EXPECT_EQ(result.status, Status::converged);
  ASSERT_EQ(result.balance.size(), 3u);
  Vec3 joins = Vec3::Zero(), outside = Vec3::Zero();
  for (const Balance& balance : result.balance) {
    EXPECT_LT(balance.residual, 1e-9) << balance.vessel;
    EXPECT_LT((balance.support + balance.load + balance.join).norm(), 1e-9) << balance.vessel;
    joins += balance.join;
    outside += balance.support + balance.load;
  }
  EXPECT_LT(joins.norm(), 1e-12) << "what the branches do to each other";
  EXPECT_LT(outside.norm(), 1e-9);
  EXPECT_EQ(result.balance[2].load, Vec3(0.2, 0.3, -0.1));
  EXPECT_GT(result.balance[2].join.norm(), 0.1);
  EXPECT_EQ(result.vessels.size(), 3u);
  EXPECT_EQ(result.metrics.size(), 3u);
  EXPECT_EQ(result.model.rod_nodes, 1 + 10 + 6 + 6);
}

TEST(RodScene, StressesAlongACantileverAreStaticsOnTheBentShape) {
  const Result result = solve_rod_scene(pulled_aside(40, false));
  const CenterlineResult& line = *result.vessels.at(0).centerline;
  const Vec3 force(0, 1.5, 0), end = tip(result);
  for (Eigen::Index i = 1; i + 1 < line.current.rows(); ++i) {
    const auto n = static_cast<size_t>(i);
    const Vec3 arm = end - line.current.row(i).transpose();
    EXPECT_LT((line.directors[n] * line.force[n] - force).norm(), 0.01 * 1.5) << i;
    EXPECT_LT((line.directors[n] * line.moment[n] - arm.cross(force)).norm(), 0.01 * 15) << i;
  }
}

TEST(RodScene, MetricsSayWhere) {
  const Result result = solve_rod_scene(pulled_aside(40, false));
  const VesselMetrics& metrics = result.metrics.at(0);
  EXPECT_LT(metrics.where.at("largest_curvature").norm(), 1e-12) << "at the clamp";
  EXPECT_GT(metrics.stretch[1], 1);
  EXPECT_GE(metrics.stretch[1], metrics.stretch[0]);
  EXPECT_EQ(result.model.terms, std::vector<std::string>{"rod"});
}

}  // namespace
}  // namespace vasorod
