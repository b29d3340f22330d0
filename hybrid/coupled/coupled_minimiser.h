// Minimises the energy of a CoupledSystem for given multipliers and contact planes.
//
// Stage 1, where walls are only held and moved: L-BFGS preconditioned by the rest Hessian K0, which
// is factorised once and applied in the frames of the rods, D K0^-1 D^T. This brings the start
// given by the rods close to its minimum. From a start of joined or touching walls far from their
// minimum, where the true Hessian would have to be tried with many shifts: L-BFGS preconditioned by
// the convex part of the Hessian (SecondDerivatives) of a nearby point. It takes the bends of a
// rough start for its shape and would keep them: from there K0 comes first, in the frames of the
// start and with the springs of seams, ties and contacts.
//
// Stage 2: L-BFGS preconditioned by the true Hessian of a nearby point, factorised again when
// convergence slows down: Newton's method with as few factorisations as possible. Far from the
// minimum they may be in single precision, where that suffices; the one that certifies it is not.
// Cholesky decides definiteness; where it fails, the Hessian is shifted by mu D K0 D^T. The energy
// rises by no more than lbfgs() lets it.
#pragma once

#include <limits>
#include <optional>

#include "coupled/coupled_system.h"
#include "coupled/roughness.h"
#include "numerics/cholesky.h"
#include "numerics/lbfgs.h"

namespace vasorod {

/// Options of CoupledMinimiser::minimise().
struct CoupledMinimiserOptions {
  /// On |gradient| / sqrt(2 k E), with k the mean stiffness of a vertex and E the elastic energy.
  double tolerance = 1e-9;
  /// Residual at which the true Hessian replaces K0; from there on it converges fast.
  double rough = 1e-4;
  int rest_patience = 12;  ///< iterations for a tenfold reduction of the residual with K0
  /// Iterations with one true Hessian; an iteration costs a tenth of a factorisation.
  int per_hessian = 6;
  double largest_step = 0;  ///< LbfgsOptions::largest_step
  bool by_slopes = false;   ///< LbfgsOptions::by_slopes
  /// A shift that made one Hessian positive definite is this many times larger than the first that
  /// is tried for the next. Less spares factorisations where most Hessians need a shift.
  double release_shift = 25;
  /// Remove the bound largest_step where negative curvature persists.
  bool release_step = false;
  int max_iterations = 3000;
  int max_factorisations = 60;
  /// Of them, those that met a negative pivot, needed a shift or took the convex part instead.
  int max_shifted = std::numeric_limits<int>::max();
  /// False: no K0 stage (for free bodies, seams and contacts, which K0 does not include).
  bool use_rest = true;
  /// What z is like, which decides with which Hessian the minimisation begins.
  Roughness start = Roughness::near;
  bool reuse_hessian = false;  ///< begin with the last factorised true Hessian
  /// Far from the minimum factors may be Precision::rough. Not on a branch that is to be followed:
  /// one that fails although its Hessian is positive would be taken for the branch's end.
  bool rough_factors = false;
  /// Determine the sign of the smallest curvature at the end, and leave saddles.
  bool certify = true;
  std::function<bool(int iteration, double energy, double residual)> stop;  ///< LbfgsOptions::stop
  /// Called with the point reached before each new Hessian: may change the contacts. Returns
  /// whether steps are bounded by `closing_step` from here on. May be empty.
  std::function<bool(const Eigen::VectorXd& z)> follow;
  double closing_step = 0;  ///< LbfgsOptions::largest_step where `follow` asks for it
  StopInside stop_inside;   ///< of a factorisation
  /// Called before each ordering, which cannot be stopped inside, and each factorisation, with the
  /// best point so far; returning true interrupts. May be empty.
  std::function<bool(const std::string& step, const Eigen::VectorXd& z)> before;
};

/// Iterations of all stages.
struct CoupledMinimiserSummary : StagedSummary {
  int rest_iterations = 0, factorisations = 0;
  bool positive = false;      ///< the Hessian at the result is found positive definite, exactly
  bool left_saddle = false;   ///< a saddle was found on the way and left
  bool unfactorised = false;  ///< ended because no shift made the Hessian positive definite
  /// Negative curvature is only rounding: there is a zero-energy direction.
  bool neutral = false;
};

/// Minimiser of one CoupledSystem; keeps its factors between calls.
class CoupledMinimiser {
 public:
  /// `system` must outlive this, and so must `work`, to which what this does is added.
  CoupledMinimiser(CoupledSystem& system, Work& work);

