#include <gtest/gtest.h>

#include "bodies/contact_wall.h"
#include "data/in_parallel.h"
#include "geometry/triangle_surface.h"
#include "paper/paper_tubes.h"

namespace vasorod {
namespace {

using testing::tube;

void expect_alike(const ClosestPoint& wall, const TriangleSurface& surface) {
  const ClosestPoint alone(surface);
  for (int v = 0; v < surface.points.rows(); v += 7) {
    const Vec3 place = Vec3(surface.points.row(v)) + 0.3 * Vec3::UnitX();
    const ClosestPoint::Hit hit = wall.query(place), expected = alone.query(place);
    EXPECT_EQ(hit.triangle, expected.triangle) << v;
    EXPECT_EQ(hit.signed_distance, expected.signed_distance) << v;
    EXPECT_EQ(wall.vertex_normal(v), alone.vertex_normal(v)) << v;
  }
}

TEST(ContactWall, IsOneWallForAllItsCopies) {
  TriangleSurface surface = tube(1, 6, 24, 21);
  ContactWall wall(surface), copy = wall;
  EXPECT_EQ(wall.mean_edge(), mean_edge_length(surface));
  EXPECT_EQ(wall.areas(), vertex_areas(surface));
  const TriangleSurface rest = surface;
  for (int step = 0; step < 3; ++step) {
    surface.points.col(0) += 0.05 * surface.points.col(2).cwiseAbs2();
    expect_alike(wall.now_at(surface.points), surface);
    EXPECT_EQ(&wall.now_at(surface.points), &copy.now_at(surface.points));
    TriangleSurface carried = rest;
    carried.points.array() += step;
    expect_alike(copy.carried_to(carried.points), carried);
    EXPECT_EQ(wall.now_at(surface.points).surface().points, surface.points);
    expect_alike(wall.at_rest(), rest);
  }
}

TEST(ContactWall, MovesOnceForAllThreads) {
  TriangleSurface surface = tube(1, 6, 24, 21);
  ContactWall wall(surface);
  for (int step = 0; step < 20; ++step) {
    surface.points.col(0).array() += 0.1;
    const double expected = ClosestPoint(surface).query(Vec3::Zero()).signed_distance;
    std::vector<double> found(8);
    in_parallel(4, 8, [&](int k) {
      found[static_cast<std::size_t>(k)] =
          wall.now_at(surface.points).query(Vec3::Zero()).signed_distance;
    });
    for (const double distance : found) EXPECT_EQ(distance, expected);
  }
}

}  // namespace
}  // namespace vasorod
