#include "numerics/fronts.h"

#include <algorithm>
#include <atomic>
#include <cholmod.h>
#include <cstddef>
#include <thread>

#include "numerics/dense_blocks.h"

namespace vasorod {
namespace {

// Rows of a panel: enough for the BLAS, few enough to share a front.
constexpr int panel = 192;
// Operations between two questions whether to stop: about a millisecond.
constexpr double between_questions = 1e6;

template <class Task>
void for_panels(int threads, int size, Task task) {
  in_parallel(threads, (size + panel - 1) / panel, [&](int p) {
    const int first = p * panel;
    task(first, std::min(panel, size - first));
  });
}

}  // namespace

// The numbers of the matrix in the columns `first` ... `end` - 1 of the supernode, and what the
// children changed there. Each column is of one thread, which so is the first to use its memory.
template <class Scalar>
void Fronts<Scalar>::set_own(int k, const cholmod_sparse& matrix, const Places& places, int first,
                             int end, Scalar* columns) const {
  const Supernode node = nodes_[k];
  const auto* begin = static_cast<const int*>(matrix.p);
  const auto* row = static_cast<const int*>(matrix.i);
  const auto* entry = static_cast<const double*>(matrix.x);
  for (int j = first; j < end; ++j) {
    Scalar* to = columns + std::ptrdiff_t{j} * node.rows;
    std::fill(to + j, to + node.rows, Scalar{0});
    for (int p = begin[node.start + j]; p < begin[node.start + j + 1]; ++p)
      to[places[index(row[p])]] = static_cast<Scalar>(entry[p]);
  }
  nodes_.for_children(k, [&](int c) {
    const Supernode child = nodes_[c];
    const Scalar* from = changes_[index(c)].get();
    for (int j = child.first_from(first); j < child.of_parent && child.place[j] < end; ++j) {
      Scalar* to = columns + std::ptrdiff_t{child.place[j]} * node.rows;
      const Scalar* column = from + std::ptrdiff_t{j} * child.below;
      for (int i = j; i < child.below; ++i) to[child.place[i]] += column[i];
    }
  });
}

// What they changed in the columns after them.
template <class Scalar>
void Fronts<Scalar>::add_below(int k, int first, int end, Scalar* change) const {
  const Supernode node = nodes_[k];
  nodes_.for_children(k, [&](int c) {
    const Supernode child = nodes_[c];
    const Scalar* from = changes_[index(c)].get();
    for (int j = child.first_from(node.columns + first);
         j < child.below && child.place[j] - node.columns < end; ++j) {
      Scalar* to = change + std::ptrdiff_t{child.place[j] - node.columns} * node.below;
      const Scalar* column = from + std::ptrdiff_t{j} * child.below;
      for (int i = j; i < child.below; ++i) to[child.place[i] - node.columns] += column[i];
    }
  });
}

// Where the columns of a supernode go.
template <class Scalar>
Scalar* Fronts<Scalar>::columns_of(int k, Scalar* factor, Workspace& workspace) const {
  const Supernode node = nodes_[k];
  if (factor) return factor + node.entry;
  const size_t size = index(node.rows) * index(node.columns);
  if (workspace.columns.size() < size) workspace.columns.resize(size);
  return workspace.columns.data();
}

template <class Scalar>
bool Fronts<Scalar>::eliminate(int k, const cholmod_sparse& matrix, Scalar* factor,
                               Workspace& workspace, int threads) {
  const Supernode node = nodes_[k];
  Places& places = workspace.places;
  Scalar* columns = columns_of(k, factor, workspace);
  for (int i = 0; i < node.rows; ++i) places[index(node.row[i])] = i;
  const auto release_children = [&] {
    nodes_.for_children(k, [&](int c) { changes_[index(c)].reset(); });
  };
  for_panels(threads, node.columns, [&](int first, int size) {
    set_own(k, matrix, places, first, first + size, columns);
  });
  if (!dense::cholesky(node.columns, columns, node.rows)) return false;
  if (node.below == 0) {
    release_children();
    return true;
  }
  Scalar* below = columns + node.columns;
  for_panels(threads, node.below, [&](int first, int size) {
    dense::divide_rows(size, node.columns, columns, node.rows, below + first);
  });
  changes_[index(k)].reset(new Scalar[index(node.below) * index(node.below)]);
  Scalar* change = changes_[index(k)].get();
  for_panels(threads, node.below, [&](int first, int size) {
    Scalar* to = change + std::ptrdiff_t{first} * node.below + first;
    dense::minus_square(size, node.columns, below + first, node.rows, to, node.below);
    if (const int rest = node.below - first - size; rest > 0)
      dense::minus_product(rest, size, node.columns, below + first + size, below + first, node.rows,
                           to + size, node.below);
    add_below(k, first, first + size, change);
  });
  release_children();
  return true;
}

template <class Scalar>
bool Fronts<Scalar>::factorise(const cholmod_sparse& matrix, Scalar* factor, int threads,
                               const StopInside& stop) {
  std::vector<Workspace> workspaces(index(threads));
  for (Workspace& mine : workspaces) mine.places.resize(index(nodes_.unknowns()));
  std::atomic<bool> good = true, stopped = false;
  const std::thread::id caller = std::this_thread::get_id();
  double operations = 0;  // of the calling thread since the last question
  nodes_.upwards(threads, [&](int k, int thread, int share) {
    if (!good || stopped) return;
    if (stop && std::this_thread::get_id() == caller) {
      const double rows = nodes_[k].rows;
      operations += rows * rows * nodes_[k].columns;
      if (operations > between_questions) {
        operations = 0;
        stopped = stop();
        if (stopped) return;
      }
    }
    if (!eliminate(k, matrix, factor, workspaces[index(thread)], share)) good = false;
  });
  if (!good || stopped)
    for (std::unique_ptr<Scalar[]>& change : changes_) change.reset();
  if (stopped) throw Interruption{};
  return good;
}

template class Fronts<double>;
template class Fronts<float>;

}  // namespace vasorod
