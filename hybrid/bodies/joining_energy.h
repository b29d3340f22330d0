// Joining springs of a seam with augmented Lagrangian multipliers:
//
//   E = sum over pairs k_j |d|^2 + m.d,   d = x_a - x_b - o
//
// After each minimisation m += 2 k_j d, so that the gap d closes at a finite k_j. The offset o is
// zero in a seam; on the way to it, o is where a is to be beside b. k_j in force / length, m in
// force.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include <vasorod/types.h>

namespace vasorod {

/// Two vertices to be joined, the multiplier of the pair (a force, acting on b), and its offset.
struct Join {
  int a = 0, b = 0;
  Vec3 multiplier = Vec3::Zero();
  Vec3 offset = Vec3::Zero();
};

/// Sum over all pairs, force * length. `p` is n x 3.
double joining_energy(double k_j, const std::vector<Join>& joins,
                      const Eigen::Ref<const Points>& p);

/// gradient += dE/dp (n x 3); returns the energy.
double joining_energy_gradient(double k_j, const std::vector<Join>& joins,
                               const Eigen::Ref<const Points>& p, Eigen::Ref<Points> gradient);

/// The constant Hessian, the same for x, y and z: n x n.
Eigen::SparseMatrix<double> joining_energy_hessian(double k_j, const std::vector<Join>& joins,
                                                   int vertex_count);

/// m += 2 k_j d for every pair.
void update_join_multipliers(double k_j, std::vector<Join>& joins,
                             const Eigen::Ref<const Points>& p);

}  // namespace vasorod
