// Rods shared by the tests.
#pragma once

#include <vector>

#include "geometry/rigid_motion.h"
#include "rod/newton.h"

namespace vasorod {

inline Vec6 vec6(double a, double b, double c, double d, double e, double f) {
  Vec6 x;
  x << a, b, c, d, e, f;
  return x;
}

/// Start frame with given tangent (d3) and normal (d1).
inline Pose frame(const Vec3& position, const Vec3& tangent, const Vec3& normal) {
  Pose p;
  p.position = position;
  const Vec3 d3 = tangent.normalized(), d1 = (normal - d3 * d3.dot(normal)).normalized();
  p.rotation << d1, d3.cross(d1), d3;
  return p;
}

/// Appends a branch of equal elements with constant drawn curvature at node `from` (or a root at
/// `start`).
inline int append(RodTree& tree, const Pose& start, int from, double length, const Vec3& curvature,
                  int elements, const Vec6& stiffness) {
  RodBranch branch;
  if (tree.rest.empty()) tree.rest.push_back(start);
  int node = from;
  branch.nodes.push_back(node);
  Pose pose = start;
  for (int i = 0; i < elements; ++i) {
    RodElement e;
    e.first = node;
    e.second = tree.node_count();
    e.length = length / elements;
    e.rest_strain << 0, 0, 1, curvature;
    e.natural_strain = e.rest_strain;
    e.stiffness = stiffness.asDiagonal();
    pose = pose * exp_motion(e.length * e.rest_strain);
    tree.rest.push_back(pose);
    branch.elements.push_back(static_cast<int>(tree.elements.size()));
    tree.elements.push_back(e);
    node = e.second;
    branch.nodes.push_back(node);
  }
  for (std::size_t b = 0; b < tree.branches.size(); ++b)
    if (tree.branches[b].nodes.back() == from) branch.parent = static_cast<int>(b);
  tree.branches.push_back(branch);
  return node;
}

/// Straight or curved single rod. Stiffness order v1 v2 v3 u1 u2 u3.
inline RodTree chain(const Pose& start, double length, const Vec3& curvature, int elements,
                     const Vec6& stiffness) {
  RodTree tree;
  append(tree, start, 0, length, curvature, elements, stiffness);
  return tree;
}

inline Vec6 isotropic(double ga, double ea, double ei, double gj) {
  return vec6(ga, ga, ea, ei, ei, gj);
}

/// B7: the 45 degree bend, clamped at the origin, tangent +y, bending towards +x; dead tip force
/// along +z.
inline RodTree bend45(int elements, const Vec6& stiffness) {
  // d3 = y, bending towards x: with d1 = x, u = (0, 1/R, 0) rotates d3 towards d1
  return chain(frame({0, 0, 0}, {0, 1, 0}, {1, 0, 0}), 100 * 3.14159265358979323846 / 4,
               {0, 0.01, 0}, elements, stiffness);
}

}  // namespace vasorod
