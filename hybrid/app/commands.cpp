#include "app/commands.h"

#include <algorithm>
#include <cctype>
#include <iostream>

#include "app/collect_vessel.h"
#include "app/solve_scene.h"
#include "app/stopwatch.h"
#include "geometry/error.h"
#include "output/compare.h"
#include "output/folder_replacement.h"
#include "output/result_folder.h"
#include "output/write_json.h"
#include "scene/read_surface.h"
#include "scene/sha256.h"
#include "vessel/vessel.h"

namespace vasorod {
namespace {

// What a vessel of a scene may be called (scene/read_vessels.cpp): the name becomes those of files.
std::string vessel_name(std::string text) {
  for (char& c : text)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-') c = '_';
  return text;
}

// A surface as result.json lists it: by its name, or by its path where another input has that name too.
std::string input_name(const Scene& scene, const std::filesystem::path& surface) {
  const auto taken = [&](const std::filesystem::path& other) {
    return other.filename() == surface.filename() && other.lexically_normal() != surface.lexically_normal();
  };
  const bool shared = taken(scene.file) ||
                      std::any_of(scene.vessels.begin(), scene.vessels.end(), [&](const VesselSpec& vessel) {
                        return vessel.surface && taken(*vessel.surface);
                      });
  if (!shared) return surface.filename().string();
  const std::filesystem::path beside = surface.lexically_relative(scene.file.parent_path());
  return (beside.empty() ? surface : beside).generic_string();
}

// A line a person can use: status, what was written, what to look at; warnings of validity each on their own
// line.
void say(const Result& result, const CommandOptions& options) {
  if (options.json) {
    std::cout << to_json(result) << '\n';
    return;
  }
  std::cout << result.scene << ": " << to_string(result.status) << " (" << result.fidelity << ")";
  if (result.glenn && result.fidelity != "rod")
    std::cout << ", largest seam gap " << result.glenn->join.largest_gap << ' ' << result.length_unit;
  std::cout << '\n';
  for (const std::string& warning : result.validity.warnings) std::cout << "  " << warning << '\n';
  std::cout << "  " << (options.folder / "report.html").string() << '\n';
}

int finish(Result& result, const CommandOptions& options) {
  result.program = program_version();
  write_result_folder(result, options.folder);
  say(result, options);
  return result.status == Status::converged ? 0 : 1;
}

}  // namespace

std::string program_version() {
  return "vasorod " VASOROD_VERSION;
}

int solve_command(const CommandOptions& options) {
  const Scene scene = read_scene(options.input);
  require_replaceable(options.folder);  // now, not after an hour's solution
  Result result = solve_scene(scene, options.solve);
  result.environment.inputs[scene.file.filename().string()] = sha256_of_file(scene.file);
  for (const VesselSpec& vessel : scene.vessels)
    if (vessel.surface)
      result.environment.inputs[input_name(scene, *vessel.surface)] = sha256_of_file(*vessel.surface);
  return finish(result, options);
}

int fit_command(const CommandOptions& options) {
  require_replaceable(options.folder);
  Stopwatch watch;
  Scene scene;
  scene.file = options.input;
  scene.name = options.input.stem().string();
  scene.units.length = options.length_unit;
  scene.units.metres = options.length_unit == "mm" ? 1e-3 : options.length_unit == "cm" ? 1e-2 : 1;
  VesselSpec spec;
  spec.name = vessel_name(scene.name);
  spec.surface = options.input;
  spec.remesh = options.remesh;
  const LoadedSurface loaded = load_surface(spec, scene);
  watch.lap("read");
  const Vessel vessel = fit_vessel(spec.name, loaded.surface);
  watch.lap("fit");
  Result result = fitted_result(spec.name, loaded, vessel);
  result.length_unit = options.length_unit;
  result.seconds = watch.seconds();
  result.environment.inputs[options.input.filename().string()] = sha256_of_file(options.input);
  return finish(result, options);
}

int compare_command(const CommandOptions& options) {
  const Comparison comparison = compare_results(options.input, options.second);
  std::cout << (options.json ? comparison_json(comparison) : comparison_table(comparison));
  return 0;
}

}  // namespace vasorod
