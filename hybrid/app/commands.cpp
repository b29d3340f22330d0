#include "app/commands.h"

#include <cmath>
#include <iostream>

#include <vasorod/compare.h>
#include <vasorod/read_scene.h>
#include <vasorod/result_folder.h>

#include "data/sentence.h"
#include "result/folder_replacement.h"

namespace vasorod {
namespace {

// A line a person can use: status, what was written, what to look at; warnings of validity each on
// their own line.
void say(const Result& result, const CommandOptions& options) {
  if (options.json) {
    std::cout << to_json(result) << '\n';
    return;
  }
  const double residual = result.certificate.relative_residual;
  std::cout << result.scene << ": " << to_string(result.status) << " (" << result.fidelity << ")";
  if (is_unfinished(result.status))
    std::cout << ", relative residual "
              << (std::isfinite(residual) ? number_text(residual, 3) : "unknown");
  if (result.glenn && result.fidelity != "rod")
    std::cout << ", largest seam gap " << result.glenn->join.largest_gap << ' '
              << result.length_unit;
  std::cout << '\n';
  for (const std::string& warning : result.validity.warnings) std::cout << "  " << warning << '\n';
  std::cout << "  " << (options.folder / "report.html").string() << '\n';
}

int finish(Result& result, const CommandOptions& options) {
  write_result_folder(result, options.folder);
  say(result, options);
  return result.status == Status::converged ? 0 : 1;
}

}  // namespace

int solve_command(const CommandOptions& options) {
  const Scene scene = read_scene(options.input);
  std::vector<std::filesystem::path> inputs{scene.file};
  for (const VesselSpec& vessel : scene.vessels)
    if (vessel.surface) inputs.push_back(*vessel.surface);
  require_outside(options.folder, inputs);
  require_replaceable(options.folder);  // now, not after an hour's solution
  Result result = predict(scene, options.solve);
  return finish(result, options);
}

int fit_command(const CommandOptions& options) {
  require_outside(options.folder, {options.fit.surface});
  require_replaceable(options.folder);
  Result result = fit(options.fit);
  return finish(result, options);
}

int compare_command(const CommandOptions& options) {
  const Comparison comparison = compare_results(options.input, options.second);
  std::cout << (options.json ? comparison_json(comparison) : comparison_table(comparison));
  return 0;
}

}  // namespace vasorod
