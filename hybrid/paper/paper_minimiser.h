// Minimises the paper's energy for given multipliers and contact planes. First L-BFGS
// preconditioned by a constant matrix (4 to 30 iterations on walls), and where that is slow -
// compressed edges that buckle, weak binding - L-BFGS preconditioned by the true Hessian of a
// nearby point, mixed with its positive bound as far as Cholesky demands.
#pragma once

#include "numerics/kept_factor.h"
#include "numerics/lbfgs.h"
#include "paper/paper_energy.h"

namespace vasorod {

struct PaperMinimiserOptions {
  double tolerance = 1e-8;    ///< on |sum of forces| / sum over the terms of |their forces|
  int max_iterations = 3000;  ///< of both kinds together
  int patience =
      100;  ///< iterations for a tenfold smaller residual before the true Hessian is tried
  int max_factorisations = 40;  ///< of the true Hessian
  bool reuse_hessian =
      false;  ///< start with the last true Hessian that was factorised, if there is one
  std::function<bool(int iteration, double energy, double residual)> stop;  ///< LbfgsOptions::stop
};

/// Iterations of both kinds.
struct PaperMinimiserSummary : StagedSummary {
  int factorisations = 0;  ///< of the true Hessian
};

class PaperMinimiser {
 public:
  /// System and factor must outlive this; the joins' multipliers and the contacts may change
  /// between calls. `constant` keeps the constant matrix' factor, also for the next system that has
  /// the same matrix.
  PaperMinimiser(const PaperSystem& system, KeptFactor& constant)
      : system_(system), constant_(constant) {}

  /// Factorises the constant matrix, paper_energy_bound with the springs' mean share, with the
  /// contacts that press at p. Needed after the contacts changed, and at first.
  void factorise(const Points& p);

  PaperMinimiserSummary minimise(Points& p, const PaperMinimiserOptions& options);

  /// One step of the paper's local-global iteration [13]: edges projected to their rest length,
  /// then the bound solved; the same as descending by the gradient in the bound's metric.
  void local_global_step(Points& p);

  /// The residual of LbfgsSummary at p: |sum of forces on free vertices| / sum over terms |forces|;
  /// 0 when rounding is all.
  double residual(const Points& p);

  /// Whether the Hessian at p is positive definite: a stable minimum.
  bool stable(const Points& p);

 private:
  double evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& gradient, double& residual);
  void precondition(KeptFactor& factor, const Eigen::VectorXd& gradient,
                    Eigen::VectorXd& direction);
  bool factorise_hessian(const Points& p, double& blend, int& factorisations);

  const PaperSystem& system_;
  KeptFactor& constant_;
  KeptFactor bound_;  // of the local-global iteration alone
  Cholesky hessian_;
  PaperGradient terms_;
  double largest_diagonal_ = 0;
  Eigen::MatrixXd columns_, solution_;
};

}  // namespace vasorod
