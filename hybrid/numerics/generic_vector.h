// A vector with a part in every direction that a method has to see.
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace vasorod {

/// Without pattern, and always the same: for starts of inverse iterations, and right-hand sides by
/// which a factor is judged. Entries of size 1, no unit.
inline Eigen::VectorXd generic_vector(Eigen::Index size) {
  Eigen::VectorXd v(size);
  for (Eigen::Index i = 0; i < size; ++i)
    v[i] = std::sin(1.0 + 12.9898 * static_cast<double>(i % 7919));
  return v;
}

}  // namespace vasorod
