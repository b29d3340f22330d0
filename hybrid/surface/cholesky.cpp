#include "surface/cholesky.h"

#include <cholmod.h>

#include <stdexcept>
#include <vector>

#include "surface/blas.h"

namespace vasorod {

using Matrix = Eigen::SparseMatrix<double>;

struct Cholesky::Data {
  cholmod_common common{};
  cholmod_factor* factor = nullptr;
  cholmod_dense *solution = nullptr, *work = nullptr, *work_e = nullptr;
  bool factorised = false;

  Data() {
    cholmod_start(&common);
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.final_ll = 1;
    common.nmethods = 1;  // AMD alone: trying METIS costs more than it gains below some 300k vertices
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
    cholmod_finish(&common);
  }
  Data(const Data&) = delete;
  Data& operator=(const Data&) = delete;
};

namespace {

// CHOLMOD's view of an Eigen matrix; CHOLMOD does not write through it.
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

// The graph of the blocks: one row per block of unknowns.
Matrix block_graph(const Matrix& m, int block) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<size_t>(m.nonZeros() / (block * block) + m.cols()));
  for (int column = 0; column < m.cols(); column += block) {
    int last = -1;
    for (Matrix::InnerIterator it(m, column); it; ++it) {
      const int row = static_cast<int>(it.row()) / block;
      if (row != last) entries.emplace_back(row, column / block, 1.0);
      last = row;
    }
  }
  Matrix graph(m.rows() / block, m.cols() / block);
  graph.setFromTriplets(entries.begin(), entries.end());
  return graph;
}

}  // namespace

Cholesky::Cholesky() : data_(std::make_unique<Data>()) {}
Cholesky::~Cholesky() = default;
Cholesky::Cholesky(Cholesky&&) noexcept = default;
Cholesky& Cholesky::operator=(Cholesky&&) noexcept = default;

void Cholesky::analyse(const Matrix& matrix, int block) {
  const OneCholmodThread one_thread;
  Data& d = *data_;
  cholmod_free_factor(&d.factor, &d.common);
  d.factorised = false;
  cholmod_sparse view = view_of(matrix);
  if (block == 1) {
    d.common.method[0].ordering = CHOLMOD_AMD;
    d.factor = cholmod_analyze(&view, &d.common);
  } else {
    Matrix graph = block_graph(matrix, block);
    cholmod_sparse graph_view = view_of(graph);
    std::vector<int> order(static_cast<size_t>(graph.cols())), unknowns;
    if (!cholmod_amd(&graph_view, nullptr, 0, order.data(), &d.common))
      throw std::runtime_error("AMD failed");
    for (const int i : order)
      for (int k = 0; k < block; ++k) unknowns.push_back(block * i + k);
    d.common.method[0].ordering = CHOLMOD_GIVEN;
    d.factor = cholmod_analyze_p(&view, unknowns.data(), nullptr, 0, &d.common);
  }
  if (!d.factor) throw std::runtime_error("the sparse factorisation could not be analysed (out of memory)");
}

bool Cholesky::factorise(const Matrix& matrix) {
  const OneCholmodThread one_thread;
  Data& d = *data_;
  cholmod_sparse view = view_of(matrix);
  d.common.status = CHOLMOD_OK;
  cholmod_factorize(&view, d.factor, &d.common);
  if (d.common.status < CHOLMOD_OK) throw std::runtime_error("the sparse factorisation ran out of memory");
  d.factorised = d.common.status == CHOLMOD_OK && d.factor->minor == d.factor->n;
  return d.factorised;
}

void Cholesky::solve(const double* b, double* x, int columns) {
  const OneCholmodThread one_thread;
  Data& d = *data_;
  cholmod_dense rhs{};
  rhs.nrow = rhs.d = d.factor->n;
  rhs.ncol = static_cast<size_t>(columns);
  rhs.nzmax = rhs.nrow * rhs.ncol;
  rhs.x = const_cast<double*>(b);
  rhs.xtype = CHOLMOD_REAL;
  rhs.dtype = CHOLMOD_DOUBLE;
  if (!cholmod_solve2(CHOLMOD_A, d.factor, &rhs, nullptr, &d.solution, nullptr, &d.work, &d.work_e,
                      &d.common))
    throw std::runtime_error("the sparse solve ran out of memory");
  std::copy_n(static_cast<const double*>(d.solution->x), rhs.nzmax, x);
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
