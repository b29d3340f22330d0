// A rim that is held rigid does not thin.
//
// A wall in plane stress thins by c_1 e_1 + c_2 e_2. Where its end is glued to a rigid section it
// keeps its thickness, which within about half a thickness makes it stiffer, as if it were shorter
// by delta. Plane strain, isotropic, two-dimensional finite elements (nine nodes, graded to the
// corner, to four digits):
//
//   nu          0.1      0.2      0.3      0.4      0.45     0.49
//   delta / t   0.00178  0.00862  0.0241   0.0549   0.0800   0.1074
//
// Within 2 % this is delta = (0.146 - 0.031 c) c^2 t with c = nu / (1 - nu). Per length of the rim
//
//   1/2 (0.146 - 0.031 c) E' t^2 (c_1 e_1 + c_2 e_2)^2
//
// is added, E' the modulus and c the contraction across the rim. It decays over a length that goes
// as the root of the shear modulus; walls with another one than an isotropic wall's have the energy
// times that root.
#pragma once

#include <vasorod/types.h>

#include "wall/plane_stress.h"

namespace vasorod {

/// The matrix of that energy per length of the rim on (e11, e22, 2 e12) in the frame (fibre,
/// across); force. `d`: the unit direction across the rim in that frame. `thickness`: length.
Mat3 held_thickness(const Material& material, double thickness, const Vec2& d);

}  // namespace vasorod
