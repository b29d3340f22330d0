// A wall's material in plane stress.
#pragma once

#include <vasorod/material.h>
#include <vasorod/types.h>

namespace vasorod {

/// Plane-stress stiffness in the frame (fibre, across), order (11, 22, 2*12); unit: stress.
Mat3 plane_stress(const Material& material);

/// The shear moduli across the wall of fibres along the axis and around it, stress.
Vec2 transverse_shear(const Material& material);

/// The shear modulus of a wall that is as isotropic as its Young's moduli permit, stress:
///
/// ```
/// sqrt(E_L E_T) / (2 (1 + sqrt(nu_LT nu_TL)))
/// ```
double ordinary_shear(const Material& material);

}  // namespace vasorod
