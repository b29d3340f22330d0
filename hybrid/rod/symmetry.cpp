#include "rod/symmetry.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "geometry/rigid_motion.h"

namespace vasorod {
namespace {

using Vec7 = Eigen::Matrix<double, 7, 1>;

/// Whether rolling every section by the same angle changes the energy of no link.
bool sections_are_isotropic(const std::vector<RodLink>& links) {
  Mat6 roll = Mat6::Zero();
  roll.topLeftCorner<3, 3>() = roll.bottomRightCorner<3, 3>() = exp_rotation({0, 0, 1});
  return std::all_of(links.begin(), links.end(), [&](const RodLink& link) {
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

/// Whether, at two finite angles, the supports still hold and the loads do no work.
bool holds_at_finite_angles(const RodSymmetry& symmetry, const RodProblem& problem,
                            const RodState& state) {
  constexpr double tolerance = 1e-9;
  for (const NodeCondition& c : problem.conditions())
    for (const double t : {1., 2.3}) {
      const Pose& pose = state.poses[index(c.node)];
      const Pose now = moved(symmetry, pose, t);
      const Vec3 gap = c.frame.transpose() * (now.position - pose.position);
      const Vec3 turn =
          c.frame.transpose() * (log_rotation(now.rotation * c.target.rotation.transpose()) -
                                 log_rotation(pose.rotation * c.target.rotation.transpose()));
      for (int i = 0; i < 3; ++i)
        if ((c.fixed[index(i)] && std::abs(gap[i]) > tolerance) ||
            (c.fixed[index(3 + i)] && std::abs(turn[i]) > tolerance))
          return false;
      if (std::abs(c.force.dot(now.position - pose.position)) > tolerance * c.force.norm())
        return false;
      if ((c.space_moment.norm() > 0 || c.body_moment.norm() > 0) &&
          (now.rotation - pose.rotation).norm() > tolerance)
        return false;
    }
  return true;
}

/// Motions (move, turn, roll) that to first order violate no support, do no work, and move the
/// state.
std::vector<RodSymmetry> candidates(const RodProblem& problem, const RodState& state,
                                    bool with_roll) {
  std::vector<Vec7> rows;
  const auto add = [&](const Vec3& along, const Vec3& about, const Pose& pose) {
    // along . v + about . omega of velocity(), as a row for (move, turn, roll)
    Vec7 row;
    row << along, pose.position.cross(along) + about, about.dot(pose.director(3));
    if (row.norm() > 0) rows.push_back(row);
  };
  for (const NodeCondition& c : problem.conditions()) {
    const Pose& pose = state.poses[index(c.node)];
    const Mat3 inverse =
        left_jacobian_inverse(log_rotation(pose.rotation * c.target.rotation.transpose()));
    for (int i = 0; i < 3; ++i) {
      const Vec3 axis = c.frame.col(i);
      if (c.fixed[index(i)]) add(axis, Vec3::Zero(), pose);
      if (c.fixed[index(3 + i)]) add(Vec3::Zero(), inverse.transpose() * axis, pose);
    }
    const Vec6 load = c.load(pose);
    if (load.head<3>().norm() > 0) add(load.head<3>().normalized(), Vec3::Zero(), pose);
    if (load.tail<3>().norm() > 0) add(Vec3::Zero(), load.tail<3>().normalized(), pose);
  }
  if (!with_roll) rows.push_back(Vec7::Unit(6));
  Eigen::Matrix<double, 7, 7> gram = Eigen::Matrix<double, 7, 7>::Zero();
  for (const Vec7& row : rows) gram += row * row.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 7, 7>> eigen(gram);
  std::vector<RodSymmetry> found;
  for (int i = 0; i < 7 && eigen.eigenvalues()[i] < 1e-14; ++i) {
    const Vec7 p = eigen.eigenvectors().col(i);
    const RodSymmetry symmetry{p.head<3>(), p.segment<3>(3), p[6]};
    double largest = 0;
    for (const Pose& pose : state.poses)
      largest = std::max(largest, velocity(symmetry, pose).norm());
    if (largest > 1e-6) found.push_back(symmetry);
  }
  return found;
}

}  // namespace

std::vector<RodSymmetry> symmetries(const RodProblem& problem, const RodState& state) {
  std::vector<RodSymmetry> found = candidates(problem, state, true);
  if (found.empty()) return found;
  if (!sections_are_isotropic(problem.links())) found = candidates(problem, state, false);
  std::erase_if(found,
                [&](const RodSymmetry& s) { return !holds_at_finite_angles(s, problem, state); });
  return found;
}

std::vector<GaugeSpring> gauge_springs(const RodProblem& problem, const RodState& state) {
  std::vector<GaugeSpring> springs;
  for (const RodSymmetry& symmetry : symmetries(problem, state)) {
    GaugeSpring spring;
    for (std::size_t k = 0; k < state.poses.size(); ++k)
      if (const Vec6 zeta = velocity(symmetry, state.poses[k]); zeta.norm() > spring.along.norm()) {
        spring.along = zeta;
        spring.node = static_cast<int>(k);
      }
    spring.along *= std::sqrt(problem.weakest()) / spring.along.norm();
    springs.push_back(spring);
  }
  return springs;
}

std::string describe(const RodProblem& problem, const RodSymmetry& symmetry) {
  if (symmetry.turn.norm() < 1e-6 && symmetry.move.norm() < 1e-6)
    return "turning every section about its own axis";
  // About the space origin in the tree's own coordinates, lengths scaled.
  Vec6 twist;
  twist << symmetry.move - symmetry.turn.cross(problem.rod().origin / problem.rod().length),
      symmetry.turn;
  return "a " + describe_rigid_motion(twist, problem.rod().length) +
         (std::abs(symmetry.roll) > 1e-6 ? " while the sections turn back" : "");
}

}  // namespace vasorod
