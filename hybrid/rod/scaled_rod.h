// A rod tree in units of its own length and bending stiffness, so that mm or m, Pa or MPa give the
// same numbers.
#pragma once

#include <vector>

#include "rod/link.h"

namespace vasorod {

/// Units and node numbering of a scaled rod tree.
struct ScaledRod {
  /// Unit of length: the longest path from the root to a leaf.
  double length = 1;
  /// Unit of moment and energy: mean bending stiffness over that length.
  double moment = 1;
  Vec3 origin = Vec3::Zero();  ///< rest position of the root
  /// node_of: tree node of each scaled node (parents first). new_of: scaled node of each tree node.
  std::vector<int> node_of, new_of;
  std::vector<int> element_of;  ///< tree element of each link

  double force() const { return moment / length; }
  Pose scaled(const Pose& p) const { return {p.rotation, (p.position - origin) / length}; }
  Pose original(const Pose& p) const;
  /// C / length of an element.
  Mat6 stiffness(const RodElement& element) const;
  /// Gives a link another stiffness, and the natural strain that its element has with it.
  void set_stiffness(const RodElement& element, const Mat6& stiffness, RodLink& link) const;
};

/// Units and numbering for a tree.
ScaledRod scale(const RodTree& tree);
/// The elements as links between the renumbered nodes: link k leads to node k + 1.
std::vector<RodLink> scaled_links(const RodTree& tree, const ScaledRod& rod);

/// length * strain of link k.
Vec6 link_strain(const std::vector<RodLink>& links, const std::vector<Pose>& poses, std::size_t k);

/// Wrench (force, moment about the node; space axes) that a link's stress puts on its second node.
Vec6 wrench_on_second(const Pose& second, const Vec6& strain, const Vec6& stress);
/// The same link's wrench on its first node.
Vec6 wrench_on_first(const std::vector<RodLink>& links, const std::vector<Pose>& poses,
                     std::size_t k, const Vec6& on_second);

}  // namespace vasorod
