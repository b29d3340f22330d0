#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <random>

#include <vasorod/error.h>

#include "coupled/held_tubes.h"
#include "coupled/scan_displacement.h"

namespace vasorod {
namespace {

using namespace testing;

constexpr double any = std::numeric_limits<double>::infinity();

// A bent tube, of which `rough` 1 is oval and irregular.
struct SomeVessel : HeldTube {
  HeldSection first, last;

  SomeVessel(bool rigid, double rough) : HeldTube(40, 6, 0.6, 24, 24, 0.45) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(-0.1, 0.1);
    for (int v = 0; v < surface.points.rows(); ++v) {
      Vec3 p = surface.points.row(v);
      const bool at_end = p.z() < 1e-9 || p.z() > 40 - 1e-9;
      p.x() *= 1 + 0.2 * rough;
      if (!at_end)
        for (int k = 0; k < 3; ++k) p[k] += rough * uniform(random);
      const double turn = p.z() / 60;
      p = Vec3(60 - (60 - p.x()) * std::cos(turn), p.y(), (60 - p.x()) * std::sin(turn));
      surface.points.row(v) = p;
    }
    wall.rest = surface;
    for (size_t t = 0; t < wall.axis.size(); ++t) {
      double angle = 0;
      for (int k = 0; k < 3; ++k) {
        const Vec3 p = surface.points.row(surface.triangles(static_cast<int>(t), k));
        angle += std::atan2(p.z(), 60 - p.x()) / 3;
      }
      wall.axis[t] = Vec3(std::sin(angle), 0, std::cos(angle));
    }
    first = start();
    last = end();
    last.rest.position = Vec3(60 - 60 * std::cos(40. / 60), 0, 60 * std::sin(40. / 60));
    if (!rigid) {
      first = soft(first);
      last = soft(last);
    }
  }
};

// The wall between the sections, from its scan's pressure to the one after.
CoupledSolution solve(const HeldTube& tube, const std::vector<HeldSection>& sections,
                      LumenPressure pressure, std::vector<double> times = {1}) {
  CoupledProblem problem;
  SurfaceBody body;
  body.name = "tube";
  body.rest = tube.surface;
  body.thickness = tube.wall.thickness.mean();
  body.offset = body.thickness / 2;
  body.k = {1, 0.1, 0.24};
  problem.surfaces.bodies.push_back(body);
  problem.vessels.push_back(
      std::make_unique<CoupledVessel>(CoupledVessel{tube.wall, sections, pressure}));
  problem.carried = [](double) { return std::vector<CarriedBody>(1); };
  CoupledOptions options;
  options.tie_tolerance = 1e-10;
  options.times = std::move(times);
  CoupledSolution solution = CoupledSolver(std::move(problem), options).solve();
  EXPECT_EQ(solution.status, Status::converged) << solution.brief_report();
  return solution;
}

Points moved(const HeldTube& tube, const CoupledSolution& solution) {
  return solution.surface.bodies[0].positions - tube.surface.points;
}

double largest(const Points& displacement) {
  return displacement.rowwise().norm().maxCoeff();
}

// Gives the wall the stress of its scan.
ScanDisplacement see(HeldTube& tube, const std::vector<HeldSection>& sections, double pressure,
                     double largest_linear) {
  ScanDisplacement found = scan_displacement(tube.wall, sections, pressure, largest_linear);
  tube.wall.prestress_displacement = found.points;
  tube.wall.from_stress_free_shape = found.from_stress_free_shape;
  return found;
}

// A wall under the pressure and the stretch it was seen at stays as it is.
TEST(ScanDisplacement, TheSeenShapeDoesNotDrift) {
  for (const bool rigid : {true, false}) {
    SomeVessel tube(rigid, 1);
    // A curved tube between soft ends flattens when it is stretched, which a linear displacement
    // does not follow far.
    tube.wall.axial_prestretch = rigid ? 1.08 : 1.01;
    const double pressure = 0.002;
    const ScanDisplacement found = see(tube, {tube.first, tube.last}, pressure, any);
    EXPECT_FALSE(found.steps);
    EXPECT_GT(largest(found.points), 0.05);
    const auto solution = solve(tube, {tube.first, tube.last}, {pressure, pressure});
    EXPECT_LT(largest(moved(tube, solution)), 1e-9 * 6) << rigid;
  }
}

// Under loads that widen and stretch it by a fifth too, from the shape without stress. (What a
// section lacks of being round, a pressure of 60 times that of its collapse has made 60 times less:
// a rough vessel has no shape without stress there.)
TEST(ScanDisplacement, NorFromAFarShapeWithoutStress) {
  for (const Law law : {Law::biot, Law::svk, Law::neo_hookean})
    for (const bool rigid : {true, false}) {
      SomeVessel tube(rigid, 0.03);
      tube.wall.material.law = law;
      tube.wall.axial_prestretch = rigid ? 1.1 : 1.05;
      const double pressure = 0.02;
      const ScanDisplacement found = see(tube, {tube.first, tube.last}, pressure, 0.1);
      EXPECT_GT(found.steps, 0) << to_string(law) << rigid << largest(found.points);
      EXPECT_GT(largest(found.points), 0.2 * 6) << to_string(law) << rigid;
      const auto solution = solve(tube, {tube.first, tube.last}, {pressure, pressure});
      EXPECT_LT(largest(moved(tube, solution)), 1e-9 * 6) << to_string(law) << rigid;
    }
}

// What an inflated tube was before is what is found from its inflated shape. Its wall keeps its
// thickness, as nu is 0.
TEST(ScanDisplacement, FindsTheTubeThatWasInflated) {
  for (const Law law : {Law::biot, Law::svk}) {
    HeldTube tube(20, 5, 0.5, 24, 16, 0);
    tube.wall.material.law = law;
    // A rigid end would hold its normals as seen, which the wall beside it has turned.
    const std::vector<HeldSection> sections{soft(tube.start()), soft(tube.end())};
    const double pressure = 0.02;
    const Points widened = moved(tube, solve(tube, sections, {0, pressure}, {0.25, 0.5, 0.75, 1}));
    EXPECT_GT(largest(widened), 0.15 * 5);
    HeldTube seen = tube;
    seen.surface.points += widened;
    seen.wall.rest = seen.surface;
    HeldSection end = seen.end();
    end.rigid = false;
    const ScanDisplacement found = see(seen, {soft(seen.start()), end}, pressure, 0.1);
    EXPECT_GT(found.steps, 0);
    EXPECT_LT(largest(found.points - widened), 1e-4 * largest(widened)) << to_string(law);
    // And without the pressure it returns to there.
    const Points back = moved(seen, solve(seen, {soft(seen.start()), end}, {pressure, 0}));
    EXPECT_LT(largest(back + found.points), 1e-4 * 5) << to_string(law);
  }
}

// A tube stretched by 1.3 between soft ends, incompressible and neo-Hookean, pulls with
// mu (k^2 - 1 / k) per area as seen. Let go, its length is that divided by k.
TEST(ScanDisplacement, AStretchIsTheLawsOwn) {
  HeldTube tube(20, 5, 0.5, 48, 24, 0.5);
  tube.wall.material.law = Law::neo_hookean;
  const double k = tube.wall.axial_prestretch = 1.3;
  const std::vector<HeldSection> sections{soft(tube.start()), soft(tube.end())};
  EXPECT_GT(see(tube, sections, 0, 0).steps, 0);
  const CoupledSolution held = solve(tube, sections, {});
  EXPECT_LT(largest(moved(tube, held)), 1e-9 * 5);
  const double area = 0.5 * 48 * 2 * 5 * std::sin(std::numbers::pi / 48),
               force = (k * k - 1 / k) / 3 * area;
  EXPECT_NEAR(held.sections[0][1].force.z(), force, 2e-3 * force);
  std::vector<HeldSection> released = sections;
  released[1].fixed[2] = false;
  const CoupledSolution free = solve(tube, released, {});
  const double length = 20 + moved(tube, free).bottomRows(48).col(2).mean();
  EXPECT_NEAR(length, 20 / k, 2e-3 * 20);
}

TEST(ScanDisplacement, NeedsAHeldEnd) {
  HeldTube tube(20, 5, 0.25, 16, 8);
  EXPECT_THROW(scan_displacement(tube.wall, {}, 0.01, any), InputError);
}

// Where no shape is found the linear displacement is kept.
TEST(ScanDisplacement, IsLinearWhereNoShapeIsFound) {
  HeldTube tube(20, 5, 0.5, 16, 8);
  const std::vector<HeldSection> sections{tube.start(), tube.end()};
  const ScanDisplacement linear = scan_displacement(tube.wall, sections, 0.02, any),
                         stopped =
                             scan_displacement(tube.wall, sections, 0.02, 0, [] { return true; });
  EXPECT_FALSE(stopped.from_stress_free_shape);
  EXPECT_EQ(stopped.points, linear.points);
}

// Nor under loads that no shape without stress leads to, however far the steps go.
TEST(ScanDisplacement, IsLinearUnderLoadsThatNoShapeBears) {
  SomeVessel tube(true, 1);
  int none = 0;
  for (const double pressure : {0.5, 5., 50., 1e4}) {
    const std::vector<HeldSection> sections{tube.first, tube.last};
    const ScanDisplacement linear = scan_displacement(tube.wall, sections, pressure, any),
                           found = scan_displacement(tube.wall, sections, pressure, 0.1);
    EXPECT_TRUE(found.points.allFinite()) << pressure;
    if (found.steps > 0) continue;
    ++none;
    EXPECT_EQ(found.points, linear.points) << pressure;
  }
  EXPECT_GT(none, 0);
}

}  // namespace
}  // namespace vasorod
