// The surface's elastic binding to the rod, rest data: the rod coordinates of each vertex [6].
#pragma once

#include "rod/rod_tree.h"

namespace vasorod {

/// Rod coordinates of one vertex: p = r(s) + x d1(s) + y d2(s) + z d3(s) with z = 0 wherever a
/// section passes through the vertex; z differs from zero only beyond the rod's ends and at forks
/// [6].
struct RodCoordinates {
  int element = 0;            ///< index into RodTree::elements
  double s = 0;               ///< arc length within the element, 0 to its length, length unit
  Vec3 local = Vec3::Zero();  ///< (x, y, z) in the frame at s, length unit
};

/// One entry per vertex.
using Binding = std::vector<RodCoordinates>;

/// The frame the element carries at arc length s within it: g_first exp(s * strain), with the
/// strain the element has in `poses`.
Pose frame_at(const RodTree& tree, const RodPoses& poses, int element, double s);

/// Binds every point to the rod's rest shape [6]. `branch_of` (one branch index per point, or empty
/// for a single branch tree) restricts the search. Throws InputError when a section plane would
/// pass through the centre of curvature.
Binding bind(const RodTree& tree, const Points& points, const std::vector<int>& branch_of);

/// The rod coordinates of one point, over all branches: a picked point on its vessel. Distances are
/// compared over the local radius where the tree has one.
RodCoordinates project(const RodTree& tree, const Vec3& point);

/// p' [6]: where its section carries each vertex when the rod has `poses`. n x 3.
Points carried_points(const RodTree& tree, const RodPoses& poses, const Binding& binding);

/// R of [8] for each vertex: the rotation of its section from the rest shape to `poses`.
std::vector<Mat3> carried_rotations(const RodTree& tree, const RodPoses& poses,
                                    const Binding& binding);

}  // namespace vasorod
