// Stiffness of a flat triangle that stands for a piece of a curved wall.
//
// The triangle's edges are chords of the surface. An edge of length l along which the surface has
// the curvature k stands for an arc l (1 + (l k)^2 / 24), and when the curvature changes by dk the
// chord shortens by l^2 k dk / 12 of its length though the arc does not. So the wall's strain is
// the chords' strain set right along the three edges, in the triangle their arcs make: second order
// in l k, and what a facet otherwise lacks in area, in radius and in slope. (Measured on a tube
// with 24 vertices around, bent: moment 0.4 % low instead of 1.1 %.)
#pragma once

#include <vasorod/types.h>

#include "wall/wall_section.h"

namespace vasorod {

/// The energy is half this form on (e11, e22, 2 e12, b_0, b_1, b_2) (triangle_energy.h), the area
/// included. `gradients` of the barycentric coordinates in the section's frame, 1/length.
Mat6 triangle_stiffness(const Eigen::Matrix<double, 2, 3>& gradients, const WallSection& section);

}  // namespace vasorod
