#include "reference_fem/distributed_solver.h"

#include <algorithm>
#include <petscmat.h>
#include <stdexcept>
#include <vector>

namespace vasorod::fem {
namespace {

void check(PetscErrorCode code) {
  if (code != 0) throw std::runtime_error("PETSc refused with its error " + std::to_string(code));
}

class Mumps final : public LinearSolver::Method {
 public:
  explicit Mumps(const Processes& processes) : processes_(processes) {}
  ~Mumps() override {
    VecScatterDestroy(&gather_);
    VecDestroy(&whole_);
    VecDestroy(&right_);
    VecDestroy(&left_);
    MatDestroy(&factor_);
    MatDestroy(&matrix_);
  }

  bool factor(const Sparse& matrix, bool symmetric, int multipliers,
              LinearSolver::Fallback) override {
    if (matrix_ == nullptr) create(matrix);
    check(MatZeroEntries(matrix_));
    for (int j = 0; j < matrix.outerSize(); ++j) {
      const int begin = matrix.outerIndexPtr()[j], count = matrix.outerIndexPtr()[j + 1] - begin;
      check(MatSetValues(matrix_, count, matrix.innerIndexPtr() + begin, 1, &j,
                         matrix.valuePtr() + begin, ADD_VALUES));
    }
    check(MatAssemblyBegin(matrix_, MAT_FINAL_ASSEMBLY));
    check(MatAssemblyEnd(matrix_, MAT_FINAL_ASSEMBLY));
    MatDestroy(&factor_);
    check(MatGetFactor(matrix_, MATSOLVERMUMPS, symmetric ? MAT_FACTOR_CHOLESKY : MAT_FACTOR_LU,
                       &factor_));
    check(MatMumpsSetIcntl(factor_, 13,
                           1));  // no ScaLAPACK at the root, or its pivots are not counted
    check(MatMumpsSetIcntl(factor_, 14, 60));  // per cent of extra memory for fill-in by pivoting
    MatFactorInfo info;
    check(MatFactorInfoInitialize(&info));
    IS rows = nullptr, columns = nullptr;
    check(MatGetOrdering(matrix_, MATORDERINGEXTERNAL, &rows, &columns));
    if (symmetric) {
      check(MatSetOption(matrix_, MAT_SYMMETRIC, PETSC_TRUE));
      check(MatCholeskyFactorSymbolic(factor_, matrix_, rows, &info));
      check(MatCholeskyFactorNumeric(factor_, matrix_, &info));
    } else {
      check(MatSetOption(matrix_, MAT_SYMMETRIC, PETSC_FALSE));
      check(MatLUFactorSymbolic(factor_, matrix_, rows, columns, &info));
      check(MatLUFactorNumeric(factor_, matrix_, &info));
    }
    ISDestroy(&rows);
    ISDestroy(&columns);
    MatFactorError error = MAT_FACTOR_NOERROR;
    check(MatFactorGetError(factor_, &error));
    definite_ = false;
    if (error != MAT_FACTOR_NOERROR) return false;
    if (symmetric) {
      PetscInt negative = 0;
      check(MatGetInertia(factor_, &negative, nullptr, nullptr));
      definite_ = negative == multipliers;
    }
    return true;
  }

  bool positive_definite() const override { return definite_; }

  Eigen::VectorXd solve(const Eigen::VectorXd& right) const override {
    PetscInt begin = 0, end = 0;
    check(VecGetOwnershipRange(right_, &begin, &end));
    PetscScalar* values = nullptr;
    check(VecGetArray(right_, &values));
    for (PetscInt i = begin; i < end; ++i) values[i - begin] = right[i];
    check(VecRestoreArray(right_, &values));
    check(MatSolve(factor_, right_, left_));
    check(VecScatterBegin(gather_, left_, whole_, INSERT_VALUES, SCATTER_FORWARD));
    check(VecScatterEnd(gather_, left_, whole_, INSERT_VALUES, SCATTER_FORWARD));
    const PetscScalar* all = nullptr;
    check(VecGetArrayRead(whole_, &all));
    Eigen::VectorXd out = Eigen::Map<const Eigen::VectorXd>(all, right.size());
    check(VecRestoreArrayRead(whole_, &all));
    return out;
  }

  double factor_nonzeros() const override {
    PetscInt entries = 0;
    check(MatMumpsGetInfog(factor_, 29, &entries));
    return entries < 0 ? -1e6 * entries : entries;  // negative: in millions
  }

 private:
  void create(const Sparse& matrix) {
    const auto n = static_cast<PetscInt>(matrix.rows());
    check(MatCreate(PETSC_COMM_WORLD, &matrix_));
    check(MatSetSizes(matrix_, PETSC_DECIDE, PETSC_DECIDE, n, n));
    check(MatSetType(matrix_, MATMPIAIJ));
    // Reserves the sum of the processes' entries in a row: too much where entries are shared, never
    // too little.
    Eigen::VectorXd entries = Eigen::VectorXd::Zero(n);
    for (Eigen::Index k = 0; k < matrix.nonZeros(); ++k) entries[matrix.innerIndexPtr()[k]] += 1;
    processes_.sum(entries.data(), static_cast<std::size_t>(n));
    PetscInt begin = 0, end = 0;
    check(MatSetUp(matrix_));
    check(MatGetOwnershipRange(matrix_, &begin, &end));
    std::vector<PetscInt> here, elsewhere;
    for (PetscInt i = begin; i < end; ++i) {
      const auto room = static_cast<PetscInt>(entries[i]);
      here.push_back(std::min(room, end - begin));
      elsewhere.push_back(std::min(room, n - (end - begin)));
    }
    check(MatMPIAIJSetPreallocation(matrix_, 0, here.data(), 0, elsewhere.data()));
    check(MatSetOption(matrix_, MAT_ROW_ORIENTED, PETSC_FALSE));
    check(MatCreateVecs(matrix_, &right_, &left_));
    check(VecScatterCreateToAll(left_, &gather_, &whole_));
  }

  Processes processes_;
  Mat matrix_ = nullptr, factor_ = nullptr;
  Vec right_ = nullptr, left_ = nullptr, whole_ = nullptr;
  VecScatter gather_ = nullptr;
  bool definite_ = false;
};

}  // namespace

std::unique_ptr<LinearSolver::Method> distributed_method(const Processes& processes) {
  return std::make_unique<Mumps>(processes);
}

}  // namespace vasorod::fem
