// The section of a long thin tube under pure bending: an inextensional ring whose shape minimises
//   t E / 2 int e^2 (1 + k0 Y) ds + D / 2 int (phi' - 1/R)^2 (1 + k0 Y) ds,
//   e = (k y + c - k0 Y) / (1 + k0 Y)
// over the tangent's angle phi(s) and the axis's strain c. y and Y are the distances from the axis,
// away from the centre of the bend, in the bent state and at rest; D = E t^3 / (12 (1 - nu^2)); k0
// is the curvature at rest. With k0 = 0 this is Brazier's problem without his assumption of small
// ovalisation (Reissner 1959); near k0 it is von Karman's (1911). Per length of the axis, E = 1;
// lengths in any unit.
#pragma once

namespace vasorod::bench {

/// The bent section.
struct BentRing {
  double moment = 0;      ///< moment over E
  double flattening = 0;  ///< decrease of the diameter in the plane of bending, over 2 R
  double widening = 0;    ///< increase of the perpendicular diameter, over 2 R
};
BentRing bent_ring(double radius, double thickness, double nu, double curvature,
                   double curvature_at_rest = 0);

/// E I of the straight tube over the slope of the moment-curvature curve at the rest curvature.
double curved_tube_softening(double radius, double thickness, double nu, double curvature_at_rest);

}  // namespace vasorod::bench
