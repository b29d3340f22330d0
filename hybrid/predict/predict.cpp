#include <algorithm>
#include <chrono>
#include <mutex>

#include <vasorod/error.h>
#include <vasorod/predict.h>

#include "data/index.h"
#include "data/scene_place.h"
#include "data/sentence.h"
#include "judge/choose_fidelity.h"
#include "judge/criteria.h"
#include "numerics/threads.h"
#include "predict/chosen_fidelity.h"
#include "predict/fidelity.h"
#include "predict/fitted_vessels.h"
#include "predict/get_ready.h"
#include "predict/input_hashes.h"
#include "predict/kept_state.h"
#include "predict/memory_need.h"
#include "predict/name_faults.h"
#include "predict/name_stop.h"
#include "predict/prediction.h"
#include "predict/prestress.h"
#include "predict/rod_scene.h"
#include "surgery/pick_place.h"

namespace vasorod {
namespace {

bool has_bare_rods(const Scene& scene) {
  return std::any_of(scene.vessels.begin(), scene.vessels.end(),
                     [](const VesselSpec& vessel) { return vessel.rod.has_value(); });
}

// A scene in which nothing holds, moves, loads or joins anything would be "solved" as it stands.
// Rods that are drawn otherwise than they are at ease do move.
void require_a_condition(const Scene& scene) {
  const bool relaxes =
      std::any_of(scene.vessels.begin(), scene.vessels.end(), [](const VesselSpec& vessel) {
        return vessel.rod &&
               std::any_of(vessel.rod->pieces.begin(), vessel.rod->pieces.end(),
                           [](const RodPiece& piece) { return piece.natural.has_value(); });
      });
  if (!scene.ends.empty() || scene.joined() || relaxes) return;
  throw InputError(place_in(scene) +
                   ": found no condition in ends and no surgery, so that nothing would happen, "
                   "expected at least one end that is held, moved or loaded (vasorod fit shows a "
                   "vessel as it is)");
}

const Fidelity& named(const std::string& name, const std::string& where) {
  if (const Fidelity* fidelity = find_fidelity(name)) return *fidelity;
  const std::vector<std::string> names = fidelity_names();
  const auto meant = nearest_word(name, names);
  throw InputError(where + "fidelity: found " + in_quotes(name) + ", expected " +
                   (meant ? in_quotes(*meant) : listed(names)));
}

// The most expensive fidelity that `accuracy:` may fall back to.
const Fidelity& dearest() {
  const auto& all = fidelities();
  return *std::find_if(all.rbegin(), all.rend(), [](const Fidelity& f) { return f.choosable; });
}

std::vector<std::string> with_lumen() {
  std::vector<std::string> names;
  for (const Fidelity& fidelity : fidelities())
    if (fidelity.lumen != LumenOf::none) names.push_back(fidelity.name);
  return names;
}

// What the reader of scene files sees to, for scenes made in C++.
void check_vessels(const Scene& scene) {
  const bool bare_rods = has_bare_rods(scene);
  for (const VesselSpec& vessel : scene.vessels) {
    if (vessel.rod) continue;
    if (!vessel.surface && !vessel.tube)
      throw InputError(place_of(scene, vessel) +
                       "found no shape, expected a surface, a tube or a bare rod");
    if (bare_rods)
      throw InputError(place_of(scene, vessel) +
                       "found a surface beside bare rods, expected bare rods alone");
    if (vessel.role == Role::deformable && !vessel.wall)
      throw InputError(place_of(scene, vessel) +
                       "found no wall, expected its thickness and material");
  }
  for (const EndCondition& end : scene.ends) scene.vessel(end.vessel);
  if (scene.glenn && scene.end_to_end)
    throw InputError(place_in(scene, scene.end_to_end->line) +
                     ": end_to_end: found it beside glenn, expected one operation in a scene");
  if (const auto joined = scene.joined()) {
    if ((*joined)[0] == (*joined)[1])
      throw InputError(place_in(scene) + ": surgery: found the vessel " + in_quotes((*joined)[0]) +
                       " twice, expected two different vessels");
    for (const std::string& name : *joined)
      if (const VesselSpec& vessel = scene.vessel(name); vessel.role == Role::obstacle)
        throw InputError(place_of(scene, vessel) +
                         "found an obstacle that the surgery joins, expected a deformable vessel");
  }
  require_one_pressure(scene);
}

// The requested fidelity. With `accuracy:` alone: the most expensive one that the vessels allow,
// until the rods are solved and the choice is known.
const Fidelity& checked_fidelity(const Scene& scene, const SolveOptions& options) {
  const std::string line = place_in(scene, scene.fidelity_line) + ": ";
  const Fidelity& fidelity = options.fidelity       ? named(*options.fidelity, "")
                             : scene.fidelity       ? named(*scene.fidelity, line)
                             : has_bare_rods(scene) ? named("rod", "")
                                                    : dearest();
  for (const VesselSpec& vessel : scene.vessels) {
    const bool pressed = vessel.pressure.has_value();
    if ((pressed || vessel.axial_prestretch != 1) && fidelity.lumen == LumenOf::none)
      throw InputError(place_of(scene, vessel) + "found " +
                       (pressed ? "a pressure" : "an axial prestretch") + " at fidelity " +
                       fidelity.name + ", expected fidelity " + listed(with_lumen()) +
                       ", whose rods or walls enclose a lumen and carry stress as they were seen");
    if (vessel.rod && (pressed || vessel.axial_prestretch != 1))
      throw InputError(place_of(scene, vessel) + "found " +
                       (pressed ? "a pressure" : "an axial prestretch") +
                       " on a bare rod, expected a vessel with a surface or a tube and its wall");
    if (vessel.rod && fidelity.surfaces)
      throw InputError(place_of(scene, vessel) + "found a bare rod at fidelity " + fidelity.name +
                       ", expected fidelity rod");
  }
  if (scene.joined() && !fidelity.surgery)
    throw InputError(place_in(scene) + ": surgery: found an operation at fidelity " +
                     fidelity.name + ", whose vessels are whole, expected fidelity " +
                     listed(fidelities_with_surgery()));
  check_vessels(scene);
  return fidelity;
}

// Before the rods are solved there is no state to return. Once `stop` is true these stages have
// SolveOptions::patience to come to the first one.
class EarlyStages {
 public:
  explicit EarlyStages(const SolveOptions& options) : options_(options) {}

