// The compressible neo-Hookean law in plane stress.
//
//   W = mu/2 (I1 - 3) - mu ln J + lambda/2 ln^2 J
//
// is the law of the same name in reference_fem/law.h. With the in-plane gradient F = I + D, its
// determinant j and the stretch l across the wall, I1 = |F|^2 + l^2 and J = j l. The stress across
// the wall is zero where, with s = ln l^2,
//
//   (1 - 2 nu) (e^s - 1) + nu (2 ln j + s) = 0
//
// an equation with one solution for 0 <= nu <= 1/2. With l from it the energy falls into a part of
// the shape and a part of the area:
//
//   W / mu = 1/2 ((D11 - D22)^2 + (D12 + D21)^2) + u(j)
//
// Both parts and their first derivatives are zero at rest, so small strains lose no digits.
#pragma once

namespace vasorod {

/// u(j) and its derivatives, no unit.
struct AreaEnergy {
  double value, first, second;
};

/// Below this area the energy continues as a parabola: an area of zero or less, which a step of a
/// solver can reach, has a finite energy and a force that opens it.
inline constexpr double least_area_of_law = 0.1;

/// `excess`: j - 1. `poisson`: nu, from 0 to 1/2.
AreaEnergy neo_hookean_area(double excess, double poisson);

}  // namespace vasorod
