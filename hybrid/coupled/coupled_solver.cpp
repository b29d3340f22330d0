// The outer loop of `coupled`: follow the path of motions and loads. At each time: minimise, update
// the multipliers of seams, soft sections and contacts, find the closest features again; repeat
// until gaps are closed, nothing penetrates and forces balance. Bodies become unknowns when they
// are moved, joined or touched.
#include <algorithm>

#include <vasorod/error.h>

#include "bodies/late_contacts.h"
#include "bodies/unmet_criteria.h"
#include "coupled/coupled_path.h"
#include "coupled/coupled_report.h"
#include "coupled/free_motions.h"
#include "coupled/path_steps.h"
#include "coupled/seam_closing.h"
#include "coupled/smooth_start.h"
#include "data/sentence.h"

namespace vasorod {
namespace {

using Eigen::VectorXd;

// A rough minimum is sufficient while the multipliers still change.
constexpr double first_tolerance = 1e-4;
constexpr double tolerance_step = 1e-2;
constexpr double finest_tolerance = 1e-13;
// After this many updates, contacts that still open and close are accepted at ten times their
// tolerance, with a note.
constexpr int patience_with_contact = 40;
// A stalled minimisation (no step lowers the energy) counts as limited by rounding if its residual
// is below this value.
constexpr double rounding_residual = 1e-6;
// Of the largest force of walls whose moduli lie too far apart, what rounding may leave out of
// balance.
constexpr double largest_rounding = 1e-3;
// A state on the path that is no result is only a start.
constexpr double passable_residual = 1e-5;
// This many consecutive minimisations without a minimum end the solve.
constexpr int most_failures = 3;
// A step of the path moves the wall against its rod by a few percent of the radius; a kink moves it
// much farther.
constexpr double jump = 0.2;
// On the path, Newton steps are bounded by this fraction of the radius. Otherwise a soft direction
// would cross the low energy barrier between a smooth and a kinked minimum.
constexpr double path_step = 0.02;
// Walls that an extrapolated start carries through themselves by more than this many mean edges
// would be crumpled on their way back: they start where they were.
constexpr double deepest_start = 0.1;
// Walls that are nearer to themselves than this many mean edges approach in bounded steps.
constexpr double closing_gap = 1;
// Where a seam opens a slit, steps of a fraction of an edge keep triangles from inverting, which
// the energy would not reverse.
constexpr double seam_step = 0.3;
// A start near a minimum takes a few factorisations, more where it has to slide along a contact.
// Where it needs more than this, or so many of Hessians that are not positive definite, another
// start is better.
constexpr int most_from_start = 35, most_shifted_from_start = 15;
// Wrinkles of walls that become stiffer rearrange in some thousand short steps.
constexpr int more_to_stiffen = 30;
// Least seconds between two calls of CoupledOptions::keep, and the largest share of the time that
// they may take: the report that each needs costs a few iterations.
constexpr double between_kept = 1, share_of_keeping = 0.01;

// A state to go on from.
bool is_equilibrium(Status status) {
  return status == Status::converged || status == Status::equilibrium_only ||
         status == Status::not_unique;
}

}  // namespace

class CoupledSolver::Data {
 public:
  Data(CoupledProblem problem, const CoupledOptions& options)
      : stack_(checked(std::move(problem), options), options), path_(stack_) {}

  CoupledStack& stack() { return stack_; }

  CoupledSolution solve() {
    stop_.emplace(stack_.options);
    keep_next_ = 0;
    solution_ = {};
    stack_.begin_solve();
    stiffening_ = false;
    start_is_ = Roughness::near;
    came_far_ = false;
    updates_before_ = 0;
    const Easing easing{stack_};
    if (stack_.any_modelled()) {
      follow_path();
    } else {
      solution_.status = Status::converged;
      solution_.smallest_curvature_positive = true;
      solution_.reached = 1;
    }
    if (solution_.status == Status::interrupted)  // perhaps in a patch
      solution_.surface.residual = stack_.minimiser->residual(stack_.z);
    report_coupled(stack_.problem, stack_.scaled, stack_.system.get(), stack_.first,
                   stack_.first_wall, stack_.z, stack_.stacked, *stack_.contacts, solution_);
    solution_.surface.seam_radius = stack_.seam_radius * stack_.scaled.length;
    solution_.surface.work = work_so_far();
    note_other_walls(solution_);
    return std::move(solution_);
  }

