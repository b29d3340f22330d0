#include "numerics/cholesky.h"

#include <algorithm>
#include <cholmod.h>
#include <mutex>
#include <new>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "numerics/blas.h"
#include "numerics/fronts.h"
#include "numerics/triangular_solves.h"

namespace vasorod {
namespace {

// METIS draws from the C library's one sequence of random numbers, which it begins anew at each
// call. Two calls at the same time would disturb each other, and no run would repeat.
std::mutex one_metis;

}  // namespace

using Matrix = Eigen::SparseMatrix<double>;

struct Cholesky::Data {
  Work* done = nullptr;  // of the owner; null: not counted
  cholmod_common common{};
  cholmod_factor* symbolic = nullptr;
  std::optional<Supernodes> nodes;
  std::optional<Fronts> fronts;
  std::unique_ptr<double[]> factor;  // the entries of all supernodes
  TriangularSolves<double> solves;
  // The matrix in the order of elimination, and the place of each of its entries in the matrix as
  // given: with them a new matrix of the same pattern is sorted in one pass.
  cholmod_sparse* sorted = nullptr;
  std::vector<int> place;
  bool factorised = false;
  // The factor in single precision: not yet tried, good enough, or not.
  enum class Single { untried, good, rough } single_is = Single::untried;
  std::vector<float> single;
  TriangularSolves<float> single_solves;

  Data() {
    cholmod_start(&common);
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.final_ll = 1;
    // AMD alone: trying METIS costs more than it gains below about 300k vertices.
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_AMD;
    common.postorder = 1;
    common.quick_return_if_not_posdef = 1;
    common.print = 0;
    common.error_handler = nullptr;
  }
  ~Data() {
    cholmod_free_factor(&symbolic, &common);
    cholmod_free_sparse(&sorted, &common);
    cholmod_finish(&common);
  }
  Data(const Data&) = delete;
  Data& operator=(const Data&) = delete;
};

namespace {

// Largest relative difference of a single-precision solve; far below the preconditioner's own
// error.
constexpr double largest_difference = 1e-3;

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
  std::vector<Eigen::Triplet<double>> entries;
  for (int g = 0; g < count; ++g) {
    int last = -1;
    for (Matrix::InnerIterator it(m, groups[static_cast<size_t>(g)]); it; ++it) {
      const int row = group_of[static_cast<size_t>(it.row())];
      if (row != last) entries.emplace_back(row, g, 1.0);
      last = row;
    }
  }
  Matrix graph(count, count);
  graph.setFromTriplets(entries.begin(), entries.end());
  return graph;
}

}  // namespace

Cholesky::Cholesky(Work* work) : data_(std::make_unique<Data>()) {
  data_->done = work;
}
Cholesky::~Cholesky() = default;
Cholesky::Cholesky(Cholesky&&) noexcept = default;
Cholesky& Cholesky::operator=(Cholesky&&) noexcept = default;

std::vector<int> elimination_order(const Matrix& matrix, const std::vector<int>& groups,
                                   Ordering ordering, Work* work) {
  std::unique_lock<std::mutex> alone(one_metis, std::defer_lock);
  if (ordering == Ordering::nested_dissection) alone.lock();
  const FactorTime time(work);
  const OneCholmodThread one_thread;
  Matrix graph = group_graph(matrix, groups);
  cholmod_sparse view = view_of(graph);
  std::vector<int> order(static_cast<size_t>(graph.cols())), unknowns;
  Cholesky::Data scratch;
  const int good = ordering == Ordering::minimum_degree
                       ? cholmod_amd(&view, nullptr, 0, order.data(), &scratch.common)
                       : cholmod_metis(&view, nullptr, 0, 1, order.data(), &scratch.common);
  if (!good) fail(scratch.common, "ordered");
  unknowns.reserve(static_cast<size_t>(matrix.cols()));
  for (const int g : order) {
    const auto next = static_cast<size_t>(g) + 1;
    const int last = next < groups.size() ? groups[next] : static_cast<int>(matrix.cols());
    for (int u = groups[static_cast<size_t>(g)]; u < last; ++u) unknowns.push_back(u);
  }
  return unknowns;
}

void Cholesky::analyse(const Matrix& matrix, int block) {
  std::vector<int> order;
  if (block > 1) {
    std::vector<int> groups;
    for (int first = 0; first < matrix.cols(); first += block) groups.push_back(first);
    order = elimination_order(matrix, groups, Ordering::minimum_degree, data_->done);
  }
  analyse(matrix, order);
}

