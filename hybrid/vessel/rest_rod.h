// Converts a fitted centerline to a reference rod: nodes, twist-free frames, rest strains,
// branches.
#pragma once

#include "rod/rod_tree.h"
#include "vessel/centerline.h"

namespace vasorod {

/// A reference rod and its relation to the centerline.
struct RestRod {
  RodTree tree;  ///< rest strain = natural strain, stiffness zero, radius per node
  std::vector<std::vector<int>> branches_of;  ///< per curve: its branches in order
  /// Per curve: the parameter at which each of its branches ends.
  std::vector<std::vector<double>> branch_end;
};

/// `spacing`: element length over the local radius. `first_point` defines d1 at the root: it lies
/// in the half plane of d3 and d1. Frames are rotation minimising (double reflection, Wang et al.
/// 2008). The first frame of a branch after a fork is the fork's frame, rotated by the smallest
/// angle to the branch's tangent.
RestRod rest_rod(const Centerline& centerline, double spacing, const Vec3& first_point);

}  // namespace vasorod
