// A positive definite matrix whose supernodes have many widths, with CHOLMOD's analysis of it.
#pragma once

#include <Eigen/SparseCore>
#include <cholmod.h>
#include <random>
#include <vector>

#include "numerics/supernodes.h"

namespace vasorod::testing {

/// A grid's Laplacian with three coupled unknowns at each point and a random diagonal on top.
inline Eigen::SparseMatrix<double> grid(int side) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> more(0.1, 1);
  std::vector<Eigen::Triplet<double>> entries;
  const auto couple = [&](int a, int b) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const double value = (i == j ? 1 : 0.2) * more(random);
        entries.emplace_back(3 * a + i, 3 * b + j, -value);
        entries.emplace_back(3 * b + j, 3 * a + i, -value);
        entries.emplace_back(3 * a + i, 3 * a + i, value);
        entries.emplace_back(3 * b + j, 3 * b + j, value);
      }
  };
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const int here = i * side + j;
      for (int c = 0; c < 3; ++c) entries.emplace_back(3 * here + c, 3 * here + c, more(random));
      if (i + 1 < side) couple(here, here + side);
      if (j + 1 < side) couple(here, here + 1);
    }
  Eigen::SparseMatrix<double> matrix(3 * side * side, 3 * side * side);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// The analysis of a matrix, and its lower triangle in the order of elimination.
struct Analysed {
  explicit Analysed(Eigen::SparseMatrix<double> m) : matrix(std::move(m)) {
    cholmod_start(&common);
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.final_ll = 1;
    cholmod_sparse view{};
    view.nrow = view.ncol = static_cast<size_t>(matrix.rows());
    view.nzmax = static_cast<size_t>(matrix.nonZeros());
    view.p = matrix.outerIndexPtr();
    view.i = matrix.innerIndexPtr();
    view.x = matrix.valuePtr();
    view.stype = -1;
    view.itype = CHOLMOD_INT;
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    view.sorted = view.packed = 1;
    factor = cholmod_analyze(&view, &common);
    cholmod_sparse* upper =
        cholmod_ptranspose(&view, 1, static_cast<int*>(factor->Perm), nullptr, 0, &common);
    sorted = cholmod_ptranspose(upper, 1, nullptr, nullptr, 0, &common);
    cholmod_free_sparse(&upper, &common);
  }
  ~Analysed() {
    cholmod_free_sparse(&sorted, &common);
    cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }
  Analysed(const Analysed&) = delete;
  Analysed& operator=(const Analysed&) = delete;

  Eigen::SparseMatrix<double> matrix;
  cholmod_common common{};
  cholmod_factor* factor = nullptr;
  cholmod_sparse* sorted = nullptr;
};

/// The factor's columns as a dense lower triangle, in the order of elimination.
inline Eigen::MatrixXd dense_factor(const Supernodes& nodes, const std::vector<double>& factor) {
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(nodes.unknowns(), nodes.unknowns());
  for (int k = 0; k < nodes.size(); ++k) {
    const Supernode node = nodes[k];
    for (int j = 0; j < node.columns; ++j)
      for (int i = j; i < node.rows; ++i)
        dense(node.row[i], node.start + j) =
            factor[static_cast<size_t>(node.entry + std::ptrdiff_t{j} * node.rows + i)];
  }
  return dense;
}

/// A matrix in the order of elimination.
inline Eigen::MatrixXd in_order(const Supernodes& nodes, const Eigen::MatrixXd& matrix) {
  return matrix(nodes.order(), nodes.order());
}

}  // namespace vasorod::testing
