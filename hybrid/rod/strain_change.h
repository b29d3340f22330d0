// Changes of strain in each element of a solved rod, the basis of metrics and validity.
#pragma once

#include <vector>

#include "rod/rod_tree.h"

namespace vasorod {

/// State of one element: present strain and its change from rest, order v1 v2 v3 u1 u2 u3, body
/// frame.
struct ElementChange {
  Vec6 strain = Vec6::Zero(), change = Vec6::Zero();
  double radius = 0;  ///< mid-wall, mean of its nodes, length
  /// First element of a side branch. The drawn axis may change direction within it, so its strain
  /// is not meaningful.
  bool at_fork = false;
  Vec3 rest_middle = Vec3::Zero();  ///< midway between its nodes at rest
  Vec3 middle = Vec3::Zero();       ///< midway between its nodes now

  double bending() const { return change.segment<2>(3).norm(); }  ///< change of (u1, u2), 1/length
  double twist() const { return change[5]; }                      ///< u3 - u3^0, 1/length
  /// v3 over its rest value. At a fork, where the axis turns away from d3: length over rest length.
  double stretch() const;
};

/// One entry per element.
std::vector<ElementChange> element_changes(const RodTree& rod, const RodPoses& poses);

/// The mean of the element changes at each node: strain and change. The first element of a side
/// branch is used only at nodes that have no other element.
std::vector<ElementChange> node_changes(const RodTree& rod,
                                        const std::vector<ElementChange>& elements);

}  // namespace vasorod
