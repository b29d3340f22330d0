#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>

#include "geometry/triangle_surface.h"
#include "report/solids.h"

namespace vasorod {
namespace {

// The volume that outward triangles enclose.
double volume(const TriangleSurface& surface) {
  double sum = 0;
  for (Eigen::Index t = 0; t < surface.triangles.rows(); ++t) {
    const auto corner = surface.triangles.row(t);
    const Vec3 a = surface.points.row(corner[0]), b = surface.points.row(corner[1]),
               c = surface.points.row(corner[2]);
    sum += a.dot(b.cross(c));
  }
  return sum / 6;
}

TEST(Solids, ABallIsAClosedSphereWithItsFacesOutwards) {
  const TriangleSurface surface = ball(Vec3(5, -2, 1), 3);
  EXPECT_EQ(euler_number(surface.triangles), 2);
  EXPECT_TRUE(boundary_loops(surface.triangles).empty());
  for (const auto& point : surface.points.rowwise())
    EXPECT_NEAR((point.transpose() - Vec3(5, -2, 1)).norm(), 3, 1e-12);
  const double exact = 4.0 / 3 * M_PI * 27;
  EXPECT_LT(volume(surface), exact) << "its corners are on the sphere";
  EXPECT_GT(volume(surface), 0.9 * exact);
}

TEST(Solids, AStickGoesFromOnePlaceToTheOtherWithItsFacesOutwards) {
  const Vec3 from(1, 2, 3), to(2, 4, 5);
  const TriangleSurface surface = stick(from, to, 0.5);
  EXPECT_EQ(boundary_loops(surface.triangles).size(), 2u);
  const Points normals = vertex_normals(surface);
  const Vec3 along = (to - from).normalized();
  for (Eigen::Index i = 0; i < surface.points.rows(); ++i) {
    const Vec3 from_start = surface.points.row(i).transpose() - from,
               spoke = from_start - from_start.dot(along) * along;
    EXPECT_NEAR(spoke.norm(), 0.5, 1e-12);
    EXPECT_NEAR(from_start.dot(along), i < 8 ? 0 : 3, 1e-12);
    EXPECT_GT(normals.row(i).dot(spoke.transpose()), 0.4) << "of 0.5";
  }
}

}  // namespace
}  // namespace vasorod
