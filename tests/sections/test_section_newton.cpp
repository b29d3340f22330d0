#include <gtest/gtest.h>

#include "sections/section_newton.h"
#include "some_tube.h"

namespace vasorod {
namespace {

using testing::straight_shape, testing::wall_of_shape;

const SectionSpace space{2, AxialBasis(7, 3)};

HeldEnds pressed(double way) {
  HeldEnds ends;
  for (size_t e = 0; e < 2; ++e) {
    HeldSection& end = ends[e].emplace();
    end.rest.position = {0, 0, e == 0 ? 0.0 : 20.0};
  }
  ends[1]->motion.move = {0, 0, -way};
  return ends;
}

// A long tube pressed past Euler's load: its straight state is an equilibrium with a negative
// curvature, and beside it the method finds the bent minimum.
TEST(SectionNewton, SaysWhereTheStraightStateIsNoMinimum) {
  const SectionShape rest = straight_shape(space, 1, 20);
  SectionSystem system(wall_of_shape(rest, 0.1), pressed(2));
  system.set_time(1);
  SectionShape start = rest;
  for (Eigen::Index i = 0; i < start.coefficients.cols(); ++i)
    start.coefficients(2 * space.modes(), i) *= 0.9;
  const std::array<Pose, 2> poses{Pose{Mat3::Identity(), Vec3::Zero()},
                                  Pose{Mat3::Identity(), Vec3(0, 0, 18)}};
  Work work;
  std::optional<BandMatrix> kept;
  Eigen::VectorXd z = system.unknowns_of(start.coefficients, poses);
  const auto straight = minimise_sections(system, z, {}, kept, work);
  EXPECT_GT(straight.indefinite, 0);
  // Bent to the side as a start.
  for (Eigen::Index i = 0; i < start.coefficients.cols(); ++i) {
    const double u = space.along.interpolation_points()[i];
    start.coefficients(0, i) += 3 * std::pow(std::sin(M_PI * u), 2);
  }
  kept.reset();
  z = system.unknowns_of(start.coefficients, poses);
  const auto bent = minimise_sections(system, z, {}, kept, work);
  EXPECT_EQ(bent.status, SectionNewtonStatus::converged);
  EXPECT_LE(bent.residual, SectionNewtonOptions().tolerance);
  EXPECT_EQ(bent.positive, true);
  EXPECT_GT(system.coefficients(z).row(0).maxCoeff(), 1) << "it stays bent";
  EXPECT_EQ(work.counts.hessians, work.counts.factorisations);
}

TEST(SectionNewton, StopsWhenAsked) {
  const SectionShape rest = straight_shape(space, 1, 20);
  SectionSystem system(wall_of_shape(rest, 0.1), pressed(0.1));
  system.set_time(1);
  Eigen::VectorXd z = system.unknowns_of(
      rest.coefficients,
      {Pose{Mat3::Identity(), Vec3::Zero()}, Pose{Mat3::Identity(), Vec3(0, 0, 19.9)}});
  Work work;
  std::optional<BandMatrix> kept;
  SectionNewtonOptions options;
  options.max_iterations = 1;
  EXPECT_EQ(minimise_sections(system, z, options, kept, work).status,
            SectionNewtonStatus::iteration_limit);
  options.stop = [] { return true; };
  EXPECT_EQ(minimise_sections(system, z, options, kept, work).status,
            SectionNewtonStatus::interrupted);
}

}  // namespace
}  // namespace vasorod
