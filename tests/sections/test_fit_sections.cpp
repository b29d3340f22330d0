#include <gtest/gtest.h>

#include <vasorod/error.h>
#include <vasorod/tube.h>

#include "sections/fit_sections.h"
#include "straight_tube.h"

namespace vasorod {
namespace {

using testing::straight_tube;

TEST(FitSections, ATubesVerticesLieOnItsShape) {
  const TriangleSurface surface = tube_surface(straight_tube(10, 1, 24, 20));
  const Vessel vessel = fit_vessel("tube", surface);
  const SectionParameters at = section_parameters(vessel, "");
  const SectionShape shape = fit_sections({3, AxialBasis(6, 3)}, at, surface.points);
  EXPECT_LT((points_of(shape, at) - surface.points).rowwise().norm().maxCoeff(), 1e-8);
  // Between its vertices it is the circle that they lie on, not their polygon.
  const Vec3 between = shape.point(0.37, 0.13);
  EXPECT_NEAR(between.head<2>().norm(), 1, 1e-8);
  EXPECT_EQ(at.u.minCoeff(), 0);
  EXPECT_EQ(at.u.maxCoeff(), 1);
}

TEST(FitSections, ABentTubeIsAnArc) {
  TubeSpec spec = straight_tube(10, 1, 32, 60);
  spec.bend_deg = 57;
  const TriangleSurface surface = tube_surface(spec);
  const Vessel vessel = fit_vessel("tube", surface);
  const SectionParameters at = section_parameters(vessel, "");
  const SectionShape shape = fit_sections({3, AxialBasis(20, 3)}, at, surface.points);
  EXPECT_LT((points_of(shape, at) - surface.points).rowwise().norm().maxCoeff(), 2e-4);
}

// The end is cut at 30 degrees: lines of constant u follow the rim.
TEST(FitSections, ASlantedRimIsALineOfConstantU) {
  TriangleSurface surface = tube_surface(straight_tube(10, 1, 32, 40));
  for (Eigen::Index i = 0; i < surface.points.rows(); ++i)
    surface.points(i, 2) *= 1 + 0.05 * surface.points(i, 0);
  const Vessel vessel = fit_vessel("tube", surface);
  const SectionParameters at = section_parameters(vessel, "");
  for (const int v : vessel.ends[static_cast<size_t>(at.end[1])].loop) EXPECT_EQ(at.u[v], 1);
  const SectionShape shape = fit_sections({6, AxialBasis(12, 3)}, at, surface.points);
  EXPECT_LT((points_of(shape, at) - surface.points).rowwise().norm().maxCoeff(), 5e-3);
}

// Every second ring as far out as the others are ahead: the wall lies over itself.
TEST(FitSections, AWallThatLiesOverItselfIsRefused) {
  TriangleSurface surface = tube_surface(straight_tube(10, 1, 32, 40));
  const Vessel vessel = fit_vessel("tube", surface);
  Vessel folded = vessel;
  for (Eigen::Index i = 0; i < surface.points.rows(); ++i)
    if ((i / 32) % 2 == 1 && i / 32 < 40) folded.binding[static_cast<size_t>(i)].local.z() += 0.4;
  try {
    section_parameters(folded, "vessel v: ");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(
        std::string(error.what()).rfind("vessel v: fidelity section: found a wall that lies", 0),
        0u)
        << error.what();
  }
}

}  // namespace
}  // namespace vasorod
