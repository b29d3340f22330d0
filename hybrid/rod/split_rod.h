// Cuts a rod at a section and keeps one side.
#pragma once

#include "rod/binding.h"
#include "rod/rod_tree.h"

namespace vasorod {

/// A rod made from another rod. Along a branch, each node has a higher index than the node before
/// it.
struct RodPart {
  RodTree tree;
  int cut_node = 0;          ///< the node at the cut
  std::vector<int> node_of;  ///< per original node: its index here, -1 if removed
};

/// Inserts a node in the element at arc length s within it, 0 < s < length (at 0 or length, the
/// existing node is the cut). Both parts keep the element's strains and stiffness, so energy and
/// shape do not change.
RodPart split_rod(const RodTree& tree, int element, double s);

/// The side of a cut that is kept: the one with the tree's root, or the one away from it.
enum class RodSide { towards_root, away_from_root };

/// Splits at (element, s) and keeps one side. Directions do not change: towards the root, the cut
/// node is the last of its branch; away from it, the cut node is the new root, node 0. Branches
/// entirely on the other side are removed.
RodPart cut_rod(const RodTree& tree, int element, double s, RodSide side);

/// The side of the cut on which `node` lies.
RodSide side_of(const RodTree& tree, int element, double s, int node);

}  // namespace vasorod
