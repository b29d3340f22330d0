// The outer loop of the `paper` surface solve: minimise, update the multipliers of seams and
// contacts, find the closest features again; repeat until gaps are closed, nothing penetrates and
// forces balance. Bodies become unknowns when they are moved, joined or touched.
#include "paper/paper_solver.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <vasorod/error.h>

#include "bodies/body_contacts.h"
#include "bodies/scaled_bodies.h"
#include "bodies/seam.h"
#include "bodies/unmet_criteria.h"
#include "data/sentence.h"
#include "paper/paper_minimiser.h"
#include "paper/paper_report.h"

namespace vasorod {
namespace {

// A rough minimum is sufficient while the multipliers still change.
constexpr double first_tolerance = 1e-4;
constexpr double tolerance_step = 0.1;
constexpr int settling_iterations = 15, most_settling = 25;
constexpr double finest_tolerance = 1e-12;
// Seconds between two calls of PaperOptions::keep: the report that it needs costs a few iterations.
constexpr double between_kept = 1;

class PaperRun {
 public:
  PaperRun(const BodyProblem& problem, const PaperOptions& options, KeptFactor& bound, Work& work)
      : problem_(problem),
        options_(options),
        bound_(bound),
        work_(work),
        stop_(options),
        scaled_(scale_bodies(problem)),
        contacts_(problem, scaled_, options.contact_stiffness) {
    check_seams(problem.seams, scaled_);
    check_contacts(problem);
    seam_multipliers_.assign(problem.seams.size(), Vec3::Zero());
    for (ScaledBody& body : scaled_.bodies) body.modelled = body.moved;
    for (const SeamPair& seam : problem.seams)
      for (const int b : {seam.body_a, seam.body_b})
        this->body(b).modelled = !this->body(b).obstacle;
    seam_radius_ = mouth_radius(problem.seams, scaled_);
  }

  SurfaceSolution run() {
    if (std::any_of(scaled_.bodies.begin(), scaled_.bodies.end(),
                    [](const ScaledBody& b) { return b.modelled; })) {
      try {
        iterate();
      } catch (const Interruption&) {
        interrupt();
      }
    } else {
      solution_.status = Status::converged;
    }
    report_paper(problem_, scaled_, system_, first_, positions_, stacked_, contacts_, solution_);
    solution_.seam_radius = seam_radius_ * scaled_.length;
    solution_.work = work_so_far();
    return std::move(solution_);
  }

 private:
  Work work_so_far() const {
    Work work = work_;
    work.counts.outer = solution_.outer_iterations;
    return work;
  }

  ScaledBody& body(int index) { return scaled_.bodies[static_cast<size_t>(index)]; }

  void build() {
    system_ = {};
    first_.assign(scaled_.bodies.size(), -1);
    for (size_t b = 0; b < scaled_.bodies.size(); ++b) {
      const ScaledBody& mine = scaled_.bodies[b];
      if (!mine.modelled) continue;
      first_[b] = system_.vertex_count();
      append_body(system_, mine.rest, mine.carried, mine.rotations, mine.k, mine.fixed);
    }
    system_.k_j = joining_stiffness(problem_.seams, scaled_, options_.seam_stiffness);
    system_.joins = stacked_joins(problem_.seams, first_, seam_multipliers_);
    stack_contacts();
    minimiser_ = std::make_unique<PaperMinimiser>(system_, bound_, work_);
    positions_.resize(system_.vertex_count(), 3);
    for (size_t b = 0; b < scaled_.bodies.size(); ++b)
      if (first_[b] >= 0)
        positions_.middleRows(first_[b], scaled_.bodies[b].now.rows()) = scaled_.bodies[b].now;
  }

  void stack_contacts() {
    stacked_ = contacts_.stacked(scaled_, first_);
    system_.contacts = stacked_.points;
  }

  void unstack() {
    for (size_t b = 0; b < scaled_.bodies.size(); ++b)
      if (first_[b] >= 0)
        scaled_.bodies[b].now = positions_.middleRows(first_[b], scaled_.bodies[b].now.rows());
  }

  bool stop(int iteration, double residual) const {
    return stop_({solution_.outer_iterations, solution_.iterations + iteration, residual});
  }

  void interrupt() {
    solution_.status = Status::interrupted;
    solution_.residual = minimiser_->residual(positions_);
  }

  // Before a factorisation: whether to stop; if not, the state is kept.
  bool before_factorisation() {
    if (stop_()) {
      interrupt();
      return true;
    }
    if (options_.step) options_.step("factorisation");
    if (!options_.keep || stop_.seconds() < kept_at_ + between_kept) return false;
    unstack();
    SurfaceSolution state = solution_;
    state.status = Status::interrupted;
    state.residual = minimiser_->residual(positions_);
    report_paper(problem_, scaled_, system_, first_, positions_, stacked_, contacts_, state, false);
    state.seam_radius = seam_radius_ * scaled_.length;
    state.work = work_so_far();
    options_.keep(std::move(state));
    kept_at_ = stop_.seconds();
    return false;
  }

