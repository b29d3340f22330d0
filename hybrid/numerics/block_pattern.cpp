#include "numerics/block_pattern.h"

#include <algorithm>

namespace vasorod {

BlockPattern::BlockPattern(const std::vector<int>& sizes)
    : sizes_(sizes),
      first_(sizes.size()),
      stride_(sizes.size()),
      below_(sizes.size()),
      place_(sizes.size()) {
  int next = 0;
  for (size_t i = 0; i < sizes.size(); ++i) {
    first_[i] = next;
    next += sizes[i];
    below_[i].push_back(static_cast<int>(i));
  }
}

void BlockPattern::couple(int i, int j) {
  if (i != j) below_[static_cast<size_t>(std::min(i, j))].push_back(std::max(i, j));
}

Eigen::SparseMatrix<double> BlockPattern::build() {
  int entries = 0;
  for (size_t node = 0; node < below_.size(); ++node) {
    auto& rows = below_[node];
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    int column = 0;
    for (const int row : rows) {
      place_[node].push_back(entries + column);
      column += sizes_[static_cast<size_t>(row)];
    }
    stride_[node] = column - 1;
    for (int c = 0; c < sizes_[node]; ++c) entries += column - c;
  }
  const int unknowns = first_.empty() ? 0 : first_.back() + sizes_.back();
  Eigen::SparseMatrix<double> matrix(unknowns, unknowns);
  matrix.resizeNonZeros(entries);
  int entry = 0;
  for (size_t node = 0; node < below_.size(); ++node)
    for (int c = 0; c < sizes_[node]; ++c) {
      matrix.outerIndexPtr()[first_[node] + c] = entry;
      for (const int row : below_[node])
        for (int r = row == static_cast<int>(node) ? c : 0; r < sizes_[static_cast<size_t>(row)];
             ++r) {
          matrix.innerIndexPtr()[entry] = first_[static_cast<size_t>(row)] + r;
          matrix.valuePtr()[entry] = 0;
          ++entry;
        }
    }
  matrix.outerIndexPtr()[unknowns] = entry;
  return matrix;
}

int BlockPattern::place(int row_node, int column_node) const {
  const auto& rows = below_[static_cast<size_t>(column_node)];
  const auto at = std::lower_bound(rows.begin(), rows.end(), row_node) - rows.begin();
  return place_[static_cast<size_t>(column_node)][static_cast<size_t>(at)];
}

}  // namespace vasorod
