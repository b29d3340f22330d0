// Stiffness of a flat triangle that represents a piece of a curved wall.
//
// The triangle's edges are chords of the surface. An edge of length l along which the surface has
// the curvature k represents an arc of length l (1 + (l k)^2 / 24). When the curvature changes by
// dk, the chord shortens by the fraction l^2 k dk / 12 although the arc does not. The strain of the
// wall is therefore the chords' strain corrected along the three edges, in the triangle formed by
// their arcs. This is of second order in l k and supplies what a facet lacks in area, radius and
// slope. (Measured on a tube with 24 vertices around, bent: moment 0.4 % low instead of 1.1 %.)
#pragma once

#include <vasorod/types.h>

#include "wall/wall_section.h"

namespace vasorod {

/// The 6 x 6 matrix K of the energy 1/2 y^T K y in (e11, e22, 2 e12, b_0, b_1, b_2)
/// (triangle_energy.h), times the area. `gradients`: of the barycentric coordinates in the frame of
/// the section, 1/length.
Mat6 triangle_stiffness(const Eigen::Matrix<double, 2, 3>& gradients, const WallSection& section);

/// The curved piece of wall that a triangle represents: K = area strains^T S strains with S the
/// section's own stiffness (wall_section.h). A law that is not quadratic starts from these strains.
struct WallPiece {
  Mat6 strains;  ///< (e, c) of the piece from (e11, e22, 2 e12, b_0, b_1, b_2)
  double area;   ///< length^2
};

/// The strains of the curved piece itself, without the corrections of the section's bending.
WallPiece curved_piece(const Eigen::Matrix<double, 2, 3>& gradients, const WallSection& section);

WallPiece wall_piece(const Eigen::Matrix<double, 2, 3>& gradients, const WallSection& section);

}  // namespace vasorod
