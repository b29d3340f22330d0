// Where the director of a wall may lean (leaning_triangle.h): beside glued rims, in walls that are
// thick or soft in shear.
//
// Beside a rim that is held rigid a tube of radius R bends in a layer (Reissner's shell, symmetric
// about the axis; u the radial displacement over its value far from the rim)
//
//   D u'''' - D k / S u'' + k u = 0,   k = E t / R^2,   S = 5/6 G t
//
// in which shear across the wall has the share
//
//   s = sqrt(k D) / (2 S)
//
// of the layer's bending: 0.05 at t/R = 0.1 in an isotropic wall with nu = 0.3, in proportion to
// t/R and to E/G.
#pragma once

#include "wall/wall_energy.h"

namespace vasorod {

/// The layer beside a rim.
struct ShearLayer {
  double share = 0;   ///< s
  double length = 0;  ///< over which its slowest part decays by e
};

/// `bending`: D, force length; `hoop`: k, force / length^3; `shear`: S, force / length.
ShearLayer shear_layer(double bending, double hoop, double shear);

/// Of a tube beside its rigid rims, the fibre along its axis.
ShearLayer shear_layer(const Material& material, double thickness, double radius);

/// WallInput::lean of a wall: the direction across the nearest glued rim in the band beside each
/// rim where the share that the triangles leave is at least `least_shear_share`, zero elsewhere;
/// empty if there is no such rim.
Points shear_band(const WallInput& wall);

/// Below it, tubes without a lean are within 0.06 % of R of the finite-element shell (t/R 0.1,
/// pulled to 1.2, 96 points around).
inline constexpr double least_shear_share = 0.04;

}  // namespace vasorod
