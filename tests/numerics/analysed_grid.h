// A positive definite matrix whose supernodes have many widths, with its analysis.
#pragma once

#include <Eigen/SparseCore>
#include <random>
#include <vector>

#include "numerics/analysis.h"

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

struct AnalysedGrid {
  explicit AnalysedGrid(int side)
      : matrix(grid(side)), analysis(matrix, {}), nodes(analysis.nodes()) {}

  Eigen::SparseMatrix<double> matrix;
  Analysis analysis;
  const Supernodes& nodes;
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
