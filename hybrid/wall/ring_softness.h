// How much too soft a triangle's bending is where its wall ovalises.
//
// Mid-edge bending with an unknown per edge is nonconforming (Morley's triangle): at fixed vertices
// the edges' slopes trade true bending against a bending that alternates between neighbours, and a
// mode of wave number k costs too little by O((k h)^2). In a lattice of triangles like this one the
// slopes' best trade can be written down. With p_k the outward direction of edge k, r_k from the
// triangle's centroid to the edge's middle, P the matrix with columns p_k p_k^T, D the bending
// stiffness, x the direction of the curvature, C0 = x x^T:
//   lost energy / energy left = k^2 (var + v . (P^T D P)^-1 v / (C0 . D C0)),  v_k = (r_k . x) (C0
//   . D p_k p_k^T),
// var the triangle's second moment along x, lost because the curvature is constant in it. A section
// ovalises with k = 2 / R, and that is the mode that matters in a vessel; a flat wall (k = 0) is
// left alone. Measured on a ring pushed by cos 2 theta (L/R 10, t/R 0.05): with 24 vertices around
// 7 % too soft without this, 1.3 % with it; irregular 8 % and 1.4 %; with triangles five times
// longer along the axis, 48 around, 23 % and 4.6 %.
#pragma once

#include <vasorod/types.h>

namespace vasorod {

/// Lost energy over the rest for bending along the unit direction x at curvature 1/R (wave number
/// 2/R). `gradients` of the barycentric coordinates, 1/length; `bending` the 3 x 3 stiffness, order
/// (11, 22, 2*12).
double ring_softness(const Eigen::Matrix<double, 2, 3>& gradients, const Mat3& bending,
                     const Vec2& x, double curvature);

}  // namespace vasorod
