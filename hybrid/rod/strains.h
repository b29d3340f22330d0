// Strains and stresses along a rod, per element and averaged to nodes.
#pragma once

#include <vector>

#include "rod/rod_tree.h"

namespace vasorod {

/// Strain (v, u) of every element.
std::vector<Vec6> element_strains(const RodTree& tree, const RodPoses& poses);
/// Stress (n, m) of every element in body axes: C (strain - natural). Where a stiffness is huge,
/// RodSolution::stress holds the same numbers without the round-off that it amplifies.
std::vector<Vec6> element_stresses(const RodTree& tree, const RodPoses& poses);

/// Values per element -> values per node of one branch: mean of the two neighbours by length, at its ends the
/// one.
std::vector<Vec6> branch_node_values(const RodTree& tree, const RodBranch& branch,
                                     const std::vector<Vec6>& per_element);
/// The same for the whole tree; a node where branches meet has its parent branch's value.
std::vector<Vec6> node_values(const RodTree& tree, const std::vector<Vec6>& per_element);

/// Strains (v, u) averaged to nodes.
std::vector<Vec6> node_strains(const RodTree& tree, const RodPoses& poses);
/// Rest strains averaged to nodes.
std::vector<Vec6> node_rest_strains(const RodTree& tree);

/// Force and moment (space axes, about the element's first node) that must act on an element's start to carry
/// `stress`.
Vec6 start_wrench(const RodElement& element, const RodPoses& poses, const Vec6& stress);

}  // namespace vasorod
