// Limited-memory BFGS with a given preconditioner as the initial inverse Hessian and Armijo line
// search starting at step length 1. The energy never rises by more than its rounding error, 1e-12
// of it in a step, which LbfgsOptions::by_slopes takes for larger. Where a step changes it by less,
// slopes decide.
//
// Sources: Nocedal, Updating quasi-Newton matrices with limited storage, 1980; with the constant
// matrix of the local-global iteration as preconditioner: Liu, Bouaziz, Kavan, Quasi-Newton methods
// for real-time simulation, 2017. Slopes in place of energies lost to rounding: Hager, Zhang, A new
// conjugate gradient method with guaranteed descent and an efficient line search, 2005.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>

#include "numerics/lbfgs_pairs.h"

namespace vasorod {

/// Options of lbfgs().
struct LbfgsOptions {
  /// Number of pairs kept. More pairs gain nothing measurable on these energies. 0: preconditioned
  /// descent.
  int memory = 10;
  /// Those to begin with, which are left for another run; null: none.
  LbfgsPairs* pairs = nullptr;
  int max_iterations = 3000;
  double tolerance = 1e-8;  ///< on the residual returned by the evaluation
  /// Stop as `slow` when the residual has not fallen tenfold within this number of iterations, and
  /// they are not `worth` more than a better preconditioner. 0: never.
  int patience = 0;
  /// What a better preconditioner would cost, in iterations. It is not worth that much as long as
  /// the last `patience` iterations lowered the energy by as much each as all of them and `worth`
  /// more did on average: then the iteration goes on though its residual does not fall. 0: it
  /// stops.
  double worth = 0;
  /// Bound on the change of any unknown in one iteration; 0: no bound. A bound keeps the iteration
  /// near the closest minimum.
  double largest_step = 0;
  /// Where no step is seen to lower the energy, but one would by less than 1e-5 of it, a step ends
  /// where the slope along it is flatter: for energies of which a stiff part takes digits.
  bool by_slopes = false;
  /// The longest share, in (0, 1], of a step along `direction` from x. May be empty: 1.
  std::function<double(const Eigen::VectorXd& x, const Eigen::VectorXd& direction)> longest_share;
  /// Called once per iteration; returning true interrupts. May be empty.
  std::function<bool(int iteration, double energy, double residual)> stop;
};

enum class LbfgsStatus {
  converged,
  iteration_limit,
  slow,     ///< see LbfgsOptions::patience
  stalled,  ///< rounding limit: no step lowers the energy, or those in its noise the residual
  interrupted
};
std::string to_string(LbfgsStatus);

/// Result of lbfgs(); energy and residual are those of the final point.
struct LbfgsSummary {
  LbfgsStatus status = LbfgsStatus::iteration_limit;
  int iterations = 0, evaluations = 0;
  double energy = 0, residual = 0;
  /// One line: status, counts, residual.
  std::string brief_report() const;
};

/// Combined summary of several consecutive runs: the status of the last one and the iterations of
/// all.
struct StagedSummary {
  LbfgsStatus status = LbfgsStatus::iteration_limit;
  int iterations = 0;
  double energy = 0, residual = 0;

  void add(const LbfgsSummary& stage);
  /// LbfgsOptions::stop for the next stage, with iterations counted from the start of the first
  /// stage. `stop` may be empty; this object must outlive the returned function.
  std::function<bool(int, double, double)> counting(
      const std::function<bool(int, double, double)>& stop) const;
  /// One line: status, counts, residual.
  std::string brief_report() const;
};

/// Returns the energy at x, writes its gradient and a residual that measures the size of the
/// gradient.
using Evaluation =
    std::function<double(const Eigen::VectorXd& x, Eigen::VectorXd& gradient, double& residual)>;

/// Minimises starting at x. On return x is the best point found, whatever the status: of points
/// whose energies differ by noise that of least residual.
LbfgsSummary lbfgs(const Evaluation& evaluate, const Preconditioner& precondition,
                   Eigen::VectorXd& x, const LbfgsOptions& options = {});

}  // namespace vasorod
