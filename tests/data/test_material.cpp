#include <Eigen/Eigenvalues>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

#include <vasorod/error.h>
#include <vasorod/material.h>
#include <vasorod/types.h>

namespace vasorod {
namespace {

// The compliance of a transversely isotropic solid, fibre first: 11, 22, 33, 23, 13, 12.
Mat6 compliance(const Material& m) {
  const double l = m.young_axial, t = m.young_transverse;
  Mat6 s = Mat6::Zero();
  s(0, 0) = 1 / l;
  s(1, 1) = s(2, 2) = 1 / t;
  s(0, 1) = s(1, 0) = s(0, 2) = s(2, 0) = -m.poisson_lt / l;
  s(1, 2) = s(2, 1) = -m.poisson_tt / t;
  s(3, 3) = 2 * (1 + m.poisson_tt) / t;
  s(4, 4) = s(5, 5) = 1 / m.shear_axial;
  return s;
}

// Smallest eigenvalue after the diagonal is scaled to ones, in size; a negative entry stays one.
double smallest_eigenvalue(const Mat6& s) {
  const Vec6 scale = s.diagonal().cwiseAbs().cwiseSqrt().cwiseInverse();
  const Mat6 scaled = scale.asDiagonal() * s * scale.asDiagonal();
  return Eigen::SelfAdjointEigenSolver<Mat6>(scaled).eigenvalues()[0];
}

std::string sentence_of(const Material& material) {
  try {
    check_material(material, "wall of aorta");
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(Material, IsotropicHasItsTwoNumbersInEveryDirection) {
  const Material m = Material::isotropic(3, 0.25, Law::svk);
  EXPECT_EQ(m.law, Law::svk);
  EXPECT_EQ(m.young_axial, 3);
  EXPECT_EQ(m.young_transverse, 3);
  EXPECT_EQ(m.poisson_tt, 0.25);
  EXPECT_EQ(m.poisson_lt, 0.25);
  EXPECT_DOUBLE_EQ(m.shear_axial, 1.2);  // 3 / 2.5
  EXPECT_EQ(Material::isotropic(3, 0.25).law, Law::biot);
  EXPECT_EQ(to_string(Law::biot), "biot");
  EXPECT_EQ(to_string(Law::svk), "svk");
  EXPECT_EQ(to_string(Law::neo_hookean), "neo-hookean");
}

TEST(Material, OneNumberOffIsNotIsotropic) {
  const Material isotropic = Material::isotropic(0.7, 0.45);
  EXPECT_TRUE(isotropic.is_isotropic());
  for (double Material::*number :
       {&Material::young_axial, &Material::young_transverse, &Material::shear_axial,
        &Material::poisson_tt, &Material::poisson_lt}) {
    Material other = isotropic;
    other.*number *= 1.01;
    EXPECT_FALSE(other.is_isotropic());
  }
}

TEST(Material, IsRefusedExactlyWhereItsComplianceIsNotPositiveDefinite) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> decades(-1.5, 1.5), ratio(-1.6, 1.6);
  const auto modulus = [&] { return std::pow(10, decades(random)); };
  int refused = 0, accepted = 0, undecided = 0;
  for (int i = 0; i < 20000; ++i) {
    Material m{Law::biot, modulus(), modulus(), modulus(), ratio(random), ratio(random)};
    if (i % 10 == 1) m.young_axial *= -1;
    if (i % 10 == 2) m.young_transverse *= -1;
    if (i % 10 == 3) m.shear_axial *= -1;
    const double smallest = smallest_eigenvalue(compliance(m));
    if (std::abs(smallest) < 1e-9) {
      ++undecided;
      continue;
    }
    EXPECT_EQ(fault_of(m).has_value(), smallest < 0)
        << m.young_axial << ' ' << m.young_transverse << ' ' << m.shear_axial << ' ' << m.poisson_tt
        << ' ' << m.poisson_lt << ": " << smallest;
    ++(smallest < 0 ? refused : accepted);
  }
  EXPECT_GT(refused, 5000);
  EXPECT_GT(accepted, 2000);
  EXPECT_LT(undecided, 10);
}

TEST(Material, TheIncompressibleLimitIsLeft) {
  EXPECT_FALSE(fault_of(Material::isotropic(1, 0.5)));
  EXPECT_TRUE(fault_of(Material::isotropic(1, 0.5 + 1e-9)));
  // An incompressible fibre solid: nu_LT = 1/2, nu_TT = 1 - E_T / (2 E_L).
  EXPECT_FALSE(fault_of({Law::biot, 4, 1, 0.3, 1 - 1.0 / 8, 0.5}));
  EXPECT_TRUE(fault_of({Law::biot, 4, 1, 0.3, 1 - 1.0 / 8 + 1e-6, 0.5}));
}

TEST(Material, WhatIsNoNumberIsRefused) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
        -std::numeric_limits<double>::infinity()})
    for (double Material::*number :
         {&Material::young_axial, &Material::young_transverse, &Material::shear_axial,
          &Material::poisson_tt, &Material::poisson_lt}) {
      Material m = Material::isotropic(1, 0.3);
      m.*number = bad;
      EXPECT_TRUE(fault_of(m)) << bad;
    }
}

