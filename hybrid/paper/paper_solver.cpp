// The outer loop of the `paper` surface solve: minimise, update the multipliers of seams and
// contacts, find the closest features again; repeat until gaps are closed, nothing penetrates and
// forces balance. Bodies become unknowns when they are moved, joined or touched.
#include "paper/paper_solver.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include <vasorod/error.h>

#include "bodies/late_contacts.h"
#include "bodies/unmet_criteria.h"
#include "data/sentence.h"
#include "paper/paper_closing.h"
#include "paper/paper_report.h"
#include "paper/paper_stack.h"

namespace vasorod {
namespace {

// A rough minimum is sufficient while the multipliers still change.
constexpr double first_tolerance = 1e-3;
constexpr double tolerance_step = 0.1;
constexpr int settling_iterations = 10, most_settling = 25;
constexpr double finest_tolerance = 1e-12;
// Seconds between two calls of PaperOptions::keep: the report that it needs costs a few iterations.
constexpr double between_kept = 1;

class PaperRun {
 public:
  PaperRun(const BodyProblem& problem, const PaperWay* way, const PaperOptions& options,
           KeptFactor& bound, Work& work)
      : way_(way),
        options_(options),
        work_(work),
        stop_(options),
        stack_(problem, options, bound, work) {}

  SurfaceSolution run() {
    if (stack_.any_modelled()) {
      try {
        if (!way_ || go_along(*way_)) iterate();
      } catch (const Interruption&) {
        interrupt();
      }
    } else {
      solution_.status = Status::converged;
    }
    report(solution_, true);
    return std::move(solution_);
  }

 private:
  void report(SurfaceSolution& solution, bool final) {
    report_paper(stack_.problem, stack_.scaled, stack_.system, stack_.first, stack_.positions,
                 stack_.stacked, *stack_.contacts, solution, final);
    solution.seam_radius = stack_.seam_radius * stack_.scaled.length;
    solution.work = work_;
    solution.work.counts.outer = solution.outer_iterations;
  }

  bool stop(int iteration, double residual) const {
    return stop_({solution_.outer_iterations, solution_.iterations + iteration, residual});
  }

  void interrupt() {
    solution_.status = Status::interrupted;
    solution_.residual = stack_.minimiser->residual(stack_.positions);
  }

  // Before a factorisation: whether to stop; if not, the state is kept.
  bool before_factorisation() {
    if (stop_()) {
      interrupt();
      return true;
    }
    if (options_.step) options_.step("factorisation");
    if (!options_.keep || stop_.seconds() < kept_at_ + between_kept) return false;
    stack_.unstack();
    SurfaceSolution state = solution_;
    state.status = Status::interrupted;
    state.residual = stack_.minimiser->residual(stack_.positions);
    report(state, false);
    options_.keep(std::move(state));
    kept_at_ = stop_.seconds();
    return false;
  }

  PaperMinimiserOptions inner_options() {
    PaperMinimiserOptions inner;
    inner.max_iterations = options_.max_iterations;
    inner.max_factorisations = options_.max_factorisations;
    inner.stop = [this](int iteration, double, double residual) {
      return stop(iteration, residual);
    };
    inner.stop_inside = inside_;
    inner.before = [this](const Points&) { return before_factorisation(); };
    return inner;
  }

  void count(const PaperMinimiserSummary& summary) {
    solution_.iterations += summary.iterations;
    solution_.residual = summary.residual;
    if (summary.status == LbfgsStatus::interrupted) solution_.status = Status::interrupted;
  }

  // From rest to the seam. False: it ends there.
  bool go_along(const PaperWay& way) {
    PaperClosing closing(stack_, way, inner_options(), [this](const PaperMinimiserSummary& step) {
      ++solution_.outer_iterations;
      count(step);
    });
    solution_.status = closing.run();
    solution_.notes.push_back(closing.note());
    return solution_.status == Status::converged;
  }

