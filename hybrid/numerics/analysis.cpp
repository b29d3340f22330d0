#include "numerics/analysis.h"

#include <algorithm>
#include <cholmod.h>
#include <mutex>
#include <new>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>

#include "numerics/blas.h"

namespace vasorod {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

// METIS draws from the C library's one sequence of random numbers, which it begins anew at each
// call. Two calls at the same time would disturb each other, and no run would repeat.
std::mutex one_metis;

// Larger graphs are not offered to minimum degree.
constexpr int small_graph = 50000;
// Up to this much work of minimum degree's order (CHOLMOD's flops of the graph, over its nodes),
// what nested dissection spares a few factorisations is less than what it costs. Irregular walls of
// 7,000 vertices stay below it; a regular tube of 4,000, for which minimum degree is bad, does not.
constexpr double little_work = 10000;

// CHOLMOD's settings and workspace.
struct Cholmod {
  cholmod_common common{};

  Cholmod() {
    cholmod_start(&common);
    common.supernodal = CHOLMOD_SUPERNODAL;
    // AMD alone: trying METIS costs more than it gains below about 300k vertices.
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_AMD;
    common.postorder = 1;
    common.print = 0;
    common.error_handler = nullptr;
  }
  ~Cholmod() { cholmod_finish(&common); }
  Cholmod(const Cholmod&) = delete;
  Cholmod& operator=(const Cholmod&) = delete;
};

// CHOLMOD counts with int here: a factor whose indices an int cannot count is too large as well.
[[noreturn]] void fail(const cholmod_common& common, const std::string& what) {
  if (common.status == CHOLMOD_OUT_OF_MEMORY || common.status == CHOLMOD_TOO_LARGE)
    throw std::bad_alloc();
  throw std::runtime_error("the sparse matrix could not be " + what + ": CHOLMOD's status " +
                           std::to_string(common.status));
}

// A CHOLMOD view of an Eigen matrix. CHOLMOD does not write through it.
cholmod_sparse view_of(const Matrix& m) {
  cholmod_sparse view{};
  view.nrow = static_cast<size_t>(m.rows());
  view.ncol = static_cast<size_t>(m.cols());
  view.nzmax = static_cast<size_t>(m.nonZeros());
  view.p = const_cast<int*>(m.outerIndexPtr());
  view.i = const_cast<int*>(m.innerIndexPtr());
  view.x = const_cast<double*>(m.valuePtr());
  view.stype = -1;
  view.itype = CHOLMOD_INT;
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  view.sorted = 1;
  view.packed = 1;
  return view;
}

// The graph of the groups: one row per group of unknowns.
Matrix group_graph(const Matrix& m, const std::vector<int>& groups) {
  const auto count = static_cast<int>(groups.size());
  std::vector<int> group_of(static_cast<size_t>(m.cols()));
  for (int g = 0; g < count; ++g) {
    const int last =
        g + 1 < count ? groups[static_cast<size_t>(g) + 1] : static_cast<int>(m.cols());
    std::fill(group_of.begin() + groups[static_cast<size_t>(g)], group_of.begin() + last, g);
  }
  Matrix graph(count, count);
  Eigen::Index entries = 0;
  for (const int first : groups) entries += m.outerIndexPtr()[first + 1] - m.outerIndexPtr()[first];
  graph.reserve(entries);
  for (int g = 0; g < count; ++g) {  // rows ascend, and so do their groups
    graph.startVec(g);
    int last = -1;
    for (Matrix::InnerIterator it(m, groups[static_cast<size_t>(g)]); it; ++it) {
      const int row = group_of[static_cast<size_t>(it.row())];
      if (row != last) graph.insertBack(row, g) = 1;
      last = row;
    }
  }
  graph.finalize();
  return graph;
}

}  // namespace

std::vector<int> elimination_order(const Matrix& matrix, const std::vector<int>& groups,
                                   Ordering ordering, Work* work) {
  std::optional<FactorTime> time(std::in_place, work);
  const OneCholmodThread one_thread;
  Matrix graph = group_graph(matrix, groups);
  cholmod_sparse view = view_of(graph);
  std::vector<int> order(static_cast<size_t>(graph.cols())), unknowns;
  Cholmod scratch;
  bool found = false;
  if (ordering == Ordering::minimum_degree ||
      (ordering == Ordering::cheaper && graph.cols() <= small_graph)) {
    if (!cholmod_amd(&view, nullptr, 0, order.data(), &scratch.common))
      fail(scratch.common, "ordered");
    found = ordering == Ordering::minimum_degree ||
            scratch.common.fl <= little_work * static_cast<double>(graph.cols());
  }
  if (!found) {
    time.reset();  // waiting is none of it
    const std::lock_guard<std::mutex> alone(one_metis);
    time.emplace(work);
    if (!cholmod_metis(&view, nullptr, 0, 1, order.data(), &scratch.common))
      fail(scratch.common, "ordered");
  }
  unknowns.reserve(static_cast<size_t>(matrix.cols()));
  for (const int g : order) {
    const auto next = static_cast<size_t>(g) + 1;
    const int last = next < groups.size() ? groups[next] : static_cast<int>(matrix.cols());
    for (int u = groups[static_cast<size_t>(g)]; u < last; ++u) unknowns.push_back(u);
  }
  return unknowns;
}

