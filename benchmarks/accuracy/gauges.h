// Section stiffnesses measured in the middle of a held tube, away from its ends.
#pragma once

#include "accuracy/held_tube.h"

namespace vasorod::bench {

/// Axial measurement.
struct AxialGauge {
  double strain = 0;    ///< strain of the axis
  double widening = 0;  ///< change of the radius over R
};
/// Means over the middle half; the strain is measured between its two halves. For tubes straight at
/// rest.
AxialGauge middle_half(const HeldTube& tube, const Points& positions);

/// Largest change of the distance from the z axis, over R.
double off_cylinder(const HeldTube& tube, const Points& positions);

/// The motion that changes the curvature by this value in the plane of the normal without a force:
/// rotations and y held, x and z free.
EndMotion pure_bending(double curvature);
/// Rotation of the middle fifth about the binormal over its length.
double middle_curvature(const HeldTube& tube, const Points& positions);

/// A small transverse force on the free end of a cantilever. The shear strain is the motion of the
/// sections' centres beyond the motion due to their rotation, between .4 and .6 of the length.
struct ShearGauge {
  double bending = 0;      ///< measured E I over E I
  double coefficient = 0;  ///< k of k G A
  bool settled = false;
};
ShearGauge transverse_force(const HeldTube& tube);

/// k of a hollow circle (Cowper 1966).
double cowper_coefficient(double radius, double thickness, double nu);

}  // namespace vasorod::bench
