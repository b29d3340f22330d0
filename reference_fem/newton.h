// Newton's method on the discrete equilibrium: at a given load, or with the load as an unknown
// beside a given distance along the path (Riks 1979, Ramm 1981), which passes points where the load
// has its maximum.
#pragma once

#include "reference_fem/stepper.h"

namespace vasorod::fem {

class Newton {
 public:
  Newton(const System& system, const StepperOptions& options, StepperSummary& summary)
      : system_(system), options_(options), summary_(summary), solver_(system.processes()) {}

  /// From `state` (prescribed values already in place). False: `state` is not to be used.
  bool at_load(State& state, double load, System::Assembly& assembly);
  /// The same with the load free and the displacements' component along `direction` (unit, of the
  /// unknowns) kept.
  bool along(State& state, double& load, const Eigen::VectorXd& direction,
             System::Assembly& assembly);
  /// One linear step from the equilibrium `last` to a guess whose prescribed values are already in
  /// place.
  bool linear_step(const State& last, double load, State& guess, System::Assembly& assembly);

  int iterations() const { return iterations_; }  ///< of the last solve

 private:
  enum class Verdict { go_on, done, failed };
  Verdict judge(double residual, int iteration);
  bool assemble(const State& state, double load, System::Assembly& assembly);
  bool factor(const System::Assembly& assembly);
  Eigen::VectorXd load_slope(const State& state, double load, const System::Assembly& assembly);

  const System& system_;
  const StepperOptions& options_;
  StepperSummary& summary_;
  LinearSolver solver_;
  double best_ = 0;
  int iterations_ = 0;
};

}  // namespace vasorod::fem
