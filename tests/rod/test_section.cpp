#include <cmath>
#include <gtest/gtest.h>

#include <vasorod/error.h>

#include "rod/rods.h"
#include "rod/section.h"

namespace vasorod {
namespace {

TEST(Section, ThinRingAndSolidDiskClosedForms) {
  const AnnularSection thin{10, 1e-6};
  const Mat6 c = annular_stiffness(thin, {Law::biot, 2, 2, 0.7, 0.3, 0});
  const double pi = 3.14159265358979323846;
  EXPECT_NEAR(c(2, 2) / (2 * 2 * pi * 10 * 1e-6), 1, 1e-12);
  EXPECT_NEAR(c(3, 3) / (2 * pi * 1e3 * 1e-6), 1, 1e-10);
  EXPECT_NEAR(c(5, 5) / (0.7 * 2 * pi * 1e3 * 1e-6), 1, 1e-10);
  // Cowper's thin tube: 2 (1 + nu) / (4 + 3 nu)
  EXPECT_NEAR(thin.shear_coefficient(0.3), 2 * 1.3 / (4 + 0.9), 1e-6);
  // a disk of radius 2: 6 (1 + nu) / (7 + 6 nu), pi r^4 / 4
  const AnnularSection disk{1, 2};
  EXPECT_NEAR(disk.shear_coefficient(0.3), 6 * 1.3 / (7 + 1.8), 1e-14);
  EXPECT_NEAR(disk.second_moment(), pi * 16 / 4, 1e-13);
  EXPECT_NEAR(disk.area(), pi * 4, 1e-13);
}

TEST(Section, ThePolarMomentIsTheIntegralOverTheRing) {
  const AnnularSection ring{5, 2};
  double area = 0, second = 0;
  const int steps = 20000;
  for (int i = 0; i < steps; ++i) {
    const double r = ring.inner() + 2.0 * (i + 0.5) / steps;
    area += 2 * M_PI * r * 2 / steps;
    second += M_PI * r * r * r * 2 / steps;  // of y^2: half the polar one
  }
  EXPECT_NEAR(ring.area(), area, 1e-7 * area);
  EXPECT_NEAR(ring.second_moment(), second, 1e-7 * second);
  const Mat6 c = annular_stiffness(ring, {Law::biot, 3, 1, 0.7, 0.3, 0});
  EXPECT_NEAR(c(2, 2), 3 * area, 1e-6 * c(2, 2));
  EXPECT_NEAR(c(4, 4), 3 * second, 1e-6 * c(4, 4));
  EXPECT_NEAR(c(5, 5), 0.7 * 2 * second, 1e-6 * c(5, 5));
  EXPECT_EQ(c, Mat6(c.diagonal().asDiagonal()));
}

TEST(Section, WhatIsNoRingIsRefused) {
  const Material good = Material::isotropic(1, 0.3);
  const auto refused = [&](const AnnularSection& section, const Material& material,
                           const std::string& word) {
    try {
      annular_stiffness(section, material, "vessel svc");
      ADD_FAILURE() << word << " was accepted";
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).rfind("vessel svc: " + word, 0), 0u) << error.what();
    }
  };
  for (const double bad : {0.0, -1.0, std::nan("")}) {
    refused({bad, 1}, good, "mid-wall radius");
    refused({5, bad}, good, "thickness");
    Material m = good;
    m.young_axial = bad;
    refused({5, 1}, m, "Young's modulus");
    m = good;
    m.shear_axial = bad;
    refused({5, 1}, m, "shear modulus");
  }
  refused({5, 10.1}, good, "thickness");
  EXPECT_NO_THROW(annular_stiffness({5, 10}, good));
  Material m = good;
  m.poisson_tt = 0.6;
  refused({5, 1}, m, "Poisson's ratio");
}

TEST(Section, ATaperingTreeHasTheSectionOfEachElementsMiddle) {
  RodTree tree = chain({}, 10, Vec3::Zero(), 2, isotropic(1, 1, 1, 1));
  tree.radius = {5, 4, 2};
  const Material material = Material::isotropic(2, 0.25);
  set_annular_stiffness(tree, {1, 0.5, 0.25}, material);
  EXPECT_EQ(tree.elements[0].stiffness, annular_stiffness({4.5, 0.75}, material));
  EXPECT_EQ(tree.elements[1].stiffness, annular_stiffness({3, 0.375}, material));
}

}  // namespace
}  // namespace vasorod
