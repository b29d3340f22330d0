// Where a flat triangle's energy would end, it is stopped: folds that lie flat, triangles that
// collapse to a line.
//
// sin(theta / 2) stops growing towards theta = 180 degrees, where the two normals have no mean, and
// the Biot law spends finite energy on a triangle without area, past which its normal is turned
// over: descent ends at such corners of the energy. Both stops are zero up to far beyond what the
// law holds for (a right angle over one edge; half the area), smooth there, and grow without bound.
#pragma once

#include <vasorod/types.h>

namespace vasorod {

/// Added to sin(theta / 2): x^3 / (pi/2 - theta/2), x = theta/2 - pi/4 beyond a right angle.
/// Derivatives by theta / 2.
struct FoldBarrier {
  double value = 0, first = 0, second = 0;
  FoldBarrier(double half_sine, double half_cosine);
};

/// x^3 / J, x = 1/2 - J, for a triangle of less than half its area: J^2 = det C. Derivatives by
/// (C11, C22, C12).
struct CollapseBarrier {
  double value = 0;
  Vec3 gradient = Vec3::Zero();
  Mat3 hessian = Mat3::Zero();
  explicit CollapseBarrier(const Vec3& metric);
};

}  // namespace vasorod
