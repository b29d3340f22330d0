// Strains and stresses along a rod, per element and averaged to nodes.
#pragma once

#include <vector>

#include "rod/rod_tree.h"

namespace vasorod {

/// Strain (v, u) of every element.
std::vector<Vec6> element_strains(const RodTree& tree, const RodPoses& poses);

/// Values per element -> values per node of one branch: mean of the two neighbours by length, at
/// its ends the one.
std::vector<Vec6> branch_node_values(const RodTree& tree, const RodBranch& branch,
                                     const std::vector<Vec6>& per_element);

/// Force and moment (space axes, about the element's first node) that must act on an element's
/// start to carry `stress`.
Vec6 start_wrench(const RodElement& element, const RodPoses& poses, const Vec6& stress);

}  // namespace vasorod
