#include "reference_fem/law.h"

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <sstream>

#include <vasorod/error.h>

namespace vasorod::fem {
namespace {

Vec6 stress_vector(const Mat3& m) {
  Vec6 v;
  v << m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(0, 2), m(1, 2);
  return v;
}

/// (C^-1 (.) C^-1)_IJKL = 1/2 (Ci_IK Ci_JL + Ci_IL Ci_JK) as a 6x6 matrix for engineering strains.
Mat6 inverse_square(const Mat3& Ci) {
  Mat6 m;
  for (int a = 0; a < 6; ++a)
    for (int b = 0; b < 6; ++b) {
      const auto [I, J] = six_pairs[static_cast<std::size_t>(a)];
      const auto [K, L] = six_pairs[static_cast<std::size_t>(b)];
      m(a, b) = 0.5 * (Ci(I, K) * Ci(J, L) + Ci(I, L) * Ci(J, K));
    }
  return m;
}

/// The energy T0 : (U - I) + 1/2 (U - I) : C : (U - I). T = T0 + C : (U - I) is conjugate to U; S
/// solves S U + U S = 2 T. All derivatives are Sylvester equations with U. In U's eigenbasis they
/// are solved by division by sums of stretches, so repeated stretches are no special case.
Response of_stretch(const Mat3& C, const Vec6& T0, const Mat6& stiffness) {
  const Eigen::SelfAdjointEigenSolver<Mat3> eigen(C);
  const Mat3& N = eigen.eigenvectors();
  const Vec3 stretch = eigen.eigenvalues().cwiseMax(0).cwiseSqrt();
  const Mat3 sums = stretch.replicate<1, 3>() + stretch.transpose().replicate<3, 1>();
  const auto sylvester = [&](const Mat3& right) -> Mat3 {
    return N * (N.transpose() * right * N).cwiseQuotient(sums) * N.transpose();
  };
  // U - I = (C - I) (U + I)^-1, without cancellation at small strain
  const Mat3 strain = N *
                      ((N.transpose() * (C - Mat3::Identity()) * N)
                           .diagonal()
                           .cwiseQuotient(stretch + Vec3::Ones()))
                          .asDiagonal() *
                      N.transpose();
  const Vec6 strain6 = strain_components(strain);
  const Vec6 T6 = T0 + stiffness * strain6;

  Response out;
  out.energy = 0.5 * strain6.dot(T0 + T6);
  const Mat3 S = sylvester(2 * stress_tensor(T6));
  out.stress = stress_vector(S);
  for (int b = 0; b < 6; ++b) {
    Vec6 dE6 = Vec6::Zero();
    dE6[b] = b < 3 ? 1.0 : 0.5;
    const Mat3 dU = sylvester(2 * stress_tensor(dE6));
    const Mat3 dT = stress_tensor(stiffness * strain_components(dU));
    out.tangent.col(b) = stress_vector(sylvester(2 * dT - S * dU - dU * S));
  }
  return out;
}

}  // namespace

Response& Response::operator+=(const Response& other) {
  energy += other.energy;
  stress += other.stress;
  tangent += other.tangent;
  return *this;
}

Moduli Moduli::isotropic(double young, double nu) {
  return {young, young, nu, nu, young / (2 * (1 + nu)), true};
}

std::string inadmissible(const Moduli& m) {
  const auto say = [](const std::string& what, double value, const std::string& bound) {
    std::ostringstream s;
    s << what << " = " << value << " must be " << bound;
    return s.str();
  };
  if (!(m.axial > 0)) return say("E_axial", m.axial, "positive");
  if (!(m.transverse > 0)) return say("E_T", m.transverse, "positive");
  if (!(m.shear > 0)) return say("G_axial", m.shear, "positive");
  if (!(std::abs(m.poisson) < 1)) return say("nu_TT", m.poisson, "between -1 and 1");
  const double d = 1 - m.poisson - 2 * m.coupling * m.coupling * m.transverse / m.axial;
  if (!(d > 0)) return say("1 - nu_TT - 2 nu_LT^2 E_T / E_axial", d, "positive");
  return {};
}

Mat6 stiffness(const Moduli& m) {
  Mat6 compliance = Mat6::Zero();
  compliance(0, 0) = compliance(1, 1) = 1 / m.transverse;
  compliance(2, 2) = 1 / m.axial;
  compliance(0, 1) = compliance(1, 0) = -m.poisson / m.transverse;
  compliance(0, 2) = compliance(2, 0) = compliance(1, 2) = compliance(2, 1) = -m.coupling / m.axial;
  compliance(3, 3) = 2 * (1 + m.poisson) / m.transverse;
  compliance(4, 4) = compliance(5, 5) = 1 / m.shear;
  return compliance.inverse();
}

std::string to_string(LawKind kind) {
  switch (kind) {
    case LawKind::biot:
      return "biot";
    case LawKind::svk:
      return "svk";
    case LawKind::neo_hookean:
      return "neo-hookean";
    case LawKind::split_neo_hookean:
      return "split-neo-hookean";
  }
  return {};
}

MaterialLaw::MaterialLaw(LawKind kind, const Moduli& m) : kind_(kind) {
  if (const std::string why = inadmissible(m); !why.empty())
    throw InputError("wall: the moduli are not those of a stable material: " + why);
  if ((kind == LawKind::neo_hookean || kind == LawKind::split_neo_hookean) && !m.is_isotropic)
    throw InputError(
        "wall: the neo-Hookean law is isotropic here, found a transversely isotropic wall; "
        "expected law biot "
        "or svk");
  stiffness_ = stiffness(m);
  mu_ = m.shear;
  lambda_ = stiffness_(0, 1);
  kappa_ = lambda_ + 2 * mu_ / 3;
}

MaterialLaw MaterialLaw::split(double mu, double kappa) {
  MaterialLaw law;
  law.kind_ = LawKind::split_neo_hookean;
  law.mu_ = mu;
  law.kappa_ = kappa;
  law.stiffness_.topLeftCorner<3, 3>().setConstant(kappa - 2 * mu / 3);
  law.stiffness_.diagonal() += mu * Vec6(Vec6(2, 2, 2, 1, 1, 1));
  return law;
}

Response MaterialLaw::evaluate(const Mat3& F) const {
  const Mat3 C = F.transpose() * F;
  switch (kind_) {
    case LawKind::biot:
      return biot(C);
    case LawKind::svk:
      return svk(C);
    case LawKind::neo_hookean:
      return neo_hookean(C, F.determinant());
    case LawKind::split_neo_hookean:
      break;
  }
  const double J = F.determinant();
  const Volumetric u = volumetric(J);
  Response out = isochoric(F);
  const Response held = pressure_response(F, u.slope);
  const Vec6 ci = stress_vector(C.inverse());
  out += held;
  out.energy += u.energy;
  out.tangent += J * J * u.curvature * ci * ci.transpose();
  return out;
}

Response MaterialLaw::biot(const Mat3& C) const {
  return of_stretch(C, Vec6::Zero(), stiffness_);
}

Vec6 MaterialLaw::uniaxial_strain(double stretch) const {
  const Vec6 under_a_unit_pull = stiffness_.llt().solve(Vec6::Unit(2));
  return (stretch - 1) / under_a_unit_pull[2] * under_a_unit_pull;
}

Vec3 MaterialLaw::uniaxial_stretches(double stretch) const {
  if (kind_ == LawKind::biot) return Vec3::Ones() + uniaxial_strain(stretch).head<3>();
  const Vec3 small = uniaxial_strain(2).head<3>();
  return {std::pow(stretch, small[0]), std::pow(stretch, small[1]), stretch};
}

Response MaterialLaw::of_prestress(const Mat3& F, const Vec6& s) const {
  const Mat3 C = F.transpose() * F;
  if (kind_ != LawKind::svk) return of_stretch(C, s, Mat6::Zero());
  Response out;
  out.stress = s;
  out.energy = s.dot(strain_components(0.5 * (C - Mat3::Identity())));
  return out;
}

Response MaterialLaw::svk(const Mat3& C) const {
  const Vec6 E = strain_components(0.5 * (C - Mat3::Identity()));
  Response out;
  out.stress = stiffness_ * E;
  out.energy = 0.5 * E.dot(out.stress);
  out.tangent = stiffness_;
  return out;
}

Response MaterialLaw::neo_hookean(const Mat3& C, double J) const {
  const Mat3 Ci = C.inverse();
  const double lnJ = std::log(J);
  const Vec6 ci = stress_vector(Ci);
  Response out;
  out.energy = mu_ / 2 * (C.trace() - 3) - mu_ * lnJ + lambda_ / 2 * lnJ * lnJ;
  out.stress = mu_ * (stress_vector(Mat3::Identity()) - ci) + lambda_ * lnJ * ci;
  out.tangent = lambda_ * ci * ci.transpose() + 2 * (mu_ - lambda_ * lnJ) * inverse_square(Ci);
  return out;
}

Response MaterialLaw::isochoric(const Mat3& F) const {
  const Mat3 C = F.transpose() * F, Ci = C.inverse();
  const Vec6 ci = stress_vector(Ci), one = stress_vector(Mat3::Identity());
  const double I1 = C.trace(), scale = mu_ * std::pow(F.determinant(), -2.0 / 3);
  Response out;
  out.energy = 0.5 * (scale * I1 - 3 * mu_);
  out.stress = scale * (one - I1 / 3 * ci);
  out.tangent = scale * (-2.0 / 3 * (ci * one.transpose() + one * ci.transpose()) +
                         2.0 / 9 * I1 * ci * ci.transpose() + 2.0 / 3 * I1 * inverse_square(Ci));
  return out;
}

Volumetric MaterialLaw::volumetric(double J) const {
  return {kappa_ / 4 * (J * J - 1 - 2 * std::log(J)), kappa_ / 2 * (J - 1 / J),
          kappa_ / 2 * (1 + 1 / (J * J))};
}

Response pressure_response(const Mat3& F, double pressure) {
  const Mat3 Ci = (F.transpose() * F).inverse();
  const Vec6 ci = stress_vector(Ci);
  const double pJ = pressure * F.determinant();
  Response out;
  out.stress = pJ * ci;
  out.tangent = pJ * (ci * ci.transpose() - 2 * inverse_square(Ci));
  return out;
}

Response from_stress_free_shape(const Response& response, const Mat3& A) {
  Mat6 push;  // S = A S' A^T in components; its transpose takes E to A^T E A
  for (int a = 0; a < 6; ++a)
    for (int b = 0; b < 6; ++b) {
      const auto [I, J] = six_pairs[static_cast<std::size_t>(a)];
      const auto [K, L] = six_pairs[static_cast<std::size_t>(b)];
      push(a, b) = A(I, K) * A(J, L);
      if (K != L) push(a, b) += A(I, L) * A(J, K);
    }
  const double volume = A.determinant();
  Response out;
  out.energy = response.energy / volume;
  out.stress = push * response.stress / volume;
  out.tangent = push * response.tangent * push.transpose() / volume;
  return out;
}

}  // namespace vasorod::fem
