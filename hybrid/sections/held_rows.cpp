#include "sections/held_rows.h"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <numbers>

#include "data/index.h"
#include "geometry/rigid_motion.h"

namespace vasorod {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Orthonormal basis of the vectors that every row of `conditions` maps to zero.
MatrixXd null_space(const MatrixXd& conditions) {
  Eigen::ColPivHouseholderQR<MatrixXd> qr(conditions.transpose());
  qr.setThreshold(1e-10);
  const MatrixXd q = qr.householderQ();
  return q.rightCols(q.cols() - qr.rank());
}

// Points around the rim: many enough for products of three of its functions.
struct Rim {
  VectorXd angles;
  MatrixXd values;  // points x modes
  Eigen::MatrixX3d place, normal;
  VectorXd weight;  // of the rim's length, sum 1

  Rim(const SectionShape& rest, double u) {
    const int points = 8 * rest.space.harmonics + 8;
    angles = VectorXd::LinSpaced(points, 0, 2 * std::numbers::pi * (points - 1) / points);
    values = harmonic_values(angles, rest.space.harmonics, 0);
    place.resize(points, 3);
    normal.resize(points, 3);
    weight.resize(points);
    for (int q = 0; q < points; ++q) {
      const SurfaceJet jet = rest.jet(u, angles[q]);
      place.row(q) = rest.point(u, angles[q]).transpose();
      normal.row(q) = surface_frame(jet).col(0).transpose();
      weight[q] = jet.col(1).norm();
    }
    weight /= weight.sum();
  }
};

// Fields of one row whose component along the normal vanishes in all harmonics that its product
// with the normal of a round rim can have.
MatrixXd tangential_fields(const SectionShape& rest, double u) {
  const Rim rim(rest, u);
  const MatrixXd tests = harmonic_values(rim.angles, rest.space.harmonics + 1, 0);
  const int modes = rest.space.modes();
  MatrixXd conditions(tests.cols(), 3 * modes);
  for (int k = 0; k < 3; ++k)
    conditions.middleCols(k * modes, modes) = tests.transpose() * rim.normal.col(k).asDiagonal() *
                                              rim.values / static_cast<double>(rim.angles.size());
  return null_space(conditions);
}

// Fields of one row without a mean over the rim and without a mean moment about it.
MatrixXd meanless_fields(const SectionShape& rest, double u) {
  const Rim rim(rest, u);
  const int modes = rest.space.modes();
  const Vec3 mean = rim.place.transpose() * rim.weight;
  MatrixXd conditions = MatrixXd::Zero(6, 3 * modes);
  for (Eigen::Index q = 0; q < rim.angles.size(); ++q) {
    const Vec3 arm = rim.place.row(q).transpose() - mean;
    const Mat3 moment = hat(arm);
    for (int k = 0; k < 3; ++k) {
      const auto row = rim.weight[q] * rim.values.row(q);
      conditions.row(k).segment(k * modes, modes) += row;
      for (int i = 0; i < 3; ++i)
        conditions.row(3 + i).segment(k * modes, modes) += moment(i, k) / arm.norm() * row;
    }
  }
  return null_space(conditions);
}

}  // namespace

HeldRows::HeldRows(const HeldSection& section, const SectionShape& rest, bool last)
    : pose(section) {
  const int count = rest.space.along.count(), size = rest.space.row_size();
  const double u = last ? 1 : 0;
  rows_ = {last ? count - 1 : 0};
  if (section.rigid) {
    rows_.push_back(last ? count - 2 : 1);
    const MatrixXd tangential = tangential_fields(rest, u);
    fields_.setZero(2 * size, tangential.cols());
    fields_.bottomRows(size) = tangential;
  } else {
    fields_ = meanless_fields(rest, u);
  }
  for (const int row : rows_) {
    rest_.emplace_back(rest.coefficients.col(row).reshaped(rest.space.modes(), 3));
    rest_.back().row(0) -= section.rest.position.transpose();
  }
}

HeldRows::Arms HeldRows::arms(const VectorXd& z, size_t a) const {
  const Eigen::Index modes = rest_[a].rows(), size = 3 * modes;
  const VectorXd field =
      fields_.middleRows(static_cast<Eigen::Index>(a) * size, size) * z.tail(fields_.cols());
  return rest_[a] + field.reshaped(modes, 3);
}

void HeldRows::place(const VectorXd& z, MatrixXd& coefficients) const {
  const SectionPlacement at = pose.place(z.data());
  for (size_t a = 0; a < rows_.size(); ++a) {
    Arms row = arms(z, a) * at.rotation.transpose();
    row.row(0) += at.position.transpose();
    coefficients.col(rows_[a]) = row.reshaped();
  }
}

