// Barriers against degenerate flat triangles: folds that close to 180 degrees, and triangles that
// collapse to a line.
//
// Without barriers, sin(theta / 2) stops growing towards theta = 180 degrees, where the two normals
// have no mean. The Biot law assigns a finite energy to a triangle of zero area, beyond which its
// normal is reversed. Descent would end at such corners of the energy. Both barriers are zero far
// beyond the range of validity of the law (up to a right angle over one edge; down to half the
// area), smooth where they set in, and grow without bound.
#pragma once

#include <vasorod/types.h>

namespace vasorod {

/// Added to sin(theta / 2) beyond a right angle:
///
/// ```
/// x^3 / (pi/2 - theta/2),   x = theta/2 - pi/4
/// ```
///
/// Derivatives with respect to theta / 2. No unit.
struct FoldBarrier {
  double value = 0, first = 0, second = 0;
  FoldBarrier(double half_sine, double half_cosine);
};

/// Barrier for a triangle of less than half its rest area:
///
/// ```
/// x^3 / J,   x = 1/2 - J,   J^2 = det C
/// ```
///
/// Derivatives with respect to (C11, C22, C12). No unit.
struct CollapseBarrier {
  double value = 0;
  Vec3 gradient = Vec3::Zero();
  Mat3 hessian = Mat3::Zero();
  explicit CollapseBarrier(const Vec3& metric);
};

}  // namespace vasorod
