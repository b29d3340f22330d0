#include "rod/section.h"

#include <cmath>
#include <numbers>

#include <vasorod/error.h>

#include "data/index.h"
#include "data/sentence.h"

namespace vasorod {

double AnnularSection::area() const {
  return 2 * std::numbers::pi * radius * thickness;
}

double AnnularSection::second_moment() const {
  // (ro^4 - ri^4) / 4 = (ro^2 - ri^2)(ro^2 + ri^2) / 4, free of cancellation for a thin wall
  return area() * (inner() * inner() + outer() * outer()) / 4;
}

double AnnularSection::shear_coefficient(double poisson) const {
  const double m2 = (inner() / outer()) * (inner() / outer());
  const double square = (1 + m2) * (1 + m2);
  return 6 * (1 + poisson) * square / ((7 + 6 * poisson) * square + (20 + 12 * poisson) * m2);
}

Mat6 annular_stiffness(const AnnularSection& s, const Material& material,
                       const std::string& where) {
  const double young = material.young_axial, shear = material.shear_axial,
               poisson = material.poisson_tt;
  const auto refuse = [&](const char* what, double found, const char* expected) {
    throw InputError(where + ": " + what + " is " + number_text(found) + ", expected " + expected);
  };
  if (!(s.radius > 0) || !std::isfinite(s.radius))
    refuse("mid-wall radius", s.radius, "a positive number");
  if (!(s.thickness > 0)) refuse("thickness", s.thickness, "a positive number");
  if (s.thickness > 2 * s.radius)
    refuse("thickness", s.thickness, "at most twice the mid-wall radius");
  if (!(young > 0) || !std::isfinite(young)) refuse("Young's modulus", young, "a positive number");
  if (!(shear > 0) || !std::isfinite(shear)) refuse("shear modulus", shear, "a positive number");
  if (!(poisson > -1 && poisson <= 0.5))
    refuse("Poisson's ratio", poisson, "above -1 and at most 0.5");
  const double area = s.area(), inertia = s.second_moment(),
               kga = s.shear_coefficient(poisson) * shear * area;
  Vec6 diagonal;
  diagonal << kga, kga, young * area, young * inertia, young * inertia, shear * 2 * inertia;
  return diagonal.asDiagonal();
}

void set_annular_stiffness(RodTree& tree, const std::vector<double>& thickness,
                           const Material& material, const std::string& where) {
  for (RodElement& element : tree.elements) {
    const auto a = index(element.first), b = index(element.second);
    const AnnularSection section{(tree.radius.at(a) + tree.radius.at(b)) / 2,
                                 (thickness.at(a) + thickness.at(b)) / 2};
    element.stiffness = annular_stiffness(section, material, where);
  }
}

}  // namespace vasorod
