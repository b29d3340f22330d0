// Newton's method for the discrete equilibrium: at a given load, or with the load as an unknown at
// a given distance along the path (Riks 1979, Ramm 1981). The latter passes maxima of the load.
#pragma once

#include "reference_fem/stepper.h"

namespace vasorod::fem {

/// Newton's method on one system.
class Newton {
 public:
  Newton(const System& system, const StepperOptions& options, StepperSummary& summary)
      : system_(system), options_(options), summary_(summary), solver_(system.processes()) {}

  /// Solves from `state` (prescribed values already set). False: `state` must not be used.
  bool at_load(State& state, double load, System::Assembly& assembly);
  /// Solves with the load free and the displacements' component along `direction` (unit, in the
  /// unknowns) fixed.
  bool along(State& state, double& load, const Eigen::VectorXd& direction,
             System::Assembly& assembly);
  /// One linear step from the equilibrium `last` to a guess whose prescribed values are already
  /// set.
  bool linear_step(const State& last, double load, State& guess, System::Assembly& assembly);

  /// Whether the symmetric part of the tangent at load 1 is positive definite on the constraints.
  bool positive_definite(const State& state, System::Assembly& assembly);

  int iterations() const { return iterations_; }  ///< of the last solve

 private:
  enum class Verdict { go_on, done, failed };
  Verdict judge(double residual, int iteration);
  bool assemble(const State& state, double load, bool want_tangent, System::Assembly& assembly,
                const State* target = nullptr);
  bool factor(const System::Assembly& assembly);
  bool factor(LinearSolver& solver, const Sparse& matrix, bool symmetric,
              LinearSolver::Fallback fallback = LinearSolver::Fallback::umfpack);
  Eigen::VectorXd solve(const Eigen::VectorXd& right);
  Eigen::VectorXd load_slope(const State& state, double load, const System::Assembly& assembly);

  const System& system_;
  const StepperOptions& options_;
  StepperSummary& summary_;
  LinearSolver solver_;
  double best_ = 0;
  int iterations_ = 0;
};

}  // namespace vasorod::fem