 private:
  // Whatever ends a solve, the walls are the scene's after it.
  struct Easing {
    CoupledStack& stack;
    ~Easing() { stack.end_easing(); }
  };

  static CoupledProblem checked(CoupledProblem problem, const CoupledOptions& options) {
    if (const auto fault = options.is_invalid()) throw InputError("options of coupled: " + *fault);
    check_contacts(problem.surfaces);
    if (problem.lets_out && !problem.start)
      throw InputError("walls to be let out: found no start, expected that of inflated walls");
    return problem;
  }

  Work work_so_far() const {
    Work work = stack_.work;
    work.counts.outer = solution_.surface.outer_iterations;
    return work;
  }

  bool stop(int iteration, double residual) const {
    return (*stop_)(
        {solution_.surface.outer_iterations, solution_.surface.iterations + iteration, residual});
  }

  // Before a long step at z: whether to stop; if not, the state is kept.
  bool before(const std::string& step, const VectorXd& z) {
    if ((*stop_)()) return true;
    if (stack_.options.step) stack_.options.step(step);
    const double began = stop_->seconds();
    // The forces of a patch are not those of the walls.
    if (!stack_.options.keep || began < keep_next_ || stack_.is_narrow()) return false;
    CoupledSolution state = solution_;
    state.status = Status::interrupted;
    state.surface.residual = stack_.minimiser->residual(z);
    state.smallest_curvature_positive = false;
    report_coupled(stack_.problem, stack_.scaled, stack_.system.get(), stack_.first,
                   stack_.first_wall, z, stack_.stacked, *stack_.contacts, state, false);
    state.surface.seam_radius = stack_.seam_radius * stack_.scaled.length;
    state.surface.work = work_so_far();
    note_other_walls(state);
    stack_.options.keep(std::move(state));
    const double ended = stop_->seconds();
    keep_next_ = ended + std::max(between_kept, (ended - began) / share_of_keeping);
    return false;
  }

  // On the way walls may be others than the scene's.
  void note_other_walls(CoupledSolution& state) const {
    if (stack_.is_inflated())
      state.notes.emplace_back(
          "the vessels are still inflated, by a pressure that is not the scene's");
    if (stack_.is_eased())
      state.notes.emplace_back("the walls' shear modulus is still lower than the scene's");
  }

  bool has_jumped(const Points& from) const {
    return from.rows() == stack_.system->vertex_count() &&
           (positions() - from).rowwise().norm().maxCoeff() > jump * stack_.ring_radius();
  }
  double imbalance() const {
    return worst_coupled_balance(stack_.scaled, *stack_.system, stack_.first_wall, stack_.z);
  }
  Points positions() const { return stack_.system->state(stack_.z).positions; }

