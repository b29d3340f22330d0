#include "app/solve_scene.h"

#include <algorithm>

#include "app/collect_result.h"
#include "app/prediction.h"
#include "app/solve_coupled.h"
#include "app/solve_surfaces.h"
#include "app/stopwatch.h"
#include "geometry/error.h"
#include "surface/blas.h"
#include "vessel/choose_fidelity.h"
#include "vessel/rod_scene.h"

namespace vasorod {
namespace {

std::string line_of(const Scene& scene, const VesselSpec& vessel) {
  return scene.file.string() + ":" + std::to_string(vessel.line) + ": ";
}

std::string place(const Scene& scene, const VesselSpec& vessel) {
  return line_of(scene, vessel) + "vessel " + vessel.name + ": ";
}

// What a part that knows no scene file says of its input, with the place it belongs to.
template <class Work>
auto placed(const std::string& where, Work&& work) {
  try {
    return work();
  } catch (const InputError& error) {
    throw InputError(where + error.what());
  }
}

bool has_bare_rods(const Scene& scene) {
  return std::any_of(scene.vessels.begin(), scene.vessels.end(),
                     [](const VesselSpec& vessel) { return vessel.rod.has_value(); });
}

// As asked for; with `accuracy:` alone the dearest the vessels allow, until the rods say what will do.
Fidelity checked_fidelity(const Scene& scene, const SolveOptions& options) {
  const Fidelity dearest = has_bare_rods(scene) ? Fidelity::rod : Fidelity::coupled;
  const Fidelity fidelity = options.fidelity ? *options.fidelity : scene.fidelity.value_or(dearest);
  for (const VesselSpec& vessel : scene.vessels) {
    if (vessel.pressure)
      throw InputError(place(scene, vessel) +
                       "found a pressure, expected none: only the finite-element reference takes it");
    if (vessel.rod && fidelity != Fidelity::rod)
      throw InputError(place(scene, vessel) + "found a bare rod at fidelity " + to_string(fidelity) +
                       ", expected fidelity rod");
  }
  return fidelity;
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
    vessel.rod = placed(place(*prediction.scene, vessel.prepared.spec), [&] {
      return solve_rod(vessel.prepared.vessel.rod, vessel.conditions.rod, rod_options);
    });
    vessel.rod_solved = true;
  }
}

// The rods are solved: which fidelity does `accuracy:` need?
FidelityChoice choose(const Scene& scene, const Prediction& prediction) {
  std::vector<RodOfVessel> rods;
  for (const PredictedVessel& vessel : prediction.vessels) {
    if (vessel.prepared.obstacle()) continue;
    rods.push_back({&vessel.prepared, &vessel.rod.poses, rigid_nodes(prediction, vessel)});
  }
  return choose_fidelity(scene, rods);
}

}  // namespace

Result solve_scene(const Scene& scene, const SolveOptions& options) {
  Fidelity fidelity = checked_fidelity(scene, options);
  set_blas_threads(options.threads);
  if (has_bare_rods(scene)) {
    RodSceneOptions rods;
    rods.stop = options.stop;
    Result result = solve_rod_scene(scene, rods);
    result.environment.blas = blas_name();
    result.environment.threads = options.threads;
    return result;
  }

  Stopwatch watch;
  Prediction prediction;
  prediction.scene = &scene;
  for (const VesselSpec& spec : scene.vessels) {
    if (spec.role == Role::obstacle && fidelity == Fidelity::rod) {
      prediction.left_out["obstacle " + spec.name] = "fidelity rod: no surface, nothing to touch";
      continue;
    }
    options.progress("vessel " + spec.name);
    PredictedVessel vessel;
    vessel.prepared = read_vessel(spec, scene);
    prediction.vessels.push_back(std::move(vessel));
  }
  watch.lap("read");
  for (PredictedVessel& vessel : prediction.vessels) {
    if (vessel.prepared.obstacle()) continue;
    placed(line_of(scene, vessel.prepared.spec), [&] { fit(vessel.prepared); });
    vessel.conditions = end_conditions(scene, vessel.prepared.spec.name, vessel.prepared.vessel);
  }
  watch.lap("fit");

  Stage rest{"rest", {}, {}};
  for (const PredictedVessel& vessel : prediction.vessels) {
    rest.surfaces.push_back(vessel.prepared.vessel.surface);
    rest.names.push_back(vessel.prepared.spec.name);
  }
  prediction.stages.push_back(std::move(rest));

  if (scene.glenn) {
    PredictedVessel& svc = prediction.vessels[vessel_named(prediction, scene.glenn->svc)];
    PredictedVessel& rpa = prediction.vessels[vessel_named(prediction, scene.glenn->rpa)];
    GlennOptions glenn;
    glenn.rod.stop = options.stop;
    glenn.progress = options.progress;
    prediction.glenn = operate(scene, *scene.glenn, svc.prepared, rpa.prepared, svc.conditions, glenn);
    svc.rod = prediction.glenn->vein;
    svc.rod_solved = true;
    for (Stage& stage : prediction.glenn->stages) prediction.stages.push_back(std::move(stage));
  }
  watch.lap("surgery");

  solve_rods(prediction, options);
  std::optional<FidelityChoice> choice;
  if (!options.fidelity && !scene.fidelity) {
    choice = choose(scene, prediction);
    fidelity = choice->fidelity;
  }
  prediction.fidelity = fidelity;
  prediction.certified = options.certify && fidelity == Fidelity::paper;
  watch.lap("rod");
  placed(scene.file.string() + ": ", [&] {
    if (fidelity == Fidelity::rod)
      prediction.left_out["surface"] = "fidelity rod: only the centerlines are asked for";
    else if (fidelity == Fidelity::skin)
      solve_skin(prediction);
    else if (fidelity == Fidelity::coupled)
      solve_coupled(prediction, options);
    else
      solve_paper_surfaces(prediction, options);
  });
  watch.lap("solve");

  Result result = collect_result(prediction);
  if (choice) result.certificate.notes.push_back(choice->sentence());
  watch.lap("collect");
  result.seconds = watch.seconds();
  result.environment.threads = options.threads;
  return result;
}

}  // namespace vasorod
