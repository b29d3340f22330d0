#include "wall/fold.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vasorod {
namespace {

// Two triangles over the edge from (0, 0, 0) to (0, 2, 0), the second turned by `angle` out of the plane.
TriangleSurface hinge(double angle) {
  TriangleSurface s;
  s.points.resize(4, 3);
  s.points << 0, 0, 0, 0, 2, 0, -1, 1, 0, std::cos(angle), 1, std::sin(angle);
  s.triangles.resize(2, 3);
  s.triangles << 0, 1, 2, 1, 0, 3;
  return s;
}

TEST(Fold, TheAngleBetweenTwoTrianglesAndItsPlace) {
  for (const double angle : {0.7, 2.5, M_PI}) {
    const Fold fold = sharpest_fold(hinge(angle));
    EXPECT_NEAR(fold.cosine, std::cos(angle), 1e-12);
    EXPECT_LT((fold.place - Vec3(0, 1, 0)).norm(), 1e-12);
  }
}

TEST(Fold, AFlatSheetHasNone) {
  EXPECT_NEAR(sharpest_fold(hinge(0)).cosine, 1, 1e-15);
}

}  // namespace
}  // namespace vasorod
