// Rods shared by the rod benchmarks.
#pragma once

#include <numbers>

#include "geometry/rigid_motion.h"
#include "rod/newton.h"

namespace vasorod::bench {

/// Order: shear, shear, axial, bending, bending, torsion.
inline Mat6 stiffness(double ga, double ea, double ei, double gj) {
  Vec6 d;
  d << ga, ga, ea, ei, ei, gj;
  return d.asDiagonal();
}

/// Appends a branch of equal elements and returns its last node. `start` is relative to the frame
/// of node `from`.
inline int append(RodTree& tree, int from, const Pose& start, double length, const Vec3& curvature,
                  int elements, const Mat6& c) {
  RodBranch branch;
  for (std::size_t b = 0; b < tree.branches.size(); ++b)
    if (tree.branches[b].nodes.back() == from) branch.parent = static_cast<int>(b);
  if (tree.rest.empty()) tree.rest.emplace_back();
  branch.nodes.push_back(from);
  Pose pose = tree.rest[static_cast<std::size_t>(from)] * start;
  for (int i = 0; i < elements; ++i) {
    RodElement e;
    e.first = branch.nodes.back();
    e.second = tree.node_count();
    e.length = length / elements;
    e.rest_strain << 0, 0, 1, curvature;
    e.natural_strain = e.rest_strain;
    e.stiffness = c;
    if (i == 0) e.start = start;
    pose = pose * exp_motion(e.length * e.rest_strain);
    tree.rest.push_back(pose);
    branch.elements.push_back(static_cast<int>(tree.elements.size()));
    tree.elements.push_back(e);
    branch.nodes.push_back(e.second);
  }
  tree.branches.push_back(branch);
  return branch.nodes.back();
}

inline RodTree chain(double length, const Vec3& curvature, int elements, const Mat6& c) {
  RodTree tree;
  append(tree, 0, Pose{}, length, curvature, elements, c);
  return tree;
}

/// Clamped at node 0, dead force at the last node.
inline RodConditions cantilever(const RodTree& tree, const Vec3& force) {
  RodConditions conditions;
  conditions.supports = {clamp(0)};
  conditions.loads = {{tree.node_count() - 1, force, Vec3::Zero(), false}};
  return conditions;
}

/// Circular section of diameter d.
inline Mat6 round_wire(double d, double young, double shear) {
  const double area = std::numbers::pi * d * d / 4, inertia = area * d * d / 16;
  return stiffness(0.9 * shear * area, young * area, young * inertia, 2 * shear * inertia);
}

}  // namespace vasorod::bench
