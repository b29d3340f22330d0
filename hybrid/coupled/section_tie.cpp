#include "coupled/section_tie.h"

#include <algorithm>

#include "geometry/rigid_motion.h"

namespace vasorod {

SectionTie::SectionTie(const HeldSection& section, const Points& rest, double stiffness)
    : ring_(section.ring), stiffness_(stiffness) {
  const size_t n = ring_.size();
  weight_.assign(n, 0);
  double total = 0;
  for (size_t i = 0; i < n; ++i) {
    const size_t j = (i + 1) % n;
    const double length = (rest.row(ring_[i]) - rest.row(ring_[j])).norm();
    weight_[i] += length / 2;
    weight_[j] += length / 2;
    total += length;
  }
  Vec3 mean = Vec3::Zero();
  for (size_t i = 0; i < n; ++i) {
    weight_[i] /= total;
    mean += weight_[i] * rest.row(ring_[i]).transpose();
  }
  mean_arm_ = mean - section.rest.position;
  square_ = 0;
  for (size_t i = 0; i < n; ++i) {
    arm_.push_back(rest.row(ring_[i]).transpose() - mean);
    square_ += weight_[i] * arm_.back().squaredNorm();
  }
}

Vec6 SectionTie::misfit(const SectionPlacement& at, const Points& x) const {
  Vec6 c = Vec6::Zero();
  for (size_t i = 0; i < ring_.size(); ++i) {
    const Vec3 p = x.row(ring_[i]);
    c.head<3>() += weight_[i] * p;
    c.tail<3>() += weight_[i] / square_ * (at.rotation * arm_[i]).cross(p);
  }
  c.head<3>() -= at.position + at.rotation * mean_arm_;
  return c;
}

double SectionTie::relative_misfit(const SectionPlacement& at, const Points& x) const {
  const Vec6 c = misfit(at, x);
  return std::max(c.head<3>().norm() / std::sqrt(square_), c.tail<3>().norm());
}

void SectionTie::forces(const SectionPlacement& at, const Points& x, Vec3& f1, Vec3& f2) const {
  const Vec6 c = misfit(at, x);
  f1 = multiplier_.head<3>() + stiffness_ * c.head<3>();
  f2 = multiplier_.tail<3>() + stiffness_ * square_ * c.tail<3>();
}

void SectionTie::update_multipliers(const SectionPlacement& at, const Points& x) {
  Vec3 f1, f2;
  forces(at, x, f1, f2);
  multiplier_ << f1, f2;
}

// The ring acts on the pose through arms a that rotate with the pose, each paired with a constant
// g. Sums a x g and a g^T - (a.g) I.
void SectionTie::torque(const SectionPlacement& at, const Points& x, const Vec3& f1, const Vec3& f2,
                        Vec3& sum, Mat3& spread) const {
  sum.setZero();
  spread.setZero();
  const auto add = [&](const Vec3& a, const Vec3& g) {
    sum += a.cross(g);
    spread += a * g.transpose() - a.dot(g) * Mat3::Identity();
  };
  add(at.rotation * mean_arm_, -f1);
  for (size_t i = 0; i < ring_.size(); ++i)
    add(at.rotation * arm_[i], weight_[i] / square_ * Vec3(x.row(ring_[i])).cross(f2));
}

double SectionTie::gradient(const SectionPlacement& at, const Points& x, Points& gradient,
                            Vec6& pose_gradient) const {
  const Vec6 c = misfit(at, x);
  Vec3 f1, f2;
  forces(at, x, f1, f2);
  for (size_t i = 0; i < ring_.size(); ++i)
    gradient.row(ring_[i]) +=
        (weight_[i] * (f1 + f2.cross(at.rotation * arm_[i]) / square_)).transpose();
  Vec3 t;
  Mat3 spread;
  torque(at, x, f1, f2, t, spread);
  const Eigen::Index m = at.position_axes.cols();
  pose_gradient.head(m) += at.rotation_axes.transpose() * t - at.position_axes.transpose() * f1;
  return multiplier_.dot(c) +
         0.5 * stiffness_ * (c.head<3>().squaredNorm() + square_ * c.tail<3>().squaredNorm());
}

Eigen::MatrixXd SectionTie::hessian(const SectionPose& pose, const SectionPlacement& at,
                                    const Points& x) const {
  const auto n = static_cast<Eigen::Index>(ring_.size()), m = at.position_axes.cols();
  Vec3 f1, f2;
  forces(at, x, f1, f2);
  // First the derivatives of the six equations, then their k-weighted products, then the
  // contribution of the forces.
  Eigen::MatrixXd derivative = Eigen::MatrixXd::Zero(6, 3 * n + m);
  Mat3 turned = Mat3::Zero();
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto k = static_cast<size_t>(i);
    const Vec3 a = at.rotation * arm_[k];
    derivative.block<3, 3>(0, 3 * i) = weight_[k] * Mat3::Identity();
    derivative.block<3, 3>(3, 3 * i) = weight_[k] / square_ * hat(a);
    turned += weight_[k] / square_ * hat(Vec3(x.row(ring_[k]))) * hat(a);
  }
  derivative.block(0, 3 * n, 3, m) =
      -at.position_axes + hat(at.rotation * mean_arm_) * at.rotation_axes;
  derivative.block(3, 3 * n, 3, m) = turned * at.rotation_axes;
  Vec6 k;
  k << Vec3::Constant(stiffness_), Vec3::Constant(stiffness_ * square_);
  Eigen::MatrixXd h = derivative.transpose() * k.asDiagonal() * derivative;
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto v = static_cast<size_t>(i);
    const Eigen::MatrixXd cross =
        -weight_[v] / square_ * hat(f2) * hat(at.rotation * arm_[v]) * at.rotation_axes;
    h.block(3 * i, 3 * n, 3, m) += cross;
    h.block(3 * n, 3 * i, m, 3) += cross.transpose();
  }
  Vec3 t;
  Mat3 spread;
  torque(at, x, f1, f2, t, spread);
  h.bottomRightCorner(m, m) += pose.curvature(at, t, spread).topLeftCorner(m, m);
  return h;
}

void SectionTie::reaction(const SectionPlacement& at, const Points& x, Vec3& force,
                          Vec3& moment) const {
  Vec3 f1, f2, t;
  Mat3 spread;
  forces(at, x, f1, f2);
  torque(at, x, f1, f2, t, spread);
  force = -f1;
  moment = t;
}

}  // namespace vasorod