  void follow_path() {
    stack_.ease();
    if (!stack_.system) stack_.build();
    path_.restart();
    stack_.set_inflation(1);
    bool buckled = false, crossed = false;
    const bool on_a_way = stack_.problem.seam_way.has_value();
    if (on_a_way && !close_seam(buckled)) return;
    PathSteps steps(stack_.problem.start ? std::vector<double>{1} : stack_.options.times);
    while (!steps.ended()) {
      const double t = steps.time();
      std::optional<CoupledPath::Kept> kept;  // from where a shorter step may be taken
      if (!on_a_way && solution_.reached > 0) kept = path_.keep();
      const bool stepped = !on_a_way && path_.advance(t);
      if (stepped && stack_.feels_itself() && stack_.follow(stack_.z) < -deepest_start) {
        path_.hold_back();
        stack_.follow(stack_.z);
      }
      if (stack_.problem.start) {
        path_.start_at_given();
        start_is_ = stack_.problem.start->roughness;
        if (stack_.problem.meet_up_to_seams && !part_walls()) return;
        if (stack_.problem.lets_out && !let_out()) return;
        stack_.search_contacts();
        came_far_ = start_is_ != Roughness::near;
        if (start_is_ == Roughness::smooth && !bring_near(crossed)) return;
        buckled = stack_.problem.start->buckled;
      }
      const Points predicted = positions();
      const size_t notes = solution_.notes.size();
      const bool possible = path_.is_possible();
      solution_.status = !possible ? Status::iteration_limit
                         : crossed ? settle_parted(t)
                                   : settle(t, stepped);
      // On the way a buckled pattern that creeps around its tube is near enough to go on from.
      const bool passable = possible && t < 1 && solution_.status == Status::iteration_limit &&
                            !stack_.contacts->pressing() &&
                            solution_.surface.residual <= passable_residual;
      if (!passable && !is_equilibrium(solution_.status)) {
        // Walls that crumple snap from one minimum to the next: shorter steps follow them.
        const bool shorter = kept && solution_.status == Status::iteration_limit &&
                             stack_.goes_on_in_shorter_steps() && steps.halve();
        const bool lost = kept && !path_.is_possible();
        if (shorter || lost) path_.take_back(*kept);
        if (lost && !shorter)
          solution_.notes.emplace_back(
              "walls would pass through themselves at the next step of the way: the state is the "
              "last one before it");
        if (!shorter) return;
        solution_.notes.resize(notes);
        continue;
      }
      buckled |= left_saddle_;
      buckled |= stepped && has_jumped(predicted);
      if (t < 1) solution_.notes.resize(notes);  // of a state on the way
      solution_.reached = t;
      steps.go_on();
    }
    if (!stiffen_walls(buckled)) return;
    if (solution_.status == Status::not_unique)
      solution_.notes.emplace_back(
          "a direction is left that costs nothing, as when wrinkles may turn about the axis: the "
          "result is one of many");
    if (buckled) {
      solution_.status = Status::buckled;
      solution_.notes.emplace_back(
          "the smooth branch from rest lost its stability on the way; the result is the minimum "
          "below it");
    }
  }

  // Takes eased walls to their own materials. False: no equilibrium was found on the way.
  bool stiffen_walls(bool& buckled) {
    while (stack_.is_eased()) {
      stiffening_ = true;
      stack_.stiffen();
      const Points expected = positions();
      solution_.notes.clear();  // of the softer walls
      solution_.status = settle(1, false);
      if (!is_equilibrium(solution_.status)) return false;
      buckled |= left_saddle_ || has_jumped(expected);
    }
    return true;
  }

  SeamClosing seam_closing() { return SeamClosing(stack_, path_, inner_options(true), counting()); }

  // Counts a minimisation outside settle().
  std::function<void(const CoupledMinimiserSummary&)> counting() {
    return [this](const CoupledMinimiserSummary& summary) {
      ++solution_.surface.outer_iterations;
      count(summary);
    };
  }

  // Ends a stage of the seam. False: the solve ends with it.
  bool goes_on(const SeamClosing& closing, Status status) {
    solution_.status = status;
    if (!closing.note().empty()) solution_.notes.push_back(closing.note());
    if (stack_.problem.lets_out) stack_.begin_stage();
    return status == Status::converged;
  }

  // Brings apart what lies in each other at the given start.
  bool part_walls() {
    stack_.unstack();
    SeamClosing closing = seam_closing();
    return goes_on(closing, closing.part());
  }

  // At a minimum near the start whose walls pass through each other no other one is looked for.
  Status settle_parted(double t) {
    came_far_ = false;
    stack_.problem.meet_up_to_seams = true;
    if (seam_closing().part_or_stay() == Status::interrupted) return Status::interrupted;
    stack_.search_contacts();
    return settle(t, false);
  }

