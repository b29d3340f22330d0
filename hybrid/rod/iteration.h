// The two ways to an equilibrium: Newton on the mixed functional, and descent of a softened energy.
#pragma once

#include <limits>

#include "rod/newton.h"
#include "rod/rod_problem.h"

namespace vasorod {

/// Thrown inside the solver when the caller or the time limit stops it.
struct Interrupted {};

class RodIteration {
 public:
  RodIteration(RodProblem& problem, const RodOptions& options, RodSummary& summary,
               const StopCheck& stop);

  RodState state;

  /// Mixed Newton. Full steps, except that where every node follows the strains the energy is no
  /// longer stiff and can be searched along a large step. True when the last step was below the
  /// tolerance.
  bool newton();
  /// Goes down the energy with stretch and shear softened to `cap`; true when a full step was below
  /// `tolerance`. Leaves the true stiffness, and the soft one's stress in the state. A state
  /// without slope that is no minimum is left down its lowest mode, at most `kicks` times.
  bool descend(double cap, double tolerance, int kicks = 0);
  /// Soft rod first, then the true one with the soft one's forces as stress; where that is too wide
  /// a jump, tenfold steps.
  bool soft_start();
  /// Goes down the energies of ever stiffer rods, so that it stays at a minimum, then Newton.
  bool minimize();
  /// To the state nearest to equilibrium of all that Newton saw of the whole problem since
  /// `forget`, if it saw any.
  void take_best();
  void forget() { best_size_ = std::numeric_limits<double>::infinity(); }
  /// Newton's states belong to the problem asked for, not to a part of its path or a softened rod.
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
