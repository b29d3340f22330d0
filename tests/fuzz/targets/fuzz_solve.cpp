// The input as a scene of bare rods or generated tubes, solved for a limited processor time, which
// does not depend on what else the machine does. A result that is converged or in range must hold
// finite numbers only.
#include <algorithm>
#include <ctime>
#include <nlohmann/json.hpp>
#include <set>

#include <vasorod/predict.h>
#include <vasorod/read_scene.h>

#include "fuzz/targets/number_mutator.h"
#include "result/unknown_validity.h"

namespace {

using namespace vasorod;

constexpr std::size_t most_vessels = 4;
constexpr int most_points = 200, most_elements = 24;

// Of processor time. Rods alone take a millisecond; what takes longer tries start after start.
double seconds_for(const Scene& scene) {
  const bool walls = std::any_of(scene.vessels.begin(), scene.vessels.end(),
                                 [](const VesselSpec& vessel) { return vessel.tube.has_value(); });
  return walls ? 0.04 : 0.01;
}

// Larger scenes are not wrong but slow, and surface files have targets of their own. The largest
// seed, a join of two tubes, has 184 points.
bool is_small(const Scene& scene) {
  if (scene.vessels.size() > most_vessels) return false;
  int points = 0, elements = 0;
  for (const VesselSpec& vessel : scene.vessels) {
    if (vessel.surface) return false;
    if (vessel.tube) points += vessel.tube->around * (vessel.tube->along + 1);
    if (!vessel.rod) continue;
    for (const RodPiece& piece : vessel.rod->pieces) elements += piece.elements;
  }
  return points <= most_points && elements <= most_elements;
}

bool can_be_solved(std::string_view text) {
  try {
    return is_small(read_scene_text(std::string(text)));
  } catch (const InputError&) {
    return false;
  }
}

// Says at the end how many inputs were solved, and how many to the end; the others were refused or
// too large.
struct Solved {
  long long count = 0, converged = 0;
  ~Solved() {
    std::fprintf(stderr, "stat::number_of_solved_inputs: %lld\n", count);
    std::fprintf(stderr, "stat::number_of_converged_inputs: %lld\n", converged);
  }
};

// The keys of result.json that docs/result.md allows to be null in a good result.
const std::set<std::string> may_be_null{"smallest_curvature_positive",
                                        "smallest_gap",
                                        "opened_area",
                                        "largest_gap",
                                        "rms_gap",
                                        "threshold",
                                        "strong_threshold"};

void check_json(const nlohmann::json& value, const std::string& key) {
  if (value.is_null() && !may_be_null.contains(key)) fuzz::finding("null at " + key);
  if (value.is_object())
    for (const auto& [name, entry] : value.items()) check_json(entry, name);
  if (value.is_array())
    for (const nlohmann::json& entry : value) check_json(entry, key);
}

void check_fields(const VesselResult& vessel) {
  const bool finite = vessel.rest.allFinite() && vessel.current.allFinite() &&
                      vessel.axial_stretch.allFinite() && vessel.twist_shear.allFinite() &&
                      vessel.contact_pressure.allFinite();
  if (!finite) fuzz::finding("a field of " + vessel.name + " that is not finite");
  if (vessel.centerline && !vessel.centerline->current.allFinite())
    fuzz::finding("a centerline of " + vessel.name + " that is not finite");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::fs::path file = fuzz::folder() / "scene.yaml";
  static Solved solved;
  fuzz::write_file(file, fuzz::text_of(data, size));
  fuzz::accepted([] {
    const Scene scene = read_scene(file);
    if (!is_small(scene)) return;
    SolveOptions options;
    const std::clock_t begin = std::clock();
    options.stop = [begin, clocks = seconds_for(scene) * CLOCKS_PER_SEC] {
      return static_cast<double>(std::clock() - begin) > clocks;
    };
    const Result result = predict(scene, options);
    ++solved.count;
    solved.converged += result.status == Status::converged;
    if (result.status != Status::converged && !known_range(result).value_or(false)) return;
    check_json(nlohmann::json::parse(to_json(result)), "");
    for (const VesselResult& vessel : result.vessels) check_fields(vessel);
  });
  return 0;
}

// Most mutations of a scene are refused when it is read, which the target `scene` does: of a few
// the first is taken that can be solved.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
  const std::string before(fuzz::text_of(data, size));
  std::size_t after = size;
  for (unsigned k = 0; k < 10; ++k) {
    std::memcpy(data, before.data(), size);
    after = fuzz::mutate_scene(data, size, most, seed + k);
    if (can_be_solved(fuzz::text_of(data, after))) break;
  }
  return after;
}
