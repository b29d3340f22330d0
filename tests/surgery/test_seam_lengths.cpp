#include <cmath>
#include <gtest/gtest.h>

#include "data/index.h"
#include "surgery/seam_lengths.h"

namespace vasorod {
namespace {

// A circle in the plane z = 0, its corners at irregular angles.
LoopCurve circle(int count, double radius, int sense) {
  Points p(count, 3);
  for (int k = 0; k < count; ++k) {
    const double angle = sense * 2 * M_PI / count * (k + 0.2 * std::sin(5.0 * k));
    p.row(k) << radius * std::cos(angle), radius * std::sin(angle), 0.1 * std::cos(3 * angle);
  }
  return LoopCurve(p);
}

std::vector<double> shares(const Points& polygon) {
  std::vector<double> lengths;
  double whole = 0;
  for (Eigen::Index k = 0; k < polygon.rows(); ++k) {
    lengths.push_back((polygon.row((k + 1) % polygon.rows()) - polygon.row(k)).norm());
    whole += lengths.back();
  }
  for (double& l : lengths) l /= whole;
  return lengths;
}

TEST(SeamLengths, EverySegmentHasTheSameShareOfBothLoops) {
  const SeamCurve mouth{circle(17, 2, +1), 0.13, false}, rim{circle(20, 3, -1), 0, true};
  // 0 is the first tip, 10 the rim's other tip; some knots lack a vertex of one loop.
  SeamCorners corners;
  for (int i = 0; i < 17; ++i) {
    const double x = mouth.loop.position(i) / mouth.loop.length() - mouth.start;
    corners.mouth.push_back(x - std::floor(x));
  }
  std::sort(corners.mouth.begin(), corners.mouth.end());
  for (int j = 0; j < 20; ++j)
    corners.rim.push_back(j == 0 ? 0 : 1 - rim.loop.position(20 - j) / rim.loop.length());
  corners.other_tip = 10;
  const auto knots = choose_knots(corners);
  const auto places = equal_shares(mouth, rim, knots, corners.other_tip);

  std::vector<char> on_mouth, on_rim;
  int single = 0;
  for (size_t k = 0; k < knots.size(); ++k) {
    on_mouth.push_back(knots[k].mouth >= 0);
    on_rim.push_back(knots[k].rim >= 0);
    single += knots[k].mouth < 0 || knots[k].rim < 0;
    if (knots[k].rim == 0 || knots[k].rim == 10) {
      EXPECT_EQ(places.rim[k], corners.rim[index(knots[k].rim)]);
    }
    if (k > 0) {
      EXPECT_GT(places.rim[k], places.rim[k - 1]);
    }
    if (knots[k].rim != 10) {
      EXPECT_EQ(places.mouth[k], knots[k].position);
    }
  }
  EXPECT_GT(single, 0);
  const auto a = shares(knot_points(mouth, on_mouth, places.mouth)),
             b = shares(knot_points(rim, on_rim, places.rim));
  for (size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], 1e-13);
}

TEST(SeamLengths, NewKnotsLieOnTheLineBetweenVerticesThatSlide) {
  Points square(4, 3);
  square << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0;
  const SeamCurve curve{LoopCurve(square), 0, false};
  // Vertices at (0.5, 0), (1, 0.5), (0.5, 1), (0, 0.5); one new knot on each line between them.
  const std::vector<char> slides{0, 1, 0, 1, 0, 1, 0, 1};
  const std::vector<double> ways{0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875};
  const Points points = knot_points(curve, slides, ways);
  EXPECT_NEAR((points.row(0) - Vec3(0.25, 0.25, 0).transpose()).norm(), 0, 1e-15);
  EXPECT_NEAR((points.row(1) - Vec3(0.5, 0, 0).transpose()).norm(), 0, 1e-15);
  EXPECT_NEAR((points.row(4) - Vec3(0.75, 0.75, 0).transpose()).norm(), 0, 1e-15);
}

}  // namespace
}  // namespace vasorod
