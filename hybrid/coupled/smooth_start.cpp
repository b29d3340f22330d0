#include "coupled/smooth_start.h"

#include <algorithm>
#include <utility>

#include "bodies/late_contacts.h"

namespace vasorod {
namespace {

// Of walls whose surroundings are still to move.
constexpr double rough = 1e-2;
// Most of what one convex Hessian gains for all walls it gains at once.
constexpr int iterations_of_all = 4;
// Of the patch of seam and contacts: for its first minimum, how much less for each one after an
// update, and for the last ones.
constexpr double first_tolerance = 1e-4, tolerance_step = 0.1, finest_tolerance = 1e-5;
// Each makes the change of the pressures some seven times smaller. More would settle what the whole
// then changes by a few percent. Of walls that crumple the contacts are found differently each
// time: as long as they are searched at each, which costs less here than in the whole.
constexpr int most_updates = 3;

}  // namespace

SmoothStart::SmoothStart(CoupledStack& stack, CoupledPath& path,
                         const CoupledMinimiserOptions& minimising,
                         std::function<void(const CoupledMinimiserSummary&)> count)
    : stack_(stack), path_(path), minimising_(minimising), count_(std::move(count)) {
  minimising_.certify = false;
  minimising_.use_rest = false;
}

Status SmoothStart::bring_near() {
  CoupledMinimiserOptions roughly = minimising_;
  roughly.tolerance = rough;
  roughly.start = Roughness::smooth;
  if (path_.narrow(Patch::seam)) {
    minimise(roughly);
    path_.widen();
  }
  if (last_.status == LbfgsStatus::interrupted) return Status::interrupted;
  roughly.max_iterations = iterations_of_all;
  roughly.max_factorisations = 1;
  minimise(roughly);
  if (last_.status == LbfgsStatus::interrupted) return Status::interrupted;
  stack_.unstack();
  if (path_.narrow(Patch::seam_and_contacts)) {
    settle_patch();
    path_.widen();
  }
  return last_.status == LbfgsStatus::interrupted ? Status::interrupted : Status::converged;
}

// Returns whether a minimum was found.
bool SmoothStart::minimise(const CoupledMinimiserOptions& options) {
  last_ = stack_.minimiser->minimise(stack_.z, options);
  count_(last_);
  return last_.status == LbfgsStatus::converged;
}

void SmoothStart::settle_patch() {
  CoupledMinimiserOptions finer = minimising_;
  finer.tolerance = first_tolerance;
  const CoupledOptions& options = stack_.options;
  const int most = std::max(most_updates, LateContacts::patience_with_held(options.hold_after));
  while (minimise(finer)) {
    near_ = true;
    stack_.unstack();
    if (updates_ == 0 && stack_.passes_through()) {
      crossed_ = true;
      return;
    }
    if (updates_ == most) return;
    ++updates_;
    if (updates_ == options.hold_after) stack_.contacts->hold();
    const ContactState contact = stack_.contacts->refresh(stack_.scaled);
    stack_.stack_contacts();
    // What is touched only now joins the unknowns of the whole.
    if (is_settled(contact, options) || !contact.touched.empty()) return;
    finer.tolerance = std::max(finest_tolerance, finer.tolerance * tolerance_step);
    finer.reuse_hessian = true;
  }
}

}  // namespace vasorod