  // False: the solve ends with it. `crossed`: its walls pass through each other.
  bool bring_near(bool& crossed) {
    if (stack_.problem.surfaces.seams.empty()) return true;
    SmoothStart start(stack_, path_, inner_options(false), counting());
    solution_.status = start.bring_near();
    if (start.is_near()) start_is_ = Roughness::near;
    crossed = start.is_crossed();
    updates_before_ = start.updates();
    return solution_.status == Status::converged;
  }

  bool let_out() {
    SeamClosing closing = seam_closing();
    return goes_on(closing, closing.let_out());
  }

  // Brings the seam together along its way, up to a rough state at time 1.
  bool close_seam(bool& buckled) {
    SeamClosing closing = seam_closing();
    const Status status = closing.run();
    solution_.reached = closing.reached();
    buckled |= closing.snapped();
    return goes_on(closing, status);
  }

  // Walls that fold, or are brought apart, at a seam.
  bool crumples() const { return stack_.problem.seam_way || stack_.problem.meet_up_to_seams; }
  // A given start should be near a minimum, where it is not to be brought apart first.
  bool is_near_start() const { return stack_.problem.start && !stack_.problem.meet_up_to_seams; }

  // `stepped`: the start was extrapolated along the path. The true Hessian stays on its branch
  // where the longer steps of K0 could leave it.
  CoupledMinimiserOptions inner_options(bool stepped) {
    CoupledMinimiserOptions inner;
    inner.max_iterations = stack_.options.max_iterations;
    inner.max_factorisations = stack_.options.max_factorisations;
    inner.stop = [this](int iteration, double, double residual) {
      return stop(iteration, residual);
    };
    inner.stop_inside = [this] { return (*stop_)(); };
    inner.rough_factors = !stack_.problem.surfaces.seams.empty();
    inner.before = [this](const std::string& step, const VectorXd& z) { return before(step, z); };
    if (stiffening_) {
      inner.by_slopes = true;
      inner.max_iterations *= more_to_stiffen;
      inner.max_factorisations *= more_to_stiffen;
    }
    if (stack_.feels_itself()) {
      inner.follow = [this](const VectorXd& z) { return stack_.follow(z) < closing_gap; };
      inner.closing_step = path_step * stack_.ring_radius();
    }
    if (crumples()) {  // as SeamClosing says
      inner.follow = {};
      inner.release_shift = SeamClosing::release_shift;
    }
    if (is_near_start()) {
      inner.max_factorisations = std::min(inner.max_factorisations, most_from_start);
      inner.max_shifted = most_shifted_from_start;
    }
    if (stepped) {
      inner.per_hessian = 3;
      inner.largest_step = path_step * stack_.ring_radius();
      inner.release_step = true;
    } else if (!stack_.problem.surfaces.seams.empty()) {
      inner.largest_step = seam_step;
    }
    return inner;
  }

  void name_hidden() {
    for (std::string& sentence : stack_.hidden_by_rounding())
      solution_.notes.push_back(std::move(sentence));
  }

  void count(const CoupledMinimiserSummary& summary) {
    solution_.surface.iterations += summary.iterations;
    solution_.rest_iterations += summary.rest_iterations;
    solution_.surface.residual = summary.residual;
    solution_.smallest_curvature_positive = summary.positive;
    left_saddle_ |= summary.left_saddle;
  }

