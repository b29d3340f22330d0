#include <cmath>
#include <gtest/gtest.h>

#include <vasorod/tube.h>

#include "geometry/moved_with.h"
#include "geometry/rigid_motion.h"
#include "geometry/triangle_surface.h"
#include "straight_tube.h"

namespace vasorod {
namespace {

using testing::straight_tube;

// A plate of n x n squares in the plane z = 0, x and y from -1 to 1; `slit`: along y = 0 from x = 0
// to the side x = 1, with vertices of its own on both sides.
TriangleSurface plate(int n, bool slit = false) {
  TriangleSurface s;
  s.points.resize((n + 1) * (n + 1) + (slit ? n / 2 : 0), 3);
  const auto at = [&](int i, int j) { return j * (n + 1) + i; };
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) s.points.row(at(i, j)) << 2.0 * i / n - 1, 2.0 * j / n - 1, 0;
  for (int i = n / 2 + 1; slit && i <= n; ++i)
    s.points.row((n + 1) * (n + 1) + i - n / 2 - 1) = s.points.row(at(i, n / 2));
  // The squares above the slit use its upper vertices.
  const auto above = [&](int i, int j) {
    return slit && j == n / 2 && i > n / 2 ? (n + 1) * (n + 1) + i - n / 2 - 1 : at(i, j);
  };
  s.triangles.resize(2 * n * n, 3);
  int t = 0;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      s.triangles.row(t++) << above(i, j), above(i + 1, j), at(i + 1, j + 1);
      s.triangles.row(t++) << above(i, j), at(i + 1, j + 1), at(i, j + 1);
    }
  return s;
}

Points mapped(const Points& points, const std::function<Vec3(const Vec3&)>& map) {
  Points out(points.rows(), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) out.row(i) = map(points.row(i));
  return out;
}

MovedSurface moved(const TriangleSurface& coarse, const Points& to,
                   const TriangleSurface& surface) {
  return moved_with(coarse, to, Eigen::VectorXd::Zero(to.rows()), surface);
}

TEST(MovedWith, ARigidMotionIsExactOffTheCoarseTrianglesToo) {
  const TriangleSurface coarse = tube_surface(straight_tube(40, 5, 12, 10)),
                        fine = tube_surface(straight_tube(40, 5, 31, 27));
  Vec6 motion;
  motion << 3, -2, 7, 0.4, -1.1, 0.7;
  const Pose pose = exp_motion(motion);
  const auto map = [&](const Vec3& p) { return pose * p; };
  const MovedSurface at = moved(coarse, mapped(coarse.points, map), fine);
  EXPECT_LT((at.points - mapped(fine.points, map)).rowwise().norm().maxCoeff(), 1e-12 * 40);
  for (const Mat3& rotation : at.rotations) EXPECT_LT((rotation - pose.rotation).norm(), 1e-12);
}

// The mean of a linear interpolation and of Taylor expansions about the corners.
TEST(MovedWith, AQuadraticMotionInThePlaneIsExactAwayFromTheRim) {
  const TriangleSurface coarse = plate(8), fine = plate(30);
  const auto map = [](const Vec3& p) {
    return Vec3(p.x() + 0.1 * p.x() * p.x() - 0.2 * p.x() * p.y(), p.y() + 0.3 * p.y() * p.y(), 0);
  };
  const Points exact = mapped(fine.points, map),
               at = moved(coarse, mapped(coarse.points, map), fine).points;
  int inside = 0;
  for (Eigen::Index i = 0; i < at.rows(); ++i) {
    if (fine.points.row(i).cwiseAbs().maxCoeff() > 0.74) continue;  // corners on the rim beyond
    ++inside;
    EXPECT_LT((at.row(i) - exact.row(i)).norm(), 1e-12) << fine.points.row(i);
  }
  EXPECT_GT(inside, 400);
}

// Largest error over the radius of a tube bent to an arc.
double error_of_bend(int around) {
  const double length = 40, curvature = 0.02;
  const TriangleSurface coarse = tube_surface(straight_tube(length, 5, around, 4 * around / 3)),
                        fine = tube_surface(straight_tube(length, 5, 97, 131));
  const auto map = [&](const Vec3& p) {
    Vec6 motion = Vec6::Zero();
    motion << 0, 0, p.z(), curvature * p.z(), 0, 0;
    return exp_motion(motion) * Vec3(p.x(), p.y(), 0);
  };
  const Points exact = mapped(fine.points, map),
               at = moved(coarse, mapped(coarse.points, map), fine).points;
  double worst = 0;
  for (Eigen::Index i = 0; i < at.rows(); ++i)
    if (const double z = fine.points(i, 2); z > 10 && z < 30)
      worst = std::max(worst, (at.row(i) - exact.row(i)).norm() / 5);
  return worst;
}

TEST(MovedWith, TheErrorOfABendFallsWithTheSquareOfTheEdge) {
  const double wide = error_of_bend(12), half = error_of_bend(24), quarter = error_of_bend(48);
  EXPECT_LT(wide, 0.01);
  EXPECT_GT(wide / half, 3.5) << wide << " " << half;
  EXPECT_GT(half / quarter, 3.5) << half << " " << quarter;
}

TEST(MovedWith, TheSidesOfAClosedSlitPart) {
  const TriangleSurface coarse = plate(8, true), fine = plate(26, true);
  Points open = coarse.points;
  const Eigen::Index upper = 9 * 9;
  for (Eigen::Index i = upper; i < open.rows(); ++i) open(i, 1) += 0.2 * open(i, 0);
  const Points at = moved(coarse, open, fine).points;
  for (Eigen::Index i = 27 * 27; i < at.rows(); ++i)
    EXPECT_NEAR(at(i, 1), 0.2 * fine.points(i, 0), 0.02) << fine.points.row(i);
  for (int i = 14; i <= 26; ++i)
    EXPECT_NEAR(at(13 * 27 + i, 1), 0, 2e-3) << "the tip belongs to both sides";
}

TEST(MovedWith, ValuesAreInterpolated) {
  const TriangleSurface coarse = plate(6), fine = plate(17);
  const Eigen::VectorXd values = coarse.points.col(0) - 3 * coarse.points.col(1);
  const MovedSurface at = moved_with(coarse, coarse.points, values, fine);
  const Eigen::VectorXd exact = fine.points.col(0) - 3 * fine.points.col(1);
  EXPECT_LT((at.values - exact).cwiseAbs().maxCoeff(), 1e-12);
}

}  // namespace
}  // namespace vasorod
