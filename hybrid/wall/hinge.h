// The angle between two triangles over their common edge: gradient and Hessian in closed form.
//
// Seen from one triangle, with the edge from `tail` to `head` and the apex opposite:
//   e           unit direction of the edge
//   n           unit normal of the triangle
//   p = e x n   outward direction in the triangle's plane
//   h           height of the triangle over the edge
//   f           position of the apex's foot along the edge
//   w           (1 - f, f, -1) on (tail, head, apex)
//
// The contribution of a vertex to d theta is (w_i / h) n, and the contributions of both triangles
// add up (compare Tamstorf and Grinspun 2013).
#pragma once

#include <Eigen/Geometry>

#include <vasorod/types.h>

namespace vasorod {

/// One of the two triangles at an edge.
struct HingeSide {
  Vec3 normal, outward, edge;
  double height, length;
  Vec3 weight;  ///< tail, head, apex

  /// `forward`: the triangle traverses the edge from tail to head; otherwise p = n x e. `normal` is
  /// a unit vector, `area2` twice the triangle's area.
  HingeSide(const Vec3& tail, const Vec3& head, const Vec3& apex, const Vec3& unit_normal,
            double area2, bool forward)
      : normal(unit_normal), edge(head - tail) {
    length = edge.norm();
    edge /= length;
    outward = forward ? Vec3(edge.cross(normal)) : Vec3(normal.cross(edge));
    height = area2 / length;
    const double foot = (apex - tail).dot(edge) / length;
    weight << 1 - foot, foot, -1;
  }

  Vec3 gradient(int i) const { return (weight[i] / height) * normal; }

  /// Contribution of this side to d2 theta / dx_i dx_j, with i and j among (tail, head, apex). The
  /// antisymmetric parts of the two sides cancel and are omitted.
  Mat3 hessian(int i, int j) const {
    constexpr int along[3] = {-1, 1, 0};
    const double s =
        -weight[i] * weight[j] / (height * height) - along[i] * along[j] / (2 * length * length);
    const double c = -1 / (height * length);
    const Vec3 left = s * outward + (c * along[i] * weight[j]) * edge;
    const Vec3 right = s * outward + (c * weight[i] * along[j]) * edge;
    return normal * left.transpose() + right * normal.transpose();
  }
};

}  // namespace vasorod
