// Newton's method for one SectionSystem.
#pragma once

#include "numerics/solver_options.h"
#include "numerics/work.h"
#include "sections/section_system.h"

namespace vasorod {

/// Options of minimise_sections.
struct SectionNewtonOptions : SolverOptions {
  /// On the gradient over SectionSystem::Gradient::size.
  double tolerance = 1e-10;
  /// From this residual on, the last factor may serve again.
  double near = 1e-4;
  int max_iterations = 100;
};

enum class SectionNewtonStatus { converged, stalled, iteration_limit, interrupted };

/// What a minimisation did.
struct SectionNewtonSummary {
  SectionNewtonStatus status = SectionNewtonStatus::iteration_limit;
  int iterations = 0;
  double residual = 0;
  /// Whether the last Hessian was positive definite: that of a state with at most
  /// SectionNewtonOptions::near, or of the last step's start. Empty: there was none.
  std::optional<bool> positive;
  /// Iterations whose Hessian had a negative curvature.
  int indefinite = 0;
};

/// Minimises the energy from z. `kept`: the last positive definite factor of this system, used
/// again near the minimum as long as each step with it gains a digit; empty at first.
SectionNewtonSummary minimise_sections(SectionSystem& system, Eigen::VectorXd& z,
                                       const SectionNewtonOptions& options,
                                       std::optional<BandMatrix>& kept, Work& work);

}  // namespace vasorod
