#include "numerics/cholesky.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "numerics/fronts.h"
#include "numerics/generic_vector.h"
#include "numerics/triangular_solves.h"

namespace vasorod {
namespace {

// Largest relative error of a solve in single precision, below the error of the directions it is
// for: with a copy of an exact factor, which saves a part of each solve, and with a rough factor,
// which saves half of the factorisation and of its memory.
constexpr double largest_of_copy = 1e-3, largest_of_rough = 1e-2;
// A solve with a factor of so many entries ends about when a second thread begins: with 2 million
// two threads were slower than one, with 34 million a third faster.
constexpr std::size_t few_entries = 8'000'000;

// Memory for the numbers of a factor. It is kept for the next one, which may have a few more: the
// system hands out and clears a large block anew more slowly than it is filled.
class Room {
 public:
  template <class Scalar>
  Scalar* of(std::size_t count) {
    const std::size_t size = count * sizeof(Scalar);
    if (size > size_) {
      const std::size_t more = size_ > 0 ? size / 8 : 0;
      size_ = 0;
      bytes_.reset();
      bytes_.reset(new std::byte[size + more]);
      size_ = size + more;
    }
    return numbers<Scalar>();
  }
  template <class Scalar>
  Scalar* numbers() {
    return reinterpret_cast<Scalar*>(bytes_.get());
  }

 private:
  std::unique_ptr<std::byte[]> bytes_;  // aligned for any number
  std::size_t size_ = 0;
};

}  // namespace

using Matrix = Eigen::SparseMatrix<double>;

struct Cholesky::Data {
  Work* done = nullptr;  // of the owner; null: not counted
  std::optional<Analysis> analysis;
  std::optional<Fronts<double>> fronts;
  std::optional<Fronts<float>> single_fronts;
  // Of all supernodes. An exact factor takes the place of a rough one before it.
  Room factor;
  TriangularSolves<double> solves;
  bool factorised = false;
  bool only_single = false;  // the factor is a rough one
  // What single precision is for: not yet tried, good enough, or not.
  enum class Single { untried, good, bad };
  Single copy_is = Single::untried;   // of the last exact factor
  Single rough_is = Single::untried;  // of rough factorisations
  // Of rough factorisations that fail: the first is yet to be verified, was right, or was wrong.
  enum class Failure { unverified, right, wrong } failure_is = Failure::unverified;
  Room copy;  // of an exact factor, in single precision
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
  d.fronts.reset();
  d.single_fronts.reset();
  d.analysis.reset();
  d.analysis.emplace(matrix, order);
}

bool Cholesky::factorise(const Matrix& matrix, const StopInside& stop, Precision precision) {
  const FactorTime time(data_->done);
  Data& d = *data_;
  d.factorised = d.only_single = false;
  const size_t entries = d.analysis->nodes().entries();
  const auto& sorted = d.analysis->in_order(matrix);
  using Failure = Data::Failure;
  const bool rough = precision == Precision::rough && d.rough_is != Data::Single::bad &&
                     d.failure_is != Failure::wrong;
  bool failed = false;
  if (rough) {
    d.count();
    if (!d.single_fronts) d.single_fronts.emplace(d.analysis->nodes());
    d.factor.of<double>(entries);  // with room for the exact one that may follow
    failed = !d.single_fronts->factorise(sorted, d.factor.numbers<float>(), d.threads(), stop);
    if (failed && d.failure_is == Failure::right) return false;
    d.factorised = d.only_single = !failed && single_will_do(matrix);
    if (d.factorised) return true;
  }
  d.count();
  if (!d.fronts) d.fronts.emplace(d.analysis->nodes());
  d.factorised = d.fronts->factorise(sorted, d.factor.of<double>(entries), d.threads(), stop);
  if (failed)
    d.failure_is = d.factorised ? Failure::wrong : Failure::right;
  else if (d.factorised && d.failure_is == Failure::right)
    d.failure_is = Failure::unverified;
  if (d.factorised) d.copy_is = Data::Single::untried;
  return d.factorised;
}

bool Cholesky::is_positive_definite(const Matrix& matrix, const StopInside& stop) {
  const FactorTime time(data_->done);
  Data& d = *data_;
  d.count();
  if (!d.fronts) d.fronts.emplace(d.analysis->nodes());
  return d.fronts->factorise(d.analysis->in_order(matrix), nullptr, d.threads(), stop);
}

// Asked of the first rough factor: one step of iterative refinement, whose residual is in double
// precision, tells the error of a solve.
bool Cholesky::single_will_do(const Matrix& matrix) {
  Data& d = *data_;
  if (d.rough_is == Data::Single::untried) {
    const Eigen::VectorXd b = generic_vector(matrix.cols());
    Eigen::VectorXd x(b.size()), error(b.size());
    d.only_single = true;
    solve(b.data(), x.data(), 1);
    const Eigen::VectorXd left = b - matrix.selfadjointView<Eigen::Lower>() * x;
    solve(left.data(), error.data(), 1);
    d.only_single = false;
    d.rough_is =
        error.norm() < largest_of_rough * x.norm() ? Data::Single::good : Data::Single::bad;
  }
  return d.rough_is == Data::Single::good;
}

void Cholesky::solve(const double* b, double* x, int columns) {
  Data& d = *data_;
  if (d.done) ++d.done->counts.solves;
  if (d.only_single)
    d.single_solves.solve(d.analysis->nodes(), d.factor.numbers<float>(), b, x, columns,
                          d.threads());
  else
    d.solves.solve(d.analysis->nodes(), d.factor.numbers<double>(), b, x, columns, d.threads());
}

void Cholesky::precondition(const double* b, double* x, int columns) {
  Data& d = *data_;
  if (d.only_single || d.copy_is == Data::Single::bad) return solve(b, x, columns);
  const bool untried = d.copy_is == Data::Single::untried;
  const auto size = Eigen::Index{d.analysis->nodes().unknowns()} * columns;
  Eigen::VectorXd exact;
  if (untried) {
    exact.resize(size);
    solve(b, exact.data(), columns);
    copy_to_single();
  }
  if (d.done) ++d.done->counts.solves;
  d.single_solves.solve(d.analysis->nodes(), d.copy.numbers<float>(), b, x, columns, d.threads());
  if (!untried) return;
  const Eigen::Map<Eigen::VectorXd> single(x, size);
  d.copy_is = (single - exact).norm() < largest_of_copy * exact.norm() ? Data::Single::good
                                                                       : Data::Single::bad;
  if (d.copy_is == Data::Single::bad) std::copy_n(exact.data(), size, x);
}

void Cholesky::copy_to_single() {
  Data& d = *data_;
  const size_t count = d.analysis->nodes().entries(), part = size_t{1} << 20;
  float* single = d.copy.of<float>(count);
  in_parallel(d.threads(), static_cast<int>((count + part - 1) / part), [&](int p) {
    const size_t first = index(p) * part, size = std::min(part, count - first);
    const double* from = d.factor.numbers<double>() + first;
    std::transform(from, from + size, single + first,
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
