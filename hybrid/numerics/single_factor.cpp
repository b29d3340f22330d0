#include "numerics/single_factor.h"

#include <algorithm>
#include <cholmod.h>

#include "data/index.h"

namespace vasorod {
// A set of columns with the same rows: a dense triangle and the rectangle below it.
struct SingleFactor::Supernode {
  using Column = Eigen::Map<const Eigen::VectorXf>;

  int start, width;
  std::ptrdiff_t height, rest;
  const float* entries;
  const int* rows;  // rows of the rectangle below the triangle

  float inverse(int j) const { return entries[j * (height + 1)]; }
  Column within(int j) const { return {entries + j * (height + 1) + 1, width - j - 1}; }
  Column under(int j) const { return {entries + j * height + width, rest}; }
};

SingleFactor::Supernode SingleFactor::supernode(size_t k) const {
  const int start = first_[k], width = first_[k + 1] - start;
  const std::ptrdiff_t height = row_[k + 1] - row_[k];
  return {start,
          width,
          height,
          height - width,
          entries_.data() + entry_[k],
          rows_.data() + row_[k] + width};
}

SingleFactor::SingleFactor(const cholmod_factor_struct& factor) {
  const auto* super = static_cast<const int*>(factor.super);
  const auto* pi = static_cast<const int*>(factor.pi);
  const auto* px = static_cast<const int*>(factor.px);
  const auto* s = static_cast<const int*>(factor.s);
  const auto* x = static_cast<const double*>(factor.x);
  const auto* perm = static_cast<const int*>(factor.Perm);
  const size_t count = factor.nsuper;
  first_.assign(super, super + count + 1);
  row_.assign(pi, pi + count + 1);
  entry_.assign(px, px + count);
  rows_.assign(s, s + row_.back());
  order_.assign(perm, perm + factor.n);
  entries_.resize(factor.xsize);
  std::transform(x, x + factor.xsize, entries_.begin(),
                 [](double v) { return static_cast<float>(v); });
  std::ptrdiff_t tallest = 0;
  for (size_t k = 0; k < count; ++k) {
    const std::ptrdiff_t height = row_[k + 1] - row_[k];
    tallest = std::max(tallest, height);
    for (std::ptrdiff_t j = 0; j < first_[k + 1] - first_[k]; ++j)
      entries_[index(entry_[k] + j * (height + 1))] =
          static_cast<float>(1 / x[entry_[k] + j * (height + 1)]);
  }
  below_.resize(tallest, 0);
}

void SingleFactor::solve(const double* b, double* x, int columns) {
  const auto n = static_cast<Eigen::Index>(order_.size());
  values_.resize(n, columns);
  below_.resize(below_.rows(), columns);
  for (int c = 0; c < columns; ++c)
    for (Eigen::Index i = 0; i < n; ++i)
      values_(i, c) = static_cast<float>(b[c * n + order_[index(i)]]);
  const size_t count = entry_.size();
  for (size_t k = 0; k < count; ++k) {
    const Supernode node = supernode(k);
    auto here = values_.middleRows(node.start, node.width);
    auto below = below_.topRows(node.rest);
    below.setZero();
    for (int j = 0; j < node.width; ++j)
      for (int c = 0; c < columns; ++c) {
        const float value = here(j, c) *= node.inverse(j);
        here.col(c).tail(node.width - j - 1) -= value * node.within(j);
        below.col(c) += value * node.under(j);
      }
    for (int c = 0; c < columns; ++c)
      for (Eigen::Index i = 0; i < node.rest; ++i) values_(node.rows[i], c) -= below(i, c);
  }
  for (size_t k = count; k-- > 0;) {
    const Supernode node = supernode(k);
    auto here = values_.middleRows(node.start, node.width);
    auto below = below_.topRows(node.rest);
    for (int c = 0; c < columns; ++c)
      for (Eigen::Index i = 0; i < node.rest; ++i) below(i, c) = values_(node.rows[i], c);
    for (int j = node.width - 1; j >= 0; --j)
      for (int c = 0; c < columns; ++c)
        here(j, c) = node.inverse(j) * (here(j, c) - node.under(j).dot(below.col(c)) -
                                        node.within(j).dot(here.col(c).tail(node.width - j - 1)));
  }
  for (int c = 0; c < columns; ++c)
    for (Eigen::Index i = 0; i < n; ++i)
      x[c * n + order_[index(i)]] = static_cast<double>(values_(i, c));
}

}  // namespace vasorod
