#include "wall/triangle_energy.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

#include "wall/degeneracy_barriers.h"
#include "wall/membrane_strain.h"

namespace vasorod {

namespace {

// det C, with the gradient of its logarithm.
struct Determinant {
  double value;
  Vec3 log_gradient;

  // A triangle collapsed to a line keeps finite forces.
  explicit Determinant(const Vec3& c)
      : value(std::max(c[0] * c[1] - c[2] * c[2], 1e-24)),
        log_gradient(Vec3(c[1], c[0], -2 * c[2]) / value) {}
};

// Height over edge k with the derivatives of ln h, q = g_k turned by 90 degrees:
//   h = sqrt(det C / (q^T C q))
struct Height {
  Vec3 length_gradient;  // of ln (q^T C q)
  double value;

  Height(const Vec2& g, const Vec3& c, const Determinant& det)
      : length_gradient(g[1] * g[1], g[0] * g[0], -2 * g[0] * g[1]) {
    const double square = length_gradient.dot(c);
    value = std::sqrt(det.value / square);
    length_gradient /= square;
  }
  Vec3 log_gradient(const Determinant& det) const {
    return (det.log_gradient - length_gradient) / 2;
  }
  Mat3 log_hessian(const Determinant& det) const {
    Mat3 h = (length_gradient * length_gradient.transpose() -
              det.log_gradient * det.log_gradient.transpose()) /
             2;
    h(0, 1) += 0.5 / det.value;
    h(1, 0) += 0.5 / det.value;
    h(2, 2) -= 1 / det.value;
    return h;
  }
};

// Factor of the collapse barrier: about E t A. A law for large strains needs none: its own energy
// stops a collapse.
double collapse_stiffness(const TriangleRest& rest) {
  if (rest.large) return 0;
  return (rest.stiffness(0, 0) + rest.stiffness(1, 1)) / 2;
}

Vec6 of_lean(const TriangleRest& rest, const TriangleState& state) {
  if (!rest.leaning) return Vec6::Zero();
  return rest.leaning->strains * state.lean;
}

double shear_energy(const TriangleRest& rest, const TriangleState& state) {
  return rest.leaning ? state.lean.dot(rest.leaning->stiffness * state.lean) / 2 : 0;
}

// The triangle's 2 e12 over its partner's. A lean does not count.
double apart_from_partner(const TriangleRest& rest, const TriangleState& state, const Vec6& y) {
  return y[2] - of_lean(rest, state)[2] - state.partner_shear;
}

double relieved(const TriangleRest& rest, const TriangleState& state, const Vec6& y) {
  const double apart = apart_from_partner(rest, state, y);
  return rest.relief / 4 * apart * apart;
}

// What the strains and their derivatives are made of.
struct Parts {
  MembraneStrain membrane;
  Determinant det;
  std::array<Height, 3> height;
  std::array<FoldBarrier, 3> fold;

  Parts(Law law, const TriangleRest& rest, const TriangleState& state)
      : membrane(membrane_strain(law, state.metric)),
        det(state.metric),
        height{height_over(rest, state, 0), height_over(rest, state, 1),
               height_over(rest, state, 2)},
        fold{FoldBarrier(state.half_sine[0], state.half_cosine[0]),
             FoldBarrier(state.half_sine[1], state.half_cosine[1]),
             FoldBarrier(state.half_sine[2], state.half_cosine[2])} {}

