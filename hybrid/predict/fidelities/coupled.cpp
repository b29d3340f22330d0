// Which ways `coupled` tries to a minimum, and in which order.
#include <algorithm>
#include <array>

#include "coupled/seam_closing.h"
#include "geometry/triangle_surface.h"
#include "predict/coarse_start.h"
#include "predict/coupled_attempt.h"
#include "predict/fidelities/fidelities.h"
#include "predict/sharp_vein.h"

namespace vasorod {
namespace {

using Walls = CoupledAttempt::Walls;

// Hoop strains p R / (E t) to which the vessels of a vein that folds are inflated, the second where
// the first leads nowhere.
constexpr std::array inflations{0.02, 0.05};

double mean_edge(const Prediction& prediction, const SharpVein& vein) {
  return mean_edge_length(
      prediction.vessels[vessel_named(prediction, vein.name)].prepared.vessel.surface);
}

bool touches_itself(const CoupledSolution& solution) {
  return std::any_of(
      solution.surface.contacts.begin(), solution.surface.contacts.end(),
      [](const ContactSolution& pair) { return pair.a == pair.b && pair.within_reach; });
}

void take(CoupledOutcome&& found, Prediction& prediction) {
  found.state.work = prediction.work;
  prediction = std::move(found.state);
}

// The best of what attempts found: a minimum is better than none, and the less of it passes through
// something the better.
class Best {
 public:
  Best(CoupledAttempt& attempt, CoupledSolution&& first)
      : attempt_(attempt), found_(attempt.outcome(std::move(first))) {}

  const CoupledOutcome* operator->() const { return &found_; }

  void offer(CoupledSolution&& solution) {
    CoupledOutcome next = attempt_.outcome(std::move(solution));
    if ((next.minimum() && next.depth <= found_.depth) || !found_.minimum())
      found_ = std::move(next);
  }

  CoupledOutcome take() && { return std::move(found_); }

 private:
  CoupledAttempt& attempt_;
  CoupledOutcome found_;
};

// A wall that crumples may find no end of its contacts with itself, or pass through itself: then a
// barrier takes their place.
CoupledOutcome without_operation(CoupledAttempt& attempt, CoupledSolution&& first,
                                 Prediction& prediction, const SolveOptions& options) {
  Best best(attempt, std::move(first));
  if ((best->crossed() || !best->minimum()) && !options.stop()) {
    CoupledSolution guarded = attempt.guarded();
    if (is_minimum(guarded.status) || guarded.reached >= best->solution.reached)
      best.offer(std::move(guarded));
    else
      prediction.work += guarded.surface.work;
  }
  return std::move(best).take();
}

// Of a vein on its way to its seam. `first`: from a closed seam. Walls that pass through something
// there are parted; where that fails, and first where they lie in each other by more than
// `deepest`, too deep for contact to tell the sides apart, a vein that folds is joined inflated,
// and at last one goes the way from rest.
CoupledOutcome joined(CoupledAttempt& attempt, CoupledSolution&& first, bool folds, double deepest,
                      const SolveOptions& options) {
  const CoupledSolution closed = first;
  Best best(attempt, std::move(first));
  const auto part = [&] {
    if (best->crossed() && !options.stop()) best.offer(attempt.parted(closed, folds));
  };
  const bool deep = folds && best->depth > deepest;
  const auto goes_on = [&] {
    return (best->crossed() || (folds && !best->minimum())) && !options.stop();
  };
  if (!deep) part();
  for (const double strain : inflations)
    if (folds && goes_on())
      if (auto found = attempt.inflated(strain)) best.offer(std::move(*found));
  if (goes_on()) best.offer(attempt.on_its_way());
  if (deep) part();
  return std::move(best).take();
}

const char* how_found(const CoupledSolution& on_coarse) {
  const auto& notes = on_coarse.notes;
  return std::find(notes.begin(), notes.end(), SeamClosing::let_out_note) == notes.end()
             ? "the vein's folds were found on walls with edges twice as long"
             : "the vein's folds were found on walls with edges twice as long, where the vessels "
               "were joined inflated and then let out";
}

// A vein that folds snaps from fold to fold, which coarse walls do at a fraction of the cost; the
// fine ones start in the folds that they found. Empty: there are no coarse walls, or they or the
// fine ones found no minimum that passes through nothing. Fine ones that are interrupted are the
// best there is.
std::optional<CoupledOutcome> folded_on_coarse(CoupledAttempt& attempt, Prediction& prediction,
                                               const SolveOptions& options) {
  std::optional<Prediction> coarse = coarse_prediction(prediction, options);
  if (!coarse) return std::nullopt;
  CoupledAttempt on_coarse(*coarse, options, Walls::coarse);
  // Of edges as long as these any depth is too deep to be parted.
  const CoupledOutcome found = joined(on_coarse, on_coarse.closed(true), true, 0, options);
  prediction.work += coarse->work;
  if (!found.minimum() || found.crossed()) return std::nullopt;
  CoupledSolution fine = attempt.refined(*coarse, found.solution);
  fine.notes.emplace_back(how_found(found.solution));
  CoupledOutcome outcome = attempt.outcome(std::move(fine));
  const bool interrupted = outcome.solution.status == Status::interrupted;
  if (!interrupted && (!outcome.minimum() || outcome.crossed())) return std::nullopt;
  return outcome;
}

}  // namespace

void solve_coupled(Prediction& prediction, const SolveOptions& options) {
  CoupledAttempt attempt(prediction, options);
  const std::optional<SharpVein> vein = sharp_vein(prediction);
  const bool folds = vein && has_to_fold(*vein);
  std::optional<CoupledSolution> first;
  if (!folds) {
    first = attempt.from_coarse();
  } else if (auto found = folded_on_coarse(attempt, prediction, options)) {
    take(std::move(*found), prediction);
    return;
  }
  if (!first) first = attempt.closed(folds);
  const bool apart = vein ? !folds && leaves_out_contact(prediction) : !touches_itself(*first);
  if (apart) {
    attempt.keep(std::move(*first), prediction);
    return;
  }
  CoupledOutcome found =
      vein ? joined(attempt, std::move(*first), folds, mean_edge(prediction, *vein), options)
           : without_operation(attempt, std::move(*first), prediction, options);
  take(std::move(found), prediction);
}

}  // namespace vasorod
