#include "paper/paper_minimiser.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vasorod {
namespace {

using Eigen::VectorXd;

Eigen::Map<const Points> points_of(const VectorXd& x) {
  return {x.data(), x.size() / 3, 3};
}
Eigen::Map<Points> points_of(VectorXd& x) {
  return {x.data(), x.size() / 3, 3};
}

constexpr int iterations_per_hessian = 15;

// A spring resists only along its edge. Averaged over all directions of the edge's change this is a
// third of the bound 2 k_s I, and L-BFGS does not need a bound. On tubes, shares of 1/2 and 1/4
// take up to a tenth more iterations, and the full bound takes half as many again.
constexpr double spring_share = 1.0 / 3;

}  // namespace

// The unknowns are displacements from the carried points: paper_energy_gradient_at().
VectorXd PaperMinimiser::displacements(const Points& p) const {
  VectorXd x(p.size());
  points_of(x) = p - system_.carried;
  return x;
}

void PaperMinimiser::factorise(const Points& p, const StopInside& stop) {
  ++work_.counts.hessians;
  if (without_contacts_.rows() == 0)
    without_contacts_ = paper_energy_constant(system_, spring_share);
  const Eigen::SparseMatrix<double> matrix = paper_energy_bound(system_, without_contacts_, p);
  largest_diagonal_ = matrix.diagonal().maxCoeff();
  pairs_.clear();
  if (!constant_.factorise(matrix, stop))
    throw std::runtime_error("the surface's constant matrix is not positive definite");
}

// Of a step on which no guarded surface passes through itself.
double PaperMinimiser::longest_share(const VectorXd& x, const VectorXd& direction) const {
  double share = 1;
  const Points from = system_.carried + points_of(x), to = from + points_of(direction);
  for (const PaperBlock& block : system_.blocks)
    if (block.guard)
      share = std::min(share, block.guard->longest_step(from.middleRows(block.first, block.count),
                                                        to.middleRows(block.first, block.count)));
  return share;
}

double PaperMinimiser::evaluate(const VectorXd& x, VectorXd& gradient, double& residual) {
  const double energy = paper_energy_gradient_at(system_, points_of(x), terms_).total();
  auto g = points_of(gradient);
  // Squared norms, accumulated in one sweep.
  Vec3 binding = Vec3::Zero(), bending = Vec3::Zero(), stretching = Vec3::Zero();
  for (Eigen::Index i = 0; i < g.rows(); ++i)
    for (int c = 0; c < 3; ++c) {
      const double a = terms_.binding(i, c), b = terms_.bending(i, c), d = terms_.stretching(i, c);
      binding[c] += a * a;
      bending[c] += b * b;
      stretching[c] += d * d;
      g(i, c) = a + b + d;
    }
  double all = std::sqrt(binding.sum()) + std::sqrt(bending.sum()) + std::sqrt(stretching.sum());
  if (!system_.joins.empty()) {
    g += terms_.joining;
    all += terms_.joining.norm();
  }
  if (!system_.contacts.empty() || system_.guarded()) {
    g += terms_.contact;
    all += terms_.contact.norm();
  }
  for (int i = 0; i < g.rows(); ++i)
    if (system_.fixed[static_cast<size_t>(i)]) g.row(i).setZero();
  const double rounding = 4 * std::numeric_limits<double>::epsilon() * largest_diagonal_ *
                          (system_.carried + points_of(x)).norm();
  const double net = g.norm();
  residual = net <= rounding ? 0 : net / all;
  return energy;
}

double PaperMinimiser::counted(const VectorXd& x, VectorXd& gradient, double& residual) {
  ++work_.counts.gradients;
  return evaluate(x, gradient, residual);
}

Eigen::SparseMatrix<double> PaperMinimiser::hessian_at(const Points& p, double blend) {
  ++work_.counts.hessians;
  return paper_energy_hessian(system_, p, blend);
}

void PaperMinimiser::precondition(KeptFactor& factor, const VectorXd& gradient,
                                  VectorXd& direction) {
  columns_ = points_of(gradient);
  solution_.resize(columns_.rows(), 3);
  factor.precondition(columns_.data(), solution_.data(), 3);
  points_of(direction) = solution_;
}

