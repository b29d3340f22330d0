// The wall's energy in one triangle as a function of nine scalars: its metric C, the three angles
// to its neighbours, the three edge unknowns.
//
// Mid-edge normals (Grinspun, Gingold, Reisman and Zorin 2006): on edge k
//
//   m_k = N + xi (e x N)
//
// with N the unit bisector of the normals of the two triangles. For this triangle only the slope of
// m_k over the edge matters:
//
//   s_k = sin(theta_k / 2) + xi_k cos(theta_k / 2)      (plus a barrier beyond a right angle)
//
// theta_k is the angle between the two normals, positive where the surface is convex. The second
// fundamental form pulled back to the rest triangle is
//
//   sum_k b_k g_k g_k^T,   b_k = 2 h_k s_k
//
// with h_k the deformed height over edge k and g_k the rest gradient of the barycentric coordinate.
// The energy is
//
//   E = 1/2 y^T K y,   y = (strain(C), b_k - b_k at rest)
//
// with three strains and three bendings. From the energy of two partners (shear_pairs.h) together
//
//   relief / 2 (y_2 - y_2 of the partner)^2
//
// is subtracted, half of it from each.
//
// A prestress s (wall_prestress.cpp) adds s . y and a constant, which makes the energy of a linear
// wall that of the strains K^-1 s + y.
//
// A wall with a law for large strains has E(y) of large_strain_wall.h, of which K is the Hessian at
// rest, in place of 1/2 y^T K y.
//
// In whatever state, a part of the Hessian in the unknowns is positive semidefinite
// (SecondDerivatives::convex): what the slopes of y make of K, as in Gauss and Newton's method, and
// what tension adds. Left out are what compression adds and the second derivatives of the strains
// in C, of b_k and of the angles, which may have any sign. Without stress that part is the Hessian.
// Sources: Choi, Ko, Stable but responsive cloth, 2002, who leave compression out; Teran, Sifakis,
// Irving, Fedkiw, Robust quasistatic finite elements and flesh simulation, 2005.
//
// Where the wall shears across its thickness (leaning_triangle.h), y includes the bending of the
// director's lean, L l, and 1/2 l^T S l is added.
#pragma once

#include <array>
#include <memory>

#include <vasorod/types.h>

#include "wall/large_strain_wall.h"
#include "wall/leaning_triangle.h"
#include "wall/plane_stress.h"

namespace vasorod {

using Vec9 = Eigen::Matrix<double, 9, 1>;
using Mat9 = Eigen::Matrix<double, 9, 9>;

/// Rest data of a triangle, in a frame of its plane.
struct TriangleRest {
  /// g_k, gradients of the barycentric coordinates, 1/length.
  Eigen::Matrix<double, 2, 3> gradients;
  double area = 0;                ///< length^2
  Vec3 bending = Vec3::Zero();    ///< b_k at rest, length
  Mat6 stiffness = Mat6::Zero();  ///< K on (e11, e22, 2 e12, b_0, b_1, b_2), times the area
  /// Shear stiffness that the triangle and its partner give up, times the area.
  double relief = 0;
  Vec6 prestress = Vec6::Zero();  ///< s: dE/dy at rest, times the area
  double stored = 0;              ///< the prestress' energy at rest, s . K^-1 s / 2
  /// The wall of a law for large strains; null: the energy is quadratic in y.
  std::shared_ptr<const LargeStrainWall> large;
  /// Null: the director is the surface's normal.
  std::shared_ptr<const LeaningTriangle> leaning;
};

/// The second derivatives that are asked for: of `convex` see above.
enum class SecondDerivatives { none, convex, all };

/// K^-1 s: the strains of the rest shape in the state without stress.
Vec6 prestrain(const TriangleRest& rest);

/// The nine scalars of a deformed triangle.
struct TriangleState {
  Vec3 metric;                  ///< C11, C22, C12 in the rest frame
  Vec3 half_sine, half_cosine;  ///< of theta_k / 2; at a free rim theta = 0
  Vec3 xi;                      ///< edge unknowns with the sign seen from this triangle
  double partner_shear = 0;     ///< the partner's 2 e12, if there is a relief
  /// On a glued rim the normal of the section gives b_k itself (length); half_sine then holds b_k,
  /// in place of theta_k.
  std::array<bool, 3> given{};
  Vec3 lean = Vec3::Zero();  ///< l of the vertices
};

/// The energy of a triangle (force * length) and its derivatives with respect to (C11, C22, C12,
/// theta_0..2, xi_0..2), including the partner's share. The second derivatives only if requested.
struct TriangleEnergy {
  Vec6 strains;  ///< y
  Vec6 stress;   ///< dE/dy: K y, minus the relief
  double shear;  ///< 1/2 l^T S l, part of `value`
  double value;
  Vec9 gradient;
  Mat9 hessian;
  Eigen::Matrix<double, 6, 9> strain_slopes;  ///< of y by the nine scalars; with the second ones
  // Where the wall leans:
  Vec3 lean_gradient;                       ///< dE/dl
  Eigen::Matrix<double, 9, 3> lean_slopes;  ///< d2E by a scalar and by l
  Mat3 lean_hessian;
};

TriangleEnergy triangle_energy(Law law, const TriangleRest& rest, const TriangleState& state,
                               SecondDerivatives second);

/// Of dE/dC and its transpose, 2 x 2 in the rest frame, the part in tension: the nearest positive
/// semidefinite matrix.
Eigen::Matrix2d in_tension(const Eigen::Matrix2d& stress);

/// The energy only.
double triangle_value(Law law, const TriangleRest& rest, const TriangleState& state);

/// y only.
Vec6 triangle_strains(Law law, const TriangleRest& rest, const TriangleState& state);

}  // namespace vasorod
