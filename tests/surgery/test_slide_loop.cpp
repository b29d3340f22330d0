#include <gtest/gtest.h>

#include "data/index.h"
#include "geometry/noisy_tube.h"
#include "geometry/triangle_surface.h"
#include "surgery/slide_loop.h"
#include "surgery/surface_checks.h"

namespace vasorod {
namespace {

// The first end of a tube as a loop.
struct End {
  TriangleSurface tube;
  std::vector<int> loop;
  LoopCurve curve;
};

End end_of(const testing::TubeShape& shape) {
  const auto tube = testing::noisy_tube(shape);
  for (const auto& loop : boundary_loops(tube.triangles)) {
    if (loop.front() >= shape.around) continue;
    Points points(static_cast<Eigen::Index>(loop.size()), 3);
    for (size_t k = 0; k < loop.size(); ++k)
      points.row(static_cast<Eigen::Index>(k)) = tube.points.row(loop[k]);
    return {tube, loop, LoopCurve(points)};
  }
  throw std::logic_error("no end");
}

TEST(SlideLoop, VerticesReachTheirPlacesAndNewOnesStandBetween) {
  testing::TubeShape shape;
  shape.jitter = 0.25;
  const End end = end_of(shape);
  // Every vertex slides by 0.45 of an edge, and a new one stands in every third edge.
  std::vector<LoopTarget> targets;
  const double edge = 1.0 / shape.around;
  for (int k = 0; k < shape.around; ++k) {
    targets.push_back({k, end.curve.position(k) / end.curve.length() + 0.45 * edge, 0});
    if (k % 3 == 0) targets.push_back({-1, 0, 0.25});
  }
  SurfaceEditor editor(end.tube);
  const SlidLoop slid = slide_loop(editor, end.loop, end.curve, targets);
  ASSERT_TRUE(slid.refused.empty());
  ASSERT_EQ(slid.vertices.size(), targets.size());
  const auto after = editor.whole();
  ASSERT_TRUE(testing::oriented(after.surface.triangles));
  const auto point = [&](size_t k) {
    return Vec3(after.surface.points.row(slid.vertices[k % targets.size()]));
  };
  for (size_t k = 0; k < targets.size(); ++k) {
    if (targets[k].corner >= 0) {
      EXPECT_EQ(slid.vertices[k], end.loop[index(targets[k].corner)]);
      EXPECT_NEAR((point(k) - end.curve.at(targets[k].fraction)).norm(), 0, 1e-12);
    } else {
      EXPECT_NEAR((point(k) - 0.75 * point(k - 1) - 0.25 * point(k + 1)).norm(), 0, 1e-12);
    }
  }
  // The new loop is the surface's, in the targets' order.
  auto loop = slid.vertices;
  std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
  const auto loops = boundary_loops(after.surface.triangles);
  EXPECT_EQ(std::count(loops.begin(), loops.end(), loop), 1);
  EXPECT_LT(testing::source_error(end.tube, after.surface, after.sources), 1e-11);
  EXPECT_GT(testing::made_by_surgery(end.tube, after.surface, after.sources).smallest_angle, 5);
}

TEST(SlideLoop, AVertexThatItsTrianglesDoNotLetGoIsNamed) {
  const End end = end_of({});
  std::vector<LoopTarget> targets;
  for (int k = 0; k < end.curve.count(); ++k)
    targets.push_back({k, end.curve.position(k) / end.curve.length(), 0});
  // Vertex 5 is to stand almost on vertex 6.
  targets[5].fraction = targets[6].fraction - 0.001 / end.curve.count();
  SurfaceEditor editor(end.tube);
  const SlidLoop slid = slide_loop(editor, end.loop, end.curve, targets);
  EXPECT_EQ(slid.refused, std::vector<int>{5});
  EXPECT_TRUE(slid.vertices.empty());
}

}  // namespace
}  // namespace vasorod
