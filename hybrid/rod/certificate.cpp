#include "rod/certificate.h"

#include <algorithm>
#include <cmath>

#include "rod/symmetry.h"

namespace vasorod {

RodCertificate certify(RodProblem& problem, const RodState& state) {
  problem.update_carried(state, false);
  RodElimination& elimination = problem.elimination();
  const auto negatives = [&](double shift) {
    elimination.factor(state.poses, state.strain, state.stress, Purpose::certificate, shift);
    return elimination.negative_directions();
  };
  RodCertificate certificate;
  certificate.negative = negatives(0);
  if (certificate.negative == 0 && !elimination.singular()) return certificate;
  const double spring = 1e-8 * problem.weakest();
  certificate.negative = negatives(spring);
  certificate.neutral = negatives(-spring) - certificate.negative;
  if (certificate.neutral > 0) {
    const std::vector<RodSymmetry> found = symmetries(problem, state);
    certificate.symmetries = static_cast<int>(found.size());
    if (!found.empty()) certificate.symmetry = describe(problem, found.front());
  }
  return certificate;
}

RodStep lowest_mode(RodProblem& problem, const RodState& state) {
  problem.update_carried(state, false);
  RodElimination& elimination = problem.elimination();
  const auto positive = [&](double shift) {
    elimination.factor(state.poses, state.strain, state.stress, Purpose::certificate, shift);
    return elimination.negative_directions() == 0;
  };
  double below = 0, above = problem.weakest();
  while (!positive(above) && above < 1e12) {
    below = above;
    above *= 4;
  }
  for (int i = 0; i < 12; ++i) {
    const double middle = 0.5 * (below + above);
    (positive(middle) ? above : below) = middle;
  }
  // Start vector with fixed, irregular entries, so that no symmetry makes it orthogonal to the
  // mode.
  RodStep mode;
  mode.twist.resize(state.poses.size());
  double seed = 0.5;
  for (Vec6& t : mode.twist)
    for (int i = 0; i < 6; ++i) {
      seed = std::fmod(997 * seed + 0.123456789, 1.);
      t[i] = seed - 0.5;
    }
  for (int i = 0; i < 4; ++i) {
    const double size = mode.size();
    std::vector<Vec6> pull = mode.twist;
    for (Vec6& t : pull) t /= size;
    elimination.factor_mode(state.poses, state.strain, state.stress, above, pull);
    elimination.solve(mode.twist, mode.stress, mode.stretch);
  }
  return mode;
}

}  // namespace vasorod
