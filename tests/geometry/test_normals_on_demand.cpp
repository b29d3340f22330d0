#include <gtest/gtest.h>

#include "geometry/noisy_tube.h"
#include "geometry/normals_on_demand.h"
#include "geometry/triangle_surface.h"

namespace vasorod {
namespace {

using namespace testing;

TEST(NormalsOnDemand, AreThoseOfTheWholeSurfaceWhereverItMoves) {
  TriangleSurface surface = noisy_tube({.bend = 1, .jitter = 0.2});
  ClosestPoint wall(surface);
  for (int step = 0; step < 3; ++step) {
    NormalsOnDemand normal(wall);
    const Points expected = vertex_normals(surface);
    for (int v = static_cast<int>(surface.points.rows()) - 1; v >= 0; v -= 2)
      for (int again = 0; again < 2; ++again)
        EXPECT_EQ(Vec3(normal(v)), Vec3(expected.row(v))) << v << " in step " << step;
    surface.points.col(0) += 0.1 * surface.points.col(2).cwiseProduct(surface.points.col(1));
    wall.refit(surface.points);
  }
}

TEST(NormalsOnDemand, AreZeroWithoutTriangles) {
  TriangleSurface surface;
  surface.points = Points::Random(4, 3);
  surface.triangles.resize(1, 3);
  surface.triangles << 0, 1, 2;
  surface.points.row(2) = surface.points.row(1);
  const ClosestPoint wall(surface);
  NormalsOnDemand normal(wall);
  EXPECT_EQ(normal(0), Vec3::Zero()) << "of a triangle without area";
  EXPECT_EQ(normal(3), Vec3::Zero());
}

}  // namespace
}  // namespace vasorod
