// dP/dF from dS/dE: P = F S, so dP = dF S + F (D : dE) with dE = sym(F^T dF).
#pragma once

#include "reference_fem/law.h"

namespace vasorod::fem {

using Mat9 = Eigen::Matrix<double, 9, 9>;

/// A with row and column 3 i + J for F_iJ (J in local axes).
inline Mat9 first_tangent(const Mat3& F, const Response& r) {
  Eigen::Matrix<double, 6, 9> M = Eigen::Matrix<double, 6, 9>::Zero();
  for (int a = 0; a < 6; ++a)
    for (int k = 0; k < 3; ++k) {
      const auto [I, J] = six_pairs[static_cast<std::size_t>(a)];
      M(a, 3 * k + I) += F(k, J);
      if (I != J) M(a, 3 * k + J) += F(k, I);
    }
  Mat9 A = M.transpose() * r.tangent * M;
  const Mat3 S = stress_tensor(r.stress);
  for (int i = 0; i < 3; ++i) A.block<3, 3>(3 * i, 3 * i) += S;
  return A;
}

}  // namespace vasorod::fem
