// Stretching of the surface [9], summed over the edges:
//
//   E = k_s sum_e (|e| - |e0|)^2
//
// k_s in force / length.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// An edge and its rest length.
struct Spring {
  int a = 0, b = 0;
  double rest_length = 0;
};

/// Energy, force * length. `p`: n x 3.
double stretching_energy(double k_s, const std::vector<Spring>& springs,
                         const Eigen::Ref<const Points>& p);

/// gradient += dE/dp (n x 3) at p = carried + u; returns the energy. An edge of length zero, where
/// the energy has a cusp, contributes no force. Changes of u far below the rounding of p count.
double stretching_energy_gradient(double k_s, const std::vector<Spring>& springs,
                                  const Eigen::Ref<const Points>& carried,
                                  const Eigen::Ref<const Points>& u, Eigen::Ref<Points> gradient);

/// The 3 x 3 block d2E/db2 (= d2E/da2 = -d2E/dadb) of one spring along e:
///
/// ```
/// 2 k_s ((1 - f) I + f e e^T),   f = |e0|/|e|
/// ```
///
/// with e e^T formed from the unit direction of e. blend = 1 gives the positive bound 2 k_s I;
/// values between 0 and 1 interpolate.
Mat3 spring_hessian(double k_s, const Vec3& e, double rest_length, double blend = 0);

/// Appends the blocks of the true Hessian (3n x 3n, both triangles) to `entries`.
void stretching_energy_hessian(double k_s, const std::vector<Spring>& springs,
                               const Eigen::Ref<const Points>& p,
                               std::vector<Eigen::Triplet<double>>& entries);

/// The constant matrix 2 k_s D^T D, an upper bound of the Hessian, the same for x, y and z: n x n.
Eigen::SparseMatrix<double> stretching_energy_bound(double k_s, const std::vector<Spring>& springs,
                                                    int vertex_count);

}  // namespace vasorod
