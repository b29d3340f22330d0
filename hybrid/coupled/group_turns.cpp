#include "coupled/group_turns.h"

#include <algorithm>
#include <utility>

namespace vasorod {

GroupTurns::GroupTurns(std::vector<int> groups, int unknown_count)
    : first(std::move(groups)), unknowns(unknown_count), turn_of(first.size(), -1) {}

void GroupTurns::set(size_t g, const Turn& block) {
  turn_of[g] = static_cast<int>(turn.size());
  turn.push_back(block);
}

void apply(const GroupTurns& d, bool transposed, Eigen::VectorXd& z) {
  for (size_t g = 0; g < d.first.size(); ++g) {
    const Turn* turn = d.of(g);
    if (!turn) continue;
    auto part = z.segment(d.first[g], turn->rows());
    const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6, 1> before = part;
    if (transposed)
      part.noalias() = turn->transpose() * before;
    else
      part.noalias() = *turn * before;
  }
}

void turn_matrix(const GroupTurns& d, Eigen::SparseMatrix<double>& k) {
  std::vector<size_t> group_of(static_cast<size_t>(d.unknowns));
  for (size_t g = 0; g < d.first.size(); ++g)
    std::fill_n(group_of.begin() + d.first[g], d.width(g), g);
  const int* outer = k.outerIndexPtr();
  const int* rows = k.innerIndexPtr();
  double* values = k.valuePtr();
  for (size_t g = 0; g < d.first.size(); ++g) {
    const int first = d.first[g], width = d.width(g), count = outer[first + 1] - outer[first];
    // The columns of a group share their rows below the diagonal; p counts the rows of the first
    // column.
    const auto at = [&](int p, int c) -> double& { return values[outer[first + c] + p - c]; };
    const Turn* right = d.of(g);
    if (right) {
      Turn block(width, width);
      for (int c = 0; c < width; ++c)
        for (int p = c; p < width; ++p) block(p, c) = block(c, p) = at(p, c);
      block = (*right * block * right->transpose()).eval();
      for (int c = 0; c < width; ++c)
        for (int p = c; p < width; ++p) at(p, c) = block(p, c);
    }
    for (int p = width; p < count;) {
      const size_t below = group_of[static_cast<size_t>(rows[outer[first] + p])];
      const int height = d.width(below);
      const Turn* left = d.of(below);
      if (left || right) {
        Turn block(height, width);
        for (int c = 0; c < width; ++c)
          for (int r = 0; r < height; ++r) block(r, c) = at(p + r, c);
        if (left) block = (*left * block).eval();
        if (right) block = (block * right->transpose()).eval();
        for (int c = 0; c < width; ++c)
          for (int r = 0; r < height; ++r) at(p + r, c) = block(r, c);
      }
      p += height;
    }
  }
}

}  // namespace vasorod
