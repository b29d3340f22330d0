// Strains and stresses along a rod, per element and averaged to nodes.
#pragma once

#include <vector>

#include "rod/rod_tree.h"

namespace vasorod {

/// Strain (v, u) of every element.
std::vector<Vec6> element_strains(const RodTree& tree, const RodPoses& poses);

/// Averages values per element to the nodes of one branch: at inner nodes the length-weighted mean
/// of the two neighbours, at the ends the value of the one element.
std::vector<Vec6> branch_node_values(const RodTree& tree, const RodBranch& branch,
                                     const std::vector<Vec6>& per_element);

/// The wrench (force, moment; space axes, moment about the element's first node) that must act on
/// the start of an element to produce `stress`.
Vec6 start_wrench(const RodElement& element, const RodPoses& poses, const Vec6& stress);

}  // namespace vasorod
