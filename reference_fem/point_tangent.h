// dP/dF from dS/dE: P = F S, so dP = dF S + F (D : dE) with dE = sym(F^T dF).
#pragma once

#include "reference_fem/law.h"

namespace vasorod::fem {

using Mat9 = Eigen::Matrix<double, 9, 9>;

/// A with row and column 3 i + J for F_iJ (J in local axes).
inline Mat9 first_tangent(const Mat3& F, const Response& r) {
  constexpr int pair[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
  Eigen::Matrix<double, 6, 9> M = Eigen::Matrix<double, 6, 9>::Zero();
  for (int a = 0; a < 6; ++a)
    for (int k = 0; k < 3; ++k) {
      const int I = pair[a][0], J = pair[a][1];
      M(a, 3 * k + I) += F(k, J);
      if (I != J) M(a, 3 * k + J) += F(k, I);
    }
  Mat9 A = M.transpose() * r.tangent * M;
  Mat3 S;
  S << r.stress[0], r.stress[3], r.stress[4], r.stress[3], r.stress[1], r.stress[5], r.stress[4], r.stress[5],
      r.stress[2];
  for (int i = 0; i < 3; ++i) A.block<3, 3>(3 * i, 3 * i) += S;
  return A;
}

inline Mat3 stress_tensor(const Vec6& s) {
  Mat3 S;
  S << s[0], s[3], s[4], s[3], s[1], s[5], s[4], s[5], s[2];
  return S;
}

}  // namespace vasorod::fem
