#include "rod/section.h"

#include <cmath>
#include <numbers>

#include "geometry/error.h"

namespace vasorod {

double AnnularSection::area() const {
  return 2 * std::numbers::pi * radius * thickness;
}

double AnnularSection::second_moment() const {
  // (ro^4 - ri^4) / 4 = (ro^2 - ri^2)(ro^2 + ri^2) / 4, free of cancellation for a thin wall
  return area() * (inner() * inner() + outer() * outer()) / 4;
}

double AnnularSection::shear_coefficient() const {
  const double m2 = (inner() / outer()) * (inner() / outer());
  const double square = (1 + m2) * (1 + m2);
  return 6 * (1 + poisson) * square / ((7 + 6 * poisson) * square + (20 + 12 * poisson) * m2);
}

Mat6 annular_stiffness(const AnnularSection& s, const std::string& where) {
  const auto refuse = [&](const char* what, double found, const char* expected) {
    throw InputError(where + ": " + what + " is " + std::to_string(found) + ", expected " + expected);
  };
  if (!(s.radius > 0) || !std::isfinite(s.radius)) refuse("mid-wall radius", s.radius, "a positive number");
  if (!(s.thickness > 0)) refuse("thickness", s.thickness, "a positive number");
  if (s.thickness > 2 * s.radius) refuse("thickness", s.thickness, "at most twice the mid-wall radius");
  if (!(s.young > 0) || !std::isfinite(s.young)) refuse("Young's modulus", s.young, "a positive number");
  if (!(s.shear > 0) || !std::isfinite(s.shear)) refuse("shear modulus", s.shear, "a positive number");
  if (!(s.poisson > -1 && s.poisson <= 0.5)) refuse("Poisson's ratio", s.poisson, "above -1 and at most 0.5");
  const double area = s.area(), inertia = s.second_moment(), kga = s.shear_coefficient() * s.shear * area;
  Vec6 diagonal;
  diagonal << kga, kga, s.young * area, s.young * inertia, s.young * inertia, s.shear * 2 * inertia;
  return diagonal.asDiagonal();
}

void set_annular_stiffness(RodTree& tree, const std::vector<double>& thickness, double young, double shear,
                           double poisson, const std::string& where) {
  for (RodElement& element : tree.elements) {
    const auto a = static_cast<std::size_t>(element.first), b = static_cast<std::size_t>(element.second);
    const AnnularSection section{(tree.radius.at(a) + tree.radius.at(b)) / 2,
                                 (thickness.at(a) + thickness.at(b)) / 2, young, shear, poisson};
    element.stiffness = annular_stiffness(section, where);
  }
}

}  // namespace vasorod
