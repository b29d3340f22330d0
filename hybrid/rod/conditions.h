// What holds, moves and loads a rod: supports on any subset of a node's six freedoms, prescribed
// finite motions as paths, dead forces, moments in space or body axes.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "rod/rod_tree.h"

namespace vasorod {

/// A prescribed rigid motion as a path in t from 0 to 1: rotation exp(t rotate) about the node's
/// rest position, then t move. `rotate` is a rotation vector in space axes, radians; its length may
/// exceed 2 pi and is then meant.
struct RodMotion {
  Vec3 rotate = Vec3::Zero();
  Vec3 move = Vec3::Zero();
};

/// Support of one node. fixed = x, y, z, rx, ry, rz along the columns of `frame`: the position's
/// components, and the components of the rotation vector of the node's rotation away from where the
/// motion puts it. Two fixed rotations leave the spin about the third axis.
struct RodSupport {
  int node = 0;
  std::array<bool, 6> fixed{true, true, true, true, true, true};
  std::optional<Mat3>
      frame;  ///< right-handed orthonormal columns; by default the node's rest frame (d1, d2, d3)
  RodMotion motion;
};

/// Dead load of one node: force and moment in space axes; with moment_in_body the moment's
/// components are in the node's own frame and turn with it.
struct RodLoad {
  int node = 0;
  Vec3 force = Vec3::Zero();
  Vec3 moment = Vec3::Zero();
  bool moment_in_body = false;
};

struct RodConditions {
  std::vector<RodSupport> supports;  ///< at most one per node
  std::vector<RodLoad> loads;        ///< any number per node; they add up
};

/// All six freedoms held at rest.
RodSupport clamp(int node);
/// All six freedoms, carried to `target` by the shortest rotation.
RodSupport clamp_at(const RodTree& tree, int node, const Pose& target);
/// Where a support's motion puts its node at time t.
Pose target_pose(const RodTree& tree, const RodSupport& support, double t = 1);

/// Rigid motions the supports leave to the whole rod at rest, as twists (v, u) in space axes about
/// the origin, orthonormal after scaling lengths by `scale`; columns, at most six.
Eigen::Matrix<double, 6, Eigen::Dynamic> free_rigid_motions(const RodTree& tree,
                                                            const RodConditions& conditions,
                                                            double scale);

/// A few words for a twist: "rotation about (0, 0, 1) through (1, 0, 0)" or "translation along (1,
/// 0, 0)".
std::string describe_rigid_motion(const Vec6& twist, double scale);

/// Throws InputError (one sentence, beginning with `where`) when the tree is not a tree of valid
/// elements.
void check_tree(const RodTree& tree, const std::string& where = "rod");
/// Throws InputError when a condition is wrong, or when loads drive a rigid motion that no support
/// stops.
void check_conditions(const RodTree& tree, const RodConditions& conditions,
                      const std::string& where = "rod");

/// Length all lengths are scaled by: the longest way from the root to a leaf.
double length_scale(const RodTree& tree);

}  // namespace vasorod
