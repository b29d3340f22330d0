// What an equilibrium is: the inertia of its Hessian, directions that cost nothing, and the way
// down from a saddle.
#pragma once

#include <string>
#include <vector>

#include "rod/rod_problem.h"

namespace vasorod {

struct RodCertificate {
  int negative = 0;      ///< directions in which the energy falls
  int neutral = 0;       ///< directions in which it does not change, to round-off
  int symmetries = 0;    ///< of those, motions that leave the whole scene as it is (rod/symmetry.h)
  std::string symmetry;  ///< one of them in words

  bool minimum() const { return negative == 0 && neutral <= symmetries; }
};

/// A direction counts as neutral when a spring of 1e-8 of the weakest link's bending stiffness over
/// L^4, per length and on every freedom, decides its sign.
RodCertificate certify(RodProblem& problem, const RodState& state);

/// The direction of the lowest curvature relative to the weight of every node, by bisection of the
/// shift that makes the Hessian positive and inverse iteration there; for a state with negative
/// directions.
RodStep lowest_mode(RodProblem& problem, const RodState& state);

}  // namespace vasorod
