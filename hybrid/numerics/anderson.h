// Acceleration of a fixed-point iteration x <- x + f(x) (Anderson, J. ACM 12, 1965; of type II in
// Walker and Ni, SIAM J. Numer. Anal. 49, 2011): the next x is the one that the last differences of
// x and f predict to have the smallest f. On a linear f it is GMRES in other words, and converges
// where the iteration alone would not.
#pragma once

#include <Eigen/Core>
#include <deque>

namespace vasorod {

class Anderson {
 public:
  explicit Anderson(int depth) : depth_(depth) {}  ///< of the memory, steps

  /// The next x. `f`: the step from x, x's unit.
  Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& f);

 private:
  int depth_;
  Eigen::VectorXd x_, f_;                    // of the last step
  std::deque<Eigen::VectorXd> by_x_, by_f_;  // differences, oldest first
};

}  // namespace vasorod
