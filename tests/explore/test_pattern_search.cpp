#include <cmath>
#include <gtest/gtest.h>

#include "explore/pattern_search.h"
#include "explore/small_exploration.h"

namespace vasorod::testing {
namespace {

Option first_option(const Scene& scene) {
  return options_of(scene, {}).front();
}

double at(const Option& option, const std::string& key) {
  return number_of(option, key).value();
}

// To the minimum of a quadratic with a slanted valley, from a corner of the listed values.
TEST(PatternSearch, FindsTheMinimumOfAQuadratic) {
  const Scene scene = small_exploration("cut_along: [0.5, 0.6, 0.8], rotation_deg: [0, 40, 80]");
  const auto value = [](const Option& option) {
    const double x = at(option, "cut_along") - 0.63, y = (at(option, "rotation_deg") - 50) / 100;
    return 30 * x * x + 8 * x * y + y * y;
  };
  Option centre = first_option(scene);
  PatternSearch search(refined_keys(*scene.explore), centre, {});
  int polls = 0;
  while (!search.ended() && ++polls < 200) {
    Option best = centre;
    for (const Option& option : search.poll())
      if (value(option) < value(best)) best = option;
    search.go_on(best.text() != centre.text(), best);
    centre = best;
  }
  EXPECT_LT(polls, 200);
  EXPECT_NEAR(at(centre, "cut_along"), 0.63, 0.1 / 16);
  EXPECT_NEAR(at(centre, "rotation_deg"), 50, 40. / 16);
}

TEST(PatternSearch, StaysInTheRangeOfTheListedValues) {
  const Scene scene = small_exploration("cut_along: [0.5, 0.6], rotation_deg: [auto, 40]");
  PatternSearch search(refined_keys(*scene.explore), first_option(scene), {});
  const auto options = search.poll();  // up alone: 0.5 and auto, which is 0, are the lowest
  ASSERT_EQ(options.size(), 2U);
  EXPECT_EQ(options[0].text(), "cut_along 0.55, rotation_deg auto");
  EXPECT_EQ(options[1].text(), "cut_along 0.5, rotation_deg 20");
  EXPECT_EQ(options[0].operation.cut.along, 0.55);
  EXPECT_EQ(options[1].operation.rotation_deg, 20);
}

TEST(PatternSearch, OneValueOfEachKeyLeavesNothingToSearch) {
  const Scene scene = small_exploration("cut_along: 0.5, rotation_deg: [auto]");
  EXPECT_TRUE(PatternSearch(refined_keys(*scene.explore), first_option(scene), {}).ended());
}

TEST(PatternSearch, RefinedKeysHaveTheirRangeAndSmallestGap) {
  const auto keys =
      refined_keys(*small_exploration("cut_along: [0.8, 0.5, 0.6], incision_length: 1").explore);
  ASSERT_EQ(keys.size(), 1U);
  EXPECT_EQ(keys[0].name, "cut_along");
  EXPECT_EQ(keys[0].low, 0.5);
  EXPECT_EQ(keys[0].high, 0.8);
  EXPECT_NEAR(keys[0].gap, 0.1, 1e-12);
}

}  // namespace
}  // namespace vasorod::testing
