#include <gtest/gtest.h>

#include "bodies/held_overlap.h"
#include "paper/paper_tubes.h"

namespace vasorod {
namespace {

using namespace testing;

// Tubes of radius 1 and length 6 along z; the first 48 and the last 48 vertices are held.
struct Held {
  TriangleSurface rest = tube(1, 6, 48, 40);
  Points carried = rest.points;
  std::vector<char> fixed;
  explicit Held(double x, double z = 0) : fixed(static_cast<size_t>(rest.points.rows()), 0) {
    rest.points.col(0).array() += x;
    rest.points.col(2).array() += z;
    carried = rest.points;
    std::fill_n(fixed.begin(), 48, 1);
    std::fill_n(fixed.rbegin(), 48, 1);
  }
};

HeldOverlap overlap_of(const Held& a, const Held& b) {
  const ClosestPoint rest_a(a.rest), rest_b(b.rest), carried_a = rest_a.moved(a.carried),
                                                     carried_b = rest_b.moved(b.carried);
  return held_overlap({rest_a, carried_a, a.fixed, 0.1}, {rest_b, carried_b, b.fixed, 0.1});
}

TEST(HeldOverlap, RimsApartDoNotOverlap) {
  const Held a(0), b(2.3);
  const HeldOverlap overlap = overlap_of(a, b);
  EXPECT_EQ(overlap.depth, 0);
  EXPECT_TRUE(overlap.in_a.empty() && overlap.in_b.empty());
}

TEST(HeldOverlap, RimsCarriedIntoEachOtherAtBothEnds) {
  Held a(0);
  const Held b(2.3);
  a.carried.col(0).array() += 0.5;  // 2 - 1.8 between mid walls, 0.2 between the outer faces
  const HeldOverlap overlap = overlap_of(a, b);
  EXPECT_NEAR(overlap.depth, 0.4, 0.01);
  for (const auto* side : {&overlap.in_a, &overlap.in_b}) {
    const auto start = std::count_if(side->begin(), side->end(), [](int v) { return v < 48; });
    EXPECT_GT(start, 0);
    EXPECT_LT(start, static_cast<std::ptrdiff_t>(side->size()));
  }
}

TEST(HeldOverlap, OnlyWhatIsDeeperThanAtRestCounts) {
  Held a(0);
  const Held b(2.1);
  EXPECT_EQ(overlap_of(a, b).depth, 0);
  a.carried.col(0).array() += 0.3;
  EXPECT_NEAR(overlap_of(a, b).depth, 0.3, 0.01);
}

TEST(HeldOverlap, AnEndWithinAWiderOneDoesNotMeetIt) {
  Held a(0);
  const Held b(0);
  a.rest.points.leftCols<2>() *= 0.7;
  a.carried = a.rest.points;
  a.rest.points.col(2).array() += 20;
  EXPECT_EQ(overlap_of(a, b).depth, 0);
}

// An end that presses on the middle of another wall: that wall can deform.
TEST(HeldOverlap, AnEndInsideAFreeWallIsContactsBusiness) {
  Held a(0, 3);
  const Held b(2.3);
  a.carried.col(0).array() += 0.5;
  EXPECT_EQ(overlap_of(a, b).depth, 0);
}

}  // namespace
}  // namespace vasorod
