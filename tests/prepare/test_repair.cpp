#include <gtest/gtest.h>

#include "prepare/repair.h"
#include "prepare/tube_shapes.h"
#include "surface_file/check_surface.h"

namespace vasorod::testing {
namespace {

TriangleSurface joined(const TriangleSurface& a, const TriangleSurface& b) {
  TriangleSurface out;
  out.points.resize(a.points.rows() + b.points.rows(), 3);
  out.points << a.points, b.points;
  out.triangles.resize(a.triangles.rows() + b.triangles.rows(), 3);
  out.triangles << a.triangles, (b.triangles.array() + static_cast<int>(a.points.rows())).matrix();
  return out;
}

TEST(Repair, TurnedTrianglesAreCountedAndTurnedBack) {
  TriangleSurface surface = closed_tube(40, 5, true);
  const double volume = lidded_volume(surface);
  for (Eigen::Index t = 0; t < surface.triangles.rows(); t += 7)
    std::swap(surface.triangles(t, 1), surface.triangles(t, 2));
  const auto turned = (surface.triangles.rows() + 6) / 7;
  const auto done = orient(surface);
  ASSERT_EQ(done.size(), 1u);
  EXPECT_EQ(done[0], std::to_string(turned) + " triangles turned like their neighbours");
  keep_largest(surface);
  EXPECT_NEAR(lidded_volume(surface), volume, 1e-9 * volume);
}

TEST(Repair, TheLargestPartIsKeptAndTheOthersAreToldApart) {
  TriangleSurface small = closed_tube(10, 2, true), inner = closed_tube(38, 4, true);
  small.points.col(0).array() += 20;
  inner.points.col(2).array() += 1;
  const TriangleSurface large = closed_tube(40, 5, true);
  TriangleSurface all = joined(joined(small, large), inner);
  const auto others = keep_largest(all);
  EXPECT_EQ(all.points.rows(), large.points.rows());
  ASSERT_EQ(others.size(), 2u);
  EXPECT_TRUE(others[0].inside);
  EXPECT_FALSE(others[1].inside);
  EXPECT_NEAR(others[1].center.x(), 20, 1e-9);
  EXPECT_NEAR(others[1].volume, lidded_volume(small), 1e-9 * others[1].volume);
}

TEST(Repair, AHoleIsToldFromAnEndAndClosed) {
  TubeSpec tube;
  tube.length = 40;
  tube.radius = 5;
  TriangleSurface surface = tube_surface(tube);
  const double volume = lidded_volume(surface);
  std::vector<int> keep;
  for (int t = 0; t < surface.triangles.rows(); ++t) {
    const Vec3 p = surface.points.row(surface.triangles(t, 0));
    if ((p - Vec3(5, 0, 20)).norm() > 1.5) keep.push_back(t);
  }
  surface.triangles = surface.triangles(keep, Eigen::all).eval();
  const Openings openings = openings_of(surface);
  ASSERT_EQ(openings.holes.size(), 1u);
  EXPECT_EQ(openings.ends.size(), 2u);
  fill_loops(surface, openings.holes);
  EXPECT_EQ(boundary_loops(surface.triangles).size(), 2u);
  EXPECT_NEAR(lidded_volume(surface), volume, 1e-3 * volume);
}

}  // namespace
}  // namespace vasorod::testing
