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
#include "numerics/single_factor.h"

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
  cholmod_factor* factor = nullptr;
  cholmod_dense *solution = nullptr, *work = nullptr, *work_e = nullptr;
  // The matrix in the order of elimination, and the place of each of its entries in the matrix as
  // given: with them a new matrix of the same pattern is sorted in one pass.
  cholmod_sparse* sorted = nullptr;
  std::vector<int> place;
  bool factorised = false;
  bool tried = false;  // whether `single` has been decided on
  std::optional<SingleFactor> single;

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
    cholmod_free_dense(&solution, &common);
    cholmod_free_dense(&work, &common);
    cholmod_free_dense(&work_e, &common);
    cholmod_free_factor(&factor, &common);
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
  cholmod_free_factor(&d.factor, &d.common);
  d.factorised = false;
  cholmod_sparse view = view_of(matrix);
  d.common.method[0].ordering = order.empty() ? CHOLMOD_AMD : CHOLMOD_GIVEN;
  d.factor = order.empty()
                 ? cholmod_analyze(&view, &d.common)
                 : cholmod_analyze_p(&view, const_cast<int*>(order.data()), nullptr, 0, &d.common);
  if (!d.factor) fail(d.common, "analysed");
  cholmod_free_sparse(&d.sorted, &d.common);
  d.place.clear();
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
    auto* perm = static_cast<int*>(d.factor->Perm);
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
  d.tried = false;
  d.single.reset();
  d.common.status = CHOLMOD_OK;
  sort(matrix);
  double no_shift[2] = {0, 0};
  cholmod_super_numeric(d.sorted, nullptr, no_shift, d.factor, &d.common);
  if (d.common.status < CHOLMOD_OK) fail(d.common, "factorised");
  d.factorised = d.common.status == CHOLMOD_OK && d.factor->minor == d.factor->n;
  return d.factorised;
}

void Cholesky::solve(const double* b, double* x, int columns) {
  const OneCholmodThread one_thread;
  Data& d = *data_;
  if (d.done) ++d.done->counts.solves;
  cholmod_dense rhs{};
  rhs.nrow = rhs.d = d.factor->n;
  rhs.ncol = static_cast<size_t>(columns);
  rhs.nzmax = rhs.nrow * rhs.ncol;
  rhs.x = const_cast<double*>(b);
  rhs.xtype = CHOLMOD_REAL;
  rhs.dtype = CHOLMOD_DOUBLE;
  if (!cholmod_solve2(CHOLMOD_A, d.factor, &rhs, nullptr, &d.solution, nullptr, &d.work, &d.work_e,
                      &d.common))
    fail(d.common, "solved");
  std::copy_n(static_cast<const double*>(d.solution->x), rhs.nzmax, x);
}

void Cholesky::precondition(const double* b, double* x, int columns) {
  Data& d = *data_;
  if (!d.tried) {
    d.tried = true;
    d.single.emplace(*d.factor);
    const auto size = static_cast<Eigen::Index>(d.factor->n) * columns;
    Eigen::VectorXd exact(size);
    solve(b, exact.data(), columns);
    d.single->solve(b, x, columns);
    if (d.done) ++d.done->counts.solves;
    const Eigen::Map<Eigen::VectorXd> single(x, size);
    if (!((single - exact).norm() < largest_difference * exact.norm())) {
      d.single.reset();
      std::copy_n(exact.data(), size, x);
    }
  } else if (d.single) {
    d.single->solve(b, x, columns);
    if (d.done) ++d.done->counts.solves;
  } else {
    solve(b, x, columns);
  }
}

bool Cholesky::analysed() const {
  return data_->factor != nullptr;
}
bool Cholesky::factorised() const {
  return data_->factorised;
}
double Cholesky::factor_nonzeros() const {
  return data_->common.lnz;
}

}  // namespace vasorod
