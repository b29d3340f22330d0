#include <gtest/gtest.h>

#include "report/camera.h"
#include "report/picture.h"
#include "report/solids.h"
#include "result/example_result.h"

namespace vasorod {
namespace {

TEST(Camera, HoldsEveryWantedPointAndTouchesTheMargin) {
  const TriangleSurface tube = test::tube(3, 40, 24, 20, {100, -50, 20});
  for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(1, 2, 3), Vec3(-1, 0.2, 0)})
    for (const double clear : {0.0, 0.2}) {
      const Camera camera =
          fit_camera({{&tube.points, true}}, direction, Vec3::UnitZ(), 1.5, clear);
      EXPECT_LT((camera.axes * camera.axes.transpose() - Mat3::Identity()).norm(), 1e-12);
      EXPECT_NEAR(camera.axes.determinant(), 1, 1e-12);
      double most = 0;
      for (Eigen::Index i = 0; i < tube.points.rows(); ++i) {
        const Vec3 at = camera.axes * (tube.points.row(i).transpose() - camera.centre);
        const double shrink = camera.distance / (camera.distance - at.z()) / camera.half_height;
        const double right = at.x() * shrink / 1.5 - camera.shift, up = at.y() * shrink;
        EXPECT_LT(std::abs(up), 1);
        EXPECT_GT(right, -1);
        EXPECT_LT(right, 1 - 2 * clear);
        most = std::max({most, std::abs(up), std::abs(at.x() * shrink / 1.5) / (1 - clear)});
      }
      EXPECT_GT(most, 0.9) << "the scene is smaller in the picture than it need be";
    }
}

TEST(Camera, LooksFromWhereNothingHidesWhatIsWanted) {
  const TriangleSurface wanted = test::tube(3, 30, 32, 60);
  for (const Vec3& side : {Vec3(12, 0, 0), Vec3(0, -12, 0), Vec3(-8, 8, 0)}) {
    const TriangleSurface wall = test::tube(7, 40, 64, 80, side + Vec3(0, 0, -5));
    const Vec3 direction =
        clearest_direction({{&wanted.points, true}, {&wall.points, false}}, Vec3::UnitZ());
    EXPECT_LT(direction.dot(side.normalized()), 0.5);
  }
}

TEST(Camera, FacesTheSpotsThatNothingHides) {
  const TriangleSurface vessel = test::tube(1, 10, 48, 60);
  const TriangleSurface wall = test::tube(1, 10, 48, 60, Vec3(4, 0, 0));
  const std::vector<Spot> spots{{Vec3(1, 0, 5), Vec3::UnitX(), 1},
                                {Vec3(0, 1, 5), Vec3::UnitY(), 0.1}};
  const std::vector<Seen> alone{{&vessel.points, true}};
  EXPECT_GT(facing_direction(alone, spots, Vec3::UnitZ()).x(), 0.9) << "the heavier one";
  const std::vector<Seen> beside{{&vessel.points, true}, {&wall.points, true}};
  const Vec3 turned = facing_direction(beside, spots, Vec3::UnitZ());
  EXPECT_LT(turned.x(), 0.97) << "a vessel stands before it";
  EXPECT_GT(turned.x(), 0) << "from behind neither is seen";
}

TEST(Camera, TheSpotsCountBesideWhatIsWanted) {
  const TriangleSurface vessel = test::tube(3, 30, 32, 60);
  const std::vector<Seen> scene{{&vessel.points, true}};
  for (const Vec3& side : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(-0.6, 0.8, 0)}) {
    const std::vector<Spot> spots{{Vec3(0, 0, 15) + 3 * side, side, 1}};
    EXPECT_GT(clearest_direction(scene, spots, Vec3::UnitZ()).dot(side), 0.6);
  }
  EXPECT_EQ(clearest_direction(scene, {}, Vec3::UnitZ()), clearest_direction(scene, Vec3::UnitZ()));
}

TEST(Camera, APointIsWhereItsDrawingIs) {
  const TriangleSurface body = test::tube(5, 40, 24, 20);
  Camera camera = fit_camera({{&body.points, true}}, Vec3(1, 2, 0.5), Vec3::UnitZ(), 4.0 / 3, 0.2);
  for (const Vec3& at : {Vec3(5, 0, 3), Vec3(-2, 4, 30), Vec3(0, 0, 20)}) {
    const TriangleSurface mark = ball(at, 0.5);
    DrawnSurface surface;
    surface.points = &mark.points;
    surface.triangles = &mark.triangles;
    const Picture picture = render({surface}, camera, 400, 300);
    Vec2 sum = Vec2::Zero();
    double count = 0;
    for (int row = 0; row < 300; ++row)
      for (int column = 0; column < 400; ++column)
        if (picture.rgba[4 * static_cast<std::size_t>(400 * row + column) + 3] > 0) {
          sum += Vec2(column + 0.5, row + 0.5);
          ++count;
        }
    ASSERT_GT(count, 0);
    EXPECT_LT((sum / count - pixel_of(camera, at, 400, 300)).norm(), 1);
  }
}

TEST(Camera, LaysTheLongestAxisLevel) {
  Points points(200, 3);
  for (Eigen::Index i = 0; i < 200; ++i) {
    const double t = 0.1 * static_cast<double>(i);
    points.row(i) << std::cos(7 * t), 10 * t, 4 * std::sin(5 * t);
  }
  const Vec3 up = level_up({{&points, true}});
  EXPECT_LT(std::abs(up.y()), 0.1);
  EXPECT_GT(up.z(), 0.9);
}

TEST(Camera, IsSoundForASceneWithoutExtent) {
  const Points nothing(0, 3), one = Points::Zero(1, 3);
  for (const Points* points : {&nothing, &one}) {
    const std::vector<Seen> scene{{points, true}};
    const Vec3 up = level_up(scene);
    const Camera camera = fit_camera(scene, clearest_direction(scene, up), up, 1.5);
    EXPECT_TRUE(camera.axes.allFinite());
    EXPECT_GT(camera.half_height, 0);
    EXPECT_TRUE(std::isfinite(camera.distance));
  }
}

}  // namespace
}  // namespace vasorod
