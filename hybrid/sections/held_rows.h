// An end that a support holds or a load acts on: the first rows of coefficients there follow the
// pose of a section.
//
// Rigid section: the rim and its normal follow the pose. With row 0 at the rim, x_u there is in
// proportion to row 1 - row 0, so row 1 may leave the rigid motion only by fields v with n.v = 0.
// Soft section: the mean position and the mean rotation of the rim (section_tie.h) follow the pose,
// so row 0 may leave the rigid motion by fields without a mean and without a mean moment.
//
//   row_a = r + R (arms_a + (Z y)_a)
//
// Z: orthonormal basis of those fields, in the rest orientation; y: unknowns.
#pragma once

#include <vector>

#include "coupled/held_section.h"
#include "sections/section_shape.h"

namespace vasorod {

/// The rows of coefficients at one end, as functions of the pose's unknowns and y, in this order.
class HeldRows {
 public:
  /// `last`: the end at u = 1. `section` and `rest` in the same units.
  HeldRows(const HeldSection& section, const SectionShape& rest, bool last);

  /// Indices of the rows, from the rim inwards.
  const std::vector<int>& rows() const { return rows_; }
  int unknowns() const { return pose.unknowns() + static_cast<int>(fields_.cols()); }

  /// Writes the rows at these unknowns.
  void place(const Eigen::VectorXd& z, Eigen::MatrixXd& coefficients) const;
  /// Derivative of the rows, one after the other, with respect to the unknowns.
  Eigen::MatrixXd derivative(const Eigen::VectorXd& z) const;
  /// Second derivatives of the sum of `gradient` times the rows, at constant gradient (a column per
  /// row of the vessel).
  Eigen::MatrixXd curvature(const Eigen::VectorXd& z, const Eigen::MatrixXd& gradient) const;
  /// The unknowns nearest to rows as they are, in a pose (rotation from rest) as near to the given
  /// one as the free axes allow.
  Eigen::VectorXd unknowns_of(const Mat3& rotation, const Vec3& position,
                              const Eigen::MatrixXd& coefficients);
  /// Force and moment about the section's point that the pose exerts on the rows, against the
  /// gradient of the energy.
  void wrench(const Eigen::VectorXd& z, const Eigen::MatrixXd& gradient, Vec3& force,
              Vec3& moment) const;

  SectionPose pose;

 private:
  using Arms = Eigen::Matrix<double, Eigen::Dynamic, 3>;
  // Of row a, from the section's point, in the rest orientation: modes x 3.
  Arms arms(const Eigen::VectorXd& z, size_t a) const;

  std::vector<int> rows_;
  std::vector<Arms> rest_;
  Eigen::MatrixXd fields_;  // Z: rows one after the other x y
};

}  // namespace vasorod
