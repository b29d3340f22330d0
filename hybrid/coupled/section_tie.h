// Soft section: six equations tie a pose to the mean of a ring and leave the ring free to change
// its shape.
//
//   c1 = sum w_i x_i - (r + R d) = 0            the mean of the ring is at the pose
//   c2 = sum w_i (R rho_i) x x_i / rho^2 = 0    no mean rotation relative to the pose
//
// w_i: the fraction of the ring's length assigned to vertex i, sum 1; rho_i: from the mean at rest,
// rho^2 its mean square; d: from the section's point to the mean at rest. The equations are
// enforced by multipliers l with an augmented term:
//
//   E = l1.c1 + l2.c2 + k/2 |c1|^2 + k rho^2/2 |c2|^2
//
// At the minimum the multipliers are the section's force and, with the arm R d, its moment.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "coupled/held_section.h"

namespace vasorod {

/// The six equations of one soft section with their multipliers.
class SectionTie {
 public:
  /// `rest`: rest positions of the wall's vertices, n x 3. `stiffness`: k, force / length.
  SectionTie(const HeldSection& section, const Points& rest, double stiffness);

  const std::vector<int>& ring() const { return ring_; }
  /// c1 (length) and c2 (radians).
  Vec6 misfit(const SectionPlacement& at, const Points& x) const;
  /// Largest of |c1| over the ring's radius and |c2|.
  double relative_misfit(const SectionPlacement& at, const Points& x) const;
  /// l += k c.
  void update_multipliers(const SectionPlacement& at, const Points& x);

  /// Returns the energy and adds its gradient to `gradient` (rows of the ring) and to that of the
  /// pose's unknowns.
  double gradient(const SectionPlacement& at, const Points& x, Points& gradient,
                  Vec6& pose_gradient) const;

  /// The Hessian over (ring vertices, pose unknowns), dense, of size 3 n + pose unknowns.
  Eigen::MatrixXd hessian(const SectionPose& pose, const SectionPlacement& at,
                          const Points& x) const;

  /// Force and moment of the pose on the wall, the moment about the section's point.
  void reaction(const SectionPlacement& at, const Points& x, Vec3& force, Vec3& moment) const;

 private:
  void forces(const SectionPlacement& at, const Points& x, Vec3& f1, Vec3& f2) const;
  void torque(const SectionPlacement& at, const Points& x, const Vec3& f1, const Vec3& f2,
              Vec3& torque, Mat3& spread) const;

  std::vector<int> ring_;
  std::vector<double> weight_;
  std::vector<Vec3> arm_;         // rho_i
  Vec3 mean_arm_ = Vec3::Zero();  // d
  double square_ = 1, stiffness_ = 1;
  Vec6 multiplier_ = Vec6::Zero();
};

}  // namespace vasorod
