// Elastic law of a wall: isotropic, or transversely isotropic with the vessel's axis as fibre, in plane
// stress.
#pragma once

#include <string>

#include "geometry/types.h"

namespace vasorod {

/// Which strain the wall's energy 1/2 E : C : E is quadratic in.
enum class StrainLaw {
  biot,  ///< E = U - I, engineering strain: what rods and edge springs are linear in
  svk,   ///< E = (F^T F - I) / 2, Saint-Venant and Kirchhoff
};

/// Moduli in stress, Poisson's ratios without unit.
struct WallMaterial {
  StrainLaw law = StrainLaw::biot;
  double young_axial = 0;       ///< E_L, along the fibre
  double young_transverse = 0;  ///< E_T, across it
  double shear_axial = 0;       ///< G_L, between the fibre and its normals
  double poisson_tt = 0;        ///< nu_TT, between the two directions across
  double poisson_lt = 0;        ///< nu_LT: pulled along the fibre, the wall narrows by this

  static WallMaterial isotropic(double young, double poisson, StrainLaw law = StrainLaw::biot);
};

/// Throws InputError unless the three-dimensional law has positive energy: moduli positive, |nu_TT| < 1,
/// 1 - nu_TT - 2 nu_LT^2 E_T / E_L >= 0 (zero: incompressible). `where` begins the sentence.
void check_material(const WallMaterial& material, const std::string& where);

/// The shear modulus of a wall as isotropic as its Young's moduli allow: sqrt(E_L E_T) / (2 (1 + sqrt(nu_LT
/// nu_TL))), stress.
double ordinary_shear(const WallMaterial& material);

/// Plane-stress stiffness in the frame (fibre, across), order (11, 22, 2*12): stress.
Mat3 plane_stress(const WallMaterial& material);

}  // namespace vasorod
