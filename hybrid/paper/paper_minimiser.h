// Minimises the paper's energy for given multipliers and contact planes.
//
// Stage 1: L-BFGS preconditioned by a constant matrix (4 to 30 iterations on walls). Stage 2, where
// stage 1 is slow (compressed edges that buckle, weak binding): L-BFGS preconditioned by the true
// Hessian of a nearby point, blended with its positive bound as far as Cholesky requires.
#pragma once

#include "numerics/kept_factor.h"
#include "numerics/lbfgs.h"
#include "paper/paper_energy.h"

namespace vasorod {

/// Options of PaperMinimiser::minimise().
struct PaperMinimiserOptions {
  double tolerance = 1e-8;    ///< on |sum of forces| / sum over the terms of |forces of the term|
  int max_iterations = 3000;  ///< sum over both stages
  /// Number of iterations for a tenfold reduction of the residual before the true Hessian is tried.
  int patience = 100;
  int max_factorisations = 40;  ///< of the true Hessian
  /// Start with the last true Hessian that was factorised, if there is one.
  bool reuse_hessian = false;
  std::function<bool(int iteration, double energy, double residual)> stop;  ///< LbfgsOptions::stop
  StopInside stop_inside;                                                   ///< of a factorisation
  /// Called before each factorisation, with the best positions so far; returning true interrupts.
  /// May be empty.
  std::function<bool(const Points& p)> before;
};

/// Iterations of both stages.
struct PaperMinimiserSummary : StagedSummary {
  int factorisations = 0;  ///< of the true Hessian
};

/// Minimiser of one PaperSystem; keeps its factors, and what L-BFGS learnt, between calls.
class PaperMinimiser {
 public:
  /// `system` and `constant` must outlive this. Between calls contacts, multipliers and offsets of
  /// the joins and carried points may change; bodies, stiffnesses and which vertices are joined may
  /// not. `constant` keeps the factor of the constant matrix, also for a later system with the same
  /// matrix; it counts by itself. What this does is added to `work`, which must outlive it.
  PaperMinimiser(const PaperSystem& system, KeptFactor& constant, Work& work)
      : system_(system), constant_(constant), work_(work), bound_(&work), hessian_(&work) {}

  /// Factorises the constant matrix: paper_energy_bound() with the springs' mean share and the
  /// contacts that carry pressure at p. Required at first and after the contacts changed. Throws
  /// Interruption where `stop` says so.
  void factorise(const Points& p, const StopInside& stop = {});

  PaperMinimiserSummary minimise(Points& p, const PaperMinimiserOptions& options);

  /// One step of the paper's local-global iteration [13]: edges are projected to their rest length,
  /// then a linear system with the bound is solved. This equals a gradient descent step in the
  /// metric of the bound.
  void local_global_step(Points& p);

  /// LbfgsSummary::residual at p: |sum of forces on free vertices| / sum over the terms of |forces
  /// of the term|; 0 when only rounding errors remain. Not counted: it is asked for when a state
  /// is kept, which depends on the time.
  double residual(const Points& p);

  /// Whether the Hessian at p is positive definite, i.e. a minimum at p is stable. Throws
  /// Interruption where `stop` says so.
  bool stable(const Points& p, const StopInside& stop = {});

 private:
  double longest_share(const Eigen::VectorXd& x, const Eigen::VectorXd& direction) const;
  Eigen::VectorXd displacements(const Points& p) const;
  double evaluate(const Eigen::VectorXd& x, Eigen::VectorXd& gradient, double& residual);
  double counted(const Eigen::VectorXd& x, Eigen::VectorXd& gradient, double& residual);
  Eigen::SparseMatrix<double> hessian_at(const Points& p, double blend);
  void precondition(KeptFactor& factor, const Eigen::VectorXd& gradient,
                    Eigen::VectorXd& direction);
  bool factorise_hessian(const Points& p, double& blend, int& factorisations,
                         const StopInside& stop);

  const PaperSystem& system_;
  KeptFactor& constant_;
  Work& work_;
  KeptFactor bound_;  // for the local-global iteration only
  Cholesky hessian_;
  Eigen::SparseMatrix<double> without_contacts_;  // the constant matrix
  LbfgsPairs pairs_;                              // of the runs with the factor of constant_
  PaperGradient terms_;
  double largest_diagonal_ = 0;
  Eigen::MatrixXd columns_, solution_;
};

}  // namespace vasorod
