#include "paper/paper_closing.h"

#include <cmath>
#include <utility>

#include "data/sentence.h"

namespace vasorod {
namespace {

// A state on the way is only a start.
constexpr double tolerance = 1e-3;
constexpr int most_iterations = 60, patience = 15;
// In mean edges: the penetration that is left to the next step; how often the multipliers are
// updated to come below it; and what is deeper in each other then has crossed, which so many steps
// may leave to the next.
constexpr double passable_penetration = 0.1, crossed = 0.5;
constexpr int most_updates = 12, most_crossings = 15;
// The last step may be longer by this factor, so that none is left that is much shorter.
constexpr double last_step = 1.5;
// Over the depth in which walls lie in each other beside a closed seam.
constexpr double parting_step = 0.25;

}  // namespace

PaperClosing::PaperClosing(PaperStack& stack, const PaperWay& way,
                           const PaperMinimiserOptions& minimising,
                           std::function<void(const PaperMinimiserSummary&)> count)
    : stack_(stack), way_(way), minimising_(minimising), count_(std::move(count)) {
  minimising_.tolerance = tolerance;
  minimising_.max_iterations = most_iterations;
  minimising_.patience = patience;
}

Status PaperClosing::run() {
  int crossings = 0;
  stack_.put_at_rest();
  stack_.build();
  while (reached_ < 1) {
    const double time = reached_ + last_step * way_.seam.step > 1 ? 1 : reached_ + way_.seam.step;
    stack_.carry(way_.carried(time));
    stack_.set_seam_offsets(way_.seam.offsets(time));
    const Status status = settle();
    if (status == Status::interrupted) return status;
    if (status != Status::converged && ++crossings > most_crossings) return status;
    reached_ = time;
    ++steps_;
  }
  const PaperStack::State closed = stack_.state();
  const Status status = bring_apart();
  if (status != Status::iteration_limit) return status;
  stack_.renew_contacts();
  stack_.restore(closed);
  search();
  return Status::converged;
}

std::string PaperClosing::note() const {
  if (reached_ == 1) return SeamWay::note(steps_);
  return "the seam was brought together in " + std::to_string(steps_) + " steps up to " +
         number_text(100 * reached_, 3) +
         " % of its way, where walls that lie in each other could not be parted";
}

Status PaperClosing::bring_apart() {
  stack_.contacts->meet_up_to_seams();
  search();
  for (double share = 1 - parting_step; share >= 0; share -= parting_step) {
    stack_.contacts->allow(share);
    search();
    const Status status = settle();
    if (status != Status::converged) return status;
  }
  return Status::converged;
}

void PaperClosing::search() {
  stack_.contacts->refresh(stack_.scaled);
  stack_.stack_contacts();
}

// A rough minimum at the present positions of the rods and the seam.
Status PaperClosing::settle() {
  // Fixed vertices may have been carried into what they must not pass.
  if (!std::isfinite(paper_energy(stack_.system, stack_.positions))) return Status::iteration_limit;
  double penetration = 0;
  for (int update = 1; update <= most_updates; ++update) {
    if (minimising_.before && minimising_.before(stack_.positions)) return Status::interrupted;
    stack_.minimiser->factorise(stack_.positions, minimising_.stop_inside);
    const PaperMinimiserSummary summary = stack_.minimiser->minimise(stack_.positions, minimising_);
    count_(summary);
    stack_.unstack();
    if (summary.status == LbfgsStatus::interrupted) return Status::interrupted;
    const ContactState contact = stack_.contacts->refresh(stack_.scaled);
    stack_.update_seams();
    if (!contact.touched.empty()) {
      stack_.add(contact.touched);
      continue;
    }
    stack_.stack_contacts();
    penetration = contact.penetration;
    if (penetration < passable_penetration) return Status::converged;
  }
  return penetration < crossed ? Status::converged : Status::iteration_limit;
}

}  // namespace vasorod