struct Analysis::Data {
  Cholmod cholmod;
  cholmod_factor* symbolic = nullptr;
  std::optional<Supernodes> nodes;
  // The matrix in the order of elimination, and the place of each of its entries in the matrix as
  // given: with them a new matrix of the same pattern is sorted in one pass.
  cholmod_sparse* sorted = nullptr;
  std::vector<int> place;

  Data() = default;
  ~Data() {
    cholmod_free_factor(&symbolic, &cholmod.common);
    cholmod_free_sparse(&sorted, &cholmod.common);
  }
  Data(const Data&) = delete;
  Data& operator=(const Data&) = delete;
};

Analysis::Analysis(const Matrix& matrix, const std::vector<int>& order)
    : data_(std::make_unique<Data>()) {
  const OneCholmodThread one_thread;
  Data& d = *data_;
  cholmod_sparse view = view_of(matrix);
  if (!order.empty()) d.cholmod.common.method[0].ordering = CHOLMOD_GIVEN;
  d.symbolic = cholmod_analyze_p(&view, order.empty() ? nullptr : const_cast<int*>(order.data()),
                                 nullptr, 0, &d.cholmod.common);
  if (!d.symbolic) fail(d.cholmod.common, "analysed");
  d.nodes.emplace(*d.symbolic);
}
Analysis::~Analysis() = default;

const Supernodes& Analysis::nodes() const {
  return *data_->nodes;
}

double Analysis::factor_nonzeros() const {
  return data_->cholmod.common.lnz;
}

// Column by column, as the factorisation reads them, in any order within each.
void Analysis::sort_places(const Matrix& matrix) {
  Data& d = *data_;
  const auto n = static_cast<size_t>(matrix.cols());
  const auto* perm = static_cast<const int*>(d.symbolic->Perm);
  std::vector<int> turn(n);  // of each unknown
  for (size_t k = 0; k < n; ++k) turn[static_cast<size_t>(perm[k])] = static_cast<int>(k);
  // `take(row, column, place)` for each entry of the lower triangle.
  const auto for_lower = [&](auto take) {
    for (int column = 0; column < matrix.cols(); ++column)
      for (int p = matrix.outerIndexPtr()[column]; p < matrix.outerIndexPtr()[column + 1]; ++p) {
        const int row = matrix.innerIndexPtr()[p];
        if (row < column) continue;
        const auto [first, last] =
            std::minmax(turn[static_cast<size_t>(row)], turn[static_cast<size_t>(column)]);
        take(last, first, p);
      }
  };
  std::vector<int> next(n + 1, 0);
  for_lower([&](int, int column, int) { ++next[static_cast<size_t>(column) + 1]; });
  std::partial_sum(next.begin(), next.end(), next.begin());
  const auto entries = static_cast<size_t>(next.back());
  d.sorted = cholmod_allocate_sparse(n, n, entries, 0, 1, -1, CHOLMOD_REAL, &d.cholmod.common);
  if (!d.sorted) fail(d.cholmod.common, "sorted");
  std::copy(next.begin(), next.end(), static_cast<int*>(d.sorted->p));
  auto* rows = static_cast<int*>(d.sorted->i);
  d.place.resize(entries);
  for_lower([&](int row, int column, int place) {
    const int at = next[static_cast<size_t>(column)]++;
    rows[at] = row;
    d.place[static_cast<size_t>(at)] = place;
  });
}

const cholmod_sparse& Analysis::in_order(const Matrix& matrix) {
  Data& d = *data_;
  if (!d.sorted) sort_places(matrix);
  auto* values = static_cast<double*>(d.sorted->x);
  const double* from = matrix.valuePtr();
  for (size_t k = 0; k < d.place.size(); ++k) values[k] = from[d.place[k]];
  return *d.sorted;
}

}  // namespace vasorod
