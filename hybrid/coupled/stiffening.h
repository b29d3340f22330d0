// Walls whose shear modulus lies far above Young's: no longer sheared, they wrinkle as they are
// moved, in valleys of the energy that are too narrow to be followed. They go their way with a
// lower shear modulus, which is then raised in steps to their own, from minimum to minimum.
#pragma once

#include <vasorod/material.h>

namespace vasorod {

/// The material with which a wall of material `own` goes its way: `own`, or with a shear modulus
/// 2000 times that of an isotropic wall of the same (larger) Young's modulus, if that is lower.
Material eased(const Material& own);

/// A wall's shear modulus over that of an isotropic one of the same (larger) Young's modulus.
double shear_ratio(const Material& material);

/// Whether the moduli lie so far apart that rounding of the stiffer's stresses takes the digits of
/// the other's forces.
bool hides_forces(const Material& material);

/// A step from `now` to `own`: its shear modulus is raised 30 times, at most to that of `own`.
Material stiffened(const Material& now, const Material& own);

}  // namespace vasorod