bool PaperMinimiser::factorise_hessian(const Points& p, double& blend, int& factorisations,
                                       const StopInside& stop) {
  for (;; blend = blend == 0 ? 0.02 : std::min(1.0, 3 * blend)) {
    const Eigen::SparseMatrix<double> hessian = hessian_at(p, blend);
    hessian_.analyse(hessian, 3);
    ++factorisations;
    if (hessian_.factorise(hessian, stop)) return true;
    if (blend >= 1) return false;
  }
}

PaperMinimiserSummary PaperMinimiser::minimise(Points& p, const PaperMinimiserOptions& options) {
  PaperMinimiserSummary summary;
  VectorXd x = displacements(p);
  const Evaluation evaluation = [this](const VectorXd& at, VectorXd& gradient, double& residual) {
    return counted(at, gradient, residual);
  };
  LbfgsOptions inner;
  inner.tolerance = options.tolerance;
  inner.stop = summary.counting(options.stop);
  if (system_.guarded())
    inner.longest_share = [this](const VectorXd& at, const VectorXd& direction) {
      return longest_share(at, direction);
    };
  const auto take = [&](const LbfgsSummary& stage) {
    summary.add(stage);
    p = system_.carried + points_of(x);
  };
  const Preconditioner by_constant = [this](const VectorXd& gradient, VectorXd& direction) {
    precondition(constant_, gradient, direction);
  };
  const Preconditioner by_hessian = [this](const VectorXd& gradient, VectorXd& direction) {
    hessian_.solve(gradient.data(), direction.data(), 1);
  };
  const auto unfinished = [&] {
    return summary.status == LbfgsStatus::slow || summary.status == LbfgsStatus::stalled ||
           summary.status == LbfgsStatus::iteration_limit;
  };
  if (options.reuse_hessian && hessian_.factorised()) {
    inner.max_iterations = std::min(iterations_per_hessian, options.max_iterations);
    inner.patience = iterations_per_hessian / 2;
    take(lbfgs(evaluation, by_hessian, x, inner));
  }
  if (unfinished() && summary.iterations < options.max_iterations) {
    inner.max_iterations = options.max_iterations - summary.iterations;
    inner.patience = options.max_factorisations > 0 ? options.patience : 0;
    inner.pairs = &pairs_;  // between two factors only multipliers and contact planes change
    take(lbfgs(evaluation, by_constant, x, inner));
    inner.pairs = nullptr;
  }
  inner.patience = 0;
  double blend = 0;
  int stalls = 0;
  while (unfinished() && stalls < 2 && summary.factorisations < options.max_factorisations &&
         summary.iterations < options.max_iterations) {
    if (options.before && options.before(p)) {
      summary.status = LbfgsStatus::interrupted;
      break;
    }
    try {
      if (!factorise_hessian(p, blend, summary.factorisations, options.stop_inside)) break;
    } catch (const Interruption&) {
      summary.status = LbfgsStatus::interrupted;
      break;
    }
    inner.max_iterations =
        std::min(iterations_per_hessian, options.max_iterations - summary.iterations);
    take(lbfgs(evaluation, by_hessian, x, inner));
    stalls = summary.status == LbfgsStatus::stalled ? stalls + 1 : 0;
    blend = blend < 0.03 ? 0 : blend / 3;
  }
  if (summary.status == LbfgsStatus::slow) summary.status = LbfgsStatus::iteration_limit;
  return summary;
}

void PaperMinimiser::local_global_step(Points& p) {
  VectorXd x = displacements(p), gradient(x.size()), direction(x.size());
  double ignored = 0;
  counted(x, gradient, ignored);
  ++work_.counts.hessians;
  if (!bound_.factorise(paper_energy_bound(system_, p)))
    throw std::runtime_error("the surface's constant matrix is not positive definite");
  precondition(bound_, gradient, direction);
  x -= direction;
  p = system_.carried + points_of(x);
}

double PaperMinimiser::residual(const Points& p) {
  const VectorXd x = displacements(p);
  VectorXd gradient(x.size());
  double value = 0;
  evaluate(x, gradient, value);
  return value;
}

bool PaperMinimiser::stable(const Points& p, const StopInside& stop) {
  const Eigen::SparseMatrix<double> hessian = hessian_at(p, 0);
  hessian_.analyse(hessian, 3);
  return hessian_.factorise(hessian, stop);
}

}  // namespace vasorod
