#include <cmath>
#include <gtest/gtest.h>

#include "judge/judged_tube.h"
#include "predict/result_of_vessel.h"
#include "predict/small_scenes.h"

namespace vasorod {
namespace {

TEST(ResultOfVessel, ACenterlineHasTheStrainsThatItsRodWasGiven) {
  const PreparedVessel tube = shapes::judged_tube();
  const RodTree& rod = tube.vessel.rod;
  const Vec6 change = shapes::change_of(0.05, {0.002, -0.003, 0.004});
  const CenterlineResult line = centerline_of(rod, shapes::strained(rod, change));
  const auto n = static_cast<size_t>(rod.node_count());
  ASSERT_EQ(line.abscissa.size(), n);
  EXPECT_EQ(line.radius, rod.radius);
  EXPECT_NEAR(line.abscissa.back(), 100, 1e-8);
  ASSERT_EQ(line.lines.size(), 1u);
  EXPECT_EQ(line.lines[0].size(), n);
  for (size_t i = 0; i < n; ++i) {
    EXPECT_LT((line.v[i] - Vec3(0, 0, 1.05)).norm(), 1e-10) << i;
    EXPECT_LT((line.u[i] - Vec3(0.002, -0.003, 0.004)).norm(), 1e-10) << i;
    EXPECT_LT((line.v0[i] - Vec3(0, 0, 1)).norm(), 1e-10) << i;
    EXPECT_LT(line.u0[i].norm(), 1e-10) << i;
  }
  // The screw that a constant strain is, from the root on.
  Vec6 strain = change;
  strain[2] += 1;
  const auto last = static_cast<Eigen::Index>(n) - 1;
  const Vec3 end = (rod.rest[0] * exp_motion(100 * strain)).position;
  EXPECT_LT((line.current.row(last).transpose() - end).norm(), 1e-6);
}

// A skin on its rod, and one rod without a surface.
TEST(ResultOfVessel, VesselsHaveTheirFieldsAndObstaclesOnlyTheirSurface) {
  Scene scene;
  Prediction prediction;
  prediction.scene = &scene;
  for (int i = 0; i < 2; ++i) {
    PredictedVessel& vessel = prediction.vessels.emplace_back();
    vessel.prepared = shapes::judged_tube();
    vessel.prepared.spec.name = i == 0 ? "aorta" : "heart";
    vessel.positions = vessel.prepared.vessel.surface.points;
  }
  PredictedVessel& aorta = prediction.vessels[0];
  const RodTree& rod = aorta.prepared.vessel.rod;
  aorta.rod.poses = shapes::strained(rod, shapes::change_of(0.1, {0, 0, 0.002}));
  aorta.rod_solved = true;
  aorta.positions = carried_points(rod, aorta.rod.poses, aorta.prepared.vessel.binding);
  prediction.vessels[1].prepared.spec.role = Role::obstacle;
  prediction.vessels[1].prepared.vessel.rod = {};
  prediction.stages.push_back({"rest", {}, {}});
  Result result;
  add_vessels(prediction, result);

  ASSERT_EQ(result.vessels.size(), 2u);
  EXPECT_FALSE(result.vessels[0].obstacle);
  EXPECT_TRUE(result.vessels[0].centerline);
  EXPECT_NEAR(result.vessels[0].axial_stretch.minCoeff(), 1.1, 1e-8);
  EXPECT_NEAR(result.vessels[0].axial_stretch.maxCoeff(), 1.1, 1e-8);
  EXPECT_NEAR(result.vessels[0].twist_shear.mean(), 0.02, 1e-8);  // u3 R
  EXPECT_TRUE(result.vessels[1].obstacle);
  EXPECT_FALSE(result.vessels[1].centerline);
  EXPECT_EQ(result.vessels[1].current, prediction.vessels[1].positions);
  ASSERT_EQ(result.metrics.size(), 1u) << "nothing is judged of an obstacle";
  EXPECT_EQ(result.metrics[0].vessel, "aorta");
  EXPECT_NEAR(result.metrics[0].largest_twist_shear, 0.02, 1e-8);
  EXPECT_NEAR(result.metrics[0].flattening, 0, 1e-6) << "the skin keeps its sections";
  ASSERT_EQ(result.stages.size(), 2u);
  EXPECT_EQ(result.stages[1].title, "result");
  EXPECT_EQ(result.stages[1].names, (std::vector<std::string>{"aorta", "heart"}));
}

TEST(ResultOfVessel, WithoutPositionsThereIsNoResultStage) {
  Scene scene;
  Prediction prediction;
  prediction.scene = &scene;
  PredictedVessel& vessel = prediction.vessels.emplace_back();
  vessel.prepared = shapes::judged_tube();
  vessel.rod.poses = vessel.prepared.vessel.rod.rest;
  Result result;
  add_vessels(prediction, result);
  EXPECT_TRUE(result.stages.empty());
  EXPECT_EQ(result.vessels.at(0).current.rows(), 0);
  EXPECT_EQ(result.metrics.at(0).smallest_lumen_ratio, 1);
}

}  // namespace
}  // namespace vasorod
