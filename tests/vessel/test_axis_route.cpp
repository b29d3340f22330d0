#include <gtest/gtest.h>

#include "vessel/axis_route.h"

namespace vasorod {
namespace {

// A trunk of 3 and 4 from node 0 over 1 to the fork 2, and branches of 5 to node 3 and 7 to node 4.
Vessel forked() {
  Vessel vessel;
  vessel.rod.rest.resize(5);
  const auto add = [&](int first, int second, double length) {
    RodElement element;
    element.first = first;
    element.second = second;
    element.length = length;
    vessel.rod.elements.push_back(element);
  };
  add(0, 1, 3);
  add(1, 2, 4);
  add(2, 3, 5);
  add(2, 4, 7);
  vessel.ends.resize(3);
  vessel.ends[0].node = 0;
  vessel.ends[1].node = 3;
  vessel.ends[2].node = 4;
  return vessel;
}

void expect_at(const AxisRoute& route, double distance, int element, double s) {
  const AxisPlace place = route.at(distance);
  EXPECT_EQ(place.element, element) << distance;
  EXPECT_DOUBLE_EQ(place.s, s) << distance;
}

TEST(AxisRoute, GoesDownOneBranchAndUpTheOther) {
  const Vessel vessel = forked();
  const AxisRoute route(vessel.rod, 3, 4);
  EXPECT_DOUBLE_EQ(route.length(), 12);
  expect_at(route, 0, 2, 5);
  expect_at(route, 2, 2, 3);
  expect_at(route, 6, 3, 1);
  expect_at(route, 12, 3, 7);
  expect_at(route, 99, 3, 7);
  expect_at(route, -1, 2, 5);
}

TEST(AxisRoute, IsTheSameBackwards) {
  const Vessel vessel = forked();
  const AxisRoute there(vessel.rod, 0, 4), back(vessel.rod, 4, 0);
  EXPECT_DOUBLE_EQ(there.length(), 14);
  for (const double distance : {0.5, 3.5, 6.9, 7.5, 13.9}) {
    const AxisPlace a = there.at(distance), b = back.at(14 - distance);
    EXPECT_EQ(a.element, b.element);
    EXPECT_NEAR(a.s, b.s, 1e-12);
    EXPECT_NEAR(*there.distance_to(a), distance, 1e-12);
    EXPECT_NEAR(*back.distance_to(a), 14 - distance, 1e-12);
  }
  EXPECT_FALSE(there.distance_to({2, 1.0}));
}

TEST(AxisRoute, TheFarthestEndIsThatByArcLength) {
  const Vessel vessel = forked();
  EXPECT_EQ(farthest_end(vessel, 0), 2);
  EXPECT_EQ(farthest_end(vessel, 2), 0);
  EXPECT_EQ(farthest_end(vessel, 1), 0);  // both are 12 away: the first
}

}  // namespace
}  // namespace vasorod
