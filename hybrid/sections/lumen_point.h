// The lumen under one point of a surface given by two parameters (u, theta), as a function of the
// point and its first derivatives. Per du dtheta it has
//
//   V = x . (x_theta x x_u) / 3 - h A_0 (A / A_0)^m,   A = |x_theta x x_u|
//
// The first term is a share of the volume under the surface and the lids over its ends
// (section_lid.h); the second, with m of wall/lumen.h, the tissue between the surface and the inner
// face, h below it at rest.
#pragma once

#include <vasorod/types.h>

namespace vasorod {

/// The volume at a point, length^3, with its derivatives with respect to x, x_u and x_theta.
struct PointVolume {
  double value = 0;
  Mat3 gradient = Mat3::Zero();         ///< a column per vector
  Eigen::Matrix<double, 9, 9> hessian;  ///< only if requested
};

/// The lumen under one point. Lengths in one unit.
class LumenPoint {
 public:
  LumenPoint() = default;
  /// `area`: A at rest. `depth`: from the surface inwards to the inner face at rest. `thinning`: m.
  /// `measure`: du dtheta of the point.
  LumenPoint(double area, double depth, double thinning, double measure);

  /// `jet`: x, x_u, x_theta.
  PointVolume volume(const Mat3& jet, bool with_hessian) const;

 private:
  double area_ = 1, tissue_ = 0, thinning_ = 0, measure_ = 0;  // tissue: h A_0
};

}  // namespace vasorod
