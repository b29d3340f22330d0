// Rest data of the elastic binding between surface and rod: the rod coordinates of each vertex [6].
#pragma once

#include "rod/rod_tree.h"

namespace vasorod {

/// Rod coordinates of one vertex [6]:
///
/// ```
/// p = r(s) + x d1(s) + y d2(s) + z d3(s)
/// ```
///
/// z = 0 wherever a section passes through the vertex. z differs from zero only beyond the ends of
/// the rod and at forks.
struct RodCoordinates {
  int element = 0;            ///< index into RodTree::elements
  double s = 0;               ///< arc length within the element, 0 to its length, length unit
  Vec3 local = Vec3::Zero();  ///< (x, y, z) in the frame at s, length unit
};

/// One entry per vertex.
using Binding = std::vector<RodCoordinates>;

/// The frame of an element at arc length s within it: g_first exp(s * strain), with the strain of
/// the element in `poses`.
Pose frame_at(const RodTree& tree, const RodPoses& poses, int element, double s);

/// Binds every point (n x 3) to the rod's rest shape [6]. `branch_of` restricts the search: one
/// branch index per point, or empty if the tree has a single branch. Throws InputError when a
/// section plane would pass through the centre of curvature.
Binding bind(const RodTree& tree, const Points& points, const std::vector<int>& branch_of);

/// The rod coordinates of one point, searched over all branches, e.g. for a point picked on its
/// vessel. Distances are relative to the local radius where the tree has one.
RodCoordinates project(const RodTree& tree, const Vec3& point);

/// p' [6]: positions of the vertices, each moved rigidly with its section, when the rod has
/// `poses`. n x 3.
Points carried_points(const RodTree& tree, const RodPoses& poses, const Binding& binding);

/// R of [8] for each vertex: the rotation of its section from the rest shape to `poses`.
std::vector<Mat3> carried_rotations(const RodTree& tree, const RodPoses& poses,
                                    const Binding& binding);

}  // namespace vasorod
