// Uniform torsion and stretch of a tube as a one-dimensional problem with the only unknown r(R). F
// has the local columns (radial, hoop, axis) = (r' e_r, r / R e_t, l e_z + r D e_t). The energy per
// length is minimised over r(R) in polynomials with Chebyshev-spaced nodes. This gives M and N
// independently, and the exact shape of the end sections for the three-dimensional models.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <vector>

#include "reference_fem/law.h"

namespace vasorod::fem::reference {

class UniformTorsion {
 public:
  /// Twist D per undeformed length, stretch l; free walls.
  UniformTorsion(const MaterialLaw& law, double inner, double outer, double twist, double stretch)
      : law_(law), inner_(inner), outer_(outer), twist_(twist), stretch_(stretch) {
    nodal_ = Eigen::VectorXd::Zero(degree + 1);
    for (int k = 0; k <= degree; ++k) nodal_[k] = radius_at(k);  // starts with r = R
    for (int iteration = 0; iteration < 60; ++iteration) {
      const double h = 1e-6;
      const Eigen::VectorXd g = gradient(nodal_);
      Eigen::MatrixXd H(degree + 1, degree + 1);
      for (int k = 0; k <= degree; ++k) {
        Eigen::VectorXd plus = nodal_, minus = nodal_;
        plus[k] += h;
        minus[k] -= h;
        H.col(k) = (gradient(plus) - gradient(minus)) / (2 * h);
      }
      const Eigen::VectorXd step = H.ldlt().solve(g);
      nodal_ -= step;
      if (step.norm() < 1e-13 * outer) break;
    }
  }

  double radius(double R) const { return value(nodal_, R); }
  /// Torque and axial force about the axis.
  double torque() const { return resultant(true); }
  double force() const { return resultant(false); }

 private:
  static constexpr int degree = 8;

  double radius_at(int k) const {
    return 0.5 * (inner_ + outer_) -
           0.5 * (outer_ - inner_) * std::cos(std::numbers::pi * k / degree);
  }
  /// Lagrange basis through the nodes: values or slopes.
  double basis(int k, double R, bool slope) const {
    double sum = 0, product = 1;
    for (int j = 0; j <= degree; ++j) {
      if (j == k) continue;
      product *= (R - radius_at(j)) / (radius_at(k) - radius_at(j));
      double term = 1 / (radius_at(k) - radius_at(j));
      for (int m = 0; m <= degree; ++m)
        if (m != k && m != j) term *= (R - radius_at(m)) / (radius_at(k) - radius_at(m));
      sum += term;
    }
    return slope ? sum : product;
  }
  double value(const Eigen::VectorXd& r, double R, bool slope = false) const {
    double v = 0;
    for (int k = 0; k <= degree; ++k) v += r[k] * basis(k, R, slope);
    return v;
  }
  Mat3 stress(const Eigen::VectorXd& r, double R) const {
    Mat3 F = Mat3::Zero();
    const double now = value(r, R);
    F(0, 0) = value(r, R, true);
    F(1, 1) = now / R;
    F(1, 2) = now * twist_;
    F(2, 2) = stretch_;
    return F * stress_tensor(law_.evaluate(F).stress);
  }
  template <class Function>
  void integrate(const Function& f) const {
    // Gauss-Legendre by the eigenvalues of its Jacobi matrix
    constexpr int n = 14;
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(n, n);
    for (int i = 1; i < n; ++i) J(i, i - 1) = J(i - 1, i) = i / std::sqrt(4.0 * i * i - 1);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(J);
    for (int i = 0; i < n; ++i) {
      const double R = 0.5 * (inner_ + outer_) + 0.5 * (outer_ - inner_) * eigen.eigenvalues()[i];
      const double first = eigen.eigenvectors()(0, i);
      f(R, 2 * std::numbers::pi * R * first * first * (outer_ - inner_));
    }
  }
  Eigen::VectorXd gradient(const Eigen::VectorXd& r) const {
    Eigen::VectorXd g = Eigen::VectorXd::Zero(degree + 1);
    integrate([&](double R, double weight) {
      const Mat3 P = stress(r, R);
      for (int k = 0; k <= degree; ++k)
        g[k] += weight * (P(0, 0) * basis(k, R, true) +
                          (P(1, 1) / R + P(1, 2) * twist_) * basis(k, R, false));
    });
    return g;
  }
  double resultant(bool moment) const {
    double sum = 0;
    integrate([&](double R, double weight) {
      const Mat3 P = stress(nodal_, R);
      sum += weight * (moment ? value(nodal_, R) * P(1, 2) : P(2, 2));
    });
    return sum;
  }

  MaterialLaw law_;
  double inner_, outer_, twist_, stretch_;
  Eigen::VectorXd nodal_;
};

/// The stretch at which the axial force vanishes.
inline double free_stretch(const MaterialLaw& law, double inner, double outer, double twist) {
  double a = 1, b = 1 + 1e-4;
  double fa = UniformTorsion(law, inner, outer, twist, a).force(),
         fb = UniformTorsion(law, inner, outer, twist, b).force();
  for (int i = 0; i < 30 && std::abs(b - a) > 1e-13; ++i) {
    const double c = b - fb * (b - a) / (fb - fa);
    a = b;
    fa = fb;
    b = c;
    fb = UniformTorsion(law, inner, outer, twist, b).force();
  }
  return b;
}

}  // namespace vasorod::fem::reference