  /// Makes the first order of elimination that of the walls and their seams without contacts: it
  /// can be found before these are known, now by find_order() or when the first matrix is
  /// factorised.
  void order_without_contacts() { without_contacts_ = true; }
  void find_order();
  /// Sets the rotations D applied to K0 from now on.
  void set_turns(GroupTurns turns);
  /// To be called when the material of a wall changed: evaluates K0 again. The old factor remains
  /// the preconditioner.
  void renew_rest();
  /// To be called when shear moduli of walls were raised, at most `growth` times, at the minimum z
  /// that minimise() found last: moves z towards the new minimum. K0 stays that of the softer
  /// walls until the system is built again: as the metric of shifts that of the stiffer ones would
  /// hold back what is left to move.
  void follow_stiffer(Eigen::VectorXd& z, double growth);

  /// Minimises from z; on return z is the best point found.
  CoupledMinimiserSummary minimise(Eigen::VectorXd& z, const CoupledMinimiserOptions& options);

  /// The residual at z. Not counted: it is asked for when a state is kept, which depends on the
  /// time.
  double residual(const Eigen::VectorXd& z);
  /// Whether the loads are smaller than the rounding errors of the walls' forces.
  bool load_is_hidden(const Eigen::VectorXd& z) const;

 private:
  double evaluate(const Eigen::VectorXd& z, Eigen::VectorXd& g, double& residual) const;
  double counted(const Eigen::VectorXd& z, Eigen::VectorXd& g, double& residual);
  double rounding_of_forces(const Eigen::VectorXd& z) const;
  void weigh(const Eigen::SparseMatrix<double>& rest);
  void by_rest(const Eigen::VectorXd& g, Eigen::VectorXd& direction);
  // Both may end in an Interruption.
  struct Breaks {
    std::function<void(const std::string& step)> before;
    StopInside inside;
  };
  void run(Eigen::VectorXd& z, const CoupledMinimiserOptions& options, const Breaks& breaks,
           CoupledMinimiserSummary& summary);
  bool factorise_rest(const Breaks& breaks);
  bool factorise_turned_rest(const Eigen::VectorXd& z, const Breaks& breaks);
  bool factorise_convex(const Eigen::VectorXd& z, Precision precision, const Breaks& breaks);
  bool factorise_as_analysed(Eigen::SparseMatrix<double>& matrix, Precision precision,
                             const Breaks& breaks);
  void analyse(Cholesky& factor, const Eigen::SparseMatrix<double>& matrix, const Breaks& breaks);
  // `unless_positive`: exact, and not kept where H itself is positive definite; factor_ is then
  // that of an earlier Hessian.
  enum class Factor { rough, exact, unless_positive };
  bool factorise(const Eigen::VectorXd& z, Factor factor, double& shift, int& factorisations,
                 int most, const Breaks& breaks);
  void match_pattern(Eigen::SparseMatrix<double>& matrix, const Breaks& breaks);
  enum class Saddle { left, neutral, kept };
  Saddle leave_saddle(Eigen::VectorXd& z);

  CoupledSystem& system_;
  Work& work_;
  Eigen::SparseMatrix<double> rest_, hessian_;
  Eigen::SparseMatrix<double> metric_;  // K0 in present frames; empty if H needed no shift
  GroupTurns turns_;
  Cholesky rest_factor_, factor_;
  LbfgsPairs pairs_;  // of iterations with factor_
  bool without_contacts_ = false;
  std::vector<int> order_;                // elimination order
  double order_nonzeros_ = 0;             // entries of the first factor in order_
  Eigen::SparseMatrix<double> analysed_;  // its pattern is the one analysed by factor_
  double mean_stiffness_ = 1;
  bool worn_ = false;  // the last minimum took more iterations with factor_ than a rough one costs
  Eigen::VectorXd turned_;  // the gradient in the frames of K0
};

}  // namespace vasorod
