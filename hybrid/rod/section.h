// Stiffness of the annular section of a wall [3-5] in the order v1 v2 v3 u1 u2 u3:
//
//   diag(k G A, k G A, E A, E I, E I, G J)
#pragma once

#include <vasorod/material.h>

#include "rod/rod_tree.h"

namespace vasorod {

/// An annulus.
struct AnnularSection {
  double radius = 0;     ///< mid-wall radius, length
  double thickness = 0;  ///< length, at most twice the radius

  double inner() const { return radius - thickness / 2; }
  double outer() const { return radius + thickness / 2; }
  double area() const;           ///< pi (ro^2 - ri^2)
  double second_moment() const;  ///< I = pi/4 (ro^4 - ri^4); the polar moment is twice that
  double shear_coefficient(double poisson) const;  ///< Cowper (1966), hollow circle
};

/// Stiffness with E = young_axial and G = shear_axial, which are independent of each other;
/// poisson_tt enters only Cowper's coefficient. Throws InputError when a number is not valid for an
/// annulus; `where` begins the sentence.
Mat6 annular_stiffness(const AnnularSection& section, const Material& material,
                       const std::string& where = "section");

/// Sets the stiffness of every element of a tree with `radius` from the section at the element's
/// middle: mean of the mid-wall radii and of the thicknesses of its nodes (`thickness`: one per
/// node, length). Second-order accurate for tapered walls.
void set_annular_stiffness(RodTree& tree, const std::vector<double>& thickness,
                           const Material& material, const std::string& where = "rod");

}  // namespace vasorod
