#include <algorithm>
#include <gtest/gtest.h>

#include "geometry/level_set_split.h"
#include "geometry/noisy_tube.h"
#include "geometry/plane_section.h"
#include "geometry/triangle_surface.h"

namespace vasorod {
namespace {

std::vector<double> heights(const TriangleSurface& surface, double level) {
  std::vector<double> f;
  for (int v = 0; v < surface.points.rows(); ++v) f.push_back(surface.points(v, 2) - level);
  return f;
}

TEST(LevelSetSplit, TheCycleLiesOnTheLevelWithTheUpperPartOnItsLeft) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    testing::TubeShape shape;
    shape.jitter = 0.25;
    shape.seed = seed;
    const auto tube = testing::noisy_tube(shape);
    const double level = 10 + 0.47 * seed;
    const auto curves = plane_sections(tube, {0, 0, level}, Vec3::UnitZ());
    ASSERT_EQ(curves.size(), 1U);
    SurfaceEditor editor(tube);
    const auto cycle = split_level_set(editor, heights(tube, level), curves[0].edges);
    ASSERT_GE(cycle.size(), 10U);
    for (size_t k = 0; k < cycle.size(); ++k) {
      EXPECT_NEAR(editor.point(cycle[k]).z(), level, 1e-12);
      const int left = editor.triangle_left_of(cycle[k], cycle[(k + 1) % cycle.size()]);
      ASSERT_GE(left, 0);
      const auto& corners = editor.triangle(left);
      EXPECT_GT(editor.point(corners[0]).z() + editor.point(corners[1]).z() +
                    editor.point(corners[2]).z(),
                3 * level + 1e-6);
    }
    EXPECT_EQ(euler_number(editor.whole().surface.triangles), 0);
  }
}

TEST(LevelSetSplit, ARowOfVerticesOnTheLevelIsTheCycleItself) {
  const auto tube = testing::noisy_tube({});
  const double level = tube.points(24 * 10, 2);  // exactly a row's
  const auto curves = plane_sections(tube, {0, 0, level}, Vec3::UnitZ());
  SurfaceEditor editor(tube);
  auto cycle = split_level_set(editor, heights(tube, level), curves[0].edges);
  std::sort(cycle.begin(), cycle.end());
  ASSERT_EQ(cycle.size(), 24U);
  for (int k = 0; k < 24; ++k) EXPECT_EQ(cycle[static_cast<size_t>(k)], 240 + k);
  EXPECT_EQ(editor.whole().surface.points.rows(), tube.points.rows());
}

}  // namespace
}  // namespace vasorod