 private:
  Height height_over(const TriangleRest& rest, const TriangleState& state, int k) const {
    return {rest.gradients.col(k), state.metric, det};
  }
};

Vec6 strains_of(const TriangleRest& rest, const TriangleState& state, const Parts& parts) {
  Vec6 y;
  y.head<3>() = parts.membrane.strain;
  for (int k = 0; k < 3; ++k) {
    const auto at = static_cast<size_t>(k);
    const double slope =
        state.half_sine[k] + parts.fold[at].value + state.xi[k] * state.half_cosine[k];
    y[3 + k] = (state.given[at] ? state.half_sine[k] : 2 * parts.height[at].value * slope) -
               rest.bending[k];
  }
  if (rest.leaning) y += of_lean(rest, state);
  return y;
}

}  // namespace

Vec6 prestrain(const TriangleRest& rest) {
  if (rest.prestress.isZero(0)) return Vec6::Zero();
  return rest.stiffness.ldlt().solve(rest.prestress);
}

Vec6 triangle_strains(Law law, const TriangleRest& rest, const TriangleState& state) {
  return strains_of(rest, state, Parts(law, rest, state));
}

double triangle_value(Law law, const TriangleRest& rest, const TriangleState& state) {
  const Vec6 y = triangle_strains(law, rest, state);
  const double before = rest.stored + rest.prestress.dot(y) + shear_energy(rest, state);
  if (rest.large) return before + large_strain_energy(*rest.large, y, false).value;
  return before + y.dot(rest.stiffness * y) / 2 - relieved(rest, state, y) +
         collapse_stiffness(rest) * CollapseBarrier(state.metric).value;
}

TriangleEnergy triangle_energy(Law law, const TriangleRest& rest, const TriangleState& state,
                               SecondDerivatives second) {
  const bool with_hessian = second != SecondDerivatives::none,
             all = second == SecondDerivatives::all;
  TriangleEnergy e;
  const Parts parts(law, rest, state);
  const Mat3& strain_by_metric = parts.membrane.derivative;
  e.strains = strains_of(rest, state, parts);
  const Mat6* stiffness = &rest.stiffness;
  Mat6 tangent;
  if (rest.large) {
    const LargeStrainEnergy large = large_strain_energy(*rest.large, e.strains, with_hessian);
    e.value = large.value;
    e.stress = large.stress;
    tangent = large.tangent;
    if (all || (with_hessian && tangent.llt().info() == Eigen::Success)) stiffness = &tangent;
  } else {
    e.stress.noalias() = rest.stiffness * e.strains;
    e.value = e.stress.dot(e.strains) / 2;
  }
  e.value += rest.stored + rest.prestress.dot(e.strains);
  e.stress += rest.prestress;
  e.shear = shear_energy(rest, state);
  e.value += e.shear;
  if (rest.leaning) {
    e.lean_gradient = rest.leaning->strains.transpose() * e.stress;
    e.lean_gradient += rest.leaning->stiffness * state.lean;
  }
  if (rest.relief > 0) {
    e.value -= relieved(rest, state, e.strains);
    e.stress[2] -= rest.relief * apart_from_partner(rest, state, e.strains);
  }
  const CollapseBarrier stop(state.metric);
  e.value += collapse_stiffness(rest) * stop.value;
  e.gradient.setZero();
  e.gradient.head<3>() =
      strain_by_metric.transpose() * e.stress.head<3>() + collapse_stiffness(rest) * stop.gradient;

  Eigen::Matrix<double, 6, 9>& d = e.strain_slopes;
  if (with_hessian) {
    d.setZero();
    d.topLeftCorner<3, 3>() = strain_by_metric;
    e.hessian.setZero();
    if (all)
      e.hessian.topLeftCorner<3, 3>() =
          membrane_strain_hessian(law, state.metric, e.stress.head<3>()) +
          collapse_stiffness(rest) * stop.hessian;
  }
  for (int k = 0; k < 3; ++k) {
    const double moment = e.stress[3 + k];
    if (state.given[static_cast<size_t>(k)]) {
      e.gradient[3 + k] = moment;
      if (with_hessian) d(3 + k, 3 + k) = 1;
      continue;
    }
    const Height& h = parts.height[static_cast<size_t>(k)];
    const FoldBarrier& fold = parts.fold[static_cast<size_t>(k)];
    const double over = state.half_sine[k] + state.xi[k] * state.half_cosine[k];
    const double b = 2 * h.value * (over + fold.value);
    const double by_angle =
        h.value * (state.half_cosine[k] - state.xi[k] * state.half_sine[k] + fold.first);
    const double by_xi = 2 * h.value * state.half_cosine[k];
    const Vec3 log_gradient = h.log_gradient(parts.det);
    e.gradient.head<3>() += moment * b * log_gradient;
    e.gradient[3 + k] = moment * by_angle;
    e.gradient[6 + k] = moment * by_xi;
    if (!with_hessian) continue;
    d.block<1, 3>(3 + k, 0) = b * log_gradient.transpose();
    d(3 + k, 3 + k) = by_angle;
    d(3 + k, 6 + k) = by_xi;
    if (!all) continue;
    e.hessian.topLeftCorner<3, 3>() +=
        moment * b * (h.log_hessian(parts.det) + log_gradient * log_gradient.transpose());
    const Vec3 metric_angle = moment * by_angle * log_gradient,
               metric_xi = moment * by_xi * log_gradient;
    e.hessian.block<3, 1>(0, 3 + k) = metric_angle;
    e.hessian.block<1, 3>(3 + k, 0) = metric_angle.transpose();
    e.hessian.block<3, 1>(0, 6 + k) = metric_xi;
    e.hessian.block<1, 3>(6 + k, 0) = metric_xi.transpose();
    e.hessian(3 + k, 3 + k) = moment * h.value * (fold.second - over) / 2;
    e.hessian(3 + k, 6 + k) = e.hessian(6 + k, 3 + k) = -moment * h.value * state.half_sine[k];
  }
  if (with_hessian) {
    Eigen::Matrix<double, 6, 9> kd = *stiffness * d;
    if (rest.leaning) {
      e.lean_slopes.noalias() = kd.transpose() * rest.leaning->strains;
      e.lean_hessian = rest.leaning->stiffness;
      e.lean_hessian += rest.leaning->strains.transpose() * *stiffness * rest.leaning->strains;
    }
    kd.row(2) -= rest.relief * d.row(2);
    e.hessian.noalias() += d.transpose() * kd;
  }
  return e;
}

Eigen::Matrix2d in_tension(const Eigen::Matrix2d& stress) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> principal;
  principal.computeDirect(stress);
  return principal.eigenvectors() * principal.eigenvalues().cwiseMax(0.0).asDiagonal() *
         principal.eigenvectors().transpose();
}

}  // namespace vasorod
