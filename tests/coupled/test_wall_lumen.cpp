#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

#include <vasorod/error.h>

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

// A wall under the pressure and the stretch it was seen at stays as it is.
TEST(WallLumen, TheSeenShapeDoesNotDrift) {
  for (const bool rigid : {true, false}) {
    HeldTube tube(40, 6, 0.6, 24, 24, 0.45);
    // Oval, bent, irregular.
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(-0.1, 0.1);
    for (int v = 0; v < tube.surface.points.rows(); ++v) {
      Vec3 p = tube.surface.points.row(v);
      const bool end = p.z() < 1e-9 || p.z() > 40 - 1e-9;
      p.x() *= 1.2;
      if (!end)
        for (int k = 0; k < 3; ++k) p[k] += uniform(random);
      const double turn = p.z() / 60;
      p = Vec3(60 - (60 - p.x()) * std::cos(turn), p.y(), (60 - p.x()) * std::sin(turn));
      tube.surface.points.row(v) = p;
    }
    tube.wall.rest = tube.surface;
    for (size_t t = 0; t < tube.wall.axis.size(); ++t) {
      double angle = 0;
      for (int k = 0; k < 3; ++k) {
        const Vec3 p = tube.surface.points.row(tube.surface.triangles(static_cast<int>(t), k));
        angle += std::atan2(p.z(), 60 - p.x()) / 3;
      }
      tube.wall.axis[t] = Vec3(std::sin(angle), 0, std::cos(angle));
    }
    HeldSection start = tube.start(), end = tube.end();
    end.rest.position = Vec3(60 - 60 * std::cos(40. / 60), 0, 60 * std::sin(40. / 60));
    if (!rigid) {
      start = soft(start);
      end = soft(end);
    }
    // A curved tube between soft ends flattens when it is stretched, which a linear displacement
    // does not follow far.
    tube.wall.axial_prestretch = rigid ? 1.08 : 1.01;
    const double pressure = 0.002;
    tube.wall.prestress_displacement = scan_displacement(tube.wall, {start, end}, pressure);
    const double load = tube.wall.prestress_displacement.rowwise().norm().maxCoeff();
    EXPECT_GT(load, 0.05);

    CoupledProblem problem;
    SurfaceBody body;
    body.name = "tube";
    body.rest = tube.surface;
    body.thickness = 0.6;
    body.offset = 0.3;
    body.k = {1, 0.1, 0.24};
    problem.surfaces.bodies.push_back(body);
    problem.vessels.push_back(std::make_unique<CoupledVessel>(
        CoupledVessel{tube.wall, {start, end}, LumenPressure{pressure, pressure}}));
    problem.carried = [](double) { return std::vector<CarriedBody>(1); };
    CoupledOptions options;
    options.tie_tolerance = 1e-10;
    const CoupledSolution solution = CoupledSolver(std::move(problem), options).solve();
    EXPECT_EQ(solution.status, Status::converged) << solution.brief_report();
    const Points drift = solution.surface.bodies[0].positions - tube.surface.points;
    EXPECT_LT(drift.rowwise().norm().maxCoeff(), 1e-9 * 6) << rigid;
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
