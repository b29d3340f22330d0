#include <gtest/gtest.h>

#include "sections/held_rows.h"
#include "some_tube.h"

namespace vasorod {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;
using testing::disturbed, testing::moved, testing::straight_shape;

const SectionSpace space{3, AxialBasis(6, 3)};
constexpr double length = 5;

HeldSection section_at(bool last, bool rigid) {
  HeldSection section;
  section.rigid = rigid;
  section.fixed = {};
  section.rest.position = {0.2, -0.1, last ? length : 0.0};
  return section;
}

struct Placed {
  SectionPlacement end;
  SectionShape shape;
};

// By some unknowns, from the shape at rest.
Placed placed(const HeldRows& rows, SectionShape shape) {
  VectorXd z(rows.unknowns());
  for (Eigen::Index i = 0; i < z.size(); ++i) z[i] = 0.1 * std::sin(1.9 * static_cast<double>(i));
  rows.place(z, shape.coefficients);
  return {rows.pose.place(z.data()), std::move(shape)};
}

TEST(HeldRows, ARigidEndKeepsItsRimAndItsNormals) {
  const SectionShape rest = disturbed(straight_shape(space, 1, length), 0.02);
  for (const bool last : {false, true}) {
    const HeldRows rows(section_at(last, true), rest, last);
    const auto [at, now] = placed(rows, rest);
    const double u = last ? 1 : 0;
    const Vec3 point = rows.pose.section().rest.position;
    double slope = 0;
    for (const double angle : {0.0, 0.7, 2.1, 4.4}) {
      const Vec3 expected = at.position + at.rotation * (rest.point(u, angle) - point);
      EXPECT_LT((now.point(u, angle) - expected).norm(), 1e-12);
      const Vec3 normal = at.rotation * surface_frame(rest.jet(u, angle)).col(0);
      slope = std::max(slope, std::abs(normal.dot(now.jet(u, angle).col(0))));
    }
    // All harmonics of a round rim's condition are kept; of an uneven rim's those up to N + 1.
    EXPECT_LT(slope, 0.05 * length);
  }
  const SectionShape tube = straight_shape(space, 1, length);
  const auto [at, now] = placed(HeldRows(section_at(false, true), tube, false), tube);
  for (const double angle : {0.0, 0.7, 2.1, 4.4}) {
    const Vec3 normal = at.rotation * Vec3(std::cos(angle), std::sin(angle), 0);
    EXPECT_LT(std::abs(normal.dot(now.jet(0, angle).col(0))), 1e-12);
  }
}

TEST(HeldRows, ASoftEndKeepsItsMeanAndItsMeanRotation) {
  const SectionShape rest = straight_shape(space, 1, length);
  const HeldRows rows(section_at(true, false), rest, true);
  const auto [at, now] = placed(rows, rest);
  Vec3 mean = Vec3::Zero(), moment = Vec3::Zero();
  double apart = 0;
  const int points = 60;
  for (int q = 0; q < points; ++q) {
    const double angle = 2 * M_PI * q / points;
    const Vec3 arm = rest.point(1, angle) - Vec3(0, 0, length), x = now.point(1, angle);
    mean += x / points;
    moment += (at.rotation * arm).cross(x) / points;
    apart = std::max(apart, (x - at.position - at.rotation * arm).norm());
  }
  const Vec3 center =
      at.position + at.rotation * (Vec3(0, 0, length) - rows.pose.section().rest.position);
  EXPECT_LT((mean - center).norm(), 1e-12);
  EXPECT_LT((moment - Vec3::Zero()).norm(), 1e-12);
  EXPECT_GT(apart, 0.1) << "its shape is free";
}

TEST(HeldRows, UnknownsOfAMovedShapeAreThoseOfTheMotion) {
  const SectionShape rest = disturbed(straight_shape(space, 1, length), 0.02);
  const Pose motion{exp_rotation(Vec3(0.3, -0.2, 0.5)), Vec3(1, 2, 3)};
  for (const bool rigid : {false, true}) {
    HeldRows rows(section_at(false, rigid), rest, false);
    const VectorXd z = rows.unknowns_of(motion.rotation, motion * rows.pose.section().rest.position,
                                        moved(rest, motion));
    EXPECT_LT(z.tail(rows.unknowns() - 6).norm(), 1e-12) << "no field beside the motion";
    MatrixXd now = MatrixXd::Zero(rest.coefficients.rows(), rest.coefficients.cols());
    rows.place(z, now);
    for (const int row : rows.rows())
      EXPECT_LT((now.col(row) - moved(rest, motion).col(row)).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace vasorod