void Cholesky::analyse(const Matrix& matrix, const std::vector<int>& order) {
  const FactorTime time(data_->done);
  const OneCholmodThread one_thread;
  Data& d = *data_;
  cholmod_free_factor(&d.symbolic, &d.common);
  cholmod_free_sparse(&d.sorted, &d.common);
  d.factorised = false;
  d.factor.reset();
  d.place.clear();
  cholmod_sparse view = view_of(matrix);
  d.common.method[0].ordering = order.empty() ? CHOLMOD_AMD : CHOLMOD_GIVEN;
  d.symbolic = order.empty() ? cholmod_analyze(&view, &d.common)
                             : cholmod_analyze_p(&view, const_cast<int*>(order.data()), nullptr, 0,
                                                 &d.common);
  if (!d.symbolic) fail(d.common, "analysed");
  d.fronts.reset();
  d.nodes.emplace(*d.symbolic);
  d.fronts.emplace(*d.nodes);
}

// Entries of the lower triangle in the order of elimination, column by column, as the supernodal
// factorisation reads them. CHOLMOD would sort each matrix anew.
void Cholesky::sort(const Matrix& matrix) {
  Data& d = *data_;
  if (!d.sorted) {
    std::vector<double> number(static_cast<size_t>(matrix.nonZeros()));
    std::iota(number.begin(), number.end(), 0.0);
    cholmod_sparse view = view_of(matrix);
    view.x = number.data();
    auto* perm = static_cast<int*>(d.symbolic->Perm);
    cholmod_sparse* upper = cholmod_ptranspose(&view, 1, perm, nullptr, 0, &d.common);
    if (!upper) fail(d.common, "sorted");
    d.sorted = cholmod_ptranspose(upper, 1, nullptr, nullptr, 0, &d.common);
    cholmod_free_sparse(&upper, &d.common);
    if (!d.sorted) fail(d.common, "sorted");
    const auto* numbers = static_cast<const double*>(d.sorted->x);
    d.place.assign(numbers, numbers + cholmod_nnz(d.sorted, &d.common));
  }
  auto* values = static_cast<double*>(d.sorted->x);
  const double* from = matrix.valuePtr();
  for (size_t k = 0; k < d.place.size(); ++k) values[k] = from[d.place[k]];
}

bool Cholesky::factorise(const Matrix& matrix) {
  const FactorTime time(data_->done);
  const OneCholmodThread one_thread;
  Data& d = *data_;
  if (d.done) {
    Counts& counts = d.done->counts;
    ++counts.factorisations;
    counts.factor_nonzeros =
        std::max(counts.factor_nonzeros, static_cast<std::int64_t>(d.common.lnz));
  }
  d.single_is = Data::Single::untried;
  d.common.status = CHOLMOD_OK;
  sort(matrix);
  if (!d.factor) d.factor.reset(new double[d.nodes->entries()]);
  d.factorised = d.fronts->factorise(*d.sorted, d.factor.get());
  return d.factorised;
}

void Cholesky::solve(const double* b, double* x, int columns) {
  Data& d = *data_;
  if (d.done) ++d.done->counts.solves;
  d.solves.solve(*d.nodes, d.factor.get(), b, x, columns);
}

void Cholesky::precondition(const double* b, double* x, int columns) {
  Data& d = *data_;
  if (d.single_is == Data::Single::rough) return solve(b, x, columns);
  const bool untried = d.single_is == Data::Single::untried;
  const auto size = static_cast<Eigen::Index>(d.symbolic->n) * columns;
  Eigen::VectorXd exact;
  if (untried) {
    exact.resize(size);
    solve(b, exact.data(), columns);
    copy_to_single();
  }
  if (d.done) ++d.done->counts.solves;
  d.single_solves.solve(*d.nodes, d.single.data(), b, x, columns);
  if (!untried) return;
  const Eigen::Map<Eigen::VectorXd> single(x, size);
  d.single_is = (single - exact).norm() < largest_difference * exact.norm() ? Data::Single::good
                                                                            : Data::Single::rough;
  if (d.single_is == Data::Single::rough) std::copy_n(exact.data(), size, x);
}

void Cholesky::copy_to_single() {
  Data& d = *data_;
  const size_t count = d.nodes->entries(), part = size_t{1} << 20;
  d.single.resize(count);
  in_parallel(threads(), static_cast<int>((count + part - 1) / part), [&](int p) {
    const size_t first = index(p) * part, size = std::min(part, count - first);
    const double* from = d.factor.get() + first;
    std::transform(from, from + size, d.single.begin() + static_cast<std::ptrdiff_t>(first),
                   [](double value) { return static_cast<float>(value); });
  });
}

bool Cholesky::analysed() const {
  return data_->symbolic != nullptr;
}
bool Cholesky::factorised() const {
  return data_->factorised;
}
double Cholesky::factor_nonzeros() const {
  return data_->common.lnz;
}

}  // namespace vasorod
