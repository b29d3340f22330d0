// The elimination tree of a supernodal Cholesky factor. A supernode is a set of successive columns
// with the same rows below them: a dense trapezoid of the factor. It changes columns of its
// ancestors only, so subtrees that do not hold each other are independent.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <utility>
#include <vector>

#include "data/index.h"
#include "numerics/threads.h"

struct cholmod_factor_struct;

namespace vasorod {

/// One trapezoid of the factor: `rows` rows, of which the first `columns` are the columns' own.
struct Supernode {
  int start;                 ///< first column
  int columns, rows, below;  ///< below = rows - columns
  int of_parent;             ///< of the rows below, the first so many are columns of the parent
  const int* row;            ///< row indices, ascending
  const int* place;      ///< of the rows below: their place among the rows of the parent, ascending
  std::ptrdiff_t entry;  ///< first entry in the factor, column-major with stride `rows`
  std::ptrdiff_t first_row;  ///< number of the first row index below among all

  /// The first row below whose place among the rows of the parent is `parents` or after it.
  int first_from(int parents) const {
    return static_cast<int>(std::lower_bound(place, place + below, parents) - place);
  }
};

/// The supernodes of a factor, numbered so that a subtree's are successive and its top is the last.
class Supernodes {
 public:
  /// Reads an analysed supernodal factor of CHOLMOD.
  explicit Supernodes(const cholmod_factor_struct& symbolic);

  int size() const { return static_cast<int>(parent_.size()); }
  int unknowns() const { return first_.back(); }
  std::size_t entries() const { return entries_; }          ///< of the factor
  std::size_t row_indices() const { return rows_.size(); }  ///< of all supernodes
  int tallest() const { return tallest_; }                  ///< most rows of a supernode
  const std::vector<int>& order() const { return order_; }  ///< unknown of each column
  Supernode operator[](int k) const;

  /// Calls `task` with each child of a supernode, in ascending order.
  template <class Task>
  void for_children(int k, Task task) const {
    for (int c = child_[index(k)]; c >= 0; c = sibling_[index(c)]) task(c);
  }

  /// First and last supernode of independent subtrees of about the same work, ascending.
  const std::vector<std::pair<int, int>>& subtrees() const { return subtrees_; }

  /// Calls `task(k, thread, share)` with each supernode, those below it first: in independent
  /// subtrees on up to `threads` threads, each with a share of one, then above these on the calling
  /// thread with a share of all.
  template <class Task>
  void upwards(int threads, Task task) const {
    if (threads > 1)
      for_subtrees(threads, [&](int thread, int first, int last) {
        for (int k = first; k <= last; ++k) task(k, thread, 1);
      });
    for (const int k : threads > 1 ? above_ : all_) task(k, 0, threads);
  }

  /// The same with those above it first.
  template <class Task>
  void downwards(int threads, Task task) const {
    const std::vector<int>& top = threads > 1 ? above_ : all_;
    for (auto k = top.rbegin(); k != top.rend(); ++k) task(*k, 0, threads);
    if (threads > 1)
      for_subtrees(threads, [&](int thread, int first, int last) {
        for (int k = last; k >= first; --k) task(k, thread, 1);
      });
  }

 private:
  void divide_into_subtrees();

  // Calls `task(thread, first, last)` with the first and the last supernode of each subtree.
  template <class Task>
  void for_subtrees(int threads, Task task) const {
    std::atomic<size_t> next = 0;
    in_parallel(threads, threads, [&](int thread) {
      for (size_t k = next++; k < subtrees_.size(); k = next++)
        task(thread, subtrees_[k].first, subtrees_[k].second);
    });
  }

  std::vector<int> first_;  // per supernode, plus an end entry: first column
  std::vector<int> row_;    // per supernode, plus an end entry: first row index
  std::vector<int> entry_;  // per supernode: first entry
  std::vector<int> rows_, order_;
  std::vector<int> place_;  // per row index below the columns: place among the parent's rows
  std::vector<int> parent_, child_, sibling_;  // parent, first child, next sibling; -1: none
  std::vector<int> of_parent_;
  std::vector<std::pair<int, int>> subtrees_;
  std::vector<int> above_, all_;  // above_: those in no subtree; ascending
  std::size_t entries_ = 0;
  int tallest_ = 0;
};

}  // namespace vasorod
