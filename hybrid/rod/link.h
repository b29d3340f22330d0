// Data shared by the parts of the solver: elements as links between numbered nodes, and the
// conditions at a node. Scaled units.
#pragma once

#include <array>

#include "rod/rod_tree.h"

namespace vasorod {

/// An element between scaled, renumbered nodes: link k connects node k + 1 to the node `parent`.
struct RodLink {
  int parent = 0;
  double length = 0;
  bool starts_at_node = true;  ///< false: `start` is the link's own frame at its parent
  Pose start;
  Vec6 natural = Vec6::Zero();    ///< length * natural strain, that under `lumen` included
  Mat6 stiffness = Mat6::Zero();  ///< C / length
  Vec6 lumen = Vec6::Zero();      ///< RodElement::lumen
};

/// The link's strain under a stress: stiffness^-1 stress.
Vec6 elastic_strain(const RodLink& link, const Vec6& stress);

/// The frame a link starts from.
inline Pose link_start(const RodLink& link, const Pose& parent) {
  return link.starts_at_node ? parent : parent * link.start;
}

/// Support and loads of one node. Scaled forces.
struct NodeCondition {
  int node = 0;
  std::array<bool, 6> fixed{};
  Mat3 frame = Mat3::Identity();
  Pose target;  ///< at the present time of the motion's path
  Vec3 force = Vec3::Zero(), space_moment = Vec3::Zero(), body_moment = Vec3::Zero();
  /// Force and moment about the node that the stresses of its links pass to it. In equilibrium it
  /// equals the load plus the reaction.
  Vec6 carried = Vec6::Zero();

  Vec6 load(const Pose& pose) const;  ///< force and moment in space axes
  int fixed_count() const;
  bool supported() const { return fixed_count() > 0; }
};

}  // namespace vasorod
