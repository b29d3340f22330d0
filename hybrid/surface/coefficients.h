// Coefficients of the paper's energies [7-9] derived from the wall, where the scene gives none.
//
// The paper's sums have neither a factor 1/2 nor area weights, so on a near-equilateral mesh of edge h
// (vertex area A):
//   k_s = sqrt(3)/4 E t          a triangular lattice of springs k_s (|e|-|e0|)^2 has the plane modulus 4 k_s
//   / sqrt(3)
//                                (and Poisson's ratio 1/3, whatever the wall's)
//   k_b = 4 sqrt(3) D / h^2      the umbrella of a height field w is h^2/4 of its Laplacian; the plate energy
//   is D/2 (Lap w)^2 k_c = 0.01 E t / R^2 A       a chosen share of the ring's own stiffness E t / R^2 per
//   area (measured trade-off)
// with D = E t^3 / (12 (1 - nu^2)).
#pragma once

#include "geometry/types.h"

namespace vasorod {

/// k_c, k_b, k_s of [7-9], force / length.
struct PaperCoefficients {
  double binding = 0;     ///< k_c
  double bending = 0;     ///< k_b
  double stretching = 0;  ///< k_s
};

/// What the derivation needs of a wall and its mesh.
struct WallAndMesh {
  double young = 0;        ///< E, stress
  double poisson = 0;      ///< nu
  double thickness = 0;    ///< t, length
  double radius = 0;       ///< R, mid-wall, length
  double mean_edge = 0;    ///< h, length
  double vertex_area = 0;  ///< A, mean over the vertices, length^2
};

PaperCoefficients coefficients_from_wall(const WallAndMesh& wall);

}  // namespace vasorod
