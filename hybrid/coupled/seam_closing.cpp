#include "coupled/seam_closing.h"

#include <algorithm>
#include <utility>

#include "coupled/free_motions.h"
#include "data/index.h"
#include "data/sentence.h"

namespace vasorod {
namespace {

// A state on the way is only a start.
constexpr double tolerance = 1e-3;
// A state whose forces are this large over those of its energy is torn.
constexpr double torn = 1;
constexpr int most_factorisations = 40, most_iterations = 200, per_hessian = 6;
// In mean edges: the longest step of a minimisation, and the penetration that is left to the next
// step.
constexpr double largest_step = 0.3, passable_penetration = 0.1;
constexpr int updates_per_step = 4;
// Over the radius of the narrowest end: a wall that moves farther from where its last step leads to
// has snapped.
constexpr double snap = 0.2;
// Over the longest step of the time; and how a step grows after one that succeeded.
constexpr double smallest_step = 0.04, growth = 1.4;
// The last step may be longer by this factor, so that none is left that is much shorter.
constexpr double last_step = 1.5;
// Over the depth in which walls lie in each other beside a closed seam.
constexpr double parting_step = 0.25, smallest_parting_step = 0.05;
// Over the inflation: how walls are let out. They may collapse by many edges, so that contacts are
// searched after so many iterations, up to so many times; what is deeper in each other than this
// many mean edges after three of them has crossed.
constexpr double letting_step = 0.25, smallest_letting_step = 0.03, crossed = 0.5;
constexpr int iterations_per_search = 15, most_searches = 10;

}  // namespace

SeamClosing::SeamClosing(CoupledStack& stack, CoupledPath& path,
                         const CoupledMinimiserOptions& minimising,
                         std::function<void(const CoupledMinimiserSummary&)> count)
    : stack_(stack), path_(path), minimising_(minimising), count_(std::move(count)) {
  minimising_.tolerance = tolerance;
  minimising_.certify = false;
  minimising_.use_rest = false;
  minimising_.max_factorisations = most_factorisations;
  minimising_.max_iterations = most_iterations;
  minimising_.per_hessian = per_hessian;
  minimising_.largest_step = largest_step;
  minimising_.release_shift = release_shift;
  // Contacts that are found anew before each Hessian would let no minimisation of a crumpled wall
  // end; the steps are short enough for those found after the last one.
  minimising_.follow = {};
}

Status SeamClosing::run() {
  const Status status = follow_way();
  note_.clear();
  if (status == Status::iteration_limit)
    note_ = "the seam was brought together in " + std::to_string(steps_) + " steps up to " +
            number_text(100 * reached_, 3) +
            " % of its way, from where no shorter step found an equilibrium";
  else if (status == Status::converged)
    note_ = SeamWay::note(steps_);
  return status;
}

Status SeamClosing::part() {
  Status status = part_in_patch();
  if (status == Status::iteration_limit) status = bring_apart();
  note_.clear();
  if (status == Status::iteration_limit)
    note_ =
        "walls that lay in each other beside the seam could not be brought apart, and no "
        "equilibrium was found";
  return status;
}

Status SeamClosing::part_or_stay() {
  const CoupledPath::Kept kept = path_.keep();
  const Status status = part();
  if (status != Status::iteration_limit) return status;
  stack_.problem.meet_up_to_seams = false;
  begin_again(kept);
  return status;
}

Status SeamClosing::part_in_patch() {
  if (stack_.problem.lets_out) return Status::iteration_limit;  // pressed outwards everywhere
  const CoupledPath::Kept kept = path_.keep();
  if (!path_.narrow(Patch::seam_and_contacts)) return Status::iteration_limit;
  const Status status = bring_apart();
  path_.widen();
  stack_.begin_stage();
  if (status == Status::iteration_limit) begin_again(kept);
  return status;
}

void SeamClosing::begin_again(const CoupledPath::Kept& kept) {
  stack_.begin_again();
  path_.restore(kept);
}

Status SeamClosing::let_out() {
  const Status status = release();
  note_.clear();
  if (status == Status::iteration_limit)
    note_ = "walls that were joined inflated could not be let out, and no equilibrium was found";
  else if (status == Status::converged)
    note_ = let_out_note;
  return status;
}

Status SeamClosing::follow_way() {
  const double longest = stack_.problem.seam_way->step;
  double step = longest;
  path_.advance(0);
  CoupledPath::Kept kept = path_.keep();
  Points before, last = positions();
  double before_last = 0;
  while (true) {
    const double time = reached_ + last_step * step > 1 ? 1 : reached_ + step;
    path_.advance(time);
    path_.hold_back();
    stack_.set_seam_offsets(time);
    const Status status = settle(updates_per_step, Walls::follow);
    if (status == Status::interrupted) return status;
    if (status == Status::converged) {
      const Points found = positions();
      if (before.rows() == last.rows() && last.rows() == found.rows()) {
        const double along = (time - reached_) / (reached_ - before_last);
        snapped_ |= (found - last - along * (last - before)).rowwise().norm().maxCoeff() >
                    snap * stack_.ring_radius();
      }
      before = std::exchange(last, found);
      before_last = std::exchange(reached_, time);
      ++steps_;
      if (time == 1) return bring_apart();
      kept = path_.keep();
      step = std::min(growth * step, longest);
      continue;
    }
    step /= 2;
    if (step < smallest_step * longest) return Status::iteration_limit;
    path_.take_back(kept);
  }
}

Points SeamClosing::positions() const {
  return stack_.system->state(stack_.z).positions;
}

Status SeamClosing::bring_apart() {
  stack_.contacts->meet_up_to_seams();
  stack_.search_contacts();
  CoupledPath::Kept kept = path_.keep();
  for (double share = 1, step = parting_step; share > 0;) {
    const double next = std::max(0.0, share - step);
    stack_.contacts->allow(next);
    stack_.search_contacts();
    if (share == 1 && stack_.problem.start) minimising_.start = stack_.problem.start->roughness;
    const Status status = settle(updates_per_step, Walls::follow);
    if (status == Status::interrupted) return status;
    if (status == Status::converged) {
      share = next;
      kept = path_.keep();
      continue;
    }
    step /= 2;
    if (step < smallest_parting_step || stack_.spent()) {
      stack_.contacts->allow(0);
      return status;
    }
    path_.restore(kept);
  }
  return Status::converged;
}

Status SeamClosing::release() {
  minimising_.max_iterations = iterations_per_search;
  stack_.contacts->walls_are_parted();
  CoupledPath::Kept kept = path_.keep();
  for (double share = 1, step = letting_step; share > 0;) {
    const double next = share - step < smallest_letting_step ? 0 : share - step;
    stack_.set_inflation(next);
    const Status status = settle(most_searches, Walls::collapse);
    if (status == Status::interrupted) return status;
    if (status == Status::converged) {
      share = next;
      kept = path_.keep();
      step = std::min(growth * step, letting_step);
      continue;
    }
    step = (share - next) / 2;
    if (step < smallest_letting_step || stack_.spent()) return Status::iteration_limit;
    stack_.set_inflation(share);
    path_.take_back(kept);
  }
  return Status::converged;
}

Status SeamClosing::settle(int most_updates, Walls walls) {
  double penetration = 0;
  for (int update = 1; update <= most_updates; ++update) {
    minimising_.reuse_hessian = update > 1;
    const CoupledMinimiserSummary summary = stack_.minimiser->minimise(stack_.z, minimising_);
    count_(summary);
    minimising_.start = Roughness::near;
    stack_.unstack();
    if (summary.status == LbfgsStatus::interrupted) return Status::interrupted;
    const bool stuck = summary.unfactorised && summary.iterations == 0;
    if (stuck || !(summary.residual < torn)) return Status::iteration_limit;
    if (stack_.spent()) return Status::iteration_limit;
    const ContactState contact = stack_.contacts->refresh(stack_.scaled);
    penetration = contact.penetration;
    stack_.update_seams();
    stack_.system->update_ties(stack_.z);
    if (contact.touched.empty()) {
      stack_.stack_contacts();
      const bool came_to_rest = summary.status != LbfgsStatus::iteration_limit;
      if (penetration < passable_penetration && (came_to_rest || walls == Walls::follow))
        return Status::converged;
      if (walls == Walls::collapse && update > 2 && penetration > crossed)
        return Status::iteration_limit;
      continue;
    }
    for (const int b : contact.touched) stack_.scaled.bodies[index(b)].modelled = true;
    check_free_motions(stack_.problem, stack_.scaled);
    const bool was_narrow = stack_.is_narrow();
    path_.rebuild();
    if (was_narrow) path_.narrow(Patch::seam_and_contacts);  // with what is touched now
  }
  const bool passable = walls == Walls::follow || penetration < passable_penetration;
  return passable ? Status::converged : Status::iteration_limit;
}

}  // namespace vasorod
