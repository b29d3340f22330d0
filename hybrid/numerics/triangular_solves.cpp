#include "numerics/triangular_solves.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "numerics/dense_blocks.h"

namespace vasorod {
namespace {

// Entries of a piece of a block that is read once, half a megabyte in double precision: a thread
// begins in less time than it takes to read.
constexpr double piece = 65536;

// `task(first, size)` for pieces of the `size` rows or columns of a block of so many others.
template <class Task>
void for_pieces(int threads, int size, int others, Task task) {
  const double entries = static_cast<double>(size) * others;
  const int parts = std::clamp(static_cast<int>(entries / piece), 1, std::max(1, size / 16));
  const auto begin = [&](int p) { return static_cast<int>(std::int64_t{size} * p / parts); };
  in_parallel(threads, parts, [&](int p) { task(begin(p), begin(p + 1) - begin(p)); });
}

}  // namespace

template <class Scalar>
void TriangularSolves<Scalar>::up(const Supernodes& nodes, int k, const Scalar* factor, int count,
                                  int threads) {
  const Supernode node = nodes[k];
  const int n = nodes.unknowns();
  Scalar* here = values_.data() + node.start;
  Scalar* below = passed_.data() + node.first_row * count;
  std::fill_n(below, std::ptrdiff_t{node.below} * count, Scalar{0});
  nodes.for_children(k, [&](int c) {
    const Supernode child = nodes[c];
    const Scalar* from = passed_.data() + child.first_row * count;
    for (int r = 0; r < count; ++r, from += child.below) {
      Scalar* to = here + std::ptrdiff_t{n} * r;
      for (int i = 0; i < child.of_parent; ++i) to[child.place[i]] += from[i];
      to = below + std::ptrdiff_t{node.below} * r;
      for (int i = child.of_parent; i < child.below; ++i)
        to[child.place[i] - node.columns] += from[i];
    }
  });
  const Scalar* block = factor + node.entry;
  dense::divide(false, node.columns, count, block, node.rows, here, n);
  if (node.below == 0) return;
  for_pieces(threads, node.below, node.columns, [&](int first, int size) {
    dense::subtract_product(false, size, node.columns, count, block + node.columns + first,
                            node.rows, here, n, below + first, node.below);
  });
}

template <class Scalar>
void TriangularSolves<Scalar>::down(const Supernodes& nodes, int k, const Scalar* factor, int count,
                                    int threads, std::vector<Scalar>& below) {
  const Supernode node = nodes[k];
  const int n = nodes.unknowns();
  Scalar* here = values_.data() + node.start;
  const Scalar* block = factor + node.entry;
  if (node.below > 0) {
    for (int r = 0; r < count; ++r) {
      const Scalar* from = values_.data() + std::ptrdiff_t{n} * r;
      Scalar* to = below.data() + std::ptrdiff_t{node.below} * r;
      for (int i = 0; i < node.below; ++i) to[i] = from[node.row[node.columns + i]];
    }
    for_pieces(threads, node.columns, node.below, [&](int first, int size) {
      dense::subtract_product(true, node.below, size, count,
                              block + std::ptrdiff_t{first} * node.rows + node.columns, node.rows,
                              below.data(), node.below, here + first, n);
    });
  }
  dense::divide(true, node.columns, count, block, node.rows, here, n);
}

template <class Scalar>
void TriangularSolves<Scalar>::solve(const Supernodes& nodes, const Scalar* factor, const double* b,
                                     double* x, int count, int threads) {
  const auto n = index(nodes.unknowns());
  const std::vector<int>& order = nodes.order();
  values_.resize(n * index(count));
  passed_.resize(nodes.row_indices() * index(count));
  for (size_t r = 0; r < index(count); ++r)
    for (size_t i = 0; i < n; ++i)
      values_[r * n + i] = static_cast<Scalar>(b[r * n + index(order[i])]);
  nodes.upwards(threads, [&](int k, int, int share) { up(nodes, k, factor, count, share); });
  std::vector<std::vector<Scalar>> below(
      index(threads), std::vector<Scalar>(index(nodes.tallest()) * index(count)));
  nodes.downwards(threads, [&](int k, int thread, int share) {
    down(nodes, k, factor, count, share, below[index(thread)]);
  });
  for (size_t r = 0; r < index(count); ++r)
    for (size_t i = 0; i < n; ++i)
      x[r * n + index(order[i])] = static_cast<double>(values_[r * n + i]);
}

template class TriangularSolves<double>;
template class TriangularSolves<float>;

}  // namespace vasorod
