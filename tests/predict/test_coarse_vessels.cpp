#include <algorithm>
#include <gtest/gtest.h>

#include "geometry/triangle_surface.h"
#include "predict/coarse_vessels.h"
#include "predict/small_scenes.h"
#include "rod/binding.h"

namespace vasorod {
namespace {

using namespace testing;

PreparedVessel prepared(const VesselSpec& spec) {
  const Scene scene;
  PreparedVessel vessel = read_vessel(spec, scene);
  if (!vessel.obstacle()) fit(vessel);
  return vessel;
}

TEST(CoarseVessels, EdgesAreTwiceAsLongAndEverythingElseStays) {
  const PreparedVessel fine = prepared(tube("tube", 48, {1, 2, 3}, 90));
  const std::vector<PreparedVessel> all = coarse_vessels({fine}, {"tube"});
  ASSERT_EQ(all.size(), 1u);
  const Vessel &coarse = all[0].vessel, &was = fine.vessel;
  EXPECT_NEAR(mean_edge_length(coarse.surface) / mean_edge_length(was.surface), 2, 0.3);
  EXPECT_NEAR(total_area(coarse.surface) / total_area(was.surface), 1, 0.02);
  EXPECT_EQ(coarse.rod.rest.size(), was.rod.rest.size());
  EXPECT_EQ(all[0].node_thickness, fine.node_thickness);
  ASSERT_EQ(coarse.ends.size(), was.ends.size());
  for (size_t e = 0; e < coarse.ends.size(); ++e) {
    EXPECT_EQ(coarse.ends[e].node, was.ends[e].node);
    Vec3 center = Vec3::Zero();
    for (const int v : coarse.ends[e].loop) center += coarse.surface.points.row(v).transpose();
    center /= static_cast<double>(coarse.ends[e].loop.size());
    EXPECT_LT((center - was.ends[e].center).norm(), 0.5);
  }
  // Bound to the rod: it carries the coarse wall to where that is at rest.
  EXPECT_LT((carried_points(coarse.rod, coarse.rod.rest, coarse.carry) - coarse.surface.points)
                .rowwise()
                .norm()
                .maxCoeff(),
            1e-9);
}

TEST(CoarseVessels, EdgesOfOneThatIsOnlyTouchedAreFourTimesAsLong) {
  const PreparedVessel fine = prepared(tube("touched", 100, {0, 0, 0}, 100)),
                       thick = prepared(tube("joined", 48, {20, 0, 0}, 90));
  const std::vector<PreparedVessel> all = coarse_vessels({fine, thick}, {"joined"});
  ASSERT_EQ(all.size(), 2u);
  const auto ratio = [](const PreparedVessel& coarse, const PreparedVessel& was) {
    return mean_edge_length(coarse.vessel.surface) / mean_edge_length(was.vessel.surface);
  };
  EXPECT_NEAR(ratio(all[0], fine), 4, 0.6);
  EXPECT_NEAR(ratio(all[1], thick), 2, 0.3);
}

TEST(CoarseVessels, EdgesOfOneThatIsOnlyTouchedAreNoLongerThanItsShapeAllows) {
  const PreparedVessel fine = prepared(tube("touched", 200, {0, 0, 0}, 42));
  const std::vector<PreparedVessel> all = coarse_vessels({fine}, {});
  ASSERT_EQ(all.size(), 1u);
  EXPECT_NEAR(mean_edge_length(all[0].vessel.surface) / fine.vessel.mean_radius, 0.4, 0.06);
}

TEST(CoarseVessels, NoneWhereOneWouldBeTooCoarseToFold) {
  const PreparedVessel fine = prepared(tube("fine", 48, {0, 0, 0}, 90)),
                       coarse = prepared(tube("coarse", 48, {20, 0, 0}, 24));
  EXPECT_TRUE(coarse_vessels({fine, coarse}, {}).empty());
  VesselSpec obstacle = tube("obstacle", 48, {20, 0, 0}, 24);
  obstacle.role = Role::obstacle;
  EXPECT_EQ(coarse_vessels({fine, prepared(obstacle)}, {}).size(), 2u);
}

TEST(CoarseVessels, NoneWhereTheFineOnesAreSmall) {
  const PreparedVessel small = prepared(tube("small", 48, {0, 0, 0}, 60));
  EXPECT_LT(small.vessel.surface.points.rows(), 8000);
  EXPECT_TRUE(coarse_vessels({small}, {}).empty());
}

}  // namespace
}  // namespace vasorod
