#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "coupled/held_tubes.h"
#include "coupled/wall_lumen.h"

namespace vasorod {
namespace {

using namespace testing;

CoupledProblem pressed(const HeldTube& tube, LumenPressure pressure, HeldSection start,
                       HeldSection end) {
  CoupledProblem problem = bent(tube, Vec6::Zero(), std::move(start), std::move(end));
  problem.vessels[0]->pressure = pressure;
  return problem;
}

double mean_radius(const Points& points) {
  return points.leftCols<2>().rowwise().norm().mean();
}

// Lame's thick tube in plane strain. The mid-wall moves by u(R), and the held ends feel
// 2 nu p pi r_i^2.
TEST(WallLumen, ATubeWidensAsLameSays) {
  const double radius = 10, t = 1, pressure = 1e-6;
  for (const double nu : {0.0, 0.3, 0.5}) {
    const HeldTube tube(20, radius, t, 96, 24, nu);
    const auto solution =
        CoupledSolver(pressed(tube, {0, pressure}, soft(tube.start()), soft(tube.end()))).solve();
    EXPECT_EQ(solution.status, Status::converged);
    const double a = radius - t / 2, b = radius + t / 2;
    const double exact =
        (1 + nu) * pressure * a * a / (b * b - a * a) * ((1 - 2 * nu) * radius + b * b / radius);
    const double found =
        mean_radius(solution.surface.bodies[0].positions) - mean_radius(tube.surface.points);
    EXPECT_NEAR(found / exact, 1, 0.01) << nu;
    const double axial = 2 * nu * pressure * std::numbers::pi * a * a;
    EXPECT_NEAR(solution.sections[0][1].force.z(), axial,
                0.01 * pressure * std::numbers::pi * a * a)
        << nu;
    EXPECT_LT(solution.surface.bodies[0].residual, 1e-6);
  }
}

// A ring collapses at p = 3 D / R^3. Free edges are softer: a tube as long as its radius comes
// within 5 %.
TEST(WallLumen, ARingCollapsesAtItsPressure) {
  const double radius = 10, t = 0.5, nu = 0.3;
  const HeldTube tube(10, radius, t, 48, 10, nu);
  const double critical = 3 * t * t * t / (12 * (1 - nu * nu)) / (radius * radius * radius);
  for (const double share : {0.95, 1.05}) {
    CoupledOptions options;
    options.times = {0.5, 1};
    const auto solution =
        CoupledSolver(pressed(tube, {0, -share * critical}, soft(tube.start()), soft(tube.end())),
                      options)
            .solve();
    EXPECT_EQ(solution.status, share < 1 ? Status::converged : Status::buckled)
        << share << solution.brief_report();
  }
}

}  // namespace
}  // namespace vasorod
