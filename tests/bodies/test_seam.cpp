#include <gtest/gtest.h>

#include <vasorod/error.h>

#include "bodies/seam.h"
#include "paper/paper_tubes.h"

namespace vasorod {
namespace {

ScaledBodies two_tubes() {
  ScaledBodies scaled;
  scaled.bodies.resize(2);
  for (ScaledBody& body : scaled.bodies) body.rest = testing::tube(3, 10, 12, 4);
  scaled.bodies[0].k = {1, 2, 5};
  scaled.bodies[1].k = {9, 4, 3};
  return scaled;
}

std::vector<SeamPair> rims() {  // the last row of the first against the first row of the second
  std::vector<SeamPair> seams;
  for (int k = 0; k < 12; ++k) seams.push_back({0, 48 + k, 1, k});
  return seams;
}

TEST(Seam, ItsRadiusIsTheMouths) {
  EXPECT_NEAR(mouth_radius(rims(), two_tubes()), 3, 1e-12);
  EXPECT_EQ(mouth_radius({}, two_tubes()), 0);
}

TEST(Seam, SpringsAreStifferThanAnyOfItsBodies) {
  EXPECT_DOUBLE_EQ(joining_stiffness(rims(), two_tubes(), 100), 500);
  EXPECT_EQ(joining_stiffness({}, two_tubes(), 100), 0);
}

TEST(Seam, PairsAreNumberedInTheStack) {
  const std::vector<Vec3> multipliers(12, Vec3(1, 2, 3));
  const std::vector<Join> joins = stacked_joins(rims(), {7, 100}, multipliers);
  ASSERT_EQ(joins.size(), 12U);
  EXPECT_EQ(joins[5].a, 7 + 53);
  EXPECT_EQ(joins[5].b, 105);
  EXPECT_EQ(joins[5].multiplier, Vec3(1, 2, 3));
}

TEST(Seam, TheGapIsThatOfTheWidestPair) {
  Points p(4, 3);
  p << 0, 0, 0, 0, 3, 4, 1, 1, 1, 1, 1, 2;
  EXPECT_DOUBLE_EQ(largest_gap({{2, 3, Vec3::Zero()}, {0, 1, Vec3::Zero()}}, p), 5);
  EXPECT_EQ(largest_gap({}, p), 0);
}

TEST(Seam, AVertexThatIsNotThereIsRefused) {
  EXPECT_NO_THROW(check_seams(rims(), two_tubes()));
  EXPECT_THROW(check_seams({{0, 60, 1, 0}}, two_tubes()), InputError);
  EXPECT_THROW(check_seams({{0, 0, 2, 0}}, two_tubes()), InputError);
}

}  // namespace
}  // namespace vasorod
