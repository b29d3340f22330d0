// Cuts a rod at a section and keeps one side of it.
#pragma once

#include "rod/binding.h"
#include "rod/rod_tree.h"

namespace vasorod {

/// A rod made from another. Node indices keep the rule that a node comes after the one before it on
/// its branch.
struct RodPart {
  RodTree tree;
  int cut_node = 0;          ///< the node at the cut
  std::vector<int> node_of;  ///< per node of the original: its index here, -1 where it was left out
};

/// Inserts a node in the element at arc length s within it, 0 < s < length (at 0 or length the
/// element's own node is the cut). Both parts keep the element's strains and stiffness, so energy
/// and shape are unchanged.
RodPart split_rod(const RodTree& tree, int element, double s);

/// Which side of a cut goes on: the one with the tree's root, or the one away from it.
enum class RodSide { towards_root, away_from_root };

/// Splits at (element, s) and keeps one side. Directions are kept: towards the root the cut node is
/// the last of its branch, away from it the cut node is the new root, node 0. Branches wholly on
/// the other side are left out.
RodPart cut_rod(const RodTree& tree, int element, double s, RodSide side);

/// The side of the cut on which `node` lies.
RodSide side_of(const RodTree& tree, int element, double s, int node);

}  // namespace vasorod
