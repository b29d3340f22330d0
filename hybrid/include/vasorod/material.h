// The elastic material of a vessel's wall: isotropic, or transversely isotropic with the vessel's
// axis as fibre.
#pragma once

#include <optional>
#include <string>

namespace vasorod {

/// The strain in which the wall's energy 1/2 E : C : E is quadratic.
enum class Law {
  biot,  ///< E = U - I, engineering strain: rods and edge springs are linear in it
  svk,   ///< E = (F^T F - I) / 2, Saint-Venant and Kirchhoff
};
std::string to_string(Law law);

/// Moduli in stress, Poisson's ratios without unit. L: along the fibre; T: across it.
struct Material {
  Law law = Law::biot;
  double young_axial = 0;       ///< E_L, along the fibre
  double young_transverse = 0;  ///< E_T, across it
  double shear_axial = 0;       ///< G_L, between the fibre and its normals
  double poisson_tt = 0;        ///< nu_TT, between the two directions across
  double poisson_lt = 0;        ///< nu_LT: pulled along the fibre, the wall narrows by this

  /// E_L = E_T = `young`, G = E / (2 (1 + nu)), both Poisson's ratios `poisson`.
  static Material isotropic(double young, double poisson, Law law = Law::biot);
  /// Whether the moduli are those of isotropic(young_axial, poisson_tt).
  bool is_isotropic() const;
};

/// Why a material is none: what was found and what was expected, as a sentence needs them.
struct MaterialFault {
  std::string found, expected;
};

/// Empty where the three-dimensional law has positive energy (the positive definite compliance of a
/// transversely isotropic solid): moduli positive and finite, |nu_TT| < 1,
/// 1 - nu_TT - 2 nu_LT^2 E_T / E_L >= 0 (zero: incompressible).
std::optional<MaterialFault> fault_of(const Material& material);

/// Throws InputError, a sentence that begins with `where`, where `fault_of` finds one.
void check_material(const Material& material, const std::string& where);

/// k_c, k_b, k_s of the paper's energies [7-9], force / length. They depend on the mesh; derived
/// from the wall where a scene gives none.
struct Coefficients {
  double binding = 0;     ///< k_c
  double bending = 0;     ///< k_b
  double stretching = 0;  ///< k_s
};

/// A vessel's wall.
struct Wall {
  double thickness = 0;  ///< t, length
  Material material;
};

}  // namespace vasorod
