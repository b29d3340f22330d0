// The angle between two triangles over their common edge: gradient and Hessian in closed form.
//
// Seen from one triangle with the edge from `tail` to `head` and the apex across: e the edge's unit
// direction, n the triangle's unit normal, p = e x n the outward direction in its plane, h its
// height over the edge, f where the apex's foot stands along the edge, w = (1 - f, f, -1) on (tail,
// head, apex). Then a vertex's part of d theta is (w_i / h) n, and both triangles' parts add up
// (compare Tamstorf and Grinspun 2013).
#pragma once

#include <Eigen/Geometry>

#include <vasorod/types.h>

namespace vasorod {

struct HingeSide {
  Vec3 normal, outward, edge;
  double height, length;
  Vec3 weight;  ///< tail, head, apex

  /// `forward`: the triangle runs through the edge from tail to head; else p = n x e. `normal`
  /// unit, `area2` twice the triangle's area.
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

  /// This side's part of d2 theta / dx_i dx_j, i and j among (tail, head, apex). The two sides'
  /// antisymmetric parts cancel, so each is given without its own.
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
