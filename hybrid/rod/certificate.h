// Classification of an equilibrium: the inertia of its Hessian, its zero-energy directions, and the
// descent direction at a saddle.
#pragma once

#include <string>
#include <vector>

#include "rod/rod_problem.h"

namespace vasorod {

/// Inertia and symmetries of an equilibrium.
struct RodCertificate {
  int negative = 0;  ///< number of directions in which the energy falls
  int neutral = 0;   ///< number of zero-energy directions, to round-off
  /// Number of neutral directions that are symmetries of the whole scene (rod/symmetry.h).
  int symmetries = 0;
  std::string symmetry;  ///< one of the symmetries in words

  bool minimum() const { return negative == 0 && neutral <= symmetries; }
};

/// Determines the inertia of the Hessian at an equilibrium. A direction is neutral if a spring of
/// stiffness 1e-8 times the bending stiffness of the weakest link over L^4, per length and on every
/// freedom, decides its sign.
RodCertificate certify(RodProblem& problem, const RodState& state);

/// The direction of lowest curvature relative to the node weights. It is found by bisection for the
/// shift that makes the Hessian positive definite and inverse iteration at that shift. The state
/// must have negative directions.
RodStep lowest_mode(RodProblem& problem, const RodState& state);

}  // namespace vasorod
