// Coefficients of the paper's energies [7-9], derived from the wall where the scene gives none.
//
// The paper's sums have neither a factor 1/2 nor area weights. On a near-equilateral mesh with edge
// h and vertex area A, and with D = E t^3 / (12 (1 - nu^2)):
//
//   k_s = sqrt(3)/4 E t
//     A triangular lattice of springs k_s (|e|-|e0|)^2 has the plane modulus 4 k_s / sqrt(3)
//     (and Poisson's ratio 1/3, whatever the wall's).
//
//   k_b = 4 sqrt(3) D / h^2
//     The umbrella of a height field w is h^2/4 of its Laplacian; the plate energy is
//     D/2 (Lap w)^2.
//
//   k_c = 0.01 E t / R^2 A
//     A chosen share of the ring's own stiffness E t / R^2 per area (a measured trade-off).
#pragma once

#include <vasorod/material.h>

namespace vasorod {

/// The shape and mesh of a vessel, as far as the derivation needs them.
struct WallGeometry {
  double thickness = 0;    ///< t, length
  double radius = 0;       ///< R, to mid-wall, length
  double mean_edge = 0;    ///< h, length
  double vertex_area = 0;  ///< A, mean over the vertices, length^2
};

/// Uses E = young_axial and nu = poisson_tt only: springs are isotropic. k in force / length.
Coefficients coefficients_from_wall(const Material& material, const WallGeometry& wall);

}  // namespace vasorod
