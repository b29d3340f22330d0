// The elastic material of a vessel's wall: isotropic, or transversely isotropic with the fibre
// along the vessel's axis.
#pragma once

#include <optional>
#include <string>

namespace vasorod {

/// The wall's elastic energy at finite strain. The first two are 1/2 E : C : E in a strain E.
enum class Law {
  biot,         ///< E = U - I, engineering strain: rods and edge springs are linear in it
  svk,          ///< E = (F^T F - I) / 2, Saint-Venant and Kirchhoff
  neo_hookean,  ///< mu/2 (I1 - 3) - mu ln J + lambda/2 ln^2 J, for large strains; isotropic only
};

/// The law's name in scene files: "biot", "svk" or "neo-hookean".
std::string to_string(Law law);

/// Elastic constants. Moduli in the scene's stress unit, Poisson's ratios without unit.
/// L: along the fibre; T: transverse to the fibre.
struct Material {
  Law law = Law::biot;          ///< energy at finite strain
  double young_axial = 0;       ///< E_L, along the fibre, stress
  double young_transverse = 0;  ///< E_T, transverse to the fibre, stress
  double shear_axial = 0;       ///< G_L, between the fibre and its normals, stress
  double poisson_tt = 0;        ///< nu_TT, between the two transverse directions
  double poisson_lt = 0;        ///< nu_LT, transverse contraction under tension along the fibre

  /// An isotropic material: E_L = E_T = `young` (stress), G_L = E / (2 (1 + nu)), both Poisson's
  /// ratios equal to `poisson`.
  static Material isotropic(double young, double poisson, Law law = Law::biot);
  /// Whether the constants are those of isotropic(young_axial, poisson_tt).
  bool is_isotropic() const;
};

/// Why a material is inadmissible, as the two parts of an error message.
struct MaterialFault {
  std::string found,  ///< what was found
      expected;       ///< what was expected instead
};

/// Checks that the three-dimensional energy is positive (positive definite compliance of a
/// transversely isotropic solid): moduli positive and finite, |nu_TT| < 1,
/// 1 - nu_TT - 2 nu_LT^2 E_T / E_L >= 0 (zero: incompressible); with the neo-Hookean law isotropic
/// and nu >= 0. Returns the fault, or empty if the material is admissible.
std::optional<MaterialFault> fault_of(const Material& material);

/// Throws InputError if `fault_of` finds a fault. The message begins with `where`.
void check_material(const Material& material, const std::string& where);

/// k_c, k_b and k_s of the paper's energies [7-9], force / length. They depend on the mesh; where a
/// scene gives none, they are derived from the wall.
struct Coefficients {
  double binding = 0;     ///< k_c of [7], force / length
  double bending = 0;     ///< k_b of [8], force / length
  double stretching = 0;  ///< k_s of [9], force / length
};

/// Pressure in a vessel's lumen above that around the vessel, stress.
struct LumenPressure {
  double scan = 0;   ///< when the vessel was seen: its shape is in equilibrium with it
  double after = 0;  ///< at the end of motions, loads and operation
};

/// A vessel's wall.
struct Wall {
  double thickness = 0;  ///< t, length
  Material material;     ///< elastic constants
};

}  // namespace vasorod
