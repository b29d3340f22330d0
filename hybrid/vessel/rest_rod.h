// A fitted centerline as a reference rod: nodes, twist-free frames, rest strains, branches.
#pragma once

#include "rod/rod_tree.h"
#include "vessel/centerline.h"

namespace vasorod {

struct RestRod {
  RodTree tree;  ///< rest strain = natural strain, stiffness zero, radius per node
  std::vector<std::vector<int>> branches_of;  ///< per curve: its branches in order
  std::vector<std::vector<double>>
      branch_end;  ///< per curve: the parameter at which each of them ends
};

/// `spacing`: element length over the local radius. `first_point` gives d1 at the root: it lies in
/// the half plane of d3 and d1. Frames are rotation minimising (double reflection, Wang et al.
/// 2008); a branch's first frame after a fork is the fork's, turned the shortest way to its own
/// tangent.
RestRod rest_rod(const Centerline& centerline, double spacing, const Vec3& first_point);

}  // namespace vasorod
