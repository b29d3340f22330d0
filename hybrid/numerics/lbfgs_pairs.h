// The last steps s of an L-BFGS iteration and the changes y of the gradient along them, with the
// two-loop recursion over these pairs (Nocedal, Updating quasi-Newton matrices with limited
// storage, 1980).
#pragma once

#include <Eigen/Core>
#include <deque>
#include <functional>

namespace vasorod {

/// direction = H^-1 gradient with H symmetric positive definite.
using Preconditioner =
    std::function<void(const Eigen::VectorXd& gradient, Eigen::VectorXd& direction)>;

/// The pairs of one run of lbfgs(), or of several that minimise nearly the same energy with the
/// same preconditioner: each begins with what the last one has learnt.
///
/// The products s_i . y_j are stored, so that each of the four sweeps over the pairs is one matrix
/// product. With 10 pairs of 75,000 unknowns the recursion is limited by memory bandwidth, and this
/// form reads less than half of the data.
class LbfgsPairs {
 public:
  /// Prepares for a run. Keeps the pairs where the unknowns and the number of pairs are those of
  /// the run before.
  void begin(Eigen::Index unknowns, int memory);
  bool empty() const { return order_.empty(); }
  void clear();

  /// Adds the step just taken along `direction`. `before` is the gradient descend() was last called
  /// with, `now` the gradient after the step. Pairs along which the energy does not curve upwards
  /// are left out.
  void add(double step, const Eigen::VectorXd& direction, const Eigen::VectorXd& before,
           const Eigen::VectorXd& now);

  /// direction = -H gradient.
  void descend(const Preconditioner& precondition, const Eigen::VectorXd& gradient,
               Eigen::VectorXd& work, Eigen::VectorXd& direction);

 private:
  Eigen::MatrixXd steps_, changes_;  // one column per pair
  Eigen::MatrixXd products_;         // (i, j): s_i . y_j for i not newer than j
  Eigen::VectorXd along_;            // s_i . the last gradient
  std::deque<Eigen::Index> order_;   // columns in use, oldest first
  bool pending_ = false;             // products of the newest pair are not computed yet
};

}  // namespace vasorod
