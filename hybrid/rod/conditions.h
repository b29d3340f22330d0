// Supports, motions and loads of a rod: supports on any subset of a node's six freedoms, prescribed
// finite motions as paths, dead forces, and moments in space or body axes.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "rod/rod_tree.h"

namespace vasorod {

/// A prescribed rigid motion as a path in t from 0 to 1: rotation exp(t rotate) about the node's
/// rest position, then translation t move. `rotate` is a rotation vector in space axes, radians.
/// Lengths above 2 pi are followed as written. `move` is a length.
struct RodMotion {
  Vec3 rotate = Vec3::Zero();
  Vec3 move = Vec3::Zero();
};

/// Support of one node. `fixed` lists x, y, z, rx, ry, rz along the columns of `frame`: the
/// components of the position, and the components of the rotation vector from the orientation given
/// by the motion to the node's orientation. Two fixed rotations leave the spin about the third axis
/// free.
struct RodSupport {
  int node = 0;
  std::array<bool, 6> fixed{true, true, true, true, true, true};
  /// Right-handed orthonormal columns; by default the node's rest frame (d1, d2, d3).
  std::optional<Mat3> frame;
  RodMotion motion;
};

/// Dead load of one node: force and moment in space axes. With moment_in_body the components of the
/// moment refer to the node's own frame and turn with it.
struct RodLoad {
  int node = 0;
  Vec3 force = Vec3::Zero();
  Vec3 moment = Vec3::Zero();
  bool moment_in_body = false;
};

/// All supports and loads of a rod.
struct RodConditions {
  std::vector<RodSupport> supports;  ///< at most one per node
  std::vector<RodLoad> loads;        ///< any number per node; loads are summed
};

/// Fixes all six freedoms at rest.
RodSupport clamp(int node);
/// Fixes all six freedoms and moves them to `target` by the shortest rotation.
RodSupport clamp_at(const RodTree& tree, int node, const Pose& target);
/// The pose prescribed by a support's motion at time t.
Pose target_pose(const RodTree& tree, const RodSupport& support, double t = 1);

/// Rigid motions of the whole rod at rest that the supports leave free, as twists (v, u) in space
/// axes about the origin, orthonormal after scaling lengths by `scale`. One column per motion, at
/// most six.
Eigen::Matrix<double, 6, Eigen::Dynamic> free_rigid_motions(const RodTree& tree,
                                                            const RodConditions& conditions,
                                                            double scale);

/// Describes a twist in words: "rotation about (0, 0, 1) through (1, 0, 0)" or "translation along
/// (1, 0, 0)".
std::string describe_rigid_motion(const Vec6& twist, double scale);

/// Throws InputError (one sentence, beginning with `where`) when the tree is not a tree of valid
/// elements.
void check_tree(const RodTree& tree, const std::string& where = "rod");
/// Throws InputError (one sentence) when a condition is invalid, or when loads drive a rigid motion
/// that no support prevents.
void check_conditions(const RodTree& tree, const RodConditions& conditions,
                      const std::string& where = "rod");

/// The length that scales all lengths: the longest path from the root to a leaf.
double length_scale(const RodTree& tree);

}  // namespace vasorod
