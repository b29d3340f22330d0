// The fixed pattern of a symmetric sparse matrix made of small dense blocks: its lower triangle,
// compressed, and where each block's entries stand.
#pragma once

#include <Eigen/SparseCore>
#include <vector>

namespace vasorod {

class BlockPattern {
 public:
  /// Nodes of `sizes` unknowns each, numbered one after another.
  explicit BlockPattern(const std::vector<int>& sizes);

  /// Nodes i and j are coupled.
  void couple(int i, int j);

  /// All entries zero; call once, after the last couple().
  Eigen::SparseMatrix<double> build();

  int first_unknown(int node) const { return first_[static_cast<size_t>(node)]; }
  /// Place of the first entry of block (row node >= column node) among the values. The block's next
  /// row follows it; its next column stands `stride(column node)` further, and the one after that
  /// one less again.
  int place(int row_node, int column_node) const;
  int stride(int node) const { return stride_[static_cast<size_t>(node)]; }

 private:
  std::vector<int> sizes_, first_, stride_;
  std::vector<std::vector<int>>
      below_;  // per node: coupled nodes not before it, sorted after build()
  std::vector<std::vector<int>> place_;  // of below_
};

}  // namespace vasorod
