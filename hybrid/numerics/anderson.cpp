#include "numerics/anderson.h"

#include <Eigen/QR>

namespace vasorod {

Eigen::VectorXd Anderson::next(const Eigen::VectorXd& x, const Eigen::VectorXd& f) {
  if (x_.size() > 0) {
    by_x_.emplace_back(x - x_);
    by_f_.emplace_back(f - f_);
    if (std::ssize(by_x_) > depth_) {
      by_x_.pop_front();
      by_f_.pop_front();
    }
  }
  x_ = x;
  f_ = f;
  const auto count = static_cast<Eigen::Index>(by_f_.size());
  if (count == 0) return x + f;
  Eigen::MatrixXd difference(f.size(), count);
  for (Eigen::Index k = 0; k < count; ++k) difference.col(k) = by_f_[static_cast<size_t>(k)];
  // Differences that say the same twice, as close to the end, are left out.
  const Eigen::VectorXd share = difference.colPivHouseholderQr().solve(f);
  Eigen::VectorXd out = x + f;
  for (Eigen::Index k = 0; k < count; ++k)
    out -= share[k] * (by_x_[static_cast<size_t>(k)] + by_f_[static_cast<size_t>(k)]);
  return out;
}

}  // namespace vasorod
