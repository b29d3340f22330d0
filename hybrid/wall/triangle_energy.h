// The wall's energy in one triangle as a function of nine scalars: its metric C, the three angles
// to its neighbours, the three edge unknowns.
//
// Mid-edge normals (Grinspun, Gingold, Reisman and Zorin 2006): on edge k, m_k = N + xi (e x N)
// with N the unit bisector of the two triangles' normals. Seen from this triangle only its slope
// over the edge counts, s_k = sin(theta_k / 2) + xi_k cos(theta_k / 2) (and more beyond a right
// angle), theta_k the angle between the two normals, positive where the surface is convex; the
// second fundamental form pulled back to the rest triangle is sum_k b_k g_k g_k^T with b_k = 2 h_k
// s_k, h_k the deformed height over edge k and g_k the rest gradient of the barycentric coordinate.
// So E = 1/2 y^T K y with y = (strain(C), b_k - b_k at rest): three strains and three bendings. Two
// partners (shear_pairs.h) together have relief / 2 (y_2 - y_2 of the partner)^2 less, half of it
// each.
#pragma once

#include <array>

#include <vasorod/types.h>

#include "wall/plane_stress.h"

namespace vasorod {

using Vec9 = Eigen::Matrix<double, 9, 1>;
using Mat9 = Eigen::Matrix<double, 9, 9>;

/// Rest data of a triangle, in a frame of its plane.
struct TriangleRest {
  Eigen::Matrix<double, 2, 3>
      gradients;                  ///< g_k, gradients of the barycentric coordinates, 1/length
  double area = 0;                ///< length^2
  Vec3 bending = Vec3::Zero();    ///< b_k at rest, length
  Mat6 stiffness = Mat6::Zero();  ///< K on (e11, e22, 2 e12, b_0, b_1, b_2), the area included
  double relief =
      0;  ///< what it and its partner give back of their shear stiffness, the area included
};

/// The nine scalars of a deformed triangle.
struct TriangleState {
  Vec3 metric;                  ///< C11, C22, C12 in the rest frame
  Vec3 half_sine, half_cosine;  ///< of theta_k / 2; at a free rim theta = 0
  Vec3 xi;                      ///< edge unknown as this triangle sees it, its sign included
  double partner_shear = 0;     ///< the partner's 2 e12, where there is a relief
  /// On a glued rim the section's normal gives b_k itself (length): it takes theta_k's place,
  /// half_sine holds it.
  std::array<bool, 3> given{};
};

/// Its energy; and derivatives by (C11, C22, C12, theta_0..2, xi_0..2), the partner's share
/// included.
struct TriangleEnergy {
  Vec6 strains;  ///< y
  Vec6 stress;   ///< K y, less the relief
  double value;
  Vec9 gradient;
  Mat9 hessian;  ///< only where asked for
};

TriangleEnergy triangle_energy(Law law, const TriangleRest& rest, const TriangleState& state,
                               bool with_hessian);

/// Its value alone.
double triangle_value(Law law, const TriangleRest& rest, const TriangleState& state);

/// y alone.
Vec6 triangle_strains(Law law, const TriangleRest& rest, const TriangleState& state);

}  // namespace vasorod
