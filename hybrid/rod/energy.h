// Elastic energy of one rod element [3-5] as a function of its two frames: value, gradient,
// Hessian. With xi = log(start^-1 g_first^-1 g_second) = length * strain and n the natural strain:
//
//   U = (xi - L n)^T C (xi - L n) / (2 L) - p . xi
//
// p is the element's lumen: the pressure's energy -p V is linear in the strain, so that p adds to
// the stress and enters the Hessian through the geometric term alone.
//
// Derivatives are with respect to body increments g -> g exp(eta), with eta = (first node, second
// node), 12 numbers:
//
//   d xi = -Jl^-1(xi) eta_first + Jr^-1(xi) eta_second
#pragma once

#include "rod/rod_tree.h"

namespace vasorod {

using Vec12 = Eigen::Matrix<double, 12, 1>;
using Mat12 = Eigen::Matrix<double, 12, 12>;

/// Strain (v, u) of an element between two frames.
Vec6 element_strain(const RodElement& element, const Pose& first, const Pose& second);
/// Stress (n, m) in body axes, force and moment resultants of wall and lumen together:
/// C (strain - natural) - lumen.
Vec6 element_stress(const RodElement& element, const Vec6& strain);

/// U, force * length (stress * length^3).
double element_energy(const RodElement& element, const Pose& first, const Pose& second);
/// dU / d eta.
Vec12 element_energy_gradient(const RodElement& element, const Pose& first, const Pose& second);

/// B^T C B / L + geometric term at `stress`. With the element's own stress it is the second
/// derivative of the energy along eta. With the stress predicted by the last linear step it is the
/// matrix of the mixed Newton method (Magisano, Leonetti and Garcea 2017).
Mat12 element_energy_hessian(const RodElement& element, const Pose& first, const Pose& second,
                             const Vec6& stress);

/// Second derivative of stress . log(h exp(d)) with respect to d, pulled back by Jr: Jr^T G Jr,
/// where log h = xi.
Mat6 geometric_stiffness(const Vec6& xi, const Vec6& stress);

/// Derivative of right_jacobian_inverse(x)^T m with respect to x, at constant m.
Mat3 right_jacobian_inverse_transposed_derivative(const Vec3& x, const Vec3& m);

}  // namespace vasorod
