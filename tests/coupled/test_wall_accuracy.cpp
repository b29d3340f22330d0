// The coupled minimum of whole tubes compared with closed forms and finer meshes: the fast rows of
// benchmarks/accuracy.
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "accuracy/bent_ring.h"
#include "accuracy/gauges.h"
#include "accuracy/plane_ring.h"
#include "accuracy/refinement.h"

namespace vasorod::bench {
namespace {

using std::numbers::pi;

constexpr double radius = 10, nu = 0.3;

std::vector<TubeMesh> meshes(double length, int around) {
  return {structured(length, radius, around), shifted(length, radius, around),
          blue_noise(length, radius, around)};
}

TEST(WallAccuracy, ALongTubeHasTheRodsStiffnessesWithinOnePercent) {
  for (const TubeMesh& mesh : meshes(100, 32)) {
    SCOPED_TRACE(mesh.name);
    const HeldTube tube(mesh, 100, radius, 1);
    EndMotion pulled, twisted;
    pulled.change[2] = 1e-4;
    twisted.change[5] = 3e-4 / radius;
    const HeldAnswer stretch = solve(tube, pulled), twist = solve(tube, twisted);
    EXPECT_TRUE(stretch.settled && twist.settled);
    const AxialGauge gauge = middle_half(tube, stretch.positions);
    EXPECT_NEAR(stretch.force.z() / (tube.area() * gauge.strain), 1, 5e-3) << "E A";
    EXPECT_NEAR(twist.moment.z() / (tube.shear_modulus() * 2 * tube.inertia() * twisted.change[5]),
                1, 5e-3)
        << "G J";
    EXPECT_LT(off_cylinder(tube, twist.positions), mesh.name == "structured" ? 1e-6 : 1e-5);
  }
  const HeldTube tube(structured(100, radius, 32), 100, radius, 1);
  const ShearGauge shear = transverse_force(tube);
  EXPECT_TRUE(shear.settled);
  EXPECT_NEAR(shear.bending, 1, 1e-2) << "E I";
  EXPECT_NEAR(shear.coefficient / cowper_coefficient(radius, 1, nu), 1, 1e-2) << "k G A";
}

TEST(WallAccuracy, ARingIsWithinTwoPercentOfTheThinRing) {
  for (const TubeMesh& mesh : meshes(80, 48))
    for (const double t : {0.2, 0.5})
      EXPECT_NEAR(ring_energy({mesh, 80, radius, t}), 1, 0.02) << mesh.name << " " << t;
}

TEST(WallAccuracy, PureBendingOvalisesAndSoftensAsTheRing) {
  const double length = 400, t = 1, unit = t / (radius * radius * std::sqrt(1 - nu * nu));
  const HeldTube tube(structured(length, radius, 32), length, radius, t, nu);
  for (const double k_b : {0.1, 0.2, 0.3}) {
    SCOPED_TRACE(k_b);
    const HeldAnswer answer = solve(tube, pure_bending(k_b * unit));
    EXPECT_TRUE(answer.settled);
    const double curvature = middle_curvature(tube, answer.positions);
    EXPECT_NEAR(curvature / (k_b * unit), 1, 0.05);
    const BentRing exact = bent_ring(radius, t, nu, curvature);
    const SectionMean middle = section_mean(tube, answer.positions, length / 2);
    const double thick = 1 + t * t / (4 * radius * radius);
    EXPECT_NEAR(answer.moment.y() / (exact.moment * thick), 1, 0.015);
    EXPECT_NEAR(middle.flattening / exact.flattening, 1, 0.03);
  }
}

TEST(WallAccuracy, ACurvedTubeSoftensAsVonKarmanSays) {
  const double length = 400, t = 0.5;
  for (const double degrees : {90.0, 180.0}) {
    SCOPED_TRACE(degrees);
    const HeldTube tube(structured(length, radius, 32), length, radius, t, nu, degrees);
    const double k0 = degrees * pi / 180 / length,
                 l = t / (k0 * radius * radius * std::sqrt(1 - nu * nu));
    const HeldAnswer answer = solve(tube, pure_bending(1e-4 * k0));
    EXPECT_TRUE(answer.settled);
    const double softer =
        middle_curvature(tube, answer.positions) * tube.inertia() / answer.moment.y();
    EXPECT_NEAR(softer / ((12 * l * l + 10) / (12 * l * l + 1)), 1, 0.05);
    EXPECT_NEAR(softer / curved_tube_softening(radius, t, nu, k0), 1, 0.02);
  }
}

// The reference ring itself, compared with the first terms of Brazier's expansion and the maximum
// of the moment from Reissner's equations.
TEST(BentRing, IsBraziersForSmallCurvatures) {
  const double t = 1, unit = t / (radius * radius * std::sqrt(1 - nu * nu)), k_b = 0.02;
  const BentRing ring = bent_ring(radius, t, nu, k_b * unit);
  EXPECT_NEAR(ring.moment / (pi * std::pow(radius, 3) * t * k_b * unit), 1 - 1.5 * k_b * k_b, 1e-5);
  EXPECT_NEAR(ring.flattening, k_b * k_b, 0.03 * k_b * k_b);
}

TEST(BentRing, HasItsLargestMomentAtTheKnownCurvature) {
  const double t = 1, unit = t / (radius * radius * std::sqrt(1 - nu * nu));
  const auto moment = [&](double k_b) {
    return bent_ring(radius, t, nu, k_b * unit).moment * std::sqrt(1 - nu * nu) / (radius * t * t);
  };
  EXPECT_NEAR(moment(0.475), 0.95867, 1e-4);
  EXPECT_LT(moment(0.45), moment(0.475));
  EXPECT_LT(moment(0.5), moment(0.475));
}

// From 3,000 vertices to four times as many, compared with a structured mesh of 27,000. The
// benchmark goes to 100,000.
TEST(WallAccuracy, RefiningChangesLittleOnRegularAndIrregularMeshes) {
  constexpr int fine = 120;
  const BentTube reference(structured(100, radius, fine));
  for (const RefinedMesh& kind : refined_meshes()) {
    double before = 0;
    for (const std::size_t level : {std::size_t{0}, std::size_t{1}}) {
      SCOPED_TRACE(kind.name + std::string(" ") + std::to_string(kind.around[level]));
      const BentTube bent(kind.make(kind.around[level]));
      EXPECT_TRUE(bent.answer.settled);
      EXPECT_LT(largest_distance(bent, reference, fine), 5e-3 * radius);
      const double error = bent.answer.moment.y() / reference.answer.moment.y() - 1;
      EXPECT_LT(std::abs(error), 1e-2);
      if (level == 1) {
        EXPECT_LT(std::abs(error), 0.5 * std::abs(before));
      }
      before = error;
    }
  }
}

}  // namespace
}  // namespace vasorod::bench
