// Relative error of a triangle's bending stiffness where its wall ovalises.
//
// Mid-edge bending with one unknown per edge is nonconforming (Morley's triangle). At fixed
// vertices the slopes of the edges exchange true bending for a bending that alternates between
// neighbours, so a mode of wave number k is too soft by O((k h)^2). In a regular lattice of such
// triangles the optimal slopes can be written in closed form. Notation:
//
//   p_k   outward direction of edge k
//   r_k   from the triangle's centroid to the middle of edge k
//   P     matrix with columns p_k p_k^T
//   D     bending stiffness
//   x     direction of the curvature
//   C0    x x^T
//   var   second moment of the triangle along x; its energy is lost because the curvature is
//         constant in the triangle
//
// Then
//
//   lost energy / remaining energy = k^2 (var + v . (P^T D P)^-1 v / (C0 . D C0))
//   v_k = (r_k . x) (C0 . D p_k p_k^T)
//
// A section ovalises with k = 2 / R, the relevant mode in a vessel; a flat wall (k = 0) is not
// changed. Measured on a ring loaded by cos 2 theta (L/R 10, t/R 0.05): with 24 vertices around 7 %
// too soft without this correction, 1.3 % with it; on irregular meshes 8 % and 1.4 %; with
// triangles five times longer along the axis, 48 around, 23 % and 4.6 %.
#pragma once

#include <vasorod/types.h>

namespace vasorod {

/// Lost energy over remaining energy for bending along the unit direction x at curvature 1/R (wave
/// number 2/R). `gradients`: of the barycentric coordinates, 1/length. `bending`: the 3 x 3
/// stiffness, order (11, 22, 2*12). `curvature`: 1/length.
double ring_softness(const Eigen::Matrix<double, 2, 3>& gradients, const Mat3& bending,
                     const Vec2& x, double curvature);

}  // namespace vasorod
