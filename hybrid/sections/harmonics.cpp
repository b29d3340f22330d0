#include "sections/harmonics.h"

#include <cmath>

namespace vasorod {

Eigen::MatrixXd harmonic_values(const Eigen::VectorXd& angles, int harmonics, int derivative) {
  Eigen::MatrixXd values(angles.size(), harmonic_count(harmonics));
  values.col(0).setConstant(derivative == 0 ? 1 : 0);
  // cos k theta and sin k theta as powers of the first; each derivative turns the phase by a
  // quarter and multiplies by k.
  const Eigen::ArrayXd first = angles.array().cos(), second = angles.array().sin();
  Eigen::ArrayXd even = Eigen::ArrayXd::Ones(angles.size()),
                 odd = Eigen::ArrayXd::Zero(angles.size());
  for (int k = 1; k <= harmonics; ++k) {
    const Eigen::ArrayXd next = even * first - odd * second;
    odd = even * second + odd * first;
    even = next;
    const double size = std::pow(k, derivative);
    values.col(2 * k - 1) = derivative == 0 ? even : derivative == 1 ? -size * odd : -size * even;
    values.col(2 * k) = derivative == 0 ? odd : derivative == 1 ? size * even : -size * odd;
  }
  return values;
}

}  // namespace vasorod
