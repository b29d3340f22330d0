#include <gtest/gtest.h>

#include "vessel/name_ends.h"

namespace vasorod {
namespace {

TEST(NameEnds, AnEndHasTheNameOfTheNearestLidWithinItsRadius) {
  Vessel vessel;
  vessel.rod.radius = {3, 3, 1};
  vessel.ends.resize(3);
  for (int k = 0; k < 3; ++k) {
    vessel.ends[static_cast<size_t>(k)].node = k;
    vessel.ends[static_cast<size_t>(k)].center = {10.0 * k, 0, 0};
  }
  name_ends(vessel, {{"5", {2, 0, 0}}, {"6", {-1, 0, 0}}, {"7", {20, 1.1, 0}}});
  EXPECT_EQ(vessel.ends[0].face, "6");
  EXPECT_EQ(vessel.ends[1].face, "");
  EXPECT_EQ(vessel.ends[2].face, "");
  name_ends(vessel, {{"7", {20, 0.9, 0}}});
  EXPECT_EQ(vessel.ends[2].face, "7");
}

TEST(NameEnds, ASceneNamesAnEndByItsFaceOrElseByItsPlace) {
  Vessel vessel;
  vessel.rod.radius = {3, 3, 3};
  vessel.ends.resize(2);
  vessel.ends[1].node = 1;
  EXPECT_EQ(to_string(selector_of(vessel, 0)), "start");
  EXPECT_EQ(to_string(selector_of(vessel, 1)), "end");
  vessel.ends.resize(3);
  vessel.ends[2].node = 2;
  vessel.ends[2].center = {1.23456, -20.0004, 7};
  EXPECT_EQ(to_string(selector_of(vessel, 2)), "near(1.235, -20, 7)");
  vessel.ends[0].face = vessel.ends[1].face = "2";
  vessel.ends[2].face = "12";
  EXPECT_EQ(to_string(selector_of(vessel, 0)), "start");  // two ends have its name
  EXPECT_EQ(to_string(selector_of(vessel, 2)), "face(12)");
  vessel.ends[2].face = "2.5";
  EXPECT_EQ(to_string(selector_of(vessel, 2)), "near(1.235, -20, 7)");
}

}  // namespace
}  // namespace vasorod
