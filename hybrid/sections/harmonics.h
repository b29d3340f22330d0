// Functions of the angle around a section: 1, cos theta, sin theta, cos 2 theta, ... up to the
// harmonic N.
#pragma once

#include <Eigen/Core>

namespace vasorod {

/// The number of functions up to the harmonic N: 2 N + 1.
constexpr int harmonic_count(int harmonics) {
  return 2 * harmonics + 1;
}

/// Per angle (radians, a row) the functions, or their derivatives of order 1 or 2.
Eigen::MatrixXd harmonic_values(const Eigen::VectorXd& angles, int harmonics, int derivative);

}  // namespace vasorod
