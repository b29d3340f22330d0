#include "app/commands.h"

#include <iostream>

#include "app/collect_vessel.h"
#include "app/solve_scene.h"
#include "app/stopwatch.h"
#include "geometry/error.h"
#include "output/compare.h"
#include "output/result_folder.h"
#include "output/write_json.h"
#include "scene/read_surface.h"
#include "scene/sha256.h"
#include "vessel/vessel.h"

namespace vasorod {
namespace {

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
  Result result = solve_scene(scene, options.solve);
  result.environment.inputs[scene.file.filename().string()] = sha256_of_file(scene.file);
  for (const VesselSpec& vessel : scene.vessels)
    if (vessel.surface)
      result.environment.inputs[vessel.surface->filename().string()] = sha256_of_file(*vessel.surface);
  return finish(result, options);
}

int fit_command(const CommandOptions& options) {
  Stopwatch watch;
  Scene scene;
  scene.file = options.input;
  scene.name = options.input.stem().string();
  scene.units.length = options.length_unit;
  scene.units.metres = options.length_unit == "mm" ? 1e-3 : options.length_unit == "cm" ? 1e-2 : 1;
  VesselSpec spec;
  spec.name = scene.name;
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
