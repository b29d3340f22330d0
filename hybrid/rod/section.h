// Stiffness of a wall's annular section [3-5]: diag(k G A, k G A, E A, E I, E I, G J) in the order v1 v2 v3
// u1 u2 u3.
#pragma once

#include "rod/rod_tree.h"

namespace vasorod {

/// A ring of mid-wall radius and thickness (length), moduli (stress); E and G are independent inputs.
struct AnnularSection {
  double radius = 0;     ///< mid-wall radius
  double thickness = 0;  ///< below twice the radius
  double young = 0;      ///< E along the axis
  double shear = 0;      ///< G
  double poisson = 0;    ///< only in Cowper's coefficient

  double inner() const { return radius - thickness / 2; }
  double outer() const { return radius + thickness / 2; }
  double area() const;               ///< pi (ro^2 - ri^2)
  double second_moment() const;      ///< I = pi/4 (ro^4 - ri^4); the polar moment is twice that
  double shear_coefficient() const;  ///< Cowper (1966), hollow circle
};

/// Throws InputError where a number cannot belong to a ring; `where` begins the sentence.
Mat6 annular_stiffness(const AnnularSection& section, const std::string& where = "section");

/// Gives every element of a tree with `radius` the section at its middle: mean of its nodes' mid-wall radii
/// and of their thicknesses (one per node). Second order where they taper.
void set_annular_stiffness(RodTree& tree, const std::vector<double>& thickness, double young, double shear,
                           double poisson, const std::string& where = "rod");

}  // namespace vasorod
