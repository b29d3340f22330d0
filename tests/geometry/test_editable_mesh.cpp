#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>
#include <set>

#include "geometry/editable_mesh.h"
#include "geometry/triangle_surface.h"
#include "straight_tube.h"

namespace vasorod {
namespace {

TriangleSurface tube(double length = 10, int along = 8) {
  return tube_surface(testing::straight_tube(length, 3, 12, along));
}

// The surface of the triangles that are alive.
TriangleSurface living(const EditableMesh& mesh, const TriangleSurface& input) {
  TriangleSurface all = input;
  mesh.store(all);
  return {all.points, all.triangles(mesh.alive_triangles(), Eigen::all)};
}

int euler_characteristic(const TriangleSurface& surface) {
  const std::set<int> used(surface.triangles.data(),
                           surface.triangles.data() + surface.triangles.size());
  return static_cast<int>(used.size()) - static_cast<int>(edges_of(surface.triangles).size()) +
         static_cast<int>(surface.triangles.rows());
}

TEST(EditableMesh, RingsRunCounterClockwiseAndEndsAreBoundaries) {
  const TriangleSurface surface = tube();
  const EditableMesh mesh(surface);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const bool at_end = v < 12 || v >= 12 * 8;
    EXPECT_EQ(mesh.on_boundary(v), at_end) << v;
    const std::vector<int> ring = mesh.ring(v);
    ASSERT_EQ(ring.size(), at_end ? 4U : 6U) << v;
    const Vec3 outward(mesh.point(v).x(), mesh.point(v).y(), 0);
    for (size_t k = 0; k + 1 < ring.size(); ++k) {
      EXPECT_GE(mesh.triangle_left_of(v, ring[k]), 0);
      const Vec3 turn =
          (mesh.point(ring[k]) - mesh.point(v)).cross(mesh.point(ring[k + 1]) - mesh.point(v));
      EXPECT_GT(turn.dot(outward), 0) << v;
    }
  }
}

TEST(EditableMesh, CollapsesKeepTopologyUntilNoneIsAllowed) {
  const TriangleSurface surface = tube();
  EditableMesh mesh(surface);
  ASSERT_EQ(euler_characteristic(surface), 0);  // an open tube
  int collapsed = 0;
  for (int t = 0; t < mesh.triangle_count(); ++t)
    for (int k = 0; k < 3 && mesh.alive(t); ++k) {
      const int a = mesh.corner(t, k), b = mesh.corner(t, k + 1);
      if (!mesh.may_collapse(a, b)) continue;
      mesh.collapse(a, b);
      ++collapsed;
      const TriangleSurface now = living(mesh, surface);
      ASSERT_EQ(euler_characteristic(now), 0) << collapsed;
      ASSERT_EQ(boundary_loops(now.triangles).size(), 2U) << collapsed;
    }
  EXPECT_GT(collapsed, 50);
}

TEST(EditableMesh, AnEdgeAcrossTheTubeIsNotCollapsed) {
  // One strip of triangles: every inner edge joins the two ends.
  const TriangleSurface surface = tube(3, 1);
  const EditableMesh mesh(surface);
  for (int t = 0; t < mesh.triangle_count(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int a = mesh.corner(t, k), b = mesh.corner(t, k + 1);
      EXPECT_EQ(mesh.may_collapse(a, b), mesh.on_edge(a, b).size() == 1) << a << " " << b;
    }
}

TEST(EditableMesh, ATurnedEdgeKeepsAreaOnAPlaneAndRefusesWhatWouldBeFlat) {
  TriangleSurface square;
  square.points.resize(4, 3);
  square.points << 0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0;
  square.triangles.resize(2, 3);
  square.triangles << 0, 1, 2, 0, 2, 3;
  EditableMesh mesh(square);
  EXPECT_FALSE(mesh.turn(0, 1, 0, 2, 1.5));  // both would have a height of sqrt(2)
  EXPECT_TRUE(mesh.joined(0, 2));
  EXPECT_TRUE(mesh.turn(0, 1, 0, 2, 1.4));
  EXPECT_TRUE(mesh.joined(1, 3));
  EXPECT_FALSE(mesh.joined(0, 2));
  EXPECT_NEAR((mesh.normal(0) + mesh.normal(1)).z(), 8, 1e-14);
  EXPECT_NEAR(mesh.height(0), std::sqrt(2.0), 1e-14);
}

}  // namespace
}  // namespace vasorod