  /// Call before each stage.
  void begin(const std::string& stage) {
    if (options_.stop()) {
      const auto now = std::chrono::steady_clock::now();
      if (!stopped_) stopped_ = now;
      if (std::chrono::duration<double>(now - *stopped_).count() >= options_.patience)
        stop_early(stage);
    }
    options_.progress(stage);
  }

 private:
  const SolveOptions& options_;
  std::optional<std::chrono::steady_clock::time_point> stopped_;
};

// Whether the fidelity has nothing that could touch the vessel.
bool left_out(const VesselSpec& spec, const Fidelity& fidelity) {
  return spec.role == Role::obstacle && !fidelity.surfaces;
}

PreparedVessel read_one(const VesselSpec& spec, const Scene& scene, EarlyStages& stages,
                        InputHashes& inputs) {
  stages.begin("reading vessel " + spec.name);
  PreparedVessel vessel;
  inputs.while_reading(spec, [&] { vessel = read_vessel(spec, scene); });
  return vessel;
}

void read_vessels(const Fidelity& fidelity, EarlyStages& stages, InputHashes& inputs,
                  Prediction& prediction) {
  for (const VesselSpec& spec : prediction.scene->vessels) {
    if (left_out(spec, fidelity)) {
      inputs.add(spec);
      continue;
    }
    PredictedVessel vessel;
    vessel.prepared = read_one(spec, *prediction.scene, stages, inputs);
    prediction.vessels.push_back(std::move(vessel));
  }
}

// Those of another scene with the same vessels.
void take_vessels(const Fidelity& fidelity, const FittedVessels& fitted, Prediction& prediction) {
  for (const PreparedVessel& vessel : fitted.vessels) {
    if (left_out(vessel.spec, fidelity)) continue;
    prediction.vessels.emplace_back().prepared = vessel;
  }
}

// As many at once as there are threads, without obstacles.
void fit_all(std::vector<PreparedVessel*> vessels, const Scene& scene, EarlyStages& stages) {
  std::erase_if(vessels, [](const PreparedVessel* vessel) { return vessel->obstacle(); });
  const int each = threads(), count = static_cast<int>(vessels.size());
  for (int first = 0; first < count; first += each) {
    const int size = std::min(each, count - first);
    for (int v = first; v < first + size; ++v)
      stages.begin("fitting vessel " + vessels[index(v)]->spec.name);
    in_parallel(each, size, [&](int v) {
      PreparedVessel& vessel = *vessels[index(first + v)];
      placed(place_in(scene, vessel.spec.line), [&] { fit(vessel); });
    });
  }
}

// A left and a right exchanged between vessels would be a scene that no patient has.
void require_one_space(const Prediction& prediction) {
  const PredictedVessel* first = nullptr;
  for (const PredictedVessel& vessel : prediction.vessels) {
    const std::string& space = vessel.prepared.loaded.space;
    if (space.empty()) continue;
    if (first == nullptr) first = &vessel;
    const LoadedSurface& other = first->prepared.loaded;
    if (other.space != space)
      throw InputError(place_of(*prediction.scene, vessel.prepared.spec) +
                       "found a surface in the space " + space + " (SPACE in its file) where " +
                       first->prepared.spec.name + " is in " + other.space +
                       ", expected all surfaces in one space: export them from 3D Slicer again");
  }
}

// With the rods solved: the fidelity that `accuracy:` needs.
FidelityChoice choose(const Scene& scene, const Prediction& prediction) {
  std::vector<RodOfVessel> rods;
  for (const PredictedVessel& vessel : prediction.vessels) {
    if (vessel.prepared.obstacle()) continue;
    rods.push_back({&vessel.prepared, &vessel.rod.poses, rigid_nodes(prediction, vessel)});
  }
  return choose_fidelity(scene, rods, dearest().name);
}

SolveOptions checked(const SolveOptions& given) {
  if (const auto fault = given.is_invalid()) throw InputError(*fault);
  SolveOptions options = given;
  if (!options.stop) options.stop = [] { return false; };
  if (!options.stopped_by) options.stopped_by = [] { return "the caller"; };
  if (!options.progress) options.progress = [](const std::string&) {};
  if (!options.solved) options.solved = [] {};
  return options;
}

// `fitted`: null where the vessels have to be read and fitted first. `options` are checked.
Result predict_from(const Scene& scene, const SolveOptions& options, const FittedVessels* fitted) {
  const Fidelity* fidelity = &checked_fidelity(scene, options);
  require_a_condition(scene);
  std::vector<double> sizes = stated_sizes(scene);
  require_memory(scene, fidelity->name, sizes);
  InputHashes inputs(scene);
  set_threads(options.threads);
  if (has_bare_rods(scene)) {
    Result result = solve_rod_scene(scene, options);
    result.environment.inputs = inputs.hashes();
    result.environment.scene_hash = inputs.scene();
    name_faults(result);
    result.criteria = criteria_of(result);
    return result;
  }

  Prediction prediction;
  prediction.scene = &scene;
  EarlyStages stages(options);
  if (fitted == nullptr) {
    read_vessels(*fidelity, stages, inputs, prediction);
    prediction.inputs = inputs.hashes();
  } else {
    take_vessels(*fidelity, *fitted, prediction);
    prediction.inputs = fitted->inputs;
  }
  for (const VesselSpec& spec : scene.vessels)
    if (left_out(spec, *fidelity))
      prediction.left_out["obstacle " + spec.name] =
          "fidelity " + fidelity->name + ": no surface, nothing to touch";
  require_one_space(prediction);
  prediction.scene_hash = inputs.scene();
  for (const PredictedVessel& vessel : prediction.vessels)
    for (std::size_t v = 0; v < sizes.size(); ++v)
      if (scene.vessels[v].name == vessel.prepared.spec.name)
        sizes[v] = static_cast<double>(vessel.prepared.vessel.surface.points.rows());
  require_memory(scene, fidelity->name, sizes);
  prediction.watch.lap("read");
  if (fitted == nullptr) {
    std::vector<PreparedVessel*> all;
    for (PredictedVessel& vessel : prediction.vessels) all.push_back(&vessel.prepared);
    fit_all(std::move(all), scene, stages);
  }
  for (PredictedVessel& vessel : prediction.vessels)
    if (!vessel.prepared.obstacle())
      vessel.conditions = end_conditions(scene, vessel.prepared.spec.name, vessel.prepared.vessel);
  prediction.watch.lap("fit");
  if (fidelity->coarse_first && scene.glenn)
    for (const PredictedVessel& vessel : prediction.vessels)
      prediction.whole.push_back(vessel.prepared);
  get_ready(prediction, fidelity->lumen, options,
            [&](const std::string& stage) { stages.begin(stage); });
  if (!options.fidelity && !scene.fidelity) {
    const FidelityChoice choice = choose(scene, prediction);
    fidelity = find_fidelity(choice.fidelity);
    prediction.notes.push_back(choice.sentence());
  }
  prediction.fidelity = fidelity->name;
  prediction.watch.lap("rod");
  if (fidelity->surfaces) keep_rods(prediction, options);
  options.progress("fidelity " + fidelity->name);
  placed(place_in(scene), [&] {
    if (options.fidelity || scene.fidelity)
      fidelity->solve(prediction, options);
    else
      fidelity = &solve_chosen(*fidelity, dearest(), prediction, options);
  });
  if (prediction.surfaces) options.progress(prediction.surfaces->solution.brief_report());
  prediction.watch.lap("solve");
  options.solved();
  return whole_result(std::move(prediction), options.threads);
}

// As predict_from(); a result that was interrupted, or whose search for a better one was, says by
// what and where.
Result predict_or_say_why(const Scene& scene, const SolveOptions& given,
                          const FittedVessels* fitted) {
  SolveOptions options = checked(given);
  std::string stage = "reading the scene";
  std::optional<std::string> stopped_at;
  std::once_flag stopped;  // asked by all threads of a factorisation
  options.progress = [&, tell = options.progress](const std::string& next) {
    stage = next;
    tell(next);
  };
  options.stop = [&, stop = options.stop] {
    if (!stop()) return false;
    std::call_once(stopped, [&] { stopped_at = stage; });
    return true;
  };
  Result result = predict_from(scene, options, fitted);
  if (stopped_at) name_stop(options.stopped_by(), *stopped_at, result);
  return result;
}

}  // namespace

std::optional<std::string> SolveOptions::is_invalid() const {
  if (threads < 1) return "threads: found " + std::to_string(threads) + ", expected at least 1";
  if (!(patience >= 0))
    return "patience: found " + number_text(patience) + ", expected seconds of at least 0";
  return std::nullopt;
}

FittedVessels fit_vessels(const Scene& scene, const SolveOptions& given) {
  const SolveOptions options = checked(given);
  check_vessels(scene);
  InputHashes inputs(scene);
  set_threads(options.threads);
  EarlyStages stages(options);
  FittedVessels fitted;
  for (const VesselSpec& spec : scene.vessels)
    fitted.vessels.push_back(read_one(spec, scene, stages, inputs));
  std::vector<PreparedVessel*> all;
  for (PreparedVessel& vessel : fitted.vessels) all.push_back(&vessel);
  fit_all(std::move(all), scene, stages);
  fitted.inputs = inputs.hashes();
  return fitted;
}

Result predict(const Scene& scene, const SolveOptions& options) {
  return predict_or_say_why(scene, options, nullptr);
}

Result predict(const Scene& scene, const SolveOptions& options, const FittedVessels& fitted) {
  return predict_or_say_why(scene, options, &fitted);
}

}  // namespace vasorod