  // Finds the minimum at the present time t.
  Status settle(double t, bool stepped) {
    left_saddle_ = false;
    const CoupledOptions& options = stack_.options;
    const BodyProblem& surfaces = stack_.problem.surfaces;
    CoupledMinimiserOptions inner = inner_options(stepped);
    const bool alone = surfaces.seams.empty() && !stack_.system->has_ties();
    // Multipliers between minimisations.
    bool updates = !alone || surfaces.may_meet() || stack_.contacts->pressing();
    double tolerance = updates ? std::max(first_tolerance, options.tolerance) : options.tolerance;
    int failures = 0;
    const bool crumples = options.hold_after > 0;
    LateContacts late(crumples ? LateContacts::patience_with_held(options.hold_after)
                               : patience_with_contact);
    const int before = crumples ? std::exchange(updates_before_, 0) : 0;
    CoupledStack::Placed best;  // the last minimum found
    for (int outer = 1;; ++outer) {
      ++solution_.surface.outer_iterations;
      inner.tolerance = tolerance;
      inner.start = Roughness::near;
      if (outer == 1 && (is_near_start() || !stack_.problem.start))
        inner.start = is_near_start() ? start_is_ : options.start;
      inner.use_rest = inner.start == Roughness::near && !stepped && alone && outer == 1 &&
                       stack_.system->contacts.empty();
      // What touches itself is looked for before a Hessian, so that each minimum begins with one.
      inner.reuse_hessian = outer > 1 && !(inner.follow && stack_.contacts->pressing());
      // Where multipliers still change, the minimum is certified when they are settled.
      inner.certify = options.certify && !updates && tolerance <= options.tolerance;
      CoupledMinimiserSummary summary = stack_.minimiser->minimise(stack_.z, inner);
      count(summary);
      const bool minimum = summary.status == LbfgsStatus::converged;
      const bool stalled =
          summary.status == LbfgsStatus::stalled && summary.residual <= rounding_residual;
      failures = minimum ? 0 : failures + 1;
      if (minimum || best.z.size() != stack_.z.size()) best = stack_.placed();
      if (failures > most_failures) stack_.place(best);
      stack_.unstack();
      if (summary.status == LbfgsStatus::interrupted) return Status::interrupted;
      if (is_near_start() && outer == 1 && !minimum && !stalled) {
        solution_.notes.emplace_back("no minimum was found near the given start");
        return Status::iteration_limit;
      }
      start_is_ = Roughness::near;
      if (std::exchange(came_far_, false) && is_near_start() && stack_.passes_through())
        return settle_parted(t);
      const double moment_change = stack_.system->recentre(stack_.z);
      const double seam_gap = stack_.largest_seam_gap();
      const bool seam_closed = seam_gap <= options.seam_tolerance * stack_.seam_radius;
      const double tie = stack_.system->worst_tie(stack_.z);
      const bool turned =
          moment_change <= options.moment_tolerance * stack_.system->largest_moment();
      const int update = before + outer;  // of contacts
      if (update == options.hold_after) stack_.contacts->hold();
      const bool search = !crumples || late.search(update);
      const ContactState contact =
          search ? stack_.contacts->refresh(stack_.scaled) : stack_.contacts->update(stack_.scaled);
      if (!updates && stack_.contacts->pressing()) {  // it touches itself now
        updates = true;
        tolerance = std::max(first_tolerance, options.tolerance);
      }
      const double slackness = late.is_late(update) ? LateContacts::slackness : 1;
      // A vertex that opens and closes moves the soft sections, too.
      const bool tied =
          tie <= (stack_.contacts->pressing() ? slackness : 1) * options.tie_tolerance;
      const bool pressed_right = is_settled(contact, options, slackness);
      bool good = (summary.residual <= options.tolerance || stalled) && seam_closed && tied &&
                  turned && pressed_right;
      std::optional<double> late_overlap;  // in mean edges
      const bool finest = tolerance <= finest_tolerance || stalled;
      const bool lost = good && t == 1 && stack_.hides_forces() && imbalance() > largest_rounding;
      bool settled = good && !lost && (finest || imbalance() <= options.balance_tolerance);
      if (settled && options.certify && !inner.certify) {
        inner.tolerance = tolerance = std::min(tolerance, options.tolerance);
        inner.certify = true;
        inner.reuse_hessian = false;
        summary = stack_.minimiser->minimise(stack_.z, inner);
        count(summary);
        stack_.unstack();
        if (summary.status == LbfgsStatus::interrupted) return Status::interrupted;
        good = settled = !summary.left_saddle;  // below it multipliers change again
      }
      if (settled && !search) {
        late_overlap = stack_.contacts->refresh(stack_.scaled).penetration;
        good = settled = *late_overlap <= LateContacts::largest_overlap;
      }
      if (settled) {
        if (!is_settled(contact, options) || tie > options.tie_tolerance)
          solution_.notes.push_back(LateContacts::note(late_overlap));
        if (const double left = imbalance(); left > options.balance_tolerance) {
          name_hidden();
          solution_.notes.push_back("rounding leaves " + number_text(left, 2) +
                                    " of the largest force out of balance, expected at most " +
                                    number_text(options.balance_tolerance, 2));
        }
        if (options.certify && !summary.positive)
          return summary.neutral ? Status::not_unique : Status::unstable;
        return stack_.system->has_potential() ? Status::converged : Status::equilibrium_only;
      }
      if (outer >= options.max_outer || failures > most_failures || stack_.spent() ||
          (lost && finest) ||
          (summary.status == LbfgsStatus::iteration_limit && tolerance <= options.tolerance &&
           !updates)) {
        name_hidden();
        UnmetCriteria unmet;
        unmet.require("residual", summary.residual, options.tolerance);
        if (!seam_closed)
          unmet.require("seam gap over the mouth's radius", seam_gap / stack_.seam_radius,
                        options.seam_tolerance);
        if (!tied) unmet.require("misfit of a soft section", tie, options.tie_tolerance);
        if (!turned)
          unmet.require("change of a turning load's moment",
                        moment_change / stack_.system->largest_moment(), options.moment_tolerance);
        require_contact(contact, options, unmet);
        unmet.require("imbalance of a vessel's forces", imbalance(), options.balance_tolerance);
        if (summary.unfactorised) unmet.add("the walls' Hessian could not be factorised");
        if (failures > most_failures)
          unmet.add("no minimum in " + std::to_string(failures) + " minimisations in a row");
        solution_.notes.push_back(unmet.sentence("at " + number_text(100 * t, 4) +
                                                 " % of the way after " + std::to_string(outer) +
                                                 " multiplier updates"));
        return Status::iteration_limit;
      }
      if (!seam_closed) stack_.update_seams();
      if (!tied) stack_.system->update_ties(stack_.z);
      // The slowest pattern of pressures goes on to its limit, unless others press now.
      if (!contact.pressed_changed) stack_.contacts->extrapolate();
      const double least = good ? finest_tolerance : options.tolerance;
      if (summary.residual <= tolerance) tolerance = std::max(least, tolerance * tolerance_step);
      if (contact.touched.empty()) {
        stack_.stack_contacts();
        continue;
      }
      for (const int b : contact.touched)
        stack_.scaled.bodies[static_cast<size_t>(b)].modelled = true;
      check_free_motions(stack_.problem, stack_.scaled);
      path_.rebuild();
    }
  }

