#include "numerics/cholesky.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "numerics/fronts.h"
#include "numerics/triangular_solves.h"

namespace vasorod {
namespace {

// Largest relative difference of a single-precision solve; far below the preconditioner's own
// error.
constexpr double largest_difference = 1e-3;
// A solve with a factor of so many entries ends about when a second thread begins: with 2 million
// two threads were slower than one, with 34 million a third faster.
constexpr std::size_t few_entries = 8'000'000;

}  // namespace

using Matrix = Eigen::SparseMatrix<double>;

struct Cholesky::Data {
  Work* done = nullptr;  // of the owner; null: not counted
  std::optional<Analysis> analysis;
  std::optional<Fronts<double>> fronts;
  std::optional<Fronts<float>> single_fronts;
  std::unique_ptr<double[]> factor;  // the entries of all supernodes
  TriangularSolves<double> solves;
  bool factorised = false;
  bool only_single = false;  // the factor is a rough one
  // The last exact factor in single precision: not yet tried, good enough, or not.
  enum class Single { untried, good, bad } single_is = Single::untried;
  // Of rough factorisations that fail: the first is yet to be verified, was right, or was wrong.
  enum class Failure { unverified, right, wrong } failure_is = Failure::unverified;
  std::vector<float> single;
  TriangularSolves<float> single_solves;

  void count() const {
    if (!done) return;
    Counts& counts = done->counts;
    ++counts.factorisations;
    counts.factor_nonzeros =
        std::max(counts.factor_nonzeros, static_cast<std::int64_t>(analysis->factor_nonzeros()));
  }
  int threads() const { return analysis->nodes().entries() > few_entries ? vasorod::threads() : 1; }
};

Cholesky::Cholesky(Work* work) : data_(std::make_unique<Data>()) {
  data_->done = work;
}
Cholesky::~Cholesky() = default;
Cholesky::Cholesky(Cholesky&&) noexcept = default;
Cholesky& Cholesky::operator=(Cholesky&&) noexcept = default;

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
  Data& d = *data_;
  d.factorised = d.only_single = false;
  d.factor.reset();
  d.fronts.reset();
  d.single_fronts.reset();
  d.analysis.reset();
  d.analysis.emplace(matrix, order);
  d.fronts.emplace(d.analysis->nodes());
}

bool Cholesky::factorise(const Matrix& matrix, const StopInside& stop, Precision precision) {
  const FactorTime time(data_->done);
  Data& d = *data_;
  d.factorised = d.only_single = false;
  const size_t entries = d.analysis->nodes().entries();
  const auto& sorted = d.analysis->in_order(matrix);
  const bool rough = precision == Precision::rough && d.single_is == Data::Single::good &&
                     d.failure_is != Data::Failure::wrong;
  if (rough) {
    d.count();
    if (!d.single_fronts) d.single_fronts.emplace(d.analysis->nodes());
    d.single.resize(entries);
    d.factorised = d.only_single =
        d.single_fronts->factorise(sorted, d.single.data(), d.threads(), stop);
    if (d.factorised || d.failure_is == Data::Failure::right) return d.factorised;
  }
  d.count();
  if (!d.factor) d.factor.reset(new double[entries]);
  d.factorised = d.fronts->factorise(sorted, d.factor.get(), d.threads(), stop);
  if (rough)
    d.failure_is = d.factorised ? Data::Failure::wrong : Data::Failure::right;
  else if (d.factorised && d.failure_is == Data::Failure::right)
    d.failure_is = Data::Failure::unverified;
  if (!rough || d.factorised) d.single_is = Data::Single::untried;
  return d.factorised;
}

void Cholesky::solve(const double* b, double* x, int columns) {
  Data& d = *data_;
  if (d.done) ++d.done->counts.solves;
  if (d.only_single)
    d.single_solves.solve(d.analysis->nodes(), d.single.data(), b, x, columns, d.threads());
  else
    d.solves.solve(d.analysis->nodes(), d.factor.get(), b, x, columns, d.threads());
}

void Cholesky::precondition(const double* b, double* x, int columns) {
  Data& d = *data_;
  if (d.only_single || d.single_is == Data::Single::bad) return solve(b, x, columns);
  const bool untried = d.single_is == Data::Single::untried;
  const auto size = Eigen::Index{d.analysis->nodes().unknowns()} * columns;
  Eigen::VectorXd exact;
  if (untried) {
    exact.resize(size);
    solve(b, exact.data(), columns);
    copy_to_single();
  }
  if (d.done) ++d.done->counts.solves;
  d.single_solves.solve(d.analysis->nodes(), d.single.data(), b, x, columns, d.threads());
  if (!untried) return;
  const Eigen::Map<Eigen::VectorXd> single(x, size);
  d.single_is = (single - exact).norm() < largest_difference * exact.norm() ? Data::Single::good
                                                                            : Data::Single::bad;
  if (d.single_is == Data::Single::bad) std::copy_n(exact.data(), size, x);
}

void Cholesky::copy_to_single() {
  Data& d = *data_;
  const size_t count = d.analysis->nodes().entries(), part = size_t{1} << 20;
  d.single.resize(count);
  in_parallel(d.threads(), static_cast<int>((count + part - 1) / part), [&](int p) {
    const size_t first = index(p) * part, size = std::min(part, count - first);
    const double* from = d.factor.get() + first;
    std::transform(from, from + size, d.single.begin() + static_cast<std::ptrdiff_t>(first),
                   [](double value) { return static_cast<float>(value); });
  });
}

bool Cholesky::analysed() const {
  return data_->analysis.has_value();
}
bool Cholesky::factorised() const {
  return data_->factorised;
}
double Cholesky::factor_nonzeros() const {
  return data_->analysis->factor_nonzeros();
}

}  // namespace vasorod
