#include "numerics/lbfgs_pairs.h"

#include <cstddef>

namespace vasorod {

using Eigen::VectorXd;

void LbfgsPairs::begin(Eigen::Index unknowns, int memory) {
  if (steps_.rows() != unknowns || steps_.cols() != memory) {
    clear();
    steps_.resize(unknowns, memory);
    changes_.resize(unknowns, memory);
    products_.resize(memory, memory);
  }
  // The next gradient is not that after the newest step.
  for (size_t k = 0; pending_ && k + 1 < order_.size(); ++k)
    products_(order_[k], order_.back()) = steps_.col(order_[k]).dot(changes_.col(order_.back()));
  pending_ = false;
}

void LbfgsPairs::clear() {
  order_.clear();
  pending_ = false;
}

void LbfgsPairs::add(double step, const VectorXd& direction, const VectorXd& before,
                     const VectorXd& now) {
  if (steps_.cols() == 0) return;
  const double product = step * direction.dot(now - before);
  if (!(product > 1e-12 * step * direction.norm() * (now - before).norm())) return;
  const bool full = static_cast<Eigen::Index>(order_.size()) == steps_.cols();
  const Eigen::Index slot = full ? order_.front() : static_cast<Eigen::Index>(order_.size());
  if (full) order_.pop_front();
  steps_.col(slot) = step * direction;
  changes_.col(slot) = now - before;
  products_(slot, slot) = product;
  order_.push_back(slot);
  pending_ = true;
}

void LbfgsPairs::descend(const Preconditioner& precondition, const VectorXd& gradient,
                         VectorXd& work, VectorXd& direction) {
  const auto used = static_cast<Eigen::Index>(order_.size());
  if (used == 0) {
    precondition(gradient, direction);
    direction = -direction;
    return;
  }
  const VectorXd before = along_;
  along_.noalias() = steps_.leftCols(used).transpose() * gradient;
  // The newest y is this gradient minus the previous one.
  for (size_t k = 0; pending_ && k + 1 < order_.size(); ++k)
    products_(order_[k], order_.back()) = along_[order_[k]] - before[order_[k]];
  pending_ = false;
  VectorXd alpha = along_;
  for (size_t k = order_.size(); k-- > 0;) {
    for (size_t j = k + 1; j < order_.size(); ++j)
      alpha[order_[k]] -= alpha[order_[j]] * products_(order_[k], order_[j]);
    alpha[order_[k]] /= products_(order_[k], order_[k]);
  }
  work = gradient;
  work.noalias() -= changes_.leftCols(used) * alpha;
  precondition(work, direction);
  VectorXd share = changes_.leftCols(used).transpose() * direction;
  for (size_t k = 0; k < order_.size(); ++k) {
    for (size_t j = 0; j < k; ++j)
      share[order_[k]] += share[order_[j]] * products_(order_[j], order_[k]);
    share[order_[k]] = alpha[order_[k]] - share[order_[k]] / products_(order_[k], order_[k]);
  }
  direction.noalias() += steps_.leftCols(used) * share;
  direction = -direction;
}

}  // namespace vasorod
