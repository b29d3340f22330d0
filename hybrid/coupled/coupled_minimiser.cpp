#include "coupled/coupled_minimiser.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "numerics/generic_vector.h"
#include "numerics/sparse_sum.h"
#include "numerics/within_pattern.h"

namespace vasorod {
namespace {

using Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;

constexpr double first_shift = 1e-3, shift_growth = 5, largest_shift = 1e10;
// A factorisation at a residual below this value is valid for the minimum.
constexpr double near_enough = 1e-4;
constexpr double worn_order = 1.3;
constexpr int most_per_hessian = 30;  // even where it converges well
// What a Hessian and its factor cost, in iterations. A start that slides along a valley of the
// energy gains more by steps with the one at hand.
constexpr double worth_of_hessian = 10;
// After this many points of negative curvature, the branch that the short steps follow no longer
// exists.
constexpr int patience_on_branch = 3;
// The residual at which a start is smooth enough for the true Hessian. On the way to it the
// iterations for a tenfold reduction with K0, and with one convex Hessian, and the most of these.
constexpr double smooth_enough = 1e-2;
constexpr int patience_with_rest = 20, per_convex = 6, most_convex = 12;
constexpr int inverse_iterations = 12;
constexpr int halvings_of_prediction = 4;
// Negative curvature below this fraction of the rest Hessian's curvature in the same direction is
// rounding.
constexpr double neutral_curvature = 1e-6;
// Forces below `rounding` times stiffness times coordinates are cancellation errors, unless they
// exceed `share_of_load` times the load.
constexpr double rounding = 1e-14, share_of_load = 1e-2;

}  // namespace

CoupledMinimiser::CoupledMinimiser(CoupledSystem& system, Work& work)
    : system_(system),
      work_(work),
      turns_(system.groups(), system.unknowns()),
      rest_factor_(&work),
      factor_(&work) {
  renew_rest();
}

void CoupledMinimiser::renew_rest() {
  ++work_.counts.hessians;
  system_.rest_hessian().swap(rest_);
  weigh(rest_);
}

// Sets the scale of the forces.
void CoupledMinimiser::weigh(const Matrix& rest) {
  double sum = 0;
  int count = 0;
  for (const CoupledWall& wall : system_.walls())
    for (int i = 0; i < 3 * wall.energy->vertices(); ++i)
      if (const int u = wall.unknown[static_cast<size_t>(i)]; u >= 0) {
        sum += rest.coeff(u, u);
        ++count;
      }
  mean_stiffness_ = count > 0 ? sum / count : 1;
}

// Of a modulus G that grows, the minimum z is nearly a line in 1/G: with g the gradient of what was
// raised, dz = (1/G' - 1/G) dz/d(1/G) = -H^-1 g G / G', H being the Hessian before.
void CoupledMinimiser::follow_stiffer(VectorXd& z, double growth) {
  ++work_.counts.hessians;
  weigh(system_.rest_hessian());
  if (!factor_.factorised()) return;
  VectorXd g, step(z.size());
  double ignored = 0;
  const double before = counted(z, g, ignored);
  factor_.solve(g.data(), step.data(), 1);
  step *= -1 / growth;
  if (!step.allFinite() || (system_.guarded() && system_.longest_share(z, step) < 1)) return;
  for (int k = 0; k < halvings_of_prediction; ++k, step /= 2)
    if (counted(z + step, g, ignored) < before) {
      z += step;
      return;
    }
}

void CoupledMinimiser::set_turns(GroupTurns turns) {
  turns_ = std::move(turns);
}

void CoupledMinimiser::find_order() {
  if (!order_.empty()) return;
  // Only the pattern counts, which is that of any z.
  std::vector<ContactPoint> contacts = std::exchange(system_.contacts, {});
  const Matrix free =
      sparse_sum(rest_, system_.meeting_hessian(VectorXd::Zero(system_.unknowns())));
  system_.contacts = std::move(contacts);
  order_ = elimination_order(free, system_.groups(), Ordering::cheaper, &work_);
}

// The pattern changes with the contacts that press: fewer need no new analysis. An elimination
// order is reused until its fill becomes too large.
void CoupledMinimiser::analyse(Cholesky& factor, const Matrix& matrix, const Breaks& breaks) {
  if (order_.empty() && without_contacts_) {
    breaks.before("ordering");
    find_order();
  }
  if (!order_.empty()) {
    factor.analyse(matrix, order_);
    const double nonzeros = factor.factor_nonzeros();
    if (order_nonzeros_ == 0) order_nonzeros_ = nonzeros;
    if (nonzeros < worn_order * order_nonzeros_) return;
  }
  breaks.before("ordering");
  order_ = elimination_order(matrix, system_.groups(), Ordering::cheaper, &work_);
  factor.analyse(matrix, order_);
  order_nonzeros_ = factor.factor_nonzeros();
}

bool CoupledMinimiser::factorise_rest(const Breaks& breaks) {
  if (!rest_factor_.analysed()) analyse(rest_factor_, rest_, breaks);
  breaks.before("factorisation at rest");
  Matrix shifted = rest_;
  double shift = 0;
  // Mechanisms that only a motion or a load would excite make K0 singular to rounding. Walls many
  // times thicker than their triangles are high may make it negative, which no shift mends.
  while (!rest_factor_.factorise(shifted, breaks.inside)) {
    shift = shift == 0 ? 1e-10 : 10 * shift;
    if (shift > largest_shift || !(mean_stiffness_ > 0)) return false;
    shifted = rest_;
    for (int i = 0; i < shifted.cols(); ++i) shifted.coeffRef(i, i) += shift * mean_stiffness_;
  }
  return true;
}

double CoupledMinimiser::rounding_of_forces(const VectorXd& z) const {
  const double forces = rounding * mean_stiffness_ * z.norm(), load = system_.largest_load();
  return load > 0 ? std::min(forces, share_of_load * load) : forces;
}

bool CoupledMinimiser::load_is_hidden(const VectorXd& z) const {
  const double load = system_.largest_load();
  return load > 0 && load <= rounding * mean_stiffness_ * z.norm();
}

double CoupledMinimiser::evaluate(const VectorXd& z, VectorXd& g, double& residual) const {
  const CoupledTerms terms = system_.gradient(z, g);
  const double force = std::sqrt(2 * mean_stiffness_ * std::max(0.0, terms.wall));
  const double size = g.norm();
  if (size <= rounding_of_forces(z))
    residual = 0;
  else
    residual = force > 0 ? size / force : 1;
  return terms.total();
}

double CoupledMinimiser::counted(const VectorXd& z, VectorXd& g, double& residual) {
  ++work_.counts.gradients;
  return evaluate(z, g, residual);
}

double CoupledMinimiser::residual(const VectorXd& z) {
  VectorXd g;
  double r = 0;
  evaluate(z, g, r);
  return r;
}

void CoupledMinimiser::by_rest(const VectorXd& g, VectorXd& direction) {
  turned_ = g;
  apply(turns_, true, turned_);
  rest_factor_.precondition(turned_.data(), direction.data(), 1);
  apply(turns_, false, direction);
}

// Factorises H or, if Cholesky fails, H + shift D K0 D^T with the smallest shift of a geometric
// sequence for which it succeeds.
bool CoupledMinimiser::factorise(const VectorXd& z, Factor factor, double& shift,
                                 int& factorisations, int most, const Breaks& breaks) {
  const Precision precision = factor == Factor::rough ? Precision::rough : Precision::exact;
  breaks.before("Hessian");
  ++work_.counts.hessians;
  worn_ = false;
  pairs_.clear();
  system_.hessian(z).swap(hessian_);
  match_pattern(hessian_, breaks);
  metric_.resize(0, 0);
  Matrix shifted;
  for (;;) {
    breaks.before("factorisation");
    ++factorisations;
    if (shift == 0) {
      if (factor == Factor::unless_positive ? factor_.is_positive_definite(hessian_, breaks.inside)
                                            : factor_.factorise(hessian_, breaks.inside, precision))
        return true;
    } else {
      if (metric_.size() == 0) {
        metric_ = rest_;
        turn_matrix(turns_, metric_);
        for (int i = 0; i < metric_.cols(); ++i) metric_.coeffRef(i, i) += 1e-6 * mean_stiffness_;
        shifted = hessian_;
      }
      add_within(hessian_, shift, metric_, shifted);
      if (factor_.factorise(shifted, breaks.inside, precision)) return true;
    }
    shift = shift == 0 ? first_shift : shift_growth * shift;
    if (shift > largest_shift || factorisations >= most) return false;
  }
}

// K0 in the present frames, which neither a stress nor a curvature of the start can make
// indefinite, with what seams, ties and contacts add to it.
bool CoupledMinimiser::factorise_turned_rest(const VectorXd& z, const Breaks& breaks) {
  breaks.before("Hessian at rest");
  Matrix turned = rest_;
  turn_matrix(turns_, turned);
  sparse_sum(turned, system_.meeting_hessian(z)).swap(turned);
  return factorise_as_analysed(turned, Precision::exact, breaks);
}

bool CoupledMinimiser::factorise_convex(const VectorXd& z, Precision precision,
                                        const Breaks& breaks) {
  breaks.before("Hessian");
  ++work_.counts.hessians;
  Matrix convex = system_.hessian(z, SecondDerivatives::convex);
  return factorise_as_analysed(convex, precision, breaks);
}

// Factorises a positive definite matrix.
bool CoupledMinimiser::factorise_as_analysed(Matrix& matrix, Precision precision,
                                             const Breaks& breaks) {
  pairs_.clear();
  match_pattern(matrix, breaks);
  breaks.before("factorisation");
  return factor_.factorise(matrix, breaks.inside, precision);
}

// Gives the matrix the analysed pattern, or analyses its own where it has more entries.
void CoupledMinimiser::match_pattern(Matrix& matrix, const Breaks& breaks) {
  if (pad(analysed_, matrix)) return;
  analyse(factor_, matrix, breaks);
  analysed_ = matrix;
}

// Leaves an equilibrium whose Hessian H is not positive definite. Inverse iteration with the
// shifted factor finds the direction in which v.H v is most negative relative to v.K0 v. The line
// search along v continues as long as the energy falls.
CoupledMinimiser::Saddle CoupledMinimiser::leave_saddle(VectorXd& z) {
  VectorXd v = generic_vector(z.size()), next(z.size());
  for (int k = 0; k < inverse_iterations; ++k) {
    next = metric_.selfadjointView<Eigen::Lower>() * v;
    factor_.solve(next.data(), v.data(), 1);
    v.normalize();
  }
  v.normalize();
  const VectorXd hv = hessian_.selfadjointView<Eigen::Lower>() * v;
  const double stiffness = v.dot(metric_.selfadjointView<Eigen::Lower>() * v);
  if (v.dot(hv) > -neutral_curvature * stiffness) return Saddle::neutral;
  VectorXd g;
  double ignored = 0;
  const double energy = counted(z, g, ignored);
  if (g.dot(v) > 0) v = -v;
  double best = energy, best_step = 0;
  // Steps in mean edges, from one too small to see to one that changes the shape of a section.
  for (double step = 1e-3 / v.cwiseAbs().maxCoeff(); step < 3 / v.cwiseAbs().maxCoeff();
       step *= 2) {
    if (system_.guarded() && system_.longest_share(z, step * v) < 1) break;
    const double at = counted(z + step * v, g, ignored);
    if (!(at < best)) break;
    best = at;
    best_step = step;
  }
  z += best_step * v;
  return best_step > 0 ? Saddle::left : Saddle::kept;
}

CoupledMinimiserSummary CoupledMinimiser::minimise(VectorXd& z,
                                                   const CoupledMinimiserOptions& options) {
  CoupledMinimiserSummary summary;
  try {
    const auto before = [&](const std::string& step) {
      if (options.before && options.before(step, z)) throw Interruption{};
    };
    run(z, options, {before, options.stop_inside}, summary);
  } catch (const Interruption&) {
    summary.status = LbfgsStatus::interrupted;
    summary.residual = residual(z);
  }
  return summary;
}

void CoupledMinimiser::run(VectorXd& z, const CoupledMinimiserOptions& options,
                           const Breaks& breaks, CoupledMinimiserSummary& summary) {
  const Evaluation evaluation = [this](const VectorXd& at, VectorXd& g, double& r) {
    return counted(at, g, r);
  };
  LbfgsOptions inner;
  inner.largest_step = options.largest_step;
  inner.by_slopes = options.by_slopes;
  inner.stop = summary.counting(options.stop);
  if (system_.guarded())
    inner.longest_share = [this](const VectorXd& at, const VectorXd& direction) {
      return system_.longest_share(at, direction);
    };
  const Preconditioner rest = [this](const VectorXd& g, VectorXd& d) { by_rest(g, d); };
  const Preconditioner hessian = [this](const VectorXd& g, VectorXd& d) {
    factor_.precondition(g.data(), d.data(), 1);
  };
  const auto interrupted = [&] { return summary.status == LbfgsStatus::interrupted; };
  if (options.use_rest) {
    if (!rest_factor_.factorised() && !factorise_rest(breaks)) {
      summary.unfactorised = true;
      summary.status = LbfgsStatus::iteration_limit;
      summary.residual = residual(z);
      return;
    }
    inner.tolerance = std::max(options.rough, options.tolerance);
    inner.patience = options.rest_patience;
    inner.max_iterations = options.max_iterations;
    summary.add(lbfgs(evaluation, rest, z, inner));
    summary.rest_iterations = summary.iterations;
    if (interrupted() || (!options.certify && summary.residual <= options.tolerance)) return;
  }
  inner.worth = worth_of_hessian;
  inner.pairs = &pairs_;
  const Precision far = options.rough_factors ? Precision::rough : Precision::exact;
  for (int k = 0; options.start != Roughness::near && k < most_convex; ++k) {
    const bool by_rest = k == 0 && options.start == Roughness::rough;
    ++summary.factorisations;
    if (!(by_rest ? factorise_turned_rest(z, breaks) : factorise_convex(z, far, breaks))) break;
    inner.tolerance = std::max(smooth_enough, options.tolerance);
    inner.patience = by_rest ? patience_with_rest : per_convex;
    inner.max_iterations = options.max_iterations - summary.iterations;
    summary.add(lbfgs(evaluation, hessian, z, inner));
    if (interrupted()) return;
    if (summary.status != LbfgsStatus::slow) break;
  }
  inner.patience = 0;
  inner.tolerance = options.tolerance;
  VectorXd gradient;
  double shift = 0, factored_at = 1;
  // Each convex factor but the first took the place of a Hessian that would have needed a shift.
  int stalls = 0, indefinite = 0, shifted = std::max(0, summary.factorisations - 1);
  bool fresh = false;  // factor_ is unshifted and belongs to a point near z
  // As long as one Hessian makes the residual fall tenfold within `per_hessian` iterations, or they
  // gain much of the energy, it is cheaper to go on with it than to factorise another.
  const auto go_on_with_it = [&](bool convex) {
    const int most = options.max_iterations - summary.iterations;
    inner.max_iterations = std::min(convex ? most_per_hessian : options.per_hessian, most);
    inner.patience = convex ? options.per_hessian : 0;
  };
  if (options.reuse_hessian && factor_.factorised() && !worn_) {
    go_on_with_it(true);
    summary.add(lbfgs(evaluation, hessian, z, inner));
    worn_ = options.rough_factors && summary.iterations > worth_of_hessian;
    if (interrupted() || (!options.certify && summary.residual <= options.tolerance)) return;
  }
  while (summary.factorisations < options.max_factorisations && shifted < options.max_shifted &&
         summary.iterations < options.max_iterations) {
    const bool closing = options.follow && options.follow(z);
    counted(z, gradient, factored_at);
    // Far from the minimum a factor is no certificate, only a preconditioner.
    const bool exact = !options.rough_factors || stalls > 0 || factored_at <= near_enough;
    const bool at_rest =
        factored_at <= options.tolerance || (stalls > 0 && factored_at < near_enough);
    if (at_rest) shift = 0;  // the verdict is on the Hessian itself
    // A branch goes on from its minimum with the factor there, an operation ends.
    const bool verdict =
        options.rough_factors && options.certify && factored_at <= options.tolerance;
    const Factor factor = verdict ? Factor::unless_positive : exact ? Factor::exact : Factor::rough;
    const int so_far = summary.factorisations;
    const int most =
        so_far + std::min(options.max_factorisations - so_far, options.max_shifted - shifted);
    if (!factorise(z, factor, shift, summary.factorisations, most, breaks)) {
      summary.unfactorised = true;
      summary.residual = factored_at;
      break;
    }
    fresh = shift == 0;
    if (fresh && verdict) {
      summary.positive = true;
      summary.status = LbfgsStatus::converged;
      summary.residual = factored_at;
      return;
    }
    if (!fresh) shifted += summary.factorisations - so_far;
    if (!fresh && options.release_step && ++indefinite > patience_on_branch) inner.largest_step = 0;
    if (closing && !(inner.largest_step > 0 && inner.largest_step < options.closing_step))
      inner.largest_step = options.closing_step;
    if (at_rest && !fresh) {
      const Saddle saddle = leave_saddle(z);
      if (saddle != Saddle::left) {
        summary.neutral = saddle == Saddle::neutral;
        summary.residual = factored_at;
        return;
      }
      summary.left_saddle = true;
      stalls = 0;
      continue;
    }
    // Walls that close are looked for before each Hessian, which must not be far apart then.
    go_on_with_it(fresh && !closing);
    summary.add(lbfgs(evaluation, hessian, z, inner));
    if (interrupted()) return;
    if (summary.status == LbfgsStatus::converged ||
        (summary.status == LbfgsStatus::stalled && at_rest)) {
      if (fresh && (factored_at <= near_enough || !options.certify)) {
        summary.positive = exact;
        return;
      }
      if (!options.certify) return;
    }
    stalls = summary.status == LbfgsStatus::stalled ? stalls + 1 : 0;
    if (stalls > 2) return;
    shift = shift <= first_shift ? 0 : shift / options.release_shift;
  }
  if (summary.status != LbfgsStatus::converged && summary.status != LbfgsStatus::stalled)
    summary.status = LbfgsStatus::iteration_limit;
}

}  // namespace vasorod
