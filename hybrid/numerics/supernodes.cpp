#include "numerics/supernodes.h"

#include <algorithm>
#include <cholmod.h>
#include <numeric>

namespace vasorod {
namespace {

// Enough that no thread waits long for the others at the end, and few enough that little is above.
constexpr int most_subtrees = 24;

}  // namespace

Supernodes::Supernodes(const cholmod_factor& symbolic) : entries_(symbolic.xsize) {
  const auto* super = static_cast<const int*>(symbolic.super);
  const auto* pi = static_cast<const int*>(symbolic.pi);
  const auto* px = static_cast<const int*>(symbolic.px);
  const auto* s = static_cast<const int*>(symbolic.s);
  const auto* perm = static_cast<const int*>(symbolic.Perm);
  const size_t count = symbolic.nsuper;
  first_.assign(super, super + count + 1);
  row_.assign(pi, pi + count + 1);
  entry_.assign(px, px + count);
  rows_.assign(s, s + row_.back());
  order_.assign(perm, perm + symbolic.n);
  place_.resize(rows_.size());
  parent_.assign(count, -1);
  child_.assign(count, -1);
  sibling_.assign(count, -1);
  of_parent_.assign(count, 0);
  std::vector<int> node_of(symbolic.n), place(symbolic.n);
  for (size_t k = 0; k < count; ++k)
    std::fill(node_of.begin() + first_[k], node_of.begin() + first_[k + 1], static_cast<int>(k));
  // From the last to the first, so that the children of each are in ascending order.
  for (size_t k = count; k-- > 0;) {
    const Supernode node = (*this)[static_cast<int>(k)];
    tallest_ = std::max(tallest_, node.rows);
    if (node.below == 0) continue;
    parent_[k] = node_of[index(node.row[node.columns])];
    sibling_[k] = child_[index(parent_[k])];
    child_[index(parent_[k])] = static_cast<int>(k);
  }
  for (int k = 0; k < size(); ++k) {
    const Supernode node = (*this)[k];
    for (int i = 0; i < node.rows; ++i) place[index(node.row[i])] = i;
    for_children(k, [&](int c) {
      const Supernode child = (*this)[c];
      for (int i = 0; i < child.below; ++i) {
        place_[index(child.first_row + i)] = place[index(child.row[child.columns + i])];
        of_parent_[index(c)] += child.place[i] < node.columns;
      }
    });
  }
  all_.resize(count);
  std::iota(all_.begin(), all_.end(), 0);
  divide_into_subtrees();
}

Supernode Supernodes::operator[](int k) const {
  const auto i = index(k);
  const int columns = first_[i + 1] - first_[i], rows = row_[i + 1] - row_[i];
  return {.start = first_[i],
          .columns = columns,
          .rows = rows,
          .below = rows - columns,
          .of_parent = of_parent_[i],
          .row = rows_.data() + row_[i],
          .place = place_.data() + row_[i] + columns,
          .entry = entry_[i],
          .first_row = row_[i] + columns};
}

// The heaviest subtree is opened as long as it is more than its share.
void Supernodes::divide_into_subtrees() {
  std::vector<double> work(parent_.size());
  double total = 0;
  for (int k = 0; k < size(); ++k) {
    const Supernode node = (*this)[k];
    const double own = static_cast<double>(node.columns) * node.rows * node.rows;
    total += own;
    work[index(k)] += own;
    if (const int parent = parent_[index(k)]; parent >= 0) work[index(parent)] += work[index(k)];
  }
  const auto lighter = [&](int a, int b) { return work[index(a)] < work[index(b)]; };
  std::vector<int> tops;
  const auto add = [&](int top) {
    tops.push_back(top);
    std::push_heap(tops.begin(), tops.end(), lighter);
  };
  for (int k = 0; k < size(); ++k)
    if (parent_[index(k)] < 0) add(k);
  while (!tops.empty() && work[index(tops.front())] > total / most_subtrees) {
    std::pop_heap(tops.begin(), tops.end(), lighter);
    const int opened = tops.back();
    tops.pop_back();
    above_.push_back(opened);
    for_children(opened, add);
  }
  std::sort(above_.begin(), above_.end());
  std::sort(tops.begin(), tops.end());
  for (const int top : tops) {
    int first = top;
    while (child_[index(first)] >= 0) first = child_[index(first)];
    subtrees_.emplace_back(first, top);
  }
}

}  // namespace vasorod
