#include <cmath>
#include <gtest/gtest.h>

#include "report/stripes.h"
#include "result/example_result.h"

namespace vasorod {
namespace {

// Runs of equal values around one row of a tube.
int changes(const Eigen::VectorXd& values, int row, int around) {
  int count = 0;
  for (int i = 0; i < around; ++i)
    count += (values[row * around + i] > 0.5) != (values[row * around + (i + 1) % around] > 0.5);
  return count;
}

TEST(Stripes, AreAsManyAsAskedForAndHalfOfTheWall) {
  const VesselResult tube = test::deformed_tube(48, 30);
  for (const int count : {1, 3, 6}) {
    const Eigen::VectorXd values = stripes(tube, count);
    ASSERT_EQ(values.size(), tube.rest.rows());
    EXPECT_NEAR(values.mean(), 0.5, 0.05);
    EXPECT_EQ(values.minCoeff(), 0);
    EXPECT_EQ(values.maxCoeff(), 1);
    for (const int row : {0, 10, 30}) EXPECT_EQ(changes(values, row, 48), 2 * count);
  }
}

// The rows of this straight tube that are not shifted by half an edge have the same stripes.
TEST(Stripes, RunStraightAlongTheTubeAtRestHoweverItIsTwisted) {
  const VesselResult tube = test::deformed_tube(48, 30);
  const Eigen::VectorXd values = stripes(tube, 4);
  for (int row = 2; row <= 30; row += 2)
    EXPECT_LT((values.segment(48 * row, 48) - values.segment(0, 48)).cwiseAbs().maxCoeff(), 1e-9)
        << row;
}

// Along an arc at rest the stripes keep their side: no twist comes in with the curvature.
TEST(Stripes, KeepTheirSideAlongAnArc) {
  VesselResult arc = test::deformed_tube(48, 30);
  const double curvature = 0.03;
  for (Eigen::Index i = 0; i < arc.rest.rows(); ++i)
    arc.rest.row(i) = test::deformed(arc.rest.row(i).transpose(), curvature, 0, 1).transpose();
  CenterlineResult& line = *arc.centerline;
  for (Eigen::Index i = 0; i < line.rest.rows(); ++i)
    line.rest.row(i) = test::deformed(line.rest.row(i).transpose(), curvature, 0, 1).transpose();
  const Eigen::VectorXd values = stripes(arc, 4);
  // A section of the arc is cut by its nearest node, whose tangent is that of a chord.
  for (int row = 2; row <= 30; row += 2)
    EXPECT_LT((values.segment(48 * row, 48) - values.segment(0, 48)).cwiseAbs().maxCoeff(), 0.1)
        << row;
}

TEST(Stripes, WithoutACenterlineThereAreNone) {
  EXPECT_EQ(stripes(test::obstacle(12, 4), 4).size(), 0);
}

}  // namespace
}  // namespace vasorod
