#include <gtest/gtest.h>

#include "coupled/held_tubes.h"
#include "coupled/section_tie.h"
#include "wall/walls.h"

namespace vasorod {
namespace {

using namespace testing;

// The end ring of a tube, tied to a section that is free and stands elsewhere.
struct Fixture {
  HeldTube tube{4, 1.5, 0.4, 7, 3};
  HeldSection section = tube.end();
  Points rest = tube.surface.points;
  SectionTie tie;
  SectionPose pose;
  std::vector<double> z{0.2, -0.1, 0.3, 0.4, 0.2, -0.5};
  Fixture() : tie(with_point(section), rest, 3.5), pose(free_of_all(section)) {}
  // Its point is off the ring's middle.
  static const HeldSection& with_point(HeldSection& s) {
    s.rest.position += Vec3(0.1, 0.2, -0.3);
    return s;
  }
  static HeldSection free_of_all(HeldSection s) {
    s.fixed.fill(false);
    return s;
  }
  SectionPlacement at() const { return pose.place(z.data()); }
  Points moved() const {
    Points x = rest;
    const Eigen::VectorXd random = noise(x.size(), 9);
    for (Eigen::Index i = 0; i < x.size(); ++i) x.data()[i] += 0.2 * random[i];
    return x;
  }
};

TEST(SectionTie, ARingThatMovesWithItsSectionHasNoMisfit) {
  const Fixture f;
  const SectionPlacement at = f.at();
  Points x = f.rest;
  for (Eigen::Index i = 0; i < x.rows(); ++i)
    x.row(i) = at.rotation * (f.rest.row(i).transpose() - f.section.rest.position) + at.position;
  EXPECT_LT(f.tie.misfit(at, x).norm(), 1e-13);
  EXPECT_LT(f.tie.relative_misfit(at, x), 1e-13);
}

TEST(SectionTie, TheMisfitIsTheRingsMeanDisplacementAndRotation) {
  const Fixture f;
  const SectionPlacement rest = f.pose.at_rest();
  const Vec3 shift(0.03, -0.02, 0.05), turn(1e-4, -2e-4, 3e-4);
  const Vec3 middle(0, 0, 4);
  Points x = f.rest;
  for (Eigen::Index i = 0; i < x.rows(); ++i)
    x.row(i) = exp_rotation(turn) * (f.rest.row(i).transpose() - middle) + middle + shift;
  const Vec6 misfit = f.tie.misfit(rest, x);
  EXPECT_LT((misfit.head<3>() - shift).norm(), 1e-12);
  // A flat ring: the fit of the rotation is the mean square's, sum rho x (turn x rho) / rho^2.
  const Vec3 expected(turn.x() / 2, turn.y() / 2, turn.z());
  EXPECT_LT((misfit.tail<3>() - expected).norm(), 1e-3 * turn.norm());
  // An oval is no misfit: the ring is free to change its shape.
  x = f.rest;
  x.col(0) *= 1.2;
  x.col(1) *= 0.8;
  EXPECT_LT(f.tie.misfit(rest, x).norm(), 1e-12);
}

TEST(SectionTie, GradientAndHessianMatchDifferences) {
  Fixture f;
  const Points x = f.moved();
  f.tie.update_multipliers(f.at(), x);  // a multiplier of its own
  f.z = {0.1, 0.3, -0.2, -0.3, 0.5, 0.2};
  const auto n = static_cast<Eigen::Index>(f.tie.ring().size());
  const Eigen::Index size = 3 * n + 6;
  const auto gradient_at = [&](const Eigen::VectorXd& step, double* value) {
    Points moved = x;
    std::vector<double> z = f.z;
    for (Eigen::Index i = 0; i < n; ++i)
      moved.row(f.tie.ring()[static_cast<size_t>(i)]) += step.segment<3>(3 * i).transpose();
    for (Eigen::Index k = 0; k < 6; ++k) z[static_cast<size_t>(k)] += step[3 * n + k];
    Points rows = Points::Zero(x.rows(), 3);
    Vec6 pose = Vec6::Zero();
    const double energy = f.tie.gradient(f.pose.place(z.data()), moved, rows, pose);
    if (value) *value = energy;
    Eigen::VectorXd all(size);
    for (Eigen::Index i = 0; i < n; ++i)
      all.segment<3>(3 * i) = rows.row(f.tie.ring()[static_cast<size_t>(i)]).transpose();
    all.tail<6>() = pose;
    return all;
  };
  const Eigen::VectorXd gradient = gradient_at(Eigen::VectorXd::Zero(size), nullptr);
  const Eigen::MatrixXd hessian = f.tie.hessian(f.pose, f.at(), x);
  ASSERT_EQ(hessian.rows(), size);
  const double h = 1e-5;
  for (Eigen::Index k = 0; k < size; ++k) {
    const Eigen::VectorXd step = h * Eigen::VectorXd::Unit(size, k);
    double plus = 0, minus = 0;
    const Eigen::VectorXd a = gradient_at(step, &plus), b = gradient_at(-step, &minus);
    EXPECT_NEAR(gradient[k], (plus - minus) / (2 * h), 1e-7 * gradient.norm()) << k;
    EXPECT_LT(((a - b) / (2 * h) - hessian.col(k)).norm(), 1e-7 * hessian.norm()) << k;
  }
  EXPECT_LT((hessian - hessian.transpose()).norm(), 1e-12 * hessian.norm());
}

TEST(SectionTie, TheReactionIsWhatTheRingFeels) {
  Fixture f;
  const Points x = f.moved();
  f.tie.update_multipliers(f.at(), x);
  Points rows = Points::Zero(x.rows(), 3);
  Vec6 unused = Vec6::Zero();
  f.tie.gradient(f.at(), x, rows, unused);
  Vec3 force, moment;
  f.tie.reaction(f.at(), x, force, moment);
  // The tie's energy pulls the ring with minus its gradient; about the section's point.
  Vec3 sum = Vec3::Zero(), about = Vec3::Zero();
  for (Eigen::Index i = 0; i < x.rows(); ++i) {
    sum -= rows.row(i).transpose();
    about -= (x.row(i).transpose() - f.at().position).cross(rows.row(i).transpose());
  }
  EXPECT_LT((force - sum).norm(), 1e-12 * sum.norm());
  EXPECT_LT((moment - about).norm(), 1e-11 * about.norm());
}

}  // namespace
}  // namespace vasorod
