#include <gtest/gtest.h>

#include "geometry/triangle_surface.h"
#include "surface_file/check_surface.h"
#include "surface_file/clean_surface.h"
#include "surface_file/sample_surfaces.h"

namespace vasorod {
namespace {

double smallest_height(const TriangleSurface& surface) {
  const auto area = triangle_areas(surface);
  double smallest = 1e300;
  for (int t = 0; t < surface.triangles.rows(); ++t) {
    double longest = 0;
    for (int k = 0; k < 3; ++k)
      longest = std::max(longest, (surface.points.row(surface.triangles(t, k)) -
                                   surface.points.row(surface.triangles(t, (k + 1) % 3)))
                                      .norm());
    smallest = std::min(smallest, 2 * area[t] / longest);
  }
  return smallest;
}

// Splits triangle t at `point`.
void split(TriangleSurface& surface, int t, const Vec3& point) {
  const int added = static_cast<int>(surface.points.rows());
  surface.points.conservativeResize(added + 1, 3);
  surface.points.row(added) = point;
  const int a = surface.triangles(t, 0), b = surface.triangles(t, 1), c = surface.triangles(t, 2);
  const Eigen::Index last = surface.triangles.rows();
  surface.triangles.conservativeResize(last + 2, 3);
  surface.triangles.row(t) << a, b, added;
  surface.triangles.row(last) << b, c, added;
  surface.triangles.row(last + 1) << c, a, added;
}

Vec3 inside(const TriangleSurface& surface, int t, double a, double b, double c) {
  return a * surface.points.row(surface.triangles(t, 0)) +
         b * surface.points.row(surface.triangles(t, 1)) +
         c * surface.points.row(surface.triangles(t, 2));
}

class CleanSurface : public ::testing::Test {
 protected:
  void expect_clean(const TriangleSurface& before) {
    LoadedSurface loaded;
    loaded.surface = before;
    clean_surface(loaded);
    report = loaded.report;
    after = loaded.surface;
    EXPECT_NO_THROW(check_manifold("surface", after));
    EXPECT_EQ(euler_number(after.triangles), 0);
    EXPECT_EQ(boundary_loops(after.triangles).size(), 2U);
    EXPECT_GT(smallest_height(after), degenerate_fraction * mean_edge_length(after));
    EXPECT_NEAR(total_area(after) / total_area(before), 1, 1e-3);
  }
  SurfaceReport report;
  TriangleSurface after;
};

TEST_F(CleanSurface, LeavesASoundSurfaceAsItIs) {
  expect_clean(sample_tube());
  EXPECT_EQ(after.points, sample_tube().points);
  EXPECT_EQ(after.triangles, sample_tube().triangles);
  EXPECT_TRUE(report.lines().empty());
}

TEST_F(CleanSurface, CollapsesShortEdgesInsideAndOnAnEnd) {
  TriangleSurface surface = sample_tube();
  surface.points.row(300) = surface.points.row(301) + Eigen::RowVector3d(0, 0, 1e-5);
  surface.points.row(3) = surface.points.row(4) * (1 - 1e-7);
  expect_clean(surface);
  EXPECT_EQ(report.collapsed_edges, 2);
  EXPECT_EQ(after.points.rows(), surface.points.rows() - 2);
}

TEST_F(CleanSurface, CollapsesAnEdgeOfNoLength) {
  TriangleSurface surface = sample_tube();
  split(surface, 333, surface.points.row(surface.triangles(333, 0)));
  expect_clean(surface);
  EXPECT_EQ(after.points, sample_tube().points);
}

TEST_F(CleanSurface, TurnsTheLongEdgeOfAFlatTriangle) {
  TriangleSurface surface = sample_tube();
  split(surface, 333, inside(surface, 333, 0.5, 0.5 - 1e-6, 1e-6));
  expect_clean(surface);
  EXPECT_EQ(report.collapsed_edges, 0);
  EXPECT_EQ(report.straightened, 1);
  EXPECT_EQ(after.points.rows(), surface.points.rows());
}

TEST_F(CleanSurface, RemovesAFlatTriangleOnAnEnd) {
  TriangleSurface surface = sample_tube();
  ASSERT_EQ(surface.triangles.row(0),
            Eigen::RowVector3i(0, 1, 24));  // its edge 0-1 lies on the end
  split(surface, 0, inside(surface, 0, 0.5, 0.5 - 1e-6, 1e-6));
  expect_clean(surface);
  EXPECT_EQ(report.straightened, 1);
  EXPECT_EQ(boundary_loops(after.triangles)[0].size(), 25U);
}

TEST_F(CleanSurface, CuresManyAtOnce) {
  TriangleSurface surface = sample_tube();
  for (int t = 100; t < 700; t += 7) {
    const double e = 1e-6 * (1 + t % 5);
    split(surface, t,
          t % 2 == 0 ? inside(surface, t, 1 - 2 * e, e, e) : inside(surface, t, 0.3, 0.7 - e, e));
  }
  expect_clean(surface);
}

}  // namespace
}  // namespace vasorod
