#include "surface/lbfgs.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <vector>

namespace vasorod {
namespace {

using Eigen::VectorXd;

struct Pair {
  VectorXd step, change;  // s = x_new - x, y = gradient_new - gradient
  double inverse_product = 0;
};

constexpr double armijo = 1e-4;
constexpr int most_backtracks = 30;

// The two-loop recursion: direction = -H gradient.
void descend(const std::deque<Pair>& pairs, const Preconditioner& precondition, const VectorXd& gradient,
             VectorXd& work, VectorXd& direction) {
  work = gradient;
  std::vector<double> alpha(pairs.size());
  for (size_t k = pairs.size(); k-- > 0;) {
    alpha[k] = pairs[k].inverse_product * pairs[k].step.dot(work);
    work -= alpha[k] * pairs[k].change;
  }
  precondition(work, direction);
  for (size_t k = 0; k < pairs.size(); ++k) {
    const double beta = pairs[k].inverse_product * pairs[k].change.dot(direction);
    direction += (alpha[k] - beta) * pairs[k].step;
  }
  direction = -direction;
}

}  // namespace

std::string to_string(LbfgsStatus status) {
  switch (status) {
    case LbfgsStatus::converged:
      return "converged";
    case LbfgsStatus::iteration_limit:
      return "iteration_limit";
    case LbfgsStatus::slow:
      return "slow";
    case LbfgsStatus::stalled:
      return "stalled";
    case LbfgsStatus::interrupted:
      return "interrupted";
  }
  return "";
}

LbfgsSummary lbfgs(const Evaluation& evaluate, const Preconditioner& precondition, VectorXd& x,
                   const LbfgsOptions& options) {
  LbfgsSummary summary;
  VectorXd gradient(x.size()), new_gradient(x.size()), new_x(x.size()), direction(x.size()), work(x.size());
  std::deque<Pair> pairs;
  double energy = evaluate(x, gradient, summary.residual);
  summary.evaluations = 1;
  std::vector<double> residuals{summary.residual};
  const auto finish = [&](LbfgsStatus status) {
    summary.status = status;
    summary.energy = energy;
    return summary;
  };
  while (true) {
    if (summary.residual <= options.tolerance) return finish(LbfgsStatus::converged);
    if (summary.iterations >= options.max_iterations) return finish(LbfgsStatus::iteration_limit);
    if (options.keep_going && !options.keep_going(summary.iterations, energy, summary.residual))
      return finish(LbfgsStatus::interrupted);
    if (options.patience > 0 && summary.iterations >= options.patience &&
        summary.residual > 0.1 * residuals[residuals.size() - 1 - static_cast<size_t>(options.patience)])
      return finish(LbfgsStatus::slow);

    descend(pairs, precondition, gradient, work, direction);
    double slope = gradient.dot(direction);
    if (!(slope < 0) && !pairs.empty()) {
      pairs.clear();
      descend(pairs, precondition, gradient, work, direction);
      slope = gradient.dot(direction);
    }
    if (!(slope < 0)) return finish(LbfgsStatus::stalled);

    if (const double longest = direction.cwiseAbs().maxCoeff();
        options.largest_step > 0 && longest > options.largest_step) {
      direction *= options.largest_step / longest;
      slope *= options.largest_step / longest;
    }
    // Near the minimum the decrease drowns in the sum's last digits: there a smaller residual at the same
    // energy counts.
    const double rounding = 1e-14 * std::abs(energy);
    double step = 1, new_energy = 0, new_residual = 0;
    bool accepted = false;
    for (int k = 0; k < most_backtracks && !accepted; ++k) {
      new_x = x + step * direction;
      new_energy = evaluate(new_x, new_gradient, new_residual);
      ++summary.evaluations;
      accepted = std::isfinite(new_energy) && std::isfinite(new_residual) &&
                 (new_energy < energy + armijo * step * slope ||
                  (new_energy <= energy + rounding && new_residual < summary.residual));
      if (accepted) break;
      const double curvature = 2 * (new_energy - energy - step * slope) / (step * step);
      const double minimum = std::isfinite(curvature) && curvature > 0 ? -slope / curvature : 0;
      step = std::clamp(minimum, 0.1 * step, 0.5 * step);
    }
    if (!accepted) {
      if (pairs.empty()) return finish(LbfgsStatus::stalled);
      pairs.clear();
      continue;
    }

    if (options.memory > 0) {
      Pair pair{new_x - x, new_gradient - gradient, 0};
      const double product = pair.step.dot(pair.change);
      if (product > 1e-12 * pair.step.norm() * pair.change.norm()) {
        pair.inverse_product = 1 / product;
        pairs.push_back(std::move(pair));
        if (static_cast<int>(pairs.size()) > options.memory) pairs.pop_front();
      }
    }
    std::swap(x, new_x);
    std::swap(gradient, new_gradient);
    energy = new_energy;
    summary.residual = new_residual;
    residuals.push_back(new_residual);
    ++summary.iterations;
  }
}

void StagedSummary::add(const LbfgsSummary& stage) {
  status = stage.status;
  iterations += stage.iterations;
  energy = stage.energy;
  residual = stage.residual;
}

std::function<bool(int, double, double)> StagedSummary::counting(
    const std::function<bool(int, double, double)>& keep_going) const {
  if (!keep_going) return {};
  return [this, keep_going](int iteration, double at, double left) {
    return keep_going(iterations + iteration, at, left);
  };
}

}  // namespace vasorod
