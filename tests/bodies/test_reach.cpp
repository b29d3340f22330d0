#include <gtest/gtest.h>

#include "bodies/reach.h"

namespace vasorod {
namespace {

Points corners(double from, double to) {
  Points p(2, 3);
  p << from, from, from, to, to, to;
  return p;
}

TEST(Reach, BoxesComeWithinTheMarginOrNot) {
  const Box a = box_of(corners(0, 1)), b = box_of(corners(2, 3));  // sqrt(3) apart
  EXPECT_FALSE(within_reach(a, b, 1.73));
  EXPECT_TRUE(within_reach(a, b, 1.74));
  EXPECT_TRUE(within_reach(a, box_of(corners(0.5, 3)), 0));
}

TEST(Reach, NothingIsWithinReachOfAnEmptyBox) {
  EXPECT_FALSE(within_reach(box_of(Points(0, 3)), box_of(corners(0, 1)), 1e9));
}

}  // namespace
}  // namespace vasorod
