#include <gtest/gtest.h>

#include "prepare/find_tips.h"
#include "prepare/open_tip.h"
#include "prepare/repair.h"
#include "prepare/tube_shapes.h"

namespace vasorod::testing {
namespace {

TEST(FindTips, AClosedTubeHasOneAtEachEnd) {
  for (const bool round : {true, false}) {
    const auto tips = find_tips(closed_tube(60, 5, round), 1.8);
    ASSERT_EQ(tips.size(), 2u);
    const double low = std::min(tips[0].place.z(), tips[1].place.z()),
                 high = std::max(tips[0].place.z(), tips[1].place.z());
    EXPECT_LT(low, 1);
    EXPECT_GT(high, 59);
  }
}

TEST(FindTips, AnOpenTubeHasNone) {
  TubeSpec tube;
  tube.length = 60;
  tube.radius = 5;
  EXPECT_TRUE(find_tips(tube_surface(tube), 1.8).empty());
}

TEST(OpenTip, TheEndIsFlatAcrossTheAxisWhereTheTubeIsWhole) {
  TriangleSurface surface = closed_tube(60, 5, true);
  for (const Tip& tip : find_tips(surface, 1.8)) {
    const auto sections = sections_behind_tip(surface, tip);
    ASSERT_FALSE(sections.empty());
    for (const FlatSection& section : sections) {
      EXPECT_GT(std::abs(section.normal.z()), std::cos(3 * M_PI / 180));
      EXPECT_NEAR(section.radius, 5, 0.3);
      // 0.97 of the area: at most sin(acos(sqrt(0.97))) = 0.17 radii into the half ball.
      EXPECT_LT(std::abs(section.center.z() - 30), 30 + 0.2 * 5);
    }
    // Half a radius behind that, where nothing of the half ball is left.
    EXPECT_LT(std::abs(sections.front().center.z() - 30), 30 - 0.2 * 5);
    EXPECT_GT(std::abs(sections.front().center.z() - 30), 30 - 5);
    ASSERT_TRUE(cut_tip(surface, tip, sections.front()));
  }
  const auto loops = boundary_loops(surface.triangles);
  ASSERT_EQ(loops.size(), 2u);
  for (const auto& loop : loops) EXPECT_LT(unevenness(surface.points, loop), 1e-9);
}

}  // namespace
}  // namespace vasorod::testing
