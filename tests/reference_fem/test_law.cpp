// The laws compared with finite differences of their energy, with closed forms, and with each other
// at small strain.
#include <Eigen/Dense>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include <vasorod/error.h>

#include "reference_fem/law.h"

namespace vasorod::fem {
namespace {

Moduli vessel() {
  return {1.7, 0.9, 0.35, 0.2, 0.25, false};
}

std::vector<MaterialLaw> laws() {
  return {MaterialLaw(LawKind::biot, vessel()), MaterialLaw(LawKind::svk, vessel()),
          MaterialLaw(LawKind::biot, Moduli::isotropic(1, 0.3)),
          MaterialLaw(LawKind::neo_hookean, Moduli::isotropic(1, 0.3)),
          MaterialLaw::split(0.4, 7.0)};
}

Mat3 rotation() {
  return Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()).toRotationMatrix();
}

/// Deformation gradients: general, with two and with three equal stretches, and the rest state.
std::vector<Mat3> gradients() {
  Mat3 general;
  general << 1.1, 0.2, -0.1, 0.05, 0.85, 0.15, 0.3, -0.2, 1.25;
  const Mat3 N = Eigen::AngleAxisd(1.1, Vec3(1, -1, 3).normalized()).toRotationMatrix();
  const Mat3 pair = rotation() * N * Vec3(1.2, 1.2, 0.8).asDiagonal() * N.transpose();
  return {general, pair, 1.15 * rotation(), Mat3::Identity()};
}

TEST(Law, StressIsTheDerivativeOfTheEnergy) {
  const double h = 1e-5;
  for (const MaterialLaw& law : laws())
    for (const Mat3& F : gradients()) {
      const Mat3 P = F * stress_tensor(law.evaluate(F).stress);
      for (int i = 0; i < 3; ++i)
        for (int J = 0; J < 3; ++J) {
          Mat3 plus = F, minus = F;
          plus(i, J) += h;
          minus(i, J) -= h;
          const double slope = (law.evaluate(plus).energy - law.evaluate(minus).energy) / (2 * h);
          EXPECT_NEAR(P(i, J), slope, 2e-9) << to_string(law.kind());
        }
    }
}

TEST(Law, TangentIsTheDerivativeOfTheStressAlsoAtRepeatedStretches) {
  const double h = 1e-5;
  for (const MaterialLaw& law : laws())
    for (const Mat3& F : gradients()) {
      const Response at = law.evaluate(F);
      EXPECT_LT((at.tangent - at.tangent.transpose()).norm(), 1e-12 * at.tangent.norm());
      for (int i = 0; i < 3; ++i)
        for (int J = 0; J < 3; ++J) {
          Mat3 dF = Mat3::Zero();
          dF(i, J) = 1;
          const Mat3 dE = 0.5 * (F.transpose() * dF + dF.transpose() * F);
          Vec6 strain;
          strain << dE(0, 0), dE(1, 1), dE(2, 2), 2 * dE(0, 1), 2 * dE(0, 2), 2 * dE(1, 2);
          const Vec6 expected =
              (law.evaluate(F + h * dF).stress - law.evaluate(F - h * dF).stress) / (2 * h);
          EXPECT_LT((at.tangent * strain - expected).norm(), 3e-9 * at.tangent.norm())
              << to_string(law.kind());
        }
    }
}

TEST(Law, DoesNotFeelRotations) {
  for (const MaterialLaw& law : laws())
    for (const Mat3& F : gradients()) {
      const Response a = law.evaluate(F), b = law.evaluate(rotation() * F);
      EXPECT_NEAR(a.energy, b.energy, 1e-13);
      EXPECT_LT((a.stress - b.stress).norm(), 1e-12);
    }
}

Vec6 some_stress() {
  return 0.1 * (Vec6() << -0.3, 1.0, 0.6, 0.2, -0.4, 0.5).finished();
}

TEST(Law, APrestresssStressAndTangentAreDerivatives) {
  const double h = 1e-5;
  const Vec6 s = some_stress();
  for (const MaterialLaw& law : laws())
    for (const Mat3& F : gradients()) {
      const Response at = law.of_prestress(F, s), turned = law.of_prestress(rotation() * F, s);
      EXPECT_NEAR(at.energy, turned.energy, 1e-14) << to_string(law.kind());
      EXPECT_LT((at.stress - turned.stress).norm(), 1e-14) << to_string(law.kind());
      const Mat3 P = F * stress_tensor(at.stress);
      for (int i = 0; i < 3; ++i)
        for (int J = 0; J < 3; ++J) {
          Mat3 dF = Mat3::Zero();
          dF(i, J) = 1;
          const Response plus = law.of_prestress(F + h * dF, s),
                         minus = law.of_prestress(F - h * dF, s);
          EXPECT_NEAR(P(i, J), (plus.energy - minus.energy) / (2 * h), 1e-10);
          const Vec6 strain = strain_components(0.5 * (F.transpose() * dF + dF.transpose() * F));
          EXPECT_LT((at.tangent * strain - (plus.stress - minus.stress) / (2 * h)).norm(), 1e-9)
              << to_string(law.kind());
        }
    }
}

// Of the laws that are linear in their strain, a prestress C : e0 shifts the strain by e0. At rest
// every law carries the prestress itself.
TEST(Law, APrestressIsAStrainFromTheStart) {
  const Vec3 start(0.02, -0.03, 0.05), now(1.1, 0.9, 1.2);
  const Vec6 e0 = (Vec6() << start, 0, 0, 0).finished(), s = stiffness(vessel()) * e0;
  const MaterialLaw biot(LawKind::biot, vessel()), svk(LawKind::svk, vessel());
  const Mat3 F = now.asDiagonal();
  const auto all = [&](const MaterialLaw& law) {
    Response response = law.evaluate(F);
    response += law.of_prestress(F, s);
    return response;
  };
  EXPECT_NEAR(all(biot).energy + 0.5 * s.dot(e0),
              biot.evaluate((now + start).asDiagonal().toDenseMatrix()).energy, 1e-14);
  const Vec3 shifted = (now.array().square() + 2 * start.array()).sqrt();
  EXPECT_NEAR(all(svk).energy + 0.5 * s.dot(e0),
              svk.evaluate(shifted.asDiagonal().toDenseMatrix()).energy, 1e-14);
  for (const MaterialLaw& law : laws()) {
    const Response at = law.of_prestress(Mat3::Identity(), some_stress());
    EXPECT_LT((at.stress - some_stress()).norm(), 1e-15) << to_string(law.kind());
    EXPECT_NEAR(at.energy, 0, 1e-15);
  }
}

TEST(Law, AUniaxialStrainPullsAlongTheFibreOnly) {
  for (const MaterialLaw& law : laws()) {
    const Vec6 strain = law.uniaxial_strain(1.07), stress = law.linear_stiffness() * strain;
    EXPECT_NEAR(strain[2], 0.07, 1e-15) << to_string(law.kind());
    EXPECT_LT((stress - stress[2] * Vec6::Unit(2)).norm(), 1e-14) << to_string(law.kind());
    EXPECT_LT((law.evaluate(Mat3::Identity()).tangent - law.linear_stiffness()).norm(), 1e-12);
  }
}

TEST(Law, AllAgreeWithTheStiffnessAtRest) {
  const Moduli m = vessel();
  for (const LawKind kind : {LawKind::biot, LawKind::svk})
    EXPECT_LT((MaterialLaw(kind, m).evaluate(Mat3::Identity()).tangent - stiffness(m)).norm(),
              1e-12);
  const Moduli i = Moduli::isotropic(1, 0.3);
  EXPECT_LT((MaterialLaw(LawKind::neo_hookean, i).evaluate(Mat3::Identity()).tangent - stiffness(i))
                .norm(),
            1e-12);
  EXPECT_LT(
      (MaterialLaw(LawKind::split_neo_hookean, i).evaluate(Mat3::Identity()).tangent - stiffness(i))
          .norm(),
      1e-12);
}

// Closed forms of the stiffness (transverse isotropy, axis 3), written independently of the
// inverted compliance.
TEST(Law, StiffnessMatchesItsClosedForm) {
  const Moduli m = vessel();
  const double d = m.axial * (1 - m.poisson) - 2 * m.transverse * m.coupling * m.coupling;
  const double c12 = m.transverse * (m.axial * m.poisson + m.transverse * m.coupling * m.coupling) /
                     ((1 + m.poisson) * d);
  const double c66 = m.transverse / (2 * (1 + m.poisson));
  const Mat6 C = stiffness(m);
  EXPECT_NEAR(C(0, 1), c12, 1e-14);
  EXPECT_NEAR(C(0, 0), c12 + 2 * c66, 1e-14);
  EXPECT_NEAR(C(0, 2), m.axial * m.transverse * m.coupling / d, 1e-14);
  EXPECT_NEAR(C(2, 2), m.axial * m.axial * (1 - m.poisson) / d, 1e-14);
  EXPECT_NEAR(C(3, 3), c66, 1e-14);
  EXPECT_NEAR(C(5, 5), m.shear, 1e-14);
}

/// P11 of a bar of E = 1, nu = 0.3 pulled to `stretch` with free sides (Newton on the lateral
/// stretch).
double bar(const MaterialLaw& law, double stretch, double& lateral) {
  lateral = 1;
  for (int i = 0; i < 50; ++i) {
    const Response r = law.evaluate(Vec3(lateral, lateral, stretch).asDiagonal());
    lateral -= r.stress[0] / ((r.tangent(0, 0) + r.tangent(0, 1)) * lateral);
  }
  return stretch * law.evaluate(Vec3(lateral, lateral, stretch).asDiagonal()).stress[2];
}

TEST(Law, FiniteUniaxialTension) {
  const Moduli m = Moduli::isotropic(1, 0.3);
  double lateral = 0;
  // stretch, neo-Hookean lateral stretch and P, solved independently from
  // mu (lt^2 - 1) + lambda ln J = 0
  const double table[][3] = {{0.5, 1.2107673905, -0.9353520569},
                             {0.8, 1.0673383693, -0.2400053820},
                             {1.2, 0.9456326243, 0.1749291474},
                             {1.5, 0.8801745918, 0.3782801764},
                             {2.0, 0.7980775445, 0.6467446602}};
  for (const auto& [stretch, lt, P] : table) {
    EXPECT_NEAR(bar(MaterialLaw(LawKind::neo_hookean, m), stretch, lateral), P, 1e-9);
    EXPECT_NEAR(lateral, lt, 1e-9);
    EXPECT_NEAR(bar(MaterialLaw(LawKind::svk, m), stretch, lateral),
                stretch * (stretch * stretch - 1) / 2, 1e-12);
    EXPECT_NEAR(lateral, std::sqrt(1 - 0.3 * (stretch * stretch - 1)), 1e-12);
    EXPECT_NEAR(bar(MaterialLaw(LawKind::biot, m), stretch, lateral), stretch - 1, 1e-12);
    EXPECT_NEAR(lateral, 1 - 0.3 * (stretch - 1), 1e-12);
  }
}

TEST(Law, TransverselyIsotropicBarFollowsItsAxis) {
  const MaterialLaw law(LawKind::biot, vessel());
  double lateral = 0;
  EXPECT_NEAR(bar(law, 1.2, lateral), 1.7 * 0.2, 1e-12);
  EXPECT_NEAR(lateral, 1 - 0.2 * 0.2, 1e-12);
}

TEST(Law, NamesTheViolatedInequality) {
  Moduli m = vessel();
  m.coupling = 1.2;
  EXPECT_NE(inadmissible(m).find("1 - nu_TT - 2 nu_LT^2 E_T / E_axial"), std::string::npos);
  EXPECT_THROW(MaterialLaw(LawKind::biot, m), InputError);
  EXPECT_NE(inadmissible(Moduli::isotropic(1, 0.5)).find("must be positive"), std::string::npos);
  EXPECT_NE(inadmissible(Moduli::isotropic(-1, 0.3)).find("E_axial"), std::string::npos);
  EXPECT_THROW(MaterialLaw(LawKind::neo_hookean, vessel()), InputError);
}

}  // namespace
}  // namespace vasorod::fem
