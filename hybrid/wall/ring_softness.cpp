#include "wall/ring_softness.h"

#include <Eigen/LU>

namespace vasorod {

namespace {

// x x^T as a strain (11, 22, 2*12).
Vec3 dyad(const Vec2& x) {
  return {x[0] * x[0], x[1] * x[1], 2 * x[0] * x[1]};
}

}  // namespace

double ring_softness(const Eigen::Matrix<double, 2, 3>& gradients, const Mat3& bending,
                     const Vec2& x, double curvature) {
  const double area2 =
      1 / std::abs(gradients(0, 0) * gradients(1, 1) - gradients(0, 1) * gradients(1, 0));
  const Vec3 stress = bending * dyad(x);
  Mat3 outward;
  // Extent of the edges along x, in order around the triangle.
  Vec3 extent;
  for (int k = 0; k < 3; ++k) {
    const Vec2 g = gradients.col(k);
    outward.col(k) = dyad(g.normalized());
    extent[k] = area2 * (g[0] * x[1] - g[1] * x[0]);
  }
  Vec3 v;
  for (int k = 0; k < 3; ++k)
    v[k] = (extent[(k + 2) % 3] - extent[(k + 1) % 3]) / 6 * stress.dot(outward.col(k));
  const Mat3 alternating = outward.transpose() * bending * outward;
  const double wave = 2 * curvature;
  return wave * wave *
         (extent.squaredNorm() / 36 + v.dot(alternating.inverse() * v) / dyad(x).dot(stress));
}

}  // namespace vasorod
