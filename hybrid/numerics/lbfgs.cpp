#include "numerics/lbfgs.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "data/index.h"
#include "data/sentence.h"

namespace vasorod {
namespace {

using Eigen::VectorXd;

constexpr double armijo = 1e-4;
constexpr int most_backtracks = 30;
// Fractions of the energy below which the decrease of a step may be lost to rounding. `last_digits`
// is the rounding of the sum itself. `cancelled` applies where large forces cancel in a small
// energy. In both cases the residual decides: it must fall, in the second case to less than half.
constexpr double last_digits = 1e-14, cancelled = 1e-8;
// The rounding of a sum of many terms: changes below it are noise. There the energy would let steps
// through that overshoot, and the residual falls on the shortest steps, so flattens() decides.
constexpr double many_terms = 1e-12;
// The residual has come to its own rounding where so many steps in that noise did not lower it by a
// tenth, or none of a run did.
constexpr int most_idle = 20;
constexpr double falls = 0.9;
// The fraction that may be lost with LbfgsOptions::by_slopes.
constexpr double lost_to_stiffness = 1e-5;

// Whether a step along a line has come to where the line is flatter than at its beginning, or is 1
// and still leads down: no step goes beyond that of a Newton iteration.
bool flattens(double step, double slope, double first) {
  constexpr double flatter = 0.9;
  return std::abs(slope) <= flatter * std::abs(first) || (step == 1 && slope < 0);
}

// The point of least residual, within a tenth, among those whose energies differ by noise.
struct BestInNoise {
  VectorXd x;  // empty: the last step was not in the noise
  double energy = 0, residual = 0;
  int idle = 0;  // steps since then

  void take(const VectorXd& at, double its_energy, double its_residual) {
    if (x.size() > 0 && its_residual > falls * residual) {
      ++idle;
      return;
    }
    x = at;
    energy = its_energy;
    residual = its_residual;
    idle = 0;
  }
};

// Steps along a line to where it flattens, by regula falsi; the first is 1.
class SlopeSearch {
 public:
  explicit SlopeSearch(double slope) : first_(slope), slope_below_(slope) {}

  double step() const { return step_; }

  /// Takes the slope at step(). False: there is another step.
  bool ends(double slope) {
    if (flattens(step_, slope, first_)) return true;
    if (slope < 0) {
      below_ = step_;
      slope_below_ = slope;
    } else {
      above_ = step_;
      slope_above_ = slope;
    }
    const double zero = slope_below_ / (slope_below_ - slope_above_);
    step_ = below_ + (above_ - below_) * (std::isfinite(zero) ? std::clamp(zero, 0.1, 0.9) : 0.1);
    return false;
  }

