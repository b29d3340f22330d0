// The fixed sparsity pattern of a symmetric matrix made of small dense blocks: its lower triangle
// in compressed columns, and the position of each block's entries among the values.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

namespace vasorod {

/// Builds the pattern and locates blocks: couple() nodes, build() once, then place() and stride().
class BlockPattern {
 public:
  /// Nodes with `sizes[i]` unknowns each, numbered consecutively.
  explicit BlockPattern(const std::vector<int>& sizes);

  /// Marks nodes i and j as coupled.
  void couple(int i, int j);

  /// Returns the matrix with all entries zero. Call once, after the last couple().
  Eigen::SparseMatrix<double> build();

  int first_unknown(int node) const { return first_[static_cast<size_t>(node)]; }
  /// Index of the first entry of block (row node >= column node) in the matrix's value array. The
  /// next row of the block follows directly. The next column of the block starts `stride(column
  /// node)` entries further; each following step from column to column is one entry shorter.
  int place(int row_node, int column_node) const;
  int stride(int node) const { return stride_[static_cast<size_t>(node)]; }

 private:
  std::vector<int> sizes_, first_, stride_;
  // Per node: coupled nodes that do not precede it, sorted after build().
  std::vector<std::vector<int>> below_;
  std::vector<std::vector<int>> place_;  // parallel to below_
};

}  // namespace vasorod
