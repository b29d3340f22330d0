// Rotations of groups of unknowns: D = diag(D_g), one small orthogonal block per vertex or pose.
// With them one factorisation of the rest Hessian K0 serves every pose of a vessel:
//
//   (D K0 D^T)^-1 = D K0^-1 D^T
#pragma once

#include <Eigen/SparseCore>
#include <vector>

namespace vasorod {

using Turn = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6>;

/// The blocks D_g and the groups of unknowns they act on.
struct GroupTurns {
  std::vector<int> first;  ///< first unknown of each group, ascending from 0
  int unknowns = 0;
  std::vector<int> turn_of;  ///< per group: its place in `turn`; -1: the identity, as of most
  std::vector<Turn> turn;
  /// The identity.
  GroupTurns(std::vector<int> groups, int unknown_count);
  /// Once per group.
  void set(size_t g, const Turn& block);
  const Turn* of(size_t g) const {  ///< null: the identity
    return turn_of[g] < 0 ? nullptr : &turn[static_cast<size_t>(turn_of[g])];
  }
  int width(size_t g) const { return (g + 1 < first.size() ? first[g + 1] : unknowns) - first[g]; }
};

/// z = D z, or z = D^T z if `transposed`.
void apply(const GroupTurns& d, bool transposed, Eigen::VectorXd& z);

/// K = D K D^T in place. The lower triangle of K is stored, with groups as dense blocks.
void turn_matrix(const GroupTurns& d, Eigen::SparseMatrix<double>& k);

}  // namespace vasorod
