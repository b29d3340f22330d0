// The wall's laws as point functions: energy density, second Piola-Kirchhoff stress and tangent for
// one deformation gradient.
//
//   Biot                 W = 1/2 (U - I) : C : (U - I),  U = sqrt(F^T F)
//   St. Venant-Kirchhoff W = 1/2 E : C : E,              E = (F^T F - I) / 2
//   neo-Hookean          W = mu/2 (I1 - 3) - mu ln J + lambda/2 ln^2 J
//   split neo-Hookean    W = mu/2 (J^-2/3 I1 - 3) + kappa/4 (J^2 - 1 - 2 ln J)
//   (quasi-incompressible with a large kappa)
//
// C is transversely isotropic with the third local axis as fibre (isotropic as a special case); the
// neo-Hookean laws are isotropic. F maps from *local* axes: F = (dx/dX) Q with the fibre in Q's
// third column, so no stiffness has to be rotated.
//
// A wall that carries a stress s at rest has in addition the energy
//
//   s : Y,  Y = E for St. Venant-Kirchhoff, Y = U - I for the other laws
//
// so that s + C : Y is the stress of the two laws that are linear in Y. A wall whose shape without
// stress is known has its law from there instead: of F A, where A maps from local axes in that
// shape to those at rest.
#pragma once

#include <string>

#include <vasorod/types.h>

namespace vasorod::fem {

/// Elastic constants, stress. Transversely isotropic about the axis; `isotropic(E, nu)` gives the
/// special case.
struct Moduli {
  double axial = 1;       ///< E_L
  double transverse = 1;  ///< E_T
  double poisson = 0;     ///< nu_TT: transverse strain of a transverse load
  double coupling = 0;    ///< nu_LT: transverse strain of an axial load
  double shear = 0.5;     ///< G_L, axial shear
  bool is_isotropic = true;

  static Moduli isotropic(double young, double nu);
};

/// The first violated inequality of positive definiteness, as a clause with the numbers; empty if
/// the moduli are admissible.
std::string inadmissible(const Moduli& moduli);

/// 6x6 stiffness in the order 11 22 33 12 13 23 with engineering shear strains.
Mat6 stiffness(const Moduli& moduli);

/// Indices of the six components of a symmetric tensor: 11 22 33 12 13 23.
inline constexpr std::array<std::array<int, 2>, 6> six_pairs{
    {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};

/// Symmetric tensor from its six components (no factor on the shears).
inline Mat3 stress_tensor(const Vec6& s) {
  Mat3 S;
  S << s[0], s[3], s[4], s[3], s[1], s[5], s[4], s[5], s[2];
  return S;
}

/// The six components of a strain with engineering shears, from its tensor.
inline Vec6 strain_components(const Mat3& m) {
  Vec6 v;
  v << m(0, 0), m(1, 1), m(2, 2), 2 * m(0, 1), 2 * m(0, 2), 2 * m(1, 2);
  return v;
}

/// Response at a point. S and E in the order 11 22 33 12 13 23; the tangent is dS/dE with
/// engineering shears.
struct Response {
  double energy = 0;            ///< stress
  Vec6 stress = Vec6::Zero();   ///< S, local axes
  Mat6 tangent = Mat6::Zero();  ///< dS/dE

  Response& operator+=(const Response& other);
};

/// The contribution of a pressure p conjugate to J: S = p J C^-1, and its tangent at constant p.
Response pressure_response(const Mat3& F, double pressure);

/// The response to F of a law that is evaluated at F A: energy and stress per volume at rest.
Response from_stress_free_shape(const Response& response, const Mat3& A);

/// The volumetric energy U(J) of a split law and its derivatives, stress.
struct Volumetric {
  double energy = 0, slope = 0, curvature = 0;
};

/// The available laws.
enum class LawKind { biot, svk, neo_hookean, split_neo_hookean };
std::string to_string(LawKind kind);

/// A law with its constants.
class MaterialLaw {
 public:
  /// Throws InputError (a sentence with the inequality) for inadmissible moduli and for a
  /// transversely isotropic wall with the neo-Hookean law, which is isotropic.
  MaterialLaw(LawKind kind, const Moduli& moduli);
  /// The split neo-Hookean law with given shear and bulk modulus, stress.
  static MaterialLaw split(double mu, double kappa);

  LawKind kind() const { return kind_; }
  /// Requires det F > 0.
  Response evaluate(const Mat3& F) const;
  /// What a stress s at rest adds (order 11 22 33 12 13 23, local axes). Requires det F > 0.
  Response of_prestress(const Mat3& F, const Vec6& s) const;
  /// dS/dE at F = I.
  const Mat6& linear_stiffness() const { return stiffness_; }
  /// The strain of a stretch along the fibre under which the wall is free to contract across it.
  Vec6 uniaxial_strain(double stretch) const;
  /// The stretches of the local axes under it, large too: that strain by `biot`; across the fibre
  /// k^-n by the others, with n the contraction of a small strain.
  Vec3 uniaxial_stretches(double stretch) const;

  /// Whether the energy is isochoric(F) + volumetric(det F).
  bool splits() const { return kind_ == LawKind::split_neo_hookean; }
  Response isochoric(const Mat3& F) const;
  Volumetric volumetric(double J) const;

 private:
  MaterialLaw() = default;
  Response biot(const Mat3& C) const;
  Response svk(const Mat3& C) const;
  Response neo_hookean(const Mat3& C, double J) const;

  LawKind kind_ = LawKind::svk;
  Mat6 stiffness_ = Mat6::Zero();
  double mu_ = 0, lambda_ = 0, kappa_ = 0;
};

}  // namespace vasorod::fem
