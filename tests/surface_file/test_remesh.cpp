#include <gtest/gtest.h>

#include <vasorod/tube.h>

#include "geometry/triangle_surface.h"
#include "surface_file/check_surface.h"
#include "surface_file/remesh.h"
#include "surface_file/sample_surfaces.h"

namespace vasorod {
namespace {

TEST(Remesh, MakesEdgesOfTheTargetOnTheSameSurface) {
  TubeSpec spec = small_tube();
  spec.bend_deg = 60;
  const auto before = tube_surface(spec);
  for (const double target : {1.0, 2.5}) {
    const auto after = remesh(before, target);
    check_manifold("tube", after);
    check_outward("tube", after);
    check_self_intersections("tube", after);
    EXPECT_EQ(euler_number(after.triangles), 0);
    EXPECT_NEAR(mean_edge_length(after) / target, 1, 0.1);
    double shortest = 1e300;
    for (const Edge& e : edges_of(after.triangles))
      shortest = std::min(shortest, (after.points.row(e.a) - after.points.row(e.b)).norm());
    EXPECT_GT(shortest, 0.2 * target);
    EXPECT_NEAR(total_area(after) / total_area(before), 1, 0.01);
    EXPECT_NEAR(typical_radius(after) / typical_radius(before), 1, 0.01);
  }
}

TEST(Remesh, KeepsEndsInPlaceAndInOrder) {
  TubeSpec spec = small_tube();
  spec.end_radius = 6;
  const auto before = tube_surface(spec);
  const auto after = remesh(before, 1.3);
  const auto loops = boundary_loops(after.triangles), old = boundary_loops(before.triangles);
  ASSERT_EQ(loops.size(), 2U);
  for (size_t end = 0; end < 2; ++end) {
    for (const int i : loops[end]) EXPECT_NEAR(after.points(i, 2), end == 0 ? 0 : 40, 1e-9);
    EXPECT_NEAR(
        area_vector(after.points, loops[end]).norm() / area_vector(before.points, old[end]).norm(),
        1, 0.01);
  }
  EXPECT_EQ(loops[0][0], 0);
  EXPECT_EQ(loops[1][0], static_cast<int>(loops[0].size()));
}

// A file may number its far end first: that end is `start`, before and after.
TEST(Remesh, KeepsAStartThatIsTheFarEnd) {
  TriangleSurface before = sample_tube();
  const int last = static_cast<int>(before.points.rows()) - 1;
  before.points = before.points.colwise().reverse().eval();
  before.triangles = before.triangles.unaryExpr([&](int i) { return last - i; });
  const auto after = remesh(before, 1.3);
  const auto loops = boundary_loops(after.triangles);
  for (const int i : loops[0]) EXPECT_NEAR(after.points(i, 2), 40, 1e-9);
}

TEST(Remesh, LeavesNoTriangleBelowATwentiethOfTheTargetOnACoarseEnd) {
  TriangleSurface coarse = sample_tube();
  coarse.points.row(3) = 0.99 * coarse.points.row(4) + 0.01 * coarse.points.row(3);
  const auto after = remesh(coarse, 2);
  double shortest = 1e300;
  for (const Edge& e : edges_of(after.triangles))
    shortest = std::min(shortest, (after.points.row(e.a) - after.points.row(e.b)).norm());
  EXPECT_GT(shortest, 0.2 * 2);
}

TEST(Remesh, IsKeptForTheSameSurfaceAndEdgeAlone) {
  const TriangleSurface surface = tube_surface(small_tube());
  TriangleSurface wider = surface;
  wider.points.col(0) *= 1.2;
  KeptRemesh kept;
  const auto first = kept.of(surface, 2);
  EXPECT_EQ(first->points, remesh(surface, 2).points);
  EXPECT_EQ(kept.of(surface, 2), first);
  const auto longer = kept.of(surface, 2.5);
  EXPECT_EQ(longer->points, remesh(surface, 2.5).points);
  EXPECT_EQ(kept.of(wider, 2.5)->points, remesh(wider, 2.5).points);
  const TriangleSurface larger = remesh(surface, 1);
  EXPECT_EQ(kept.of(larger, 2.5)->points, remesh(larger, 2.5).points);
  EXPECT_EQ(kept.of(surface, 2)->points, first->points);
}

}  // namespace
}  // namespace vasorod
