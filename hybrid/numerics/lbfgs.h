// Limited-memory BFGS with a given preconditioner as the initial inverse Hessian, Armijo steps from
// 1: the energy never rises by more than its rounding. Nocedal, Updating quasi-Newton matrices with
// limited storage, 1980; with the constant matrix of the local-global iteration as preconditioner:
// Liu, Bouaziz, Kavan, Quasi-Newton methods for real-time simulation, 2017.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>

namespace vasorod {

struct LbfgsOptions {
  int memory = 10;  ///< pairs kept; more gains nothing measurable on these energies; 0:
                    ///< preconditioned descent
  int max_iterations = 3000;
  double tolerance = 1e-8;  ///< on the residual that the evaluation returns
  int patience = 0;  ///< stop as `slow` when the residual has not fallen tenfold within so many
                     ///< iterations; 0: never
  double largest_step =
      0;  ///< of any unknown in one iteration; 0: no bound. Keeps to the nearest minimum
  std::function<bool(int iteration, double energy, double residual)>
      stop;  ///< asked once an iteration; true interrupts; may be empty
};

enum class LbfgsStatus {
  converged,
  iteration_limit,
  slow,     ///< see LbfgsOptions::patience
  stalled,  ///< no step lowers the energy any more: rounding
  interrupted
};
std::string to_string(LbfgsStatus);

struct LbfgsSummary {
  LbfgsStatus status = LbfgsStatus::iteration_limit;
  int iterations = 0, evaluations = 0;
  double energy = 0, residual = 0;
  /// One line: status, counts, residual.
  std::string brief_report() const;
};

/// What several runs one after another come to: the last one's end, all their iterations.
struct StagedSummary {
  LbfgsStatus status = LbfgsStatus::iteration_limit;
  int iterations = 0;
  double energy = 0, residual = 0;

  void add(const LbfgsSummary& stage);
  /// LbfgsOptions::stop of the next stage, which counts iterations from the first one on. May be
  /// empty; this must outlive it.
  std::function<bool(int, double, double)> counting(
      const std::function<bool(int, double, double)>& stop) const;
  /// One line: status, counts, residual.
  std::string brief_report() const;
};

/// Returns the energy at x, writes its gradient, and a residual that says how small that is.
using Evaluation =
    std::function<double(const Eigen::VectorXd& x, Eigen::VectorXd& gradient, double& residual)>;
/// direction = H^-1 gradient, H positive definite.
using Preconditioner =
    std::function<void(const Eigen::VectorXd& gradient, Eigen::VectorXd& direction)>;

/// Minimises from x; x is the best point found, whatever the status.
LbfgsSummary lbfgs(const Evaluation& evaluate, const Preconditioner& precondition,
                   Eigen::VectorXd& x, const LbfgsOptions& options = {});

}  // namespace vasorod