  void iterate() {
    build();
    if (before_factorisation()) return;
    minimiser_->factorise(positions_, inside_);
    PaperMinimiserOptions inner;
    inner.max_iterations = options_.max_iterations;
    inner.max_factorisations = options_.max_factorisations;
    inner.stop = [this](int iteration, double, double residual) {
      return stop(iteration, residual);
    };
    inner.stop_inside = inside_;
    inner.before = [this](const Points&) { return before_factorisation(); };
    const bool constrained = !problem_.seams.empty() || !problem_.contacts.empty();
    double tolerance =
        constrained ? std::max(first_tolerance, options_.tolerance) : options_.tolerance;
    int settling_outers = 0;
    bool held = false;
    ContactState contact;
    for (solution_.outer_iterations = 1;; ++solution_.outer_iterations) {
      inner.tolerance = tolerance;
      // While contacts still open and close, the constant matrix, which includes them, is
      // factorised again before the minimum is refined. If the contacts have not settled after
      // that, the true Hessian is used.
      const bool pressing = contacts_.pressing(),
                 settling = pressing && settling_outers < most_settling;
      settling_outers += settling ? 1 : 0;
      inner.max_iterations = settling ? settling_iterations : options_.max_iterations;
      inner.reuse_hessian = !pressing || (held && !contact.pressed_changed);
      inner.patience = pressing && !settling ? 1 : options_.patience;
      const PaperMinimiserSummary summary = minimiser_->minimise(positions_, inner);
      solution_.iterations += summary.iterations;
      solution_.residual = summary.residual;
      unstack();
      if (summary.status == LbfgsStatus::interrupted) {
        solution_.status = Status::interrupted;
        return;
      }
      const bool at_rest = summary.residual <= options_.tolerance;
      const double seam_gap = largest_gap(system_.joins, positions_);
      const bool seam_closed = seam_gap <= options_.seam_tolerance * seam_radius_;
      if (!held && solution_.outer_iterations >= options_.hold_after) {
        contacts_.hold();
        held = true;
      }
      contact = contacts_.refresh(scaled_);
      const bool pressed_right = is_settled(contact, options_);
      const double imbalance = worst_balance(sum_forces(scaled_, system_, first_, positions_));
      const bool balanced = imbalance <= options_.balance_tolerance;
      if (at_rest && seam_closed && pressed_right && (balanced || tolerance <= finest_tolerance)) {
        const bool asked = options_.certify;
        solution_.smallest_curvature_positive = asked && minimiser_->stable(positions_, inside_);
        if (contact.slip > 0)
          solution_.notes.push_back(
              "the set of walls in contact did not settle until they stuck: " +
              std::string("forces along them of up to ") + number_text(contact.slip, 2) +
              " of the pressure are left");
        solution_.status =
            asked && !solution_.smallest_curvature_positive ? Status::unstable : Status::converged;
        return;
      }
      if (solution_.outer_iterations >= options_.max_outer) {
        solution_.status = Status::iteration_limit;
        UnmetCriteria unmet;
        unmet.require("residual", summary.residual, options_.tolerance);
        if (!seam_closed)
          unmet.require("seam gap over the mouth's radius", seam_gap / seam_radius_,
                        options_.seam_tolerance);
        require_contact(contact, options_, unmet);
        unmet.require("imbalance of a vessel's forces", imbalance, options_.balance_tolerance);
        solution_.notes.push_back(unmet.sentence(
            "after " + std::to_string(solution_.outer_iterations) + " multiplier updates"));
        return;
      }
      if (!seam_closed) {
        update_join_multipliers(system_.k_j, system_.joins, positions_);
        for (size_t i = 0; i < system_.joins.size(); ++i)
          seam_multipliers_[i] = system_.joins[i].multiplier;
      }
      // Rough minima while features and multipliers still change much; then the tolerance is
      // reduced step by step to the requested one.
      const double least =
          seam_closed && pressed_right && at_rest ? finest_tolerance : options_.tolerance;
      if (summary.residual <= tolerance) tolerance = std::max(least, tolerance * tolerance_step);
      if (!contact.touched.empty()) {
        for (const int b : contact.touched) body(b).modelled = true;
        build();
        if (before_factorisation()) return;
        minimiser_->factorise(positions_, inside_);
      } else {
        stack_contacts();
        if (!contact.pressed_changed) continue;
        if (before_factorisation()) return;
        minimiser_->factorise(positions_, inside_);
      }
    }
  }

  const BodyProblem& problem_;
  const PaperOptions& options_;
  KeptFactor& bound_;
  Work& work_;
  StopCheck stop_;
  StopInside inside_ = [this] { return stop_(); };
  ScaledBodies scaled_;
  BodyContacts contacts_;
  std::vector<Vec3> seam_multipliers_;
  double seam_radius_ = 0;
  double kept_at_ = -between_kept;  // when the state was last kept, seconds since the start
  PaperSystem system_;
  std::unique_ptr<PaperMinimiser> minimiser_;
  StackedContacts stacked_;
  std::vector<int> first_;  // of each body in the stack, -1: not among the unknowns
  Points positions_;        // the stack
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
      bound_(std::make_unique<KeptFactor>(work_.get())) {
  if (const auto fault = options_.is_invalid()) throw InputError("options of paper: " + *fault);
}
PaperSolver::~PaperSolver() = default;

SurfaceSolution PaperSolver::solve(const BodyProblem& problem) {
  *work_ = {};
  return PaperRun(problem, options_, *bound_, *work_).run();
}

SurfaceSolution solve_paper(const BodyProblem& problem, const PaperOptions& options) {
  return PaperSolver(options).solve(problem);
}

}  // namespace vasorod