TEST(Material, TheSentenceSaysWhereWhatAndWhatWasExpected) {
  EXPECT_EQ(sentence_of(Material::isotropic(1, 0.3)), "");
  Material m = Material::isotropic(1, 0.3);
  m.shear_axial = -2.5;
  EXPECT_EQ(sentence_of(m),
            "wall of aorta: found G_axial = -2.5, expected a finite number above 0");
  m = Material::isotropic(1, 0.3);
  m.poisson_tt = 1.25;
  EXPECT_EQ(sentence_of(m),
            "wall of aorta: found nu_TT = 1.25, expected -1 < nu_TT < 1, or the wall has no "
            "positive energy");
  // 1 - 0.5 - 2 * 0.25 * 2 = -0.5
  EXPECT_EQ(sentence_of({Law::biot, 1, 2, 1, 0.5, 0.5}),
            "wall of aorta: found 1 - nu_TT - 2 nu_LT^2 E_T/E_L = -0.5, expected a number that is "
            "not negative, or the wall has no positive energy");
}

TEST(Material, TheNeoHookeanLawIsIsotropicInAnyUnit) {
  Material m = Material::isotropic(1.0 / 3, 0.45, Law::neo_hookean);
  EXPECT_FALSE(fault_of(m));
  for (double* modulus : {&m.young_axial, &m.young_transverse, &m.shear_axial}) *modulus /= 7e3;
  EXPECT_FALSE(fault_of(m));
  m.shear_axial *= 1.001;
  EXPECT_EQ(sentence_of(m),
            "wall of aorta: found neo-hookean on a transversely isotropic wall, expected biot or "
            "svk, as the neo-Hookean law is isotropic");
  EXPECT_FALSE(fault_of(Material::isotropic(1, 0.5, Law::neo_hookean)));
  EXPECT_FALSE(fault_of(Material::isotropic(1, 0, Law::neo_hookean)));
  EXPECT_TRUE(fault_of(Material::isotropic(1, -0.1, Law::neo_hookean)));
}

TEST(Material, RefusesWhatHasNoPositiveEnergy) {
  Material m{Law::biot, 0.02, 1, 0.4, 0.3, 0.3};
  EXPECT_THROW(check_material(m, "wall"), InputError);  // 1 - .3 - 2 * .09 * 50 < 0
  m.young_axial = 1;
  EXPECT_NO_THROW(check_material(m, "wall"));
  m.shear_axial = 0;
  EXPECT_THROW(check_material(m, "wall"), InputError);
  EXPECT_NO_THROW(check_material(Material::isotropic(1, 0.5), "wall"));
}

}  // namespace
}  // namespace vasorod
