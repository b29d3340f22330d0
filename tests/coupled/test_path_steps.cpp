#include <gtest/gtest.h>

#include "coupled/path_steps.h"

namespace vasorod {
namespace {

std::vector<double> followed(PathSteps steps) {
  std::vector<double> times;
  for (; !steps.ended(); steps.go_on()) times.push_back(steps.time());
  return times;
}

TEST(PathSteps, GoThroughTheGivenTimes) {
  EXPECT_EQ(followed(PathSteps({0.5, 0.75, 1.0})), (std::vector{0.5, 0.75, 1.0}));
}

TEST(PathSteps, AStepIsHalvedDownToATenthOfTheGivenOne) {
  PathSteps steps({0.5, 1});
  steps.go_on();
  for (const double half : {0.75, 0.625, 0.5625}) {
    EXPECT_TRUE(steps.halve());
    EXPECT_EQ(steps.time(), half);
  }
  EXPECT_FALSE(steps.halve());
  EXPECT_EQ(steps.time(), 0.5625);
  // What succeeds on the way allows no shorter ones.
  steps.go_on();
  EXPECT_EQ(steps.time(), 0.625);
  EXPECT_FALSE(steps.halve());
  EXPECT_EQ(followed(steps), (std::vector{0.625, 0.75, 1.0}));
}

TEST(PathSteps, EachGivenStepIsHalvedByItsOwnLength) {
  PathSteps steps({0.5, 0.75});
  for (int k = 0; k < 3; ++k) EXPECT_TRUE(steps.halve());
  EXPECT_FALSE(steps.halve());
  while (steps.time() < 0.75) steps.go_on();
  for (int k = 0; k < 3; ++k) EXPECT_TRUE(steps.halve());
  EXPECT_FALSE(steps.halve());
  EXPECT_EQ(steps.time(), 0.53125);
}

}  // namespace
}  // namespace vasorod