  CoupledStack stack_;
  CoupledPath path_;
  std::optional<StopCheck> stop_;  // of the present solve
  double keep_next_ = 0;           // when the state is kept again, seconds since the start
  bool left_saddle_ = false;
  bool stiffening_ = false;
  Roughness start_is_ = Roughness::near;  // that of a given start, until it is minimised
  int updates_before_ = 0;                // of contacts, from a smooth one, before the next minimum
  bool came_far_ = false;                 // its first minimum was not looked at yet
  CoupledSolution solution_;
};

CoupledSolver::CoupledSolver(CoupledProblem problem, const CoupledOptions& options)
    : data_(std::make_unique<Data>(std::move(problem), options)) {}
CoupledSolver::~CoupledSolver() = default;
CoupledSolution CoupledSolver::solve() {
  return data_->solve();
}
void CoupledSolver::prepare(const std::function<bool()>& abandoned) {
  data_->stack().prepare(abandoned);
}
void CoupledSolver::set_start(CoupledStart start) {
  data_->stack().set_start(std::move(start));
}
void CoupledSolver::set_sections(int body, const std::vector<HeldSection>& sections) {
  data_->stack().set_sections(body, sections);
}
void CoupledSolver::set_carried(std::function<std::vector<CarriedBody>(double)> carried) {
  data_->stack().problem.carried = std::move(carried);
}
void CoupledSolver::set_material(int body, const Material& material) {
  data_->stack().set_material(body, material);
}
CoupledOptions& CoupledSolver::options() {
  return data_->stack().options;
}

}  // namespace vasorod
