// Minimises the energy of a CoupledSystem for given multipliers and contact planes.
//
// First, where walls are only held and moved, L-BFGS preconditioned by the rest Hessian K0,
// factored once and applied in the rods' frames, D K0^-1 D^T: that brings a carried start near its
// minimum. Then L-BFGS preconditioned by the true Hessian of a nearby point, renewed when it stops
// paying: Newton's method that factorises as seldom as it can. Cholesky decides definiteness: where
// it fails the Hessian is shifted by mu D K0 D^T. The energy never rises.
#pragma once

#include <optional>

#include "coupled/coupled_system.h"
#include "numerics/cholesky.h"
#include "numerics/lbfgs.h"

namespace vasorod {

struct CoupledMinimiserOptions {
  double tolerance =
      1e-9;  ///< on |gradient| / sqrt(2 k E), k a vertex' mean stiffness, E the elastic energy
  double rough =
      1e-4;  ///< residual at which the true Hessian takes over from K0: where it converges fast
  int rest_patience = 12;  ///< iterations for a tenfold smaller residual with K0
  int per_hessian =
      6;  ///< iterations with one true Hessian: a step costs a tenth of a factorisation
  double largest_step = 0;    ///< LbfgsOptions::largest_step
  bool release_step = false;  ///< where negative curvature persists the bound is lifted
  int max_iterations = 3000;
  int max_factorisations = 60;
  bool use_rest =
      true;  ///< false: no K0 stage (free bodies, seams, contacts: K0 knows nothing of them)
  bool reuse_hessian = false;  ///< begin with the last true Hessian factorised
  bool certify = true;         ///< end with the sign of the smallest curvature; leave saddles
  std::function<bool(int iteration, double energy, double residual)> stop;  ///< LbfgsOptions::stop
};

/// Iterations of all stages.
struct CoupledMinimiserSummary : StagedSummary {
  int rest_iterations = 0, factorisations = 0;
  bool positive = false;      ///< the Hessian at the result is positive definite
  bool left_saddle = false;   ///< an equilibrium on the way was none to stay at
  bool unfactorised = false;  ///< ended because no shift made its Hessian positive definite
  bool neutral = false;       ///< nothing is negative but rounding: a direction costs nothing
};

class CoupledMinimiser {
 public:
  explicit CoupledMinimiser(CoupledSystem& system);

  /// The rotations for K0 from here on.
  void set_turns(GroupTurns turns);
  /// The walls' material changed: K0 is evaluated anew. The factor of the old one goes on as
  /// preconditioner until `factorise_rest`.
  void renew_rest();
  void factorise_rest();

  CoupledMinimiserSummary minimise(Eigen::VectorXd& z, const CoupledMinimiserOptions& options);

  /// The residual at z.
  double residual(const Eigen::VectorXd& z);
  /// Whether the loads are so small that what rounding leaves of the walls' forces hides them.
  bool load_is_hidden(const Eigen::VectorXd& z) const;

  double factor_nonzeros() const { return rest_factor_.factor_nonzeros(); }

 private:
  double evaluate(const Eigen::VectorXd& z, Eigen::VectorXd& g, double& residual) const;
  double rounding_of_forces(const Eigen::VectorXd& z) const;
  void by_rest(const Eigen::VectorXd& g, Eigen::VectorXd& direction);
  void analyse(Cholesky& factor, const Eigen::SparseMatrix<double>& matrix);
  bool factorise(const Eigen::VectorXd& z, double& shift, int& factorisations, int most);
  enum class Saddle { left, neutral, kept };
  Saddle leave_saddle(Eigen::VectorXd& z);

  CoupledSystem& system_;
  Eigen::SparseMatrix<double> rest_, hessian_;
  Eigen::SparseMatrix<double> metric_;  // K0 in present frames; empty where H needed no shift
  GroupTurns turns_;
  Cholesky rest_factor_, factor_;
  std::vector<int> order_;                            // of elimination
  double order_nonzeros_ = 0;                         // of the factor it was found for
  std::vector<int> analysed_outer_, analysed_inner_;  // the pattern factor_ knows
  double mean_stiffness_ = 1;
  Eigen::VectorXd work_;
};

}  // namespace vasorod
