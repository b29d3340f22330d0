// The two methods of finding an equilibrium: Newton on the mixed functional, and descent of a
// softened energy.
#pragma once

#include <limits>

#include "rod/newton.h"
#include "rod/rod_problem.h"

namespace vasorod {

/// Thrown inside the solver when the caller or the time limit stops it.
struct Interrupted {};

/// The iterations on one RodProblem, and their present state.
class RodIteration {
 public:
  RodIteration(RodProblem& problem, const RodOptions& options, RodSummary& summary,
               const StopCheck& stop);

  RodState state;

  /// Mixed Newton with full steps. When the poses of all nodes follow from the strains, the energy
  /// is not stiff along the step, and a line search is used for large steps. Returns true when the
  /// last step was below the tolerance.
  bool newton();
  /// Minimises the energy with stretch and shear stiffness capped at `cap`. Returns true when a
  /// full step was below `tolerance`. On return the true stiffness is restored and the state holds
  /// the stress of the softened rod. A stationary state that is no minimum is left along its lowest
  /// mode, at most `kicks` times.
  bool descend(double cap, double tolerance, int kicks = 0);
  /// Solves a softened rod first, then the true rod with the forces of the softened rod as stress.
  /// If that jump is too large, the stiffness is raised in tenfold steps.
  bool soft_start();
  /// Minimises the energies of increasingly stiff rods, so that the state stays at a minimum, then
  /// runs Newton.
  bool minimize();
  /// Restores the state closest to equilibrium of all that Newton visited on the whole problem
  /// since `forget`, if there is one.
  void take_best();
  void forget() { best_size_ = std::numeric_limits<double>::infinity(); }
  /// Whether the states of Newton belong to the requested problem, not to a part of its path or to
  /// a softened rod.
  void count_for_best(bool whole) { whole_ = whole; }

 private:
  void count();
  double search();
  void step_down(double& shift);
  bool kick();

  RodProblem& problem_;
  const RodOptions& options_;
  RodSummary& summary_;
  const StopCheck& stop_;
  RodStep step_;
  RodState trial_, best_;
  double best_size_ = std::numeric_limits<double>::infinity();
  bool whole_ = true, hard_ = true;
};

}  // namespace vasorod
