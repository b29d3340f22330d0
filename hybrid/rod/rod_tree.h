// The reference rod [1-5] as data: a tree of two-node elements between rigid frames.
#pragma once

#include <vasorod/types.h>

namespace vasorod {

/// One two-node element. Strains are ordered (v1, v2, v3, u1, u2, u3) in the body frame: v1, v2
/// shear, v3 stretch, u1, u2 bending, u3 twist. The strain is constant between the nodes:
///
/// ```
/// g(s) = g_first exp(s * strain),   length * strain = log(g_first^-1 g_second)
/// ```
struct RodElement {
  int first = 0;                    ///< node at the smaller arc length (towards the tree's root)
  int second = 0;                   ///< node at the larger arc length
  double length = 0;                ///< rest arc length, length unit
  Vec6 rest_strain = Vec6::Zero();  ///< strain of the drawn shape (v = (0,0,1) when drawn along d3)
  /// Strain at which the element is unstressed [3]; equal to rest_strain for a fitted vessel.
  Vec6 natural_strain = Vec6::Zero();
  /// The element's own frame at its first node, relative to that node's frame. The identity, except
  /// where a branch of a bare rod leaves the end of its parent in another direction; the strains
  /// above are then measured from this frame.
  Pose start;
  /// C: energy per length is 1/2 (strain - natural)^T C (strain - natural).
  Mat6 stiffness = Mat6::Zero();
  /// Of the pressure in the lumen: the energy -lumen . (length * strain). Forces and moments
  /// conjugate to the strain (lumen_section.h); zero: no pressure.
  Vec6 lumen = Vec6::Zero();
};

/// A branch: a run of nodes and the elements between them, from the parent's end (or the root) to
/// its own end.
struct RodBranch {
  std::string name;
  /// At least 2; nodes.front() is the last node of the parent branch.
  std::vector<int> nodes;
  std::vector<int> elements;  ///< elements[i] joins nodes[i] and nodes[i + 1]
  int parent = -1;            ///< index of the parent branch, -1 for the root branch
};

/// A tree of rods. Every element is directed away from the root, node 0; branches meet in one rigid
/// frame.
struct RodTree {
  std::vector<Pose> rest;  ///< drawn (reference) pose of each node
  std::vector<RodElement> elements;
  std::vector<RodBranch> branches;  ///< parents before children; branches[0] starts at node 0
  std::vector<double> radius;  ///< mid-wall radius at each node, length unit; empty for a bare rod
  int node_count() const { return static_cast<int>(rest.size()); }
};

/// Per element: whether it is the first of a side branch, which leaves the fork's frame in another
/// direction.
std::vector<char> leaves_fork(const RodTree& rod);

/// A configuration of a rod tree: one pose per node.
using RodPoses = std::vector<Pose>;

}  // namespace vasorod
