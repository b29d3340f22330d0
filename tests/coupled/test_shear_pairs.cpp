#include <gtest/gtest.h>

#include "coupled/held_tubes.h"
#include "geometry/triangle_surface.h"
#include "wall/shear_pairs.h"
#include "wall/walls.h"

namespace vasorod {
namespace {

using namespace testing;

// Shifts all but the end vertices along the wall by up to a quarter of their spacing.
void shift_vertices(HeldTube& t) {
  const Eigen::VectorXd random = noise(2 * t.surface.points.rows(), 5);
  for (int i = t.tube.around; i < t.surface.points.rows() - t.tube.around; ++i) {
    auto p = t.surface.points.row(i);
    const double angle = std::atan2(p.y(), p.x()) + 0.25 * 2 * M_PI / t.tube.around * random[2 * i];
    p << t.tube.radius * std::cos(angle), t.tube.radius * std::sin(angle),
        p.z() + 0.25 * t.tube.length / t.tube.along * random[2 * i + 1];
  }
  t.wall.rest = t.surface;
}

TEST(ShearPairs, PartnersAreNeighboursAndEachOthers) {
  for (const bool shifted : {false, true}) {
    HeldTube tube(60, 6, 0.6, 25, 37);
    if (shifted) shift_vertices(tube);
    const std::vector<Edge> edges = edges_of(tube.surface.triangles);
    const auto triangles = static_cast<int>(tube.surface.triangles.rows());
    const std::vector<int> partner = shear_pairs(tube.surface);
    int alone = 0;
    for (int t = 0; t < triangles; ++t) {
      const int other = partner[static_cast<size_t>(t)];
      if (other < 0) {
        ++alone;
        continue;
      }
      EXPECT_EQ(partner[static_cast<size_t>(other)], t);
      EXPECT_TRUE(std::any_of(edges.begin(), edges.end(), [&](const Edge& e) {
        return (e.triangle[0] == t && e.triangle[1] == other) ||
               (e.triangle[1] == t && e.triangle[0] == other);
      }));
    }
    EXPECT_LE(alone, shifted ? triangles / 50 : 0);
  }
}

TEST(ShearPairs, ASingleTriangleStaysAlone) {
  TriangleSurface one;
  one.points = Points::Identity(3, 3);
  one.triangles.resize(1, 3);
  one.triangles << 0, 1, 2;
  EXPECT_EQ(shear_pairs(one), std::vector<int>{-1});
}

// A slightly bent tube whose shear modulus is a hundred times that of an isotropic wall: the moment
// is still E I k. Without pairs it is 46 % too large with 24 vertices around (shifted: 32 %).
TEST(ShearPairs, AWallStiffInShearBendsLikeABeam) {
  for (const bool shifted : {false, true}) {
    HeldTube tube(100, 10, 1, 24, 44);
    if (shifted) shift_vertices(tube);
    tube.wall.material = {Law::biot, 1, 1, 100 / 2.6, 0.3, 0};
    const double curvature = 1e-5;
    Vec6 strain = Vec6::Zero();
    strain[4] = curvature;
    const CoupledSolution solution =
        CoupledSolver(bent(tube, strain, tube.start(), tube.end())).solve();
    ASSERT_EQ(solution.status, Status::converged);
    const double second_moment = M_PI * 1000 * (1 + 0.0025);  // r^3 t (1 + t^2 / 4 r^2)
    const double ratio = solution.sections[0][1].moment.y() / (second_moment * curvature);
    EXPECT_NEAR(ratio, 1, shifted ? 0.05 : 0.005);
  }
}

}  // namespace
}  // namespace vasorod
