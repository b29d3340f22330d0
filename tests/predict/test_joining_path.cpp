#include <gtest/gtest.h>

#include "data/index.h"
#include "predict/carried_bodies.h"
#include "predict/joining_path.h"
#include "predict/t_glenn.h"
#include "predict/vessel_wall.h"
#include "rod/binding.h"
#include "surgery/glenn.h"

namespace vasorod {
namespace {

using namespace testing;

// A vein along z above an artery along x that lies to its side, cut at z = 20 and joined to the
// artery's upper side.
class JoiningPathTest : public ::testing::Test {
 protected:
  JoiningPathTest() {
    prediction_.scene = &scene_;
    for (const VesselSpec& vessel : scene_.vessels) {
      PredictedVessel& made = prediction_.vessels.emplace_back();
      made.prepared = read_vessel(vessel, scene_);
      fit(made.prepared);
      made.conditions = end_conditions(scene_, vessel.name, made.prepared.vessel);
    }
    prediction_.operation = operate(scene_, *scene_.glenn, vein().prepared,
                                    prediction_.vessels[1].prepared, vein().conditions, {});
    vein().rod = *prediction_.operation->vessels[0].rod;
    vein().rod_solved = true;
  }
  PredictedVessel& vein() { return prediction_.vessels[0]; }
  Points carried(const RodPoses& poses) {
    return carried_points(vein().prepared.vessel.rod, poses, vein().prepared.vessel.carry);
  }
  Vec3 apart(size_t pair, const Points& mouth) {
    const auto [a, b] = prediction_.operation->pairs[pair];
    return (mouth.row(a) - prediction_.vessels[1].prepared.vessel.surface.points.row(b))
        .transpose();
  }

  Scene scene_ = t_glenn(24, 16);
  Prediction prediction_;
};

TEST_F(JoiningPathTest, ItLeadsFromRestToTheSeam) {
  const JoiningPath way(prediction_);
  EXPECT_TRUE(way.is_vein(0));
  EXPECT_FALSE(way.is_vein(1));
  const std::vector<Vec3> first = way.offsets(0), last = way.offsets(1);
  ASSERT_EQ(first.size(), prediction_.operation->pairs.size());
  const Points rest = vein().prepared.vessel.surface.points;
  for (size_t i = 0; i < first.size(); ++i) {
    EXPECT_LT((first[i] - apart(i, rest)).norm(), 1e-9);
    EXPECT_LT(last[i].norm(), 1e-12);
  }
  EXPECT_LT((carried(way.vein(1)) - carried(vein().rod.poses)).rowwise().norm().maxCoeff(), 1e-9);
}

// The vein goes its way while all others go by a share of their strain; here none of them moves.
TEST_F(JoiningPathTest, TheBodiesAreCarriedOnIt) {
  const JoiningPath way(prediction_);
  const std::vector<VesselSections> none(2);
  const Points rest = vein().prepared.vessel.surface.points;
  const std::vector<CarriedBody> first = carried_by_rods(prediction_, none, 0, &way),
                                 last = carried_by_rods(prediction_, none, 1, &way),
                                 straight = carried_by_rods(prediction_, none, 1, nullptr);
  ASSERT_EQ(first.size(), 2U);
  EXPECT_LT((first[0].points - rest).rowwise().norm().maxCoeff(), 1e-9);
  EXPECT_LT((last[0].points - carried(vein().rod.poses)).rowwise().norm().maxCoeff(), 1e-9);
  EXPECT_LT((straight[0].points - last[0].points).rowwise().norm().maxCoeff(), 1e-9);
  EXPECT_EQ(first[0].rotations.size(), static_cast<size_t>(rest.rows()));
  EXPECT_TRUE(first[1].points.rows() == 0);  // its rod is not solved: at rest
  BodyProblem problem;
  problem.bodies.resize(2);
  const SeamWay seam =
      start_at_rest(prediction_, std::make_shared<JoiningPath>(prediction_), problem);
  EXPECT_EQ(seam.step, way.step());
  EXPECT_TRUE(problem.bodies[0].open_mouth);
  EXPECT_EQ(problem.contacts, (std::vector<std::pair<int, int>>{{0, 0}, {1, 1}}));
}

// While it approaches, the rim keeps its section's shape: the offsets are where the rod carries it.
TEST_F(JoiningPathTest, ItComesToTheIncisionFromOutside) {
  const JoiningPath way(prediction_);
  const double top = 12, radius = 6;
  bool was_above = false;
  for (int k = 1; k < 200; ++k) {
    const double t = k / 200.0;
    const Points mouth = carried(way.vein(t));
    double lowest = 1e9, largest = 0;
    const std::vector<Vec3> offsets = way.offsets(t);
    for (size_t i = 0; i < offsets.size(); ++i) {
      lowest = std::min(lowest, mouth(prediction_.operation->pairs[i][0], 2));
      largest = std::max(largest, (offsets[i] - apart(i, mouth)).norm());
    }
    const bool lifted = largest < 1e-9;  // not yet on its way down
    if (lifted && lowest > top + 0.9 * radius) was_above = true;
    if (!lifted) {
      EXPECT_TRUE(was_above) << t;
      EXPECT_GT(lowest, top - 0.1 * radius) << t;
    }
  }
  EXPECT_TRUE(was_above);
}

TEST_F(JoiningPathTest, NoVertexOfTheRimGoesFartherInAStepThanAShareOfTheRadius) {
  const JoiningPath way(prediction_);
  ASSERT_GT(way.step(), 0);
  ASSERT_LT(way.step(), 0.1);
  std::vector<Vec3> before = way.offsets(0);
  double longest = 0;
  for (int k = 1; k * way.step() < 1 + 1e-9; ++k) {
    const std::vector<Vec3> now = way.offsets(std::min(1.0, k * way.step()));
    for (size_t i = 0; i < now.size(); ++i)
      longest = std::max(longest, (now[i] - before[i]).norm());
    before = now;
  }
  // The way down is curved: a step may be longer than the mean one.
  EXPECT_LT(longest, 0.3 * 6);
  EXPECT_GT(longest, 0.05 * 6);
}

}  // namespace
}  // namespace vasorod
