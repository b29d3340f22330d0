#include "sections/section_newton.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vasorod {
namespace {

using Eigen::VectorXd;

// Where the Hessian is indefinite, so much of its part from the present stress is taken instead.
// What is left of a law whose tangent is indefinite itself, or of ends that nothing holds, gets a
// share of its largest diagonal entry on its diagonal, growing until it is positive definite.
constexpr std::array<double, 3> stress_shares{0.8, 0.5, 0};
constexpr double first_shift = 1e-8, growth = 100;
constexpr int most_shifts = 6;
// A wall is far stiffer in its plane than across: a full step of Newton's method turns sections and
// stretches them to second order, which raises the energy, and the next step takes it back. So a
// full step is taken as well where it does not raise the residual by more than this factor.
constexpr double passable = 2;
constexpr double armijo = 1e-4, shortest = 1e-6;
constexpr double rounding = 1e-13;
constexpr double a_digit = 0.1;

double relative(const SectionSystem::Gradient& g) {
  return g.size > 0 ? g.gradient.norm() / g.size : 0;
}

}  // namespace

SectionNewtonSummary minimise_sections(SectionSystem& system, VectorXd& z,
                                       const SectionNewtonOptions& options,
                                       std::optional<BandMatrix>& kept, Work& work) {
  const StopCheck stop(options);
  SectionNewtonSummary summary;
  SectionSystem::Gradient now = system.gradient(z);
  ++work.counts.gradients;
  const auto factorised = [&](bool& shifted) {
    const auto factor_of = [&](double stress_share, double shift) {
      BandMatrix factor = system.hessian(z, now, stress_share);
      ++work.counts.hessians;
      FactorTime time(&work);
      if (shift > 0)
        factor.add_to_diagonal(
            VectorXd::Constant(factor.size(), shift * factor.diagonal().cwiseAbs().maxCoeff()));
      ++work.counts.factorisations;
      work.counts.factor_nonzeros =
          std::max(work.counts.factor_nonzeros, std::int64_t{factor.size()} * (factor.width() + 1));
      shifted = !factor.factorise();
      return factor;
    };
    BandMatrix factor = factor_of(1, 0);
    const bool indefinite = shifted;
    for (size_t k = 0; shifted && k < stress_shares.size(); ++k)
      factor = factor_of(stress_shares[k], 0);
    double shift = first_shift;
    for (int k = 0; shifted && k < most_shifts; ++k, shift *= growth) factor = factor_of(0, shift);
    shifted = indefinite;
    return factor;
  };
  for (;; ++summary.iterations) {
    summary.residual = relative(now);
    if (!std::isfinite(summary.residual)) {
      summary.status = SectionNewtonStatus::stalled;
      return summary;
    }
    // At rest the points' gradients are rounding errors themselves.
    if (summary.residual <= options.tolerance || now.size <= rounding) {
      if (now.size <= rounding) summary.residual = 0;
      summary.status = SectionNewtonStatus::converged;
      break;
    }
    if (stop({0, summary.iterations, summary.residual})) {
      summary.status = SectionNewtonStatus::interrupted;
      return summary;
    }
    if (summary.iterations >= options.max_iterations) return summary;
    if (kept && summary.residual <= options.near) {
      VectorXd step = -now.gradient;
      kept->solve(step);
      ++work.counts.solves;
      SectionSystem::Gradient there = system.gradient(z + step);
      ++work.counts.gradients;
      if (there.gradient.norm() <= a_digit * now.gradient.norm()) {
        z += step;
        now = std::move(there);
        continue;
      }
    }
    bool shifted = false;
    BandMatrix factor = factorised(shifted);
    if (shifted) ++summary.indefinite;
    summary.positive = !shifted;
    VectorXd step = -now.gradient;
    factor.solve(step);
    ++work.counts.solves;
    const double slope = now.gradient.dot(step);
    bool taken = false;
    for (double share = 1; share >= shortest; share /= 2) {
      const VectorXd trial = z + share * step;
      SectionSystem::Gradient there = system.gradient(trial);
      ++work.counts.gradients;
      const double slack = rounding * std::abs(now.value);
      const bool lower = there.value <= now.value + armijo * share * slope + slack;
      const bool nearer =
          share == 1 && !shifted && there.gradient.norm() <= passable * now.gradient.norm();
      if (!std::isfinite(there.value) || !(lower || nearer)) continue;
      // The last steps are limited by rounding.
      taken = !(summary.residual < 1e-7 && there.gradient.norm() >= now.gradient.norm());
      if (!taken) break;
      z = trial;
      now = std::move(there);
      kept.reset();
      if (!shifted) kept = std::move(factor);
      break;
    }
    if (!taken) {
      summary.status =
          summary.residual < 1e-7 ? SectionNewtonStatus::converged : SectionNewtonStatus::stalled;
      break;
    }
  }
  return summary;
}

}  // namespace vasorod
