#include <gtest/gtest.h>

#include "sections/section_system.h"
#include "some_tube.h"

namespace vasorod {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;
using testing::disturbed, testing::straight_shape, testing::wall_of_shape;

const SectionSpace space{2, AxialBasis(7, 3)};
constexpr double length = 5;

HeldSection held(bool last, bool rigid, const std::array<bool, 6>& fixed) {
  HeldSection section;
  section.rigid = rigid;
  section.fixed = fixed;
  section.rest.position = {0, 0, last ? length : 0.0};
  section.frame = exp_rotation(Vec3(-0.2, 0.6, 0.1));
  section.motion = {Vec3(0.1, 0.2, -0.1), Vec3(0.1, 0.2, -0.1)};
  section.force = {0.01, -0.02, 0.03};
  section.moment = {0.01, 0, 0.02};
  return section;
}

const std::array<bool, 6> all{1, 1, 1, 1, 1, 1}, some{1, 0, 1, 0, 1, 0}, none{};

struct Case {
  const char* name;
  HeldEnds ends;
};

class SectionSystemOf : public ::testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(
    Ends, SectionSystemOf,
    ::testing::Values(Case{"rigid", {held(false, true, all), held(true, true, all)}},
                      Case{"rigid_partly_free", {held(false, true, some), held(true, true, none)}},
                      Case{"soft", {held(false, false, all), held(true, false, all)}},
                      Case{"soft_partly_free", {held(false, false, some), held(true, false, none)}},
                      Case{"one", {std::nullopt, held(true, true, none)}}, Case{"none", {}}),
    [](const auto& one) { return std::string(one.param.name); });

VectorXd some_unknowns(SectionSystem& system, const SectionShape& shape) {
  system.set_time(1);
  VectorXd z = system.unknowns_of(shape.coefficients,
                                  {Pose{exp_rotation(Vec3(0.1, 0.1, 0)), Vec3(0.1, 0, 0.1)},
                                   Pose{exp_rotation(Vec3(0, 0.1, 0.2)), Vec3(0, 0, length)}});
  for (Eigen::Index i = 0; i < z.size(); ++i) z[i] += 0.01 * std::sin(2.3 * double(i));
  return z;
}

TEST_P(SectionSystemOf, DerivativesMatchDifferences) {
  const SectionShape rest = disturbed(straight_shape(space, 1, length), 0.02);
  SectionSystem system(wall_of_shape(rest, 0.1), GetParam().ends);
  system.set_lumen({0.01, 0.04});
  system.set_prestress(disturbed(straight_shape(space, 0.01, 0.1), 0.01).coefficients, 1.02);
  const VectorXd z = some_unknowns(system, disturbed(straight_shape(space, 1, length), 0.04));
  ASSERT_EQ(z.size(), system.unknowns());
  const auto at = system.gradient(z);
  BandMatrix hessian = system.hessian(z, at);
  const double h = 2e-6;
  double slope_error = 0, change_error = 0, largest = 0;
  for (int j = 0; j < z.size(); ++j) {
    VectorXd before = z, after = z;
    before[j] -= h;
    after[j] += h;
    const auto low = system.gradient(before), high = system.gradient(after);
    slope_error =
        std::max(slope_error, std::abs((high.value - low.value) / (2 * h) - at.gradient[j]));
    const VectorXd change = (high.gradient - low.gradient) / (2 * h);
    largest = std::max(largest, change.cwiseAbs().maxCoeff());
    for (int i = j; i < z.size(); ++i) {
      const double found = i - j > hessian.width() ? 0 : hessian.lower(i, j);
      change_error = std::max(change_error, std::abs(change[i] - found));
    }
  }
  EXPECT_LT(slope_error, 1e-7 * at.gradient.norm());
  EXPECT_LT(change_error, 1e-6 * largest);
}

TEST_P(SectionSystemOf, UnknownsGiveTheRowsTheyCameFrom) {
  const SectionShape rest = disturbed(straight_shape(space, 1, length), 0.02);
  SectionSystem system(wall_of_shape(rest, 0.1), GetParam().ends);
  const VectorXd z = some_unknowns(system, rest);
  const MatrixXd rows = system.coefficients(z);
  std::array<Pose, 2> poses;
  const auto at = system.gradient(z);
  for (int e = 0; e < 2; ++e)
    if (const auto wrench = system.wrench(e, z, at))
      poses[static_cast<size_t>(e)] = {wrench->rotation, wrench->center};
  EXPECT_LT((system.coefficients(system.unknowns_of(rows, poses)) - rows).norm(), 1e-12);
}

TEST(SectionSystem, ForcesOfTheEndsAreTheEnergysSlopeAlongTheirMotion) {
  const SectionShape rest = straight_shape(space, 1, length);
  HeldEnds ends{held(false, true, all), held(true, true, none)};
  SectionSystem system(wall_of_shape(rest, 0.1), ends);
  const VectorXd z = some_unknowns(system, disturbed(rest, 0.03));
  const auto at = system.gradient(z);
  const auto wrench = *system.wrench(1, z, at);
  // The pose's unknowns come first among those of the end.
  const double h = 1e-5;
  const int first = system.unknowns() - 6 - (space.row_size() - 2 * space.harmonics - 3);
  for (int k = 0; k < 3; ++k) {
    VectorXd before = z, after = z;
    before[first + k] -= h;
    after[first + k] += h;
    const double found = (system.value(after) - system.value(before)) / (2 * h);
    EXPECT_NEAR(found, ends[1]->frame->col(k).dot(wrench.force - ends[1]->force), 1e-8);
  }
}

// A support carries the lid of its end, an end that is free to move does not; with the lids the
// walls' forces sum to nothing.
TEST(SectionSystem, WithItsLidsTheForcesOfAWallSumToNothing) {
  const SectionShape rest = straight_shape(space, 1, length);
  for (const bool free : {false, true}) {
    HeldEnds ends{held(false, true, all), held(true, true, free ? none : all)};
    SectionSystem system(wall_of_shape(rest, 0.1), ends);
    system.set_lumen({0, 0.04});
    const VectorXd z = some_unknowns(system, disturbed(rest, 0.03));
    const auto at = system.gradient(z);
    // Of the free rows, what is not balanced here.
    Vec3 inside = Vec3::Zero(), forces = Vec3::Zero(), lids = Vec3::Zero();
    const Eigen::Index rows = at.rows.cols();
    for (int k = 0; k < 3; ++k)
      inside[k] = at.rows.row(k * space.modes()).segment(2, rows - 4).sum();
    for (int e = 0; e < 2; ++e) {
      forces += system.wrench(e, z, at)->force;
      lids += system.carried_lid(e, z);
    }
    EXPECT_LT((inside + forces - lids).norm(), 1e-14);
    EXPECT_EQ(system.carried_lid(1, z).norm() == 0, free);
    const double area = system.carried_lid(0, z).norm() / 0.04;
    EXPECT_NEAR(area, M_PI * (1 - 0.1), 0.1);
  }
}

}  // namespace
}  // namespace vasorod
