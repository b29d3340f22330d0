#include <gtest/gtest.h>

#include "geometry/noisy_tube.h"
#include "geometry/surface_editor.h"
#include "geometry/triangle_surface.h"

namespace vasorod {
namespace {

// A flat hexagon: vertex 0 in the middle, 1 to 6 around it, outwards is +z.
TriangleSurface hexagon() {
  TriangleSurface s;
  s.points = Points::Zero(7, 3);
  s.triangles.resize(6, 3);
  for (int k = 0; k < 6; ++k) {
    s.points.row(k + 1) << std::cos(k * M_PI / 3), std::sin(k * M_PI / 3), 0;
    s.triangles.row(k) << 0, k + 1, (k + 1) % 6 + 1;
  }
  return s;
}

TEST(SurfaceEditor, RingsRunCounterClockwiseAndOpenAtTheBoundary) {
  const SurfaceEditor editor(hexagon());
  EXPECT_EQ(editor.ring(0).size(), 6U);
  EXPECT_FALSE(editor.on_boundary(0));
  EXPECT_EQ(editor.ring(1), (std::vector<int>{2, 0, 6}));
  EXPECT_TRUE(editor.on_boundary(1));
  EXPECT_EQ(editor.triangle_left_of(0, 1), 0);
  EXPECT_EQ(editor.triangle_left_of(2, 1), -1);
}

TEST(SurfaceEditor, SplittingKeepsAreaTopologyAndSources) {
  SurfaceEditor editor(hexagon());
  const int inner = editor.split_edge(0, 3, 0.25), rim = editor.split_edge(5, 6, 0.5);
  const int face = editor.split_triangle(editor.triangle_left_of(0, 1), {0.5, 0.25, 0.25});
  const auto part = editor.whole();
  EXPECT_EQ(part.surface.points.rows(), 10);
  EXPECT_EQ(part.surface.triangles.rows(), 6 + 2 + 1 + 2);
  EXPECT_EQ(euler_number(part.surface.triangles), 1);
  EXPECT_EQ(boundary_loops(part.surface.triangles)[0].size(), 7U);
  EXPECT_NEAR(total_area(part.surface), 1.5 * std::sqrt(3.0), 1e-14);
  EXPECT_LT(
      (interpolate(part.sources, Eigen::MatrixXd(hexagon().points)) - part.surface.points).norm(),
      1e-15);
  for (const int v : {inner, rim, face}) EXPECT_TRUE(editor.touched(v));
  EXPECT_FALSE(editor.touched(0));
}

TEST(SurfaceEditor, AMoveThatFoldsOrFlattensATriangleIsRefusedAndChangesNothing) {
  SurfaceEditor editor(hexagon());
  EXPECT_FALSE(editor.move(0, {{0, -0.2}, {1, 1.2}}));   // beyond its own ring
  EXPECT_FALSE(editor.move(0, {{0, 0.04}, {1, 0.96}}));  // nearly onto a neighbour
  EXPECT_EQ(editor.point(0), Vec3::Zero());
  EXPECT_TRUE(editor.move(0, {{0, 0.7}, {1, 0.3}}));
  EXPECT_NEAR((editor.point(0) - Vec3(0.3, 0, 0)).norm(), 0, 1e-15);
}

TEST(SurfaceEditor, AMoveToAnInputPointKeepsThatSource) {
  SurfaceEditor editor(hexagon());
  ASSERT_TRUE(editor.move(2, {{2, 0.8}, {3, 0.2}}));  // no longer where the input has it
  VertexSource from;
  from.vertex = {0, 2};
  from.weight = {0.6, 0.4};
  const Vec3 to = 0.4 * Vec3(hexagon().points.row(2));
  ASSERT_TRUE(editor.move(0, to, from));
  EXPECT_EQ(editor.point(0), to);
  EXPECT_EQ(editor.source(0).vertex, from.vertex);
  EXPECT_EQ(editor.source(0).weight, from.weight);
}

TEST(SurfaceEditor, CollapsingKeepsTheSurfaceManifoldOrIsRefused) {
  testing::TubeShape shape;
  shape.around = 3;  // the three vertices of a ring are joined, but no triangle lies between them
  shape.along = 6;
  shape.length = 20;
  const auto tube = testing::noisy_tube(shape);
  SurfaceEditor narrow(tube);
  EXPECT_FALSE(narrow.collapse(9, 10, {{9, 1.0}}));
  SurfaceEditor editor(hexagon());
  EXPECT_FALSE(editor.collapse(0, 1, {{0, 1.0}}));  // the boundary would move
  const int m = editor.split_edge(0, 1, 0.3);
  EXPECT_TRUE(editor.collapse(0, m, {{0, 1.0}}));
  const auto part = editor.whole();
  EXPECT_EQ(part.surface.triangles.rows(), 6);
  EXPECT_EQ(euler_number(part.surface.triangles), 1);
  EXPECT_NEAR(total_area(part.surface), 1.5 * std::sqrt(3.0), 1e-14);
}

TEST(SurfaceEditor, FlipsMakeAThinPairDelaunayButLeaveFixedEdges) {
  TriangleSurface kite;  // long edge 0-1, its two opposite corners close to it
  kite.points.resize(4, 3);
  kite.points << 0, 0, 0, 4, 0, 0, 2, 0.5, 0, 2, -0.5, 0;
  kite.triangles.resize(2, 3);
  kite.triangles << 0, 1, 2, 1, 0, 3;
  for (const bool fixed : {true, false}) {
    SurfaceEditor editor(kite);
    ASSERT_GE(editor.split_edge(0, 2, 0.5), 0);  // only what surgery touches may be flipped
    ASSERT_GE(editor.split_edge(0, 3, 0.5), 0);
    editor.improve([&](int, int) { return fixed; });
    EXPECT_EQ(editor.joined(2, 3), !fixed);
    EXPECT_EQ(euler_number(editor.whole().surface.triangles), 1);
    EXPECT_NEAR(total_area(editor.whole().surface), 2, 1e-14);
  }
}

}  // namespace
}  // namespace vasorod
