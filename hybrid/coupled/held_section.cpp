#include "coupled/held_section.h"

#include <cmath>

#include "data/index.h"
#include "geometry/rigid_motion.h"

namespace vasorod {

SectionPose::SectionPose(const HeldSection& section)
    : section_(section), frame_(section.frame.value_or(section.rest.rotation)) {
  for (int k = 0; k < 6; ++k) {
    if (section.fixed[static_cast<size_t>(k)]) continue;
    free_.push_back(k);
    if (k >= 3) ++free_rotations_;
  }
  set_time(0);
  effective_moment_ = moment_at(reference_);
}

void SectionPose::set_time(double t) {
  time_ = t;
  fixed_position_ = section_.rest.position + t * section_.motion.move;
  // If all rotations are free, the reference remains where the caller set it last.
  if (free_rotations_ < 3) reference_ = exp_rotation(t * section_.motion.rotate);
  effective_moment_ = moment_at(reference_);
}

void SectionPose::set_target(const Pose& pose) {
  if (!free_.empty()) return;
  reference_ = pose.rotation;
  fixed_position_ = pose.position;
}

SectionPlacement SectionPose::place(const double* z) const {
  SectionPlacement at;
  at.position = fixed_position_;
  for (size_t k = 0; k < free_.size(); ++k) {
    const Vec3 axis = frame_.col(free_[k] % 3);
    (free_[k] < 3 ? at.position : at.vector) += z[k] * axis;
  }
  at.rotation = exp_rotation(at.vector) * reference_;
  const Mat3 jacobian = left_jacobian(at.vector);
  at.position_axes.setZero(3, unknowns());
  at.rotation_axes.setZero(3, unknowns());
  for (size_t k = 0; k < free_.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    if (free_[k] < 3)
      at.position_axes.col(column) = frame_.col(free_[k]);
    else
      at.rotation_axes.col(column) = jacobian * frame_.col(free_[k] - 3);
  }
  return at;
}

SectionPlacement SectionPose::at_rest() const {
  SectionPlacement at;
  at.position = section_.rest.position;
  at.position_axes.setZero(3, unknowns());
  at.rotation_axes.setZero(3, unknowns());
  for (size_t k = 0; k < free_.size(); ++k)
    (free_[k] < 3 ? at.position_axes : at.rotation_axes).col(static_cast<Eigen::Index>(k)) =
        frame_.col(free_[k] % 3);
  return at;
}

Eigen::MatrixXd SectionPose::turned_axes(const Mat3& rotation) const {
  Eigen::MatrixXd turned = Eigen::MatrixXd::Identity(unknowns(), unknowns());
  const Mat3 block = frame_.transpose() * rotation * frame_;
  if (unknowns() - free_rotations_ == 3) turned.topLeftCorner<3, 3>() = block;
  if (free_rotations_ == 3) turned.bottomRightCorner<3, 3>() = block;
  return turned;
}

void SectionPose::unknowns_of(const Mat3& rotation, const Vec3& position, double* z) {
  if (free_rotations_ == 3) reference_ = rotation;
  const Vec3 vector = log_rotation(nearest_rotation(rotation * reference_.transpose()));
  for (size_t k = 0; k < free_.size(); ++k) {
    const Vec3 axis = frame_.col(free_[k] % 3);
    z[k] = axis.dot(free_[k] < 3 ? Vec3(position - fixed_position_) : vector);
  }
}

Vec3 SectionPose::moment_at(const Mat3& rotation) const {
  return time_ * (section_.moment + rotation * (section_.rest.rotation * section_.body_moment));
}

double SectionPose::recentre(double* z) {
  SectionPlacement at = place(z);
  if (free_rotations_ == 3) {
    reference_ = at.rotation;
    for (size_t k = 0; k < free_.size(); ++k)
      if (free_[k] >= 3) z[k] = 0;
    at = place(z);
  }
  const Vec3 before = effective_moment_;
  effective_moment_ = left_jacobian(at.vector).transpose() * moment_at(at.rotation);
  double change = 0;
  for (const int k : free_)
    if (k >= 3) change = std::hypot(change, frame_.col(k - 3).dot(effective_moment_ - before));
  return change;
}

// With R = exp(v) R_ref the work of the torque is t.(J dv), J the left Jacobian. The second
// derivative is
//   J^T (dt/dw) J + d(J^T t)/dv at constant t,   J^T t = t - b v x t + d v x (v x t)
Mat6 SectionPose::curvature(const SectionPlacement& at, const Vec3& torque,
                            const Mat3& spread) const {
  const Vec3& v = at.vector;
  const ExpCoefficients c = exp_coefficients(v.squaredNorm());
  const Vec3 once = v.cross(torque), twice = v.cross(once);
  Mat3 second = c.b * hat(torque) - c.b2 * once * v.transpose() + c.d2 * twice * v.transpose() +
                c.d * (v.dot(torque) * Mat3::Identity() + v * torque.transpose() -
                       2 * torque * v.transpose());
  const Mat3 jacobian = left_jacobian(v);
  second += jacobian.transpose() * spread * jacobian;
  Mat6 result = Mat6::Zero();
  for (size_t a = 0; a < free_.size(); ++a)
    for (size_t b = 0; b < free_.size(); ++b)
      if (free_[a] >= 3 && free_[b] >= 3)
        result(static_cast<int>(a), static_cast<int>(b)) =
            0.5 * (frame_.col(free_[a] - 3).dot(second * frame_.col(free_[b] - 3)) +
                   frame_.col(free_[b] - 3).dot(second * frame_.col(free_[a] - 3)));
  return result;
}

double SectionPose::load(const SectionPlacement& at, const double* z, Vec6& gradient) const {
  const Vec3 force = time_ * section_.force;
  double potential = -force.dot(at.position - section_.rest.position);
  for (size_t k = 0; k < free_.size(); ++k) {
    const Vec3 axis = frame_.col(free_[k] % 3);
    const double conjugate = axis.dot(free_[k] < 3 ? force : effective_moment_);
    gradient[static_cast<int>(k)] -= conjugate;
    if (free_[k] >= 3) potential -= conjugate * z[k];
  }
  return potential;
}

bool SectionPose::loaded() const {
  return section_.force != Vec3::Zero() || section_.moment != Vec3::Zero() ||
         section_.body_moment != Vec3::Zero();
}

bool SectionPose::has_potential() const {
  return free_rotations_ <= 1 ||
         (section_.moment == Vec3::Zero() && section_.body_moment == Vec3::Zero());
}

std::vector<char> glued_marks(const std::vector<HeldSection>& sections, Eigen::Index vertices) {
  std::vector<char> glued(index(vertices), 0);
  for (const HeldSection& section : sections)
    if (section.rigid)
      for (const int v : section.ring) glued[index(v)] = 1;
  return glued;
}

HeldSection scaled(const HeldSection& section, double length, double force, const Vec3& origin) {
  HeldSection s = section;
  s.rest.position = (section.rest.position - origin) / length;
  s.motion.move /= length;
  s.force /= force;
  s.moment /= force * length;
  s.body_moment /= force * length;
  return s;
}

}  // namespace vasorod
