#include <gtest/gtest.h>

#include "geometry/isoline_path.h"
#include "geometry/noisy_tube.h"
#include "geometry/triangle_surface.h"

namespace vasorod {
namespace {

// A flat sheet of irregular triangles, x from 0 to 10, y from 0 to 6, with isolines along x.
TriangleSurface sheet(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-0.25, 0.25);
  TriangleSurface s;
  s.points = Points::Zero(11 * 7, 3);
  for (int j = 0; j < 7; ++j)
    for (int i = 0; i < 11; ++i) {
      const bool inside = i > 0 && i < 10 && j > 0 && j < 6;
      s.points.row(j * 11 + i) << i + (inside ? uniform(random) : 0),
          j + (inside ? uniform(random) : 0), 0;
    }
  s.triangles.resize(120, 3);
  int t = 0;
  for (int j = 0; j < 6; ++j)
    for (int i = 0; i < 10; ++i) {
      const int a = j * 11 + i;
      s.triangles.row(t++) << a, a + 1, a + 11;
      s.triangles.row(t++) << a + 1, a + 12, a + 11;
    }
  return s;
}

IsolineRequest along_x(const TriangleSurface& s, int triangle, double length) {
  IsolineRequest request;
  request.across = s.points.col(1);
  request.along = s.points.col(0);
  request.triangle = triangle;
  request.barycentric = {0.2, 0.5, 0.3};
  request.length = length;
  request.allowed = [](int) { return true; };
  return request;
}

TEST(IsolinePath, OnAFlatSheetItIsTheStraightSegmentOfExactlyThatLength) {
  int exact = 0;
  for (unsigned seed = 1; seed <= 50; ++seed) {
    const auto s = sheet(seed);
    const int triangle = 2 * (10 * static_cast<int>(1 + seed % 4) + 4) + static_cast<int>(seed % 2);
    const auto request = along_x(s, triangle, 3.0 + 0.07 * seed);
    Vec3 start = Vec3::Zero();
    for (int k = 0; k < 3; ++k)
      start += request.barycentric[k] * s.points.row(s.triangles(triangle, k)).transpose();
    SurfaceEditor editor(s);
    const auto path = embed_isoline(editor, request);
    ASSERT_EQ(path.end, IsolineEnd::reached);
    const Vec3 at_start = editor.point(path.vertices[static_cast<size_t>(path.start)]);
    EXPECT_LT((at_start - start).norm(), 0.2);
    for (size_t k = 0; k < path.vertices.size(); ++k) {
      EXPECT_NEAR(editor.point(path.vertices[k]).y(), at_start.y(), 1e-9);
      if (k > 0) {
        EXPECT_TRUE(editor.joined(path.vertices[k - 1], path.vertices[k]));
        EXPECT_GT(editor.point(path.vertices[k]).x(), editor.point(path.vertices[k - 1]).x());
      }
    }
    EXPECT_NEAR(editor.point(path.vertices.back()).x() - at_start.x(), path.forward, 1e-12);
    EXPECT_NEAR(at_start.x() - editor.point(path.vertices.front()).x(), path.backward, 1e-12);
    if (std::abs(path.forward + path.backward - request.length) < 1e-9) ++exact;
    EXPECT_NEAR(total_area(editor.whole().surface), 60, 1e-12);
    EXPECT_EQ(euler_number(editor.whole().surface.triangles), 1);
  }
  EXPECT_GE(exact, 49);
}

TEST(IsolinePath, SaysWhyItStops) {
  const auto s = sheet(3);
  SurfaceEditor one(s);
  EXPECT_EQ(embed_isoline(one, along_x(s, 48, 40)).end, IsolineEnd::boundary);
  auto request = along_x(s, 48, 8);
  request.allowed = [&](int v) { return s.points(v, 0) < 7; };
  SurfaceEditor two(s);
  const auto path = embed_isoline(two, request);
  EXPECT_EQ(path.end, IsolineEnd::forbidden);
  EXPECT_LT(path.stopped_at.x(), 7.5);
}

}  // namespace
}  // namespace vasorod
