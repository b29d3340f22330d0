#include "predict/get_ready.h"

#include <vasorod/error.h>

#include "data/scene_place.h"
#include "predict/prestress.h"
#include "predict/stump.h"
#include "surgery/end_to_end.h"
#include "surgery/glenn.h"

namespace vasorod {
namespace {

Stage rest_stage(const Prediction& prediction) {
  Stage rest{"rest", {}, {}};
  for (const PredictedVessel& vessel : prediction.vessels) {
    rest.surfaces.push_back(vessel.prepared.vessel.surface);
    rest.names.push_back(vessel.prepared.spec.name);
  }
  return rest;
}

// Cuts, opens, places and sews; solves the rods that the join moves.
void operate_on(Prediction& prediction, const SolveOptions& options,
                const std::function<void(const std::string&)>& begin) {
  const Scene& scene = *prediction.scene;
  const auto [first_name, second_name] = scene.joined().value();
  PredictedVessel& first = prediction.vessels[vessel_named(prediction, first_name)];
  PredictedVessel& second = prediction.vessels[vessel_named(prediction, second_name)];
  OperationOptions how;
  how.rod.stop = options.stop;
  how.progress = [&](const std::string& step) { begin("surgery: " + step); };
  Operation& operation = prediction.operation.emplace();
  if (scene.glenn)
    operation =
        operate(scene, *scene.glenn, first.prepared, second.prepared, first.conditions, how);
  else
    operation = join_end_to_end(scene, *scene.end_to_end,
                                {VesselToJoin{first.prepared, first.conditions},
                                 VesselToJoin{second.prepared, second.conditions}},
                                how);
  for (PredictedVessel* vessel : {&first, &second}) {
    auto& rod = operation.vessels[vessel == &first ? 0 : 1].rod;
    if (!rod) continue;
    vessel->rod = *rod;
    vessel->rod_solved = true;
  }
  for (Stage& stage : operation.stages) prediction.stages.push_back(std::move(stage));
}

void solve_rods(Prediction& prediction, const SolveOptions& options) {
  RodOptions rod_options;
  rod_options.stop = options.stop;
  for (PredictedVessel& vessel : prediction.vessels) {
    if (vessel.prepared.obstacle() || vessel.rod_solved) continue;
    vessel.rod.poses = vessel.prepared.vessel.rod.rest;
    if (!vessel.conditions.acts) {
      prediction.left_out["rod of " + vessel.prepared.spec.name] =
          "nothing moves or loads it: it stays as it is";
      continue;
    }
    options.progress("rod of " + vessel.prepared.spec.name);
    try {
      vessel.rod = solve_rod(vessel.prepared.vessel.rod, vessel.conditions.rod, rod_options);
    } catch (const InputError& error) {
      throw InputError(place_of(*prediction.scene, vessel.prepared.spec) + error.what());
    }
    vessel.rod_solved = true;
  }
}

}  // namespace

void get_ready(Prediction& prediction, LumenOf lumen, const SolveOptions& options,
               const std::function<void(const std::string&)>& begin) {
  prestress(prediction, lumen, options.stop, begin);
  prediction.stages.push_back(rest_stage(prediction));
  if (prediction.scene->joined()) {
    operate_on(prediction, options, begin);
    add_stump(prediction);
  }
  prediction.watch.lap("surgery");
  solve_rods(prediction, options);
}

}  // namespace vasorod
