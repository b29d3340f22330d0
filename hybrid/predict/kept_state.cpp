#include "predict/kept_state.h"

#include <limits>
#include <memory>

#include <vasorod/error.h>

#include "data/sentence.h"
#include "judge/criteria.h"
#include "predict/name_crossings.h"
#include "predict/name_faults.h"
#include "predict/result_of_prediction.h"
#include "rod/binding.h"

namespace vasorod {

Result whole_result(Prediction&& prediction, int threads) {
  Result result = result_of(prediction, threads);
  name_crossings(prediction, result);
  prediction.watch.lap("collect");
  result.seconds = prediction.watch.seconds();
  result.seconds["factor"] = prediction.work.factor_seconds;  // a part of `solve`
  result.counts = prediction.work.counts;
  result.environment.inputs = std::move(prediction.inputs);
  result.environment.scene_hash = std::move(prediction.scene_hash);
  name_faults(result);
  result.criteria = criteria_of(result);
  return result;
}

void stop_early(const std::string& stage) {
  throw StoppedEarly("stopped at " + in_quotes(stage) +
                     ", before there was a state: nothing is written; expected a longer time limit "
                     "or a later signal");
}

void keep_state(Prediction&& state, const SolveOptions& options) {
  if (!options.keep) return;
  state.watch.lap("solve");
  state.status = Status::interrupted;
  // The caller may call it from another thread while the solver goes on: nothing is shared but the
  // scene.
  options.keep([kept = std::make_shared<const Prediction>(std::move(state)),
                threads = options.threads] { return whole_result(Prediction(*kept), threads); });
}

void keep_rods(const Prediction& prediction, const SolveOptions& options) {
  if (!options.keep) return;
  auto state = std::make_shared<Prediction>(prediction);
  for (PredictedVessel& vessel : state->vessels) vessel.positions = carried_surface(vessel);
  state->watch.lap("solve");
  state->status = Status::interrupted;
  options.keep([state = std::shared_ptr<const Prediction>(state), threads = options.threads] {
    Result result = whole_result(Prediction(*state), threads);
    // Those of the rods say nothing about the surfaces.
    result.certificate.relative_residual = std::numeric_limits<double>::quiet_NaN();
    result.certificate.smallest_curvature_positive.reset();
    result.certificate.notes.emplace_back(
        "stopped before the first step on the surfaces: every section is carried rigidly by its "
        "rod, and a seam is not closed");
    return result;
  });
}

}  // namespace vasorod
