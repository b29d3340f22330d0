#include "rod/symmetry.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "geometry/rigid_motion.h"

namespace vasorod {
namespace {

using Vec7 = Eigen::Matrix<double, 7, 1>;

/// Rolling every section by the same angle changes no link's energy.
bool sections_are_isotropic(const ScaledRod& rod) {
  Mat6 roll = Mat6::Zero();
  roll.topLeftCorner<3, 3>() = roll.bottomRightCorner<3, 3>() = exp_rotation({0, 0, 1});
  return std::all_of(rod.links.begin(), rod.links.end(), [&](const RodLink& link) {
    const Vec6 s = link.stiffness.diagonal().cwiseSqrt().cwiseInverse();
    const Mat6 change = roll * link.stiffness * roll.transpose() - link.stiffness;
    const Vec6 turned = roll * link.natural - link.natural;
    return (s.asDiagonal() * change * s.asDiagonal()).cwiseAbs().maxCoeff() < 1e-12 &&
           turned.cwiseAbs().maxCoeff() < 1e-14 &&
           (link.start.rotation * Vec3::UnitZ() - Vec3::UnitZ()).norm() < 1e-14 &&
           link.start.position.head<2>().norm() < 1e-14;
  });
}

Vec6 velocity(const RodSymmetry& symmetry, const Pose& pose) {
  Vec6 zeta;
  zeta << symmetry.move + symmetry.turn.cross(pose.position),
      symmetry.turn + symmetry.roll * pose.director(3);
  return zeta;
}

/// The pose at angle t along the symmetry.
Pose moved(const RodSymmetry& symmetry, const Pose& pose, double t) {
  Vec6 twist;
  twist << t * symmetry.move, t * symmetry.turn;
  Pose result = exp_motion(twist) * pose;
  result.rotation = result.rotation * exp_rotation({0, 0, t * symmetry.roll});
  return result;
}

/// Supports still hold and loads do no work, at two angles.
bool holds_at_finite_angles(const RodSymmetry& symmetry, const RodProblem& problem, const RodState& state) {
  constexpr double tolerance = 1e-9;
  for (const NodeCondition& c : problem.conditions())
    for (const double t : {1., 2.3}) {
      const Pose& pose = state.poses[index(c.node)];
      const Pose now = moved(symmetry, pose, t);
      const Vec3 gap = c.frame.transpose() * (now.position - pose.position);
      const Vec3 turn = c.frame.transpose() * (log_rotation(now.rotation * c.target.rotation.transpose()) -
                                               log_rotation(pose.rotation * c.target.rotation.transpose()));
      for (int i = 0; i < 3; ++i)
        if ((c.fixed[index(i)] && std::abs(gap[i]) > tolerance) ||
            (c.fixed[index(3 + i)] && std::abs(turn[i]) > tolerance))
          return false;
      if (std::abs(c.force.dot(now.position - pose.position)) > tolerance * c.force.norm()) return false;
      if ((c.space_moment.norm() > 0 || c.body_moment.norm() > 0) &&
          (now.rotation - pose.rotation).norm() > tolerance)
        return false;
    }
  return true;
}

}  // namespace

std::vector<RodSymmetry> symmetries(const RodProblem& problem, const RodState& state) {
  std::vector<Vec7> rows;
  const auto add = [&](const Vec3& along, const Vec3& about, const Pose& pose) {
    // along . v + about . omega of velocity(), as a row for (move, turn, roll)
    Vec7 row;
    row << along, pose.position.cross(along) + about, about.dot(pose.director(3));
    if (row.norm() > 0) rows.push_back(row);
  };
  for (const NodeCondition& c : problem.conditions()) {
    const Pose& pose = state.poses[index(c.node)];
    const Mat3 inverse = left_jacobian_inverse(log_rotation(pose.rotation * c.target.rotation.transpose()));
    for (int i = 0; i < 3; ++i) {
      const Vec3 axis = c.frame.col(i);
      if (c.fixed[index(i)]) add(axis, Vec3::Zero(), pose);
      if (c.fixed[index(3 + i)]) add(Vec3::Zero(), inverse.transpose() * axis, pose);
    }
    const Vec6 load = c.load(pose);
    if (load.head<3>().norm() > 0) add(load.head<3>().normalized(), Vec3::Zero(), pose);
    if (load.tail<3>().norm() > 0) add(Vec3::Zero(), load.tail<3>().normalized(), pose);
  }
  if (!sections_are_isotropic(problem.rod())) rows.push_back(Vec7::Unit(6));
  Eigen::MatrixXd matrix =
      Eigen::MatrixXd::Zero(std::max<Eigen::Index>(7, static_cast<Eigen::Index>(rows.size())), 7);
  for (std::size_t i = 0; i < rows.size(); ++i)
    matrix.row(static_cast<Eigen::Index>(i)) = rows[i].transpose();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(matrix, Eigen::ComputeFullV);
  std::vector<RodSymmetry> found;
  for (Eigen::Index i = 0; i < 7; ++i) {
    if (svd.singularValues()[i] > 1e-9) continue;
    const Vec7 p = svd.matrixV().col(i);
    const RodSymmetry symmetry{p.head<3>(), p.segment<3>(3), p[6]};
    double largest = 0;
    for (const Pose& pose : state.poses) largest = std::max(largest, velocity(symmetry, pose).norm());
    if (largest > 1e-6 && holds_at_finite_angles(symmetry, problem, state)) found.push_back(symmetry);
  }
  return found;
}

std::string describe(const RodProblem& problem, const RodSymmetry& symmetry) {
  if (symmetry.turn.norm() < 1e-6 && symmetry.move.norm() < 1e-6)
    return "turning every section about its own axis";
  Vec6 twist;  // about the space origin in the tree's own place, lengths scaled
  twist << symmetry.move - symmetry.turn.cross(problem.rod().origin / problem.rod().length), symmetry.turn;
  return "a " + describe_rigid_motion(twist, problem.rod().length) +
         (std::abs(symmetry.roll) > 1e-6 ? " while the sections turn back" : "");
}

}  // namespace vasorod
