#include <gtest/gtest.h>
#include <numeric>

#include <vasorod/tube.h>

#include "geometry/rigid_motion.h"
#include "geometry/smooth_moved.h"
#include "geometry/triangle_surface.h"
#include "straight_tube.h"

namespace vasorod {
namespace {

using testing::straight_tube;

// The vertices of a tube between its ends.
std::vector<int> middle(const TubeSpec& tube) {
  std::vector<int> chosen(static_cast<size_t>(tube.around * (tube.along - 1)));
  std::iota(chosen.begin(), chosen.end(), tube.around);
  return chosen;
}

TEST(SmoothMoved, ARigidMotionStays) {
  const TubeSpec tube = straight_tube(20, 4, 20, 16);
  const TriangleSurface rest = tube_surface(tube);
  Vec6 motion;
  motion << 1, 2, 3, 0.5, -0.4, 0.9;
  const Pose pose = exp_motion(motion);
  MovedSurface moved;
  moved.points = (rest.points * pose.rotation.transpose()).rowwise() + pose.position.transpose();
  moved.rotations.assign(static_cast<size_t>(rest.points.rows()), pose.rotation);
  const Points before = moved.points;
  smooth_moved(rest, middle(tube), 8, moved);
  EXPECT_LT((moved.points - before).rowwise().norm().maxCoeff(), 1e-12 * 20);
}

// What shakes from vertex to vertex goes, the tube stays; other vertices do not move.
TEST(SmoothMoved, NoiseGoesAndTheShapeStays) {
  const TubeSpec tube = straight_tube(20, 4, 20, 16);
  const TriangleSurface rest = tube_surface(tube);
  MovedSurface moved;
  moved.points = rest.points;
  moved.rotations.assign(static_cast<size_t>(rest.points.rows()), Mat3::Identity());
  const std::vector<int> chosen = middle(tube);
  for (const int i : chosen)
    moved.points.row(i) +=
        0.1 * Eigen::RowVector3d(std::sin(7.0 * i), std::sin(11.0 * i), std::sin(13.0 * i));
  const double before = (moved.points - rest.points).norm();
  smooth_moved(rest, chosen, 5, moved);
  EXPECT_LT((moved.points - rest.points).norm(), 0.35 * before);
  EXPECT_EQ(moved.points.topRows(tube.around), rest.points.topRows(tube.around));
}

// A strip folded by a right angle along one row of vertices, with rotations that go over gradually.
TEST(SmoothMoved, ACreaseSpreadsOverTheEdgesBesideIt) {
  const int along = 24, across = 2;
  TriangleSurface rest;
  rest.points.resize((along + 1) * (across + 1), 3);
  rest.triangles.resize(2 * along * across, 3);
  for (int i = 0; i <= along; ++i)
    for (int j = 0; j <= across; ++j) rest.points.row(i * (across + 1) + j) << i, j, 0;
  int t = 0;
  for (int i = 0; i < along; ++i)
    for (int j = 0; j < across; ++j) {
      const int a = i * (across + 1) + j;
      rest.triangles.row(t++) << a, a + across + 1, a + across + 2;
      rest.triangles.row(t++) << a, a + across + 2, a + 1;
    }
  MovedSurface moved;
  moved.points = rest.points;
  std::vector<int> chosen;
  for (int i = 0; i < rest.points.rows(); ++i) {
    const double x = rest.points(i, 0) - along / 2;
    if (x > 0) moved.points.row(i) << along / 2, rest.points(i, 1), x;
    const double angle = M_PI / 2 * std::clamp((x + 3) / 6, 0.0, 1.0);
    moved.rotations.push_back(Eigen::AngleAxisd(-angle, Vec3::UnitY()).toRotationMatrix());
    if (std::abs(x) < 5) chosen.push_back(i);
  }
  const auto largest_fold = [&] {
    double largest = 0;
    for (int i = 1; i < along; ++i) {
      const auto at = [&](int k) { return moved.points.row(k * (across + 1) + 1); };
      const Eigen::RowVector3d in = at(i) - at(i - 1), out = at(i + 1) - at(i);
      largest = std::max(largest, std::acos(in.normalized().dot(out.normalized())));
    }
    return largest;
  };
  EXPECT_NEAR(largest_fold(), M_PI / 2, 1e-9);
  smooth_moved(rest, chosen, 5, moved);
  EXPECT_LT(largest_fold(), 0.5 * M_PI / 2);
}

}  // namespace
}  // namespace vasorod