  void iterate() {
    if (!way_) stack_.build();
    if (before_factorisation()) return;
    stack_.minimiser->factorise(stack_.positions, inside_);
    PaperMinimiserOptions inner = inner_options();
    const bool constrained = !stack_.problem.seams.empty() || !stack_.problem.contacts.empty();
    double tolerance =
        constrained ? std::max(first_tolerance, options_.tolerance) : options_.tolerance;
    int settling_outers = 0;
    LateContacts late(LateContacts::patience_with_held(options_.hold_after));
    bool held = false;
    ContactState contact;
    for (int outer = 1;; ++outer) {
      ++solution_.outer_iterations;
      inner.tolerance = tolerance;
      // While contacts still open and close, the constant matrix, which includes them, is
      // factorised again before the minimum is refined. If the contacts have not settled after
      // that, the true Hessian is used.
      const bool pressing = stack_.contacts->pressing(),
                 settling = pressing && settling_outers < most_settling;
      settling_outers += settling ? 1 : 0;
      inner.max_iterations = settling ? settling_iterations : options_.max_iterations;
      inner.reuse_hessian = !pressing || (held && !contact.pressed_changed);
      inner.patience = pressing && !settling ? 1 : options_.patience;
      const PaperMinimiserSummary summary = stack_.minimiser->minimise(stack_.positions, inner);
      count(summary);
      stack_.unstack();
      if (summary.status == LbfgsStatus::interrupted) return;
      const bool at_rest = summary.residual <= options_.tolerance;
      const double seam_gap = stack_.largest_seam_gap();
      const bool seam_closed = seam_gap <= options_.seam_tolerance * stack_.seam_radius;
      if (!held && outer >= options_.hold_after) {
        stack_.contacts->hold();
        held = true;
      }
      const bool search = late.search(outer);
      contact =
          search ? stack_.contacts->refresh(stack_.scaled) : stack_.contacts->update(stack_.scaled);
      const bool pressed_right =
          is_settled(contact, options_, late.is_late(outer) ? LateContacts::slackness : 1);
      const double imbalance =
          worst_balance(sum_forces(stack_.scaled, stack_.system, stack_.first, stack_.positions));
      const bool balanced = imbalance <= options_.balance_tolerance;
      if (at_rest && seam_closed && pressed_right && (balanced || tolerance <= finest_tolerance) &&
          stays_settled(search, contact)) {
        conclude(contact);
        return;
      }
      if (outer >= options_.max_outer) {
        solution_.status = Status::iteration_limit;
        UnmetCriteria unmet;
        unmet.require("residual", summary.residual, options_.tolerance);
        if (!seam_closed)
          unmet.require("seam gap over the mouth's radius", seam_gap / stack_.seam_radius,
                        options_.seam_tolerance);
        require_contact(contact, options_, unmet);
        unmet.require("imbalance of a vessel's forces", imbalance, options_.balance_tolerance);
        solution_.notes.push_back(
            unmet.sentence("after " + std::to_string(outer) + " multiplier updates"));
        return;
      }
      if (!seam_closed) stack_.update_seams();
      // The slowest pattern of pressures goes on to its limit, unless others press now.
      if (!contact.pressed_changed && summary.residual <= tolerance) stack_.contacts->extrapolate();
      // Rough minima while features and multipliers still change much; then the tolerance is
      // reduced step by step to the requested one.
      const double least =
          seam_closed && pressed_right && at_rest ? finest_tolerance : options_.tolerance;
      if (summary.residual <= tolerance) tolerance = std::max(least, tolerance * tolerance_step);
      if (!contact.touched.empty()) {
        stack_.add(contact.touched);
      } else {
        stack_.stack_contacts();
        if (!contact.pressed_changed && !stack_.system.guarded()) continue;
      }
      if (before_factorisation()) return;
      stack_.minimiser->factorise(stack_.positions, inside_);
    }
  }

  // Contacts that were not searched are, for the last time.
  bool stays_settled(bool searched, ContactState& contact) {
    late_overlap_.reset();
    if (searched) return true;
    const ContactState last = stack_.contacts->refresh(stack_.scaled);
    contact.pressed_changed |= last.pressed_changed;
    contact.touched = last.touched;
    late_overlap_ = last.penetration;
    return last.touched.empty() && last.penetration <= LateContacts::largest_overlap;
  }

  // The minimum that was found.
  void conclude(const ContactState& contact) {
    const bool asked = options_.certify;
    solution_.smallest_curvature_positive =
        asked && stack_.minimiser->stable(stack_.positions, inside_);
    if (contact.slip > 0)
      solution_.notes.push_back(
          "the set of walls in contact did not settle until they stuck: forces along them of up "
          "to " +
          number_text(contact.slip, 2) + " of the pressure are left");
    if (!is_settled(contact, options_))
      solution_.notes.push_back(LateContacts::note(late_overlap_));
    solution_.status =
        asked && !solution_.smallest_curvature_positive ? Status::unstable : Status::converged;
  }

  const PaperWay* way_;
  const PaperOptions& options_;
  const Work& work_;
  StopCheck stop_;
  StopInside inside_ = [this] { return stop_(); };
  PaperStack stack_;
  std::optional<double> late_overlap_;  // in mean edges
  double kept_at_ = -between_kept;      // when the state was last kept, seconds since the start
  SurfaceSolution solution_;
};

}  // namespace

std::optional<std::string> PaperOptions::is_invalid() const {
  if (auto fault = SurfaceOptions::is_invalid()) return fault;
  return first_fault({{patience >= 1, "patience: expected at least 1"},
                      {hold_after >= 1, "hold_after: expected at least 1"}});
}

PaperSolver::PaperSolver(PaperOptions options)
    : options_(std::move(options)),
      work_(std::make_unique<Work>()),
      // Only directions come from it.
      bound_(std::make_unique<KeptFactor>(work_.get(), Precision::rough)) {
  if (const auto fault = options_.is_invalid()) throw InputError("options of paper: " + *fault);
}
PaperSolver::~PaperSolver() = default;

SurfaceSolution PaperSolver::solve(const BodyProblem& problem, const PaperWay* way) {
  *work_ = {};
  return PaperRun(problem, way, options_, *bound_, *work_).run();
}

SurfaceSolution solve_paper(const BodyProblem& problem, const PaperOptions& options) {
  return PaperSolver(options).solve(problem);
}

}  // namespace vasorod
