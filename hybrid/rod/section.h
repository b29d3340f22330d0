// Stiffness of a wall's annular section [3-5]: diag(k G A, k G A, E A, E I, E I, G J) in the order
// v1 v2 v3 u1 u2 u3.
#pragma once

#include <vasorod/material.h>

#include "rod/rod_tree.h"

namespace vasorod {

/// A ring.
struct AnnularSection {
  double radius = 0;     ///< mid-wall radius, length
  double thickness = 0;  ///< length, at most twice the radius

  double inner() const { return radius - thickness / 2; }
  double outer() const { return radius + thickness / 2; }
  double area() const;           ///< pi (ro^2 - ri^2)
  double second_moment() const;  ///< I = pi/4 (ro^4 - ri^4); the polar moment is twice that
  double shear_coefficient(double poisson) const;  ///< Cowper (1966), hollow circle
};

/// With E = young_axial, G = shear_axial, independent of each other; poisson_tt enters Cowper's
/// coefficient only. Throws InputError where a number cannot belong to a ring; `where` begins the
/// sentence.
Mat6 annular_stiffness(const AnnularSection& section, const Material& material,
                       const std::string& where = "section");

/// Gives every element of a tree with `radius` the section at its middle: mean of its nodes'
/// mid-wall radii and of their thicknesses (one per node). Second order where they taper.
void set_annular_stiffness(RodTree& tree, const std::vector<double>& thickness,
                           const Material& material, const std::string& where = "rod");

}  // namespace vasorod
