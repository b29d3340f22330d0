#include <algorithm>
#include <gtest/gtest.h>
#include <stdexcept>

#include "geometry/noisy_tube.h"
#include "geometry/slit.h"
#include "geometry/triangle_surface.h"

namespace vasorod {
namespace {

TEST(Slit, OpensARowOfATubeWithTheFirstBankOnTheLeftOfThePath) {
  testing::TubeShape shape;
  shape.around = 12;
  shape.along = 8;
  const auto tube = testing::noisy_tube(shape);
  SurfaceEditor editor(tube);
  const std::vector<int> path{4 * 12, 4 * 12 + 1, 4 * 12 + 2,
                              4 * 12 + 3};  // counter-clockwise around the tube
  const auto slit = open_slit(editor, path);
  ASSERT_EQ(slit.rim.size(), 6U);
  EXPECT_EQ(slit.other_tip, 3);
  const auto open = editor.whole().surface;
  EXPECT_EQ(euler_number(open.triangles), -1);
  EXPECT_EQ(open.points.rows(), tube.points.rows() + 2);
  const auto loops = boundary_loops(open.triangles);
  ASSERT_EQ(loops.size(), 3U);
  EXPECT_EQ(std::count(loops.begin(), loops.end(), slit.rim), 1);
  // The left of the path is above: the triangles there keep the first bank.
  for (const int t : editor.triangles_of(slit.rim[1])) {
    double mean = 0;
    for (const int v : editor.triangle(t)) mean += editor.point(v).z() / 3;
    EXPECT_GT(mean, editor.point(path[1]).z());
  }
}

TEST(Slit, APathThatIsNoInnerPathIsABug) {
  const auto tube = testing::noisy_tube({});
  SurfaceEditor editor(tube);
  EXPECT_THROW(open_slit(editor, {30, 31}), std::logic_error);
  EXPECT_THROW(open_slit(editor, {0, 1, 2}), std::logic_error);     // an end
  EXPECT_THROW(open_slit(editor, {90, 50, 51}), std::logic_error);  // 90 is not joined to 50
  EXPECT_THROW(open_slit(editor, {51, 50, 90}), std::logic_error);
}

}  // namespace
}  // namespace vasorod
