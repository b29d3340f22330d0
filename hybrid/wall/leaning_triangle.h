// A triangle whose wall shears across its thickness: its director, which carries the fibres, leans
// from the surface's normal.
//
// At vertex i the lean is l_i d_i with d_i a given direction in the surface and l_i an unknown, the
// covariant shear strain across the wall (no unit); in the triangle it is linear. The bending of
// the wall is the director's,
//
//   c = c of the surface + sum_i l_i sym(d_i g_i^T)
//
// with g_i the gradient of a barycentric coordinate, and the wall shears with the energy per area
//
//   1/2 (5/6) t l . G l
//
// The lean is added to the bending of a wall that does not shear (Oesterle, Ramm and Bischoff 2016,
// "hierarchic" rotations). So a wall that is stiff in shear, or thin, is that wall without a lean,
// and nothing locks.
//
// On an edge with a free normal its unknown xi takes up what the leans on both sides have in
// common. On a glued rim the director is given, and the surface's normal is the director without
// the lean.
#pragma once

#include <array>

#include <vasorod/types.h>

#include "wall/wall_section.h"

namespace vasorod {

/// Maps of the leans of a triangle's vertices.
struct LeaningTriangle {
  /// L: what a unit lean adds to y (triangle_energy.h).
  Eigen::Matrix<double, 6, 3> strains = Eigen::Matrix<double, 6, 3>::Zero();
  Mat3 stiffness = Mat3::Zero();  ///< S, times the area: force * length
};

/// `directions`: d_i in the frame of the section, zero for a vertex without a lean. `glued`:
/// whether the edge opposite each vertex is on a glued rim.
LeaningTriangle leaning_triangle(const Eigen::Matrix<double, 2, 3>& gradients,
                                 const WallSection& section,
                                 const Eigen::Matrix<double, 2, 3>& directions,
                                 const std::array<bool, 3>& glued);

}  // namespace vasorod
