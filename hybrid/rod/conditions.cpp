#include "rod/conditions.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <numbers>

#include <vasorod/error.h>

#include "data/index.h"
#include "data/sentence.h"
#include "geometry/rigid_motion.h"

namespace vasorod {
namespace {

// Round-off of a direction along an axis is not shown.
std::string direction_text(const Vec3& v) {
  return place_text(v.unaryExpr([](double x) { return std::abs(x) < 1e-9 ? 0. : x; }), 3);
}

/// Tests the matrix scaled to a unit diagonal, so that slenderness does not hide indefiniteness.
bool is_positive_definite(const Mat6& c) {
  const Vec6 diagonal = c.diagonal();
  if (!(diagonal.minCoeff() > 0)) return false;
  const Vec6 s = diagonal.cwiseSqrt().cwiseInverse();
  const Mat6 scaled = s.asDiagonal() * c * s.asDiagonal();
  return Eigen::SelfAdjointEigenSolver<Mat6>(scaled, Eigen::EigenvaluesOnly).eigenvalues()[0] >=
         1e-13;
}

}  // namespace

RodSupport clamp(int node) {
  RodSupport support;
  support.node = node;
  return support;
}

RodSupport clamp_at(const RodTree& tree, int node, const Pose& target) {
  RodSupport support = clamp(node);
  const Pose& rest = tree.rest.at(index(node));
  support.motion.rotate = log_rotation(target.rotation * rest.rotation.transpose());
  support.motion.move = target.position - rest.position;
  return support;
}

Pose target_pose(const RodTree& tree, const RodSupport& support, double t) {
  const Pose& rest = tree.rest.at(index(support.node));
  return {exp_rotation(t * support.motion.rotate) * rest.rotation,
          rest.position + t * support.motion.move};
}

double length_scale(const RodTree& tree) {
  std::vector<double> way(index(tree.node_count()), 0);
  double longest = 0;
  // elements may be listed in any order; the branches are ordered parents first, so one walk along
  // them suffices
  for (const RodBranch& branch : tree.branches)
    for (std::size_t i = 0; i < branch.elements.size(); ++i) {
      const double end =
          way[index(branch.nodes[i])] + tree.elements[index(branch.elements[i])].length;
      way[index(branch.nodes[i + 1])] = end;
      longest = std::max(longest, end);
    }
  return longest;
}

Eigen::Matrix<double, 6, Eigen::Dynamic> free_rigid_motions(const RodTree& tree,
                                                            const RodConditions& conditions,
                                                            double scale) {
  std::vector<Vec6> rows;
  for (const RodSupport& support : conditions.supports) {
    const Pose pose = target_pose(tree, support, 0);
    const Mat3 frame = support.frame.value_or(pose.rotation);
    for (int k = 0; k < 6; ++k) {
      if (!support.fixed[index(k)]) continue;
      const Vec3 axis = frame.col(k % 3);
      Vec6 row;
      if (k < 3)
        row << axis, (pose.position / scale).cross(axis);
      else
        row << Vec3::Zero(), axis;
      rows.push_back(row);
    }
  }
  Mat6 gram = Mat6::Zero();
  for (const Vec6& row : rows) gram += row * row.transpose();
  const Eigen::SelfAdjointEigenSolver<Mat6> eigen(gram);
  const double limit = 1e-14 * std::max(1e-300, eigen.eigenvalues()[5]);
  int count = 0;
  while (count < 6 && eigen.eigenvalues()[count] <= limit) ++count;
  return eigen.eigenvectors().leftCols(count);
}

std::string describe_rigid_motion(const Vec6& twist, double scale) {
  const Vec3 v = twist.head<3>(), u = twist.tail<3>();
  if (u.norm() < 1e-6) return "translation along " + direction_text(v.normalized());
  const Vec3 axis = u.normalized(), point = u.cross(v) / u.squaredNorm() * scale;
  return "rotation about the axis " + direction_text(axis) + " through " + direction_text(point);
}

void check_tree(const RodTree& tree, const std::string& where) {
  const int n = tree.node_count();
  const auto fail = [&](const std::string& sentence) { throw InputError(where + ": " + sentence); };
  if (n < 2 || tree.elements.empty()) fail("the rod has no element, expected at least one");
  if (static_cast<int>(tree.elements.size()) != n - 1)
    fail("found " + number_text(static_cast<double>(tree.elements.size())) + " elements between " +
         number_text(n) + " nodes, expected one less than nodes (a tree without closed loops)");
  for (int i = 0; i < n; ++i) {
    const Pose& pose = tree.rest[index(i)];
    if (!pose.rotation.allFinite() || !pose.position.allFinite())
      fail("the rest frame of node " + number_text(i) + " is not finite");
    if ((pose.rotation.transpose() * pose.rotation - Mat3::Identity()).norm() > 1e-6 ||
        pose.rotation.determinant() < 0)
      fail("the rest frame of node " + number_text(i) + " is not right-handed and orthonormal");
  }
  std::vector<int> parent(index(n), -1);
  for (std::size_t e = 0; e < tree.elements.size(); ++e) {
    const RodElement& element = tree.elements[e];
    const auto name = [e] { return "element " + std::to_string(e); };
    if (element.first < 0 || element.first >= n || element.second < 0 || element.second >= n ||
        element.first == element.second)
      fail(name() + " joins nodes " + number_text(element.first) + " and " +
           number_text(element.second) + ", expected two different nodes of the rod");
    if (!(element.length > 0) || !std::isfinite(element.length))
      fail(name() + " has length " + number_text(element.length) + ", expected a positive number");
    if (!element.natural_strain.allFinite() || !element.rest_strain.allFinite() ||
        !element.stiffness.allFinite() || !element.lumen.allFinite())
      fail(name() + " has a strain, stiffness or lumen that is not finite");
    const double turn = element.length * element.natural_strain.tail<3>().norm();
    if (turn >= std::numbers::pi)
      fail(name() + " turns by " + number_text(turn * 180 / std::numbers::pi) +
           " degrees in its natural shape, expected below 180: use more elements");
    const Mat6& c = element.stiffness;
    if (e == 0 || c != tree.elements[e - 1].stiffness) {
      if ((c - c.transpose()).norm() > 1e-9 * c.norm())
        fail(name() + " has a stiffness matrix that is not symmetric");
      if (!is_positive_definite(c)) fail(name() + " has a stiffness that is not positive definite");
    }
    if (element.second == 0)
      fail(name() + " leads into node 0, expected every element to lead away from that root");
    if (parent[index(element.second)] >= 0)
      fail("two elements lead into node " + number_text(element.second) +
           ": the rod has a closed loop or a reversed element");
    parent[index(element.second)] = element.first;
  }
  // every node but the root has exactly one incoming element, so nodes not reached from the root
  // form a cycle
  std::vector<char> reached(index(n), 0);
  reached[0] = 1;
  std::vector<int> way;
  for (int i = 0; i < n; ++i) {
    int at = i;
    for (way.clear(); at >= 0 && !reached[index(at)]; at = parent[index(at)]) {
      way.push_back(at);
      if (static_cast<int>(way.size()) > n) break;
    }
    if (at < 0 || !reached[index(at)])
      fail("node " + number_text(i) + " is not connected to the root, expected one connected tree");
    for (const int node : way) reached[index(node)] = 1;
  }
}

void check_conditions(const RodTree& tree, const RodConditions& conditions,
                      const std::string& where) {
  const auto fail = [&](const std::string& sentence) { throw InputError(where + ": " + sentence); };
  const int n = tree.node_count();
  std::vector<bool> supported(index(n), false);
  for (const RodSupport& s : conditions.supports) {
    if (s.node < 0 || s.node >= n)
      fail("a support names node " + number_text(s.node) + ", expected 0 to " + number_text(n - 1));
    if (supported[index(s.node)])
      fail("node " + number_text(s.node) + " has two supports, expected at most one");
    supported[index(s.node)] = true;
    if (!s.motion.rotate.allFinite() || !s.motion.move.allFinite())
      fail("the motion of node " + number_text(s.node) + " is not finite");
    if (s.frame && ((s.frame->transpose() * *s.frame - Mat3::Identity()).norm() > 1e-6 ||
                    s.frame->determinant() < 0))
      fail("the support's frame at node " + number_text(s.node) +
           " is not right-handed and orthonormal");
  }
  const double scale = length_scale(tree);
  Vec6 total = Vec6::Zero();
  double size = 0;
  for (const RodLoad& load : conditions.loads) {
    if (load.node < 0 || load.node >= n)
      fail("a load names node " + number_text(load.node) + ", expected 0 to " + number_text(n - 1));
    if (!load.force.allFinite() || !load.moment.allFinite())
      fail("the load of node " + number_text(load.node) + " is not finite");
    const Pose& pose = tree.rest[index(load.node)];
    const Vec3 moment =
        (load.moment_in_body ? Vec3(pose.rotation * load.moment) : load.moment) / scale;
    total.head<3>() += load.force;
    total.tail<3>() += moment + (pose.position / scale).cross(load.force);
    size += load.force.norm() + moment.norm();
  }
  const auto motions = free_rigid_motions(tree, conditions, scale);
  for (Eigen::Index k = 0; k < motions.cols(); ++k)
    if (std::abs(motions.col(k).dot(total)) > 1e-9 * size) {
      // the free motion that the load drives
      Vec6 driven = motions * (motions.transpose() * total);
      // reported as a translation if the direction of the total force is a free translation
      Vec6 translation = Vec6::Zero();
      translation.head<3>() = total.head<3>();
      if ((motions * (motions.transpose() * translation) - translation).norm() < 1e-9 * size &&
          translation.norm() > 1e-9 * size)
        driven = translation;
      fail("the loads drive a rigid motion that no support stops: " +
           describe_rigid_motion(driven, scale));
    }
}

}  // namespace vasorod