MatrixXd HeldRows::derivative(const VectorXd& z) const {
  const SectionPlacement at = pose.place(z.data());
  const int poses = pose.unknowns();
  MatrixXd derivative = MatrixXd::Zero(fields_.rows() == 0 ? 0 : fields_.rows(), unknowns());
  for (size_t a = 0; a < rows_.size(); ++a) {
    const Eigen::Index modes = rest_[a].rows(), first = static_cast<Eigen::Index>(a) * 3 * modes;
    const Arms now = arms(z, a) * at.rotation.transpose();
    for (int k = 0; k < poses; ++k) {
      Arms change = now * hat(at.rotation_axes.col(k)).transpose();
      change.row(0) += at.position_axes.col(k).transpose();
      derivative.col(k).segment(first, 3 * modes) = change.reshaped();
    }
    for (Eigen::Index j = 0; j < fields_.cols(); ++j) {
      const Arms turned =
          fields_.col(j).segment(first, 3 * modes).reshaped(modes, 3) * at.rotation.transpose();
      derivative.col(poses + j).segment(first, 3 * modes) = turned.reshaped();
    }
  }
  return derivative;
}

MatrixXd HeldRows::curvature(const VectorXd& z, const MatrixXd& gradient) const {
  const SectionPlacement at = pose.place(z.data());
  const int poses = pose.unknowns();
  MatrixXd curvature = MatrixXd::Zero(unknowns(), unknowns());
  if (poses == 0) return curvature;
  Vec3 torque = Vec3::Zero();
  Mat3 outer = Mat3::Zero();
  for (size_t a = 0; a < rows_.size(); ++a) {
    const Eigen::Index modes = rest_[a].rows(), first = static_cast<Eigen::Index>(a) * 3 * modes;
    const Arms now = arms(z, a) * at.rotation.transpose();
    const Arms force = gradient.col(rows_[a]).reshaped(modes, 3);
    outer += now.transpose() * force;
    for (Eigen::Index m = 0; m < modes; ++m) torque += Vec3(now.row(m)).cross(Vec3(force.row(m)));
    for (Eigen::Index j = 0; j < fields_.cols(); ++j) {
      const Arms field =
          fields_.col(j).segment(first, 3 * modes).reshaped(modes, 3) * at.rotation.transpose();
      Vec3 moment = Vec3::Zero();
      for (Eigen::Index m = 0; m < modes; ++m)
        moment += Vec3(field.row(m)).cross(Vec3(force.row(m)));
      const VectorXd mixed = at.rotation_axes.transpose() * moment;
      curvature.col(poses + j).head(poses) += mixed;
      curvature.row(poses + j).head(poses) += mixed.transpose();
    }
  }
  curvature.topLeftCorner(poses, poses) =
      pose.curvature(at, torque, outer - outer.trace() * Mat3::Identity())
          .topLeftCorner(poses, poses);
  return curvature;
}

VectorXd HeldRows::unknowns_of(const Mat3& rotation, const Vec3& position,
                               const MatrixXd& coefficients) {
  VectorXd z = VectorXd::Zero(unknowns());
  pose.unknowns_of(rotation, position, z.data());
  const SectionPlacement at = pose.place(z.data());
  VectorXd field(fields_.rows());
  for (size_t a = 0; a < rows_.size(); ++a) {
    const Eigen::Index modes = rest_[a].rows(), first = static_cast<Eigen::Index>(a) * 3 * modes;
    Arms row = coefficients.col(rows_[a]).reshaped(modes, 3);
    row.row(0) -= at.position.transpose();
    field.segment(first, 3 * modes) = (row * at.rotation - rest_[a]).reshaped();
  }
  z.tail(fields_.cols()) = fields_.transpose() * field;
  return z;
}

void HeldRows::wrench(const VectorXd& z, const MatrixXd& gradient, Vec3& force,
                      Vec3& moment) const {
  const SectionPlacement at = pose.place(z.data());
  force.setZero();
  moment.setZero();
  for (size_t a = 0; a < rows_.size(); ++a) {
    const Eigen::Index modes = rest_[a].rows();
    const Arms now = arms(z, a) * at.rotation.transpose();
    const Arms of_row = gradient.col(rows_[a]).reshaped(modes, 3);
    force += of_row.row(0).transpose();
    for (Eigen::Index m = 0; m < modes; ++m) moment += Vec3(now.row(m)).cross(Vec3(of_row.row(m)));
  }
}

}  // namespace vasorod