 private:
  double first_, step_ = 1, below_ = 0, slope_below_, above_ = 1, slope_above_ = 0;
};

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
  VectorXd gradient(x.size()), new_gradient(x.size()), new_x(x.size()), direction(x.size()),
      work(x.size());
  LbfgsPairs own;
  LbfgsPairs& pairs = options.pairs ? *options.pairs : own;
  pairs.begin(x.size(), options.memory);
  double energy = evaluate(x, gradient, summary.residual);
  summary.evaluations = 1;
  std::vector<double> residuals{summary.residual}, energies{energy};
  BestInNoise best;
  const auto finish = [&](LbfgsStatus status) {
    const bool ended_early = status == LbfgsStatus::slow || status == LbfgsStatus::iteration_limit;
    const bool nothing_fell = best.idle > 0 && best.idle == summary.iterations;
    summary.status = ended_early && nothing_fell ? LbfgsStatus::stalled : status;
    summary.energy = energy;
    if (best.x.size() > 0 && best.residual < summary.residual) {
      x = best.x;
      summary.energy = best.energy;
      summary.residual = best.residual;
    }
    return summary;
  };
  const auto gains_little = [&] {
    const size_t before = residuals.size() - 1 - index(options.patience);
    if (summary.residual <= 0.1 * residuals[before]) return false;
    const double last = energies[before] - energy;
    return options.worth <= 0 || last <= last_digits * std::abs(energy) ||
           last / options.patience <
               (energies.front() - energy) / (summary.iterations + options.worth);
  };
  while (true) {
    if (summary.residual <= options.tolerance) return finish(LbfgsStatus::converged);
    if (summary.iterations >= options.max_iterations) return finish(LbfgsStatus::iteration_limit);
    if (options.stop && options.stop(summary.iterations, energy, summary.residual))
      return finish(LbfgsStatus::interrupted);
    if (best.idle >= most_idle) return finish(LbfgsStatus::stalled);
    if (options.patience > 0 && summary.iterations >= options.patience && gains_little())
      return finish(LbfgsStatus::slow);

    pairs.descend(precondition, gradient, work, direction);
    double slope = gradient.dot(direction);
    if (!(slope < 0) && !pairs.empty()) {
      pairs.clear();
      pairs.descend(precondition, gradient, work, direction);
      slope = gradient.dot(direction);
    }
    if (!(slope < 0)) return finish(LbfgsStatus::stalled);

    if (const double longest = direction.cwiseAbs().maxCoeff();
        options.largest_step > 0 && longest > options.largest_step) {
      direction *= options.largest_step / longest;
      slope *= options.largest_step / longest;
    }
    if (options.longest_share) {
      const double share = options.longest_share(x, direction);
      direction *= share;
      slope *= share;
    }
    double step = 1, new_energy = 0, new_residual = 0;
    bool accepted = false, lost = false;
    for (int k = 0; k < most_backtracks && !accepted; ++k) {
      new_x = x + step * direction;
      new_energy = evaluate(new_x, new_gradient, new_residual);
      ++summary.evaluations;
      const double change = new_energy - energy, size = std::abs(energy);
      lost = std::max(std::abs(change), -step * slope) <= many_terms * size;
      accepted = std::isfinite(new_energy) && std::isfinite(new_residual) &&
                 ((lost ? flattens(step, new_gradient.dot(direction), slope)
                        : change < armijo * step * slope) ||
                  (change <= last_digits * size && new_residual < summary.residual) ||
                  (std::max(change, -step * slope) <= cancelled * size &&
                   new_residual < 0.5 * summary.residual));
      if (accepted) break;
      const double curvature = 2 * (new_energy - energy - step * slope) / (step * step);
      const double minimum = std::isfinite(curvature) && curvature > 0 ? -slope / curvature : 0;
      step = std::clamp(minimum, 0.1 * step, 0.5 * step);
    }
    if (!accepted && pairs.empty() && options.by_slopes) {
      SlopeSearch search(slope);
      bool flatter = false;
      for (int k = 0; k < most_backtracks && !flatter; ++k) {
        step = search.step();
        new_x = x + step * direction;
        new_energy = evaluate(new_x, new_gradient, new_residual);
        ++summary.evaluations;
        flatter = search.ends(new_gradient.dot(direction));
      }
      const double change = std::max(new_energy - energy, -step * slope);
      lost = false;
      accepted =
          flatter && std::isfinite(new_residual) && change <= lost_to_stiffness * std::abs(energy);
    }
    if (!accepted) {
      if (pairs.empty()) return finish(LbfgsStatus::stalled);
      pairs.clear();
      continue;
    }

    if (lost) {
      if (best.x.size() == 0) best.take(x, energy, summary.residual);
      best.take(new_x, new_energy, new_residual);
    } else {
      best = {};
    }
    pairs.add(step, direction, gradient, new_gradient);
    std::swap(x, new_x);
    std::swap(gradient, new_gradient);
    energy = new_energy;
    summary.residual = new_residual;
    residuals.push_back(new_residual);
    energies.push_back(energy);
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
    const std::function<bool(int, double, double)>& stop) const {
  if (!stop) return {};
  return [this, stop](int iteration, double at, double left) {
    return stop(iterations + iteration, at, left);
  };
}

std::string LbfgsSummary::brief_report() const {
  return to_string(status) + ": residual " + number_text(residual) + " after " +
         std::to_string(iterations) + " iterations, " + std::to_string(evaluations) +
         " evaluations";
}

std::string StagedSummary::brief_report() const {
  return to_string(status) + ": residual " + number_text(residual) + " after " +
         std::to_string(iterations) + " iterations";
}

}  // namespace vasorod
