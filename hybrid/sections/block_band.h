// A symmetric block band matrix: blocks of one size between rows that are at most `width` apart.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace vasorod {

/// Only blocks (i, j) with i <= j <= i + width are stored.
class BlockBand {
 public:
  BlockBand(int rows, int size, int width)
      : rows_(rows),
        size_(size),
        width_(width),
        blocks_(static_cast<std::size_t>(rows) * static_cast<std::size_t>(width + 1),
                Eigen::MatrixXd::Zero(size, size)) {}

  int rows() const { return rows_; }
  int size() const { return size_; }
  int width() const { return width_; }
  Eigen::MatrixXd& upper(int i, int j) { return blocks_[place(i, j)]; }
  const Eigen::MatrixXd& upper(int i, int j) const { return blocks_[place(i, j)]; }
  /// The block of any two rows.
  Eigen::MatrixXd block(int i, int j) const {
    if (std::abs(i - j) > width_) return Eigen::MatrixXd::Zero(size_, size_);
    return i <= j ? upper(i, j) : Eigen::MatrixXd(upper(j, i).transpose());
  }
  void set_zero() {
    for (Eigen::MatrixXd& block : blocks_) block.setZero();
  }

 private:
  std::size_t place(int i, int j) const {
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(width_ + 1) +
           static_cast<std::size_t>(j - i);
  }
  int rows_, size_, width_;
  std::vector<Eigen::MatrixXd> blocks_;
};

}  // namespace vasorod
