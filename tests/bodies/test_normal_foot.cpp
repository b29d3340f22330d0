#include <gtest/gtest.h>

#include "bodies/normal_foot.h"
#include "geometry/triangle_surface.h"
#include "paper/paper_tubes.h"

namespace vasorod {
namespace {

using namespace testing;

struct Wall {
  explicit Wall(TriangleSurface given)
      : surface(std::move(given)),
        normals(vertex_normals(surface)),
        finder(surface),
        normal_of(finder) {}
  NormalFoot foot(const Vec3& p) const {
    return normal_foot(finder, normal_of, p, finder.query(p));
  }
  Vec3 point(const NormalFoot& f) const {
    Vec3 y = Vec3::Zero();
    for (int k = 0; k < 3; ++k)
      y += f.weight[k] * surface.points.row(surface.triangles(f.triangle, k)).transpose();
    return y;
  }
  TriangleSurface surface;
  Points normals;
  ClosestPoint finder;
  mutable NormalsOnDemand normal_of;
};

// A tube of radius 1 whose middle is dented from +x: convex around, concave along.
TriangleSurface dented() {
  TriangleSurface t = tube(1, 6, 24, 21);
  for (Eigen::Index i = 0; i < t.points.rows(); ++i)
    t.points(i, 0) -=
        0.4 * std::exp(-std::pow(t.points(i, 2) - 3, 2)) * std::max(0.0, t.points(i, 0));
  return t;
}

// The oracle is the definition: points are placed above known points of the wall.
TEST(NormalFoot, FindsThePlaceAPointWasPutOver) {
  const Wall wall(dented());
  for (int triangle = 150; triangle < 700; triangle += 7)
    for (const Vec3& weight :
         {Vec3(0.3, 0.5, 0.2), Vec3(0.97, 0.02, 0.01), Vec3(0.001, 0.499, 0.5)})
      for (const double d : {-0.2, 0.0, 0.1, 0.3}) {
        Vec3 y = Vec3::Zero(), n = Vec3::Zero();
        for (int k = 0; k < 3; ++k) {
          const int v = wall.surface.triangles(triangle, k);
          y += weight[k] * wall.surface.points.row(v).transpose();
          n += weight[k] * wall.normals.row(v).transpose();
        }
        const NormalFoot foot = wall.foot(y + d * n);
        EXPECT_LT((wall.point(foot) - y).norm(), 1e-9) << triangle << " " << d;
        EXPECT_NEAR(foot.height, d * n.norm(), 1e-9);
        EXPECT_LT((foot.normal - n).norm(), 1e-9);
      }
}

TEST(NormalFoot, PassesADentsEdgeWithoutTheClosestPointsJump) {
  const Wall wall(dented());
  const double height = 0.3, step = 1e-4;
  double foot_moves = 0, closest_moves = 0;
  Vec3 foot_before = Vec3::Zero(), closest_before = Vec3::Zero();
  for (int i = 0; i < 4000; ++i) {
    const Vec3 p(0.65 + height, 0.01, 2.8 + i * step);
    const Vec3 closest = wall.finder.query(p).point, foot = wall.point(wall.foot(p));
    if (i > 0) {
      foot_moves = std::max(foot_moves, (foot - foot_before).norm());
      closest_moves = std::max(closest_moves, (closest - closest_before).norm());
    }
    foot_before = foot;
    closest_before = closest;
  }
  EXPECT_LT(foot_moves, 10 * step);
  EXPECT_GT(closest_moves, 100 * step);
}

// In a narrow groove the walls' normals cross: above some points of the wall there is no foot
// nearby.
TEST(NormalFoot, IsTheClosestPointWhereThereIsNone) {
  TriangleSurface groove;
  groove.points.resize(6, 3);
  groove.points << 0, -1, 0, 0, 1, 0, 0.5, -1, 2, 0.5, 1, 2, -0.5, -1, 2, -0.5, 1, 2;
  groove.triangles.resize(4, 3);
  groove.triangles << 0, 2, 1, 2, 3, 1, 0, 1, 4, 4, 1, 5;
  const Wall wall(groove);
  int feet = 0, closest_points = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3 p(0.4 * std::sin(12.9 * i), 0.9 * std::sin(78.2 * i), 1 + std::sin(37.7 * i));
    const ClosestPoint::Hit closest = wall.finder.query(p);
    if (closest.on_boundary) continue;
    const NormalFoot foot = wall.foot(p);
    const Vec3 left = p - wall.point(foot) - foot.height * foot.normal.normalized();
    if (left.norm() < 1e-9) {
      ++feet;
    } else {
      ++closest_points;
      EXPECT_LT((wall.point(foot) - closest.point).norm(), 1e-12);
    }
    EXPECT_LT(std::abs(foot.height), 1.5 * std::abs(closest.signed_distance) + 1e-9);
  }
  EXPECT_GT(feet, 100);
  EXPECT_GT(closest_points, 0);
}

}  // namespace
}  // namespace vasorod
