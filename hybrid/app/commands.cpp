#include "app/commands.h"

#include <cmath>
#include <fstream>
#include <iostream>

#include <vasorod/compare.h>
#include <vasorod/error.h>
#include <vasorod/read_scene.h>
#include <vasorod/result_folder.h>

#include "app/ending.h"
#include "app/watchdog.h"
#include "data/sentence.h"
#include "predict/kept_state.h"
#include "predict/name_stop.h"
#include "result/folder_replacement.h"
#include "result/read_folder.h"
#include "result/unknown_validity.h"

namespace vasorod {
namespace {

std::string radii(const FittedLength& part, const std::string& unit) {
  return "radius " + number_text(part.smallest_radius, 4) + " to " +
         number_text(part.largest_radius, 4) + " " + unit + ", mean " +
         number_text(part.mean_radius, 4) + " " + unit;
}

// Without the rounding errors of zero.
Vec3 readable(const Vec3& v) {
  return v.unaryExpr([](double x) { return std::abs(x) < 1e-6 ? 0 : x; });
}

// What `fit` found: the vessel, its branches where it forks, and its ends.
void say_fit(const Result& result) {
  const FitReport& fit = *result.fit;
  const std::string& unit = result.length_unit;
  const auto length = [&](const FittedLength& part) {
    return "length " + number_text(part.length, 4) + " " + unit + ", " + radii(part, unit);
  };
  std::cout << result.scene << ": " << length(fit.whole) << '\n';
  if (fit.branches.size() > 1)
    for (std::size_t k = 0; k < fit.branches.size(); ++k)
      std::cout << "  branch " << k + 1 << ": " << length(fit.branches[k]) << '\n';
  for (const FittedEnd& end : fit.ends)
    std::cout << "  end " << end.end << (end.name.empty() ? "" : ", ModelFaceID " + end.name)
              << ": centre " << place_text(readable(end.center), 4) << ", radius "
              << number_text(end.radius, 4) << ' ' << unit << ", normal "
              << place_text(readable(end.normal), 3) << '\n';
}

// What a reader opens first.
const char* page_of(const CommandOptions& options) {
  return options.report ? "report.html" : "result.json";
}

// The status, and of a solution what a reader should look at.
void say_status(const Result& result, const CommandOptions& options) {
  const double residual = result.certificate.relative_residual;
  std::cout << result.scene << ": " << to_string(result.status) << " (" << result.fidelity << ")";
  if (is_unfinished(result.status))
    std::cout << ", relative residual "
              << (std::isfinite(residual) ? number_text(residual, 3) : "unknown");
  const auto joined = joined_vessels(result);
  if (joined && result.fidelity != "rod" && is_solution(result.status))
    std::cout << ", largest seam gap " << joined->seam->largest_gap << ' ' << result.length_unit;
  std::cout << '\n';
  if (!is_solution(result.status)) std::cout << "  " << why_unknown(result.status) << '\n';
  if (is_unfinished(result.status))
    for (const std::string& note : result.certificate.notes) std::cout << "  " << note << '\n';
  for (const Criterion& criterion : result.criteria)
    if (criterion.verdict == Verdict::warning || criterion.verdict == Verdict::strong_warning)
      std::cout << "  " << criterion.name << " of " << criterion.vessel << ' '
                << number_text(criterion.value, 3)
                << (criterion.unit.empty() ? "" : " " + criterion.unit)
                << (criterion.verdict == Verdict::warning ? ": warning" : ": strong warning")
                << " (" << page_of(options) << " has the thresholds and their source)\n";
}

void say(const Result& result, const CommandOptions& options) {
  if (options.json) {
    std::cout << to_json(result) << '\n';
    return;
  }
  if (result.fit)
    say_fit(result);
  else
    say_status(result, options);
  for (const std::string& warning : result.validity.warnings) std::cout << "  " << warning << '\n';
  std::cout << "  " << (options.folder / page_of(options)).string() << '\n';
}

int finish(Result& result, const CommandOptions& options) {
  WriteOptions write;
  write.stop = options.solve.stop;
  write.report = options.report;
  write.picture_width = options.picture_width;
  write_result_folder(result, options.folder, write);
  say(result, options);
  return result.status == Status::converged ? 0 : 1;
}

// Called by the watchdog: writes the last state, or reports that there is none.
int end_in_the_middle(const Watchdog::MakeResult& state, const std::string& stage,
                      const CommandOptions& options) {
  try {
    if (!state) stop_early(stage);
    Result result = state();
    name_stop(options.solve.stopped_by(), stage, result);
    return finish(result, options);
  } catch (...) {
    return say_failure();
  }
}

}  // namespace

int solve_command(const CommandOptions& options) {
  Scene scene;  // outlives the watchdog, whose states refer to it
  Watchdog watchdog(options.solve.stop,
                    [&](const Watchdog::MakeResult& state, const std::string& stage) {
                      return end_in_the_middle(state, stage, options);
                    });
  watchdog.begin("reading the scene");
  scene = read_scene(options.input);
  require_outside(options.folder, input_files(scene));
  require_replaceable(options.folder);  // before the solve, which may take an hour
  SolveOptions solve = options.solve;
  solve.stop = [&] { return watchdog.stop(); };
  solve.progress = [&](const std::string& stage) {
    watchdog.begin(stage);
    if (options.solve.progress) options.solve.progress(stage);
  };
  solve.keep = [&](Watchdog::MakeResult state) { watchdog.keep(std::move(state)); };
  solve.solved = [&] { watchdog.stand_down(); };
  Result result = predict(scene, solve);
  watchdog.stand_down();
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

int draw_command(const CommandOptions& options) {
  const std::filesystem::path& file = options.folder;
  if (file.extension() != ".png")
    throw InputError(file.string() + ": expected the name of a picture that ends in .png");
  const std::string png = draw_result(read_result_folder(options.input), options.draw);
  std::ofstream stream(file, std::ios::binary);
  stream.write(png.data(), static_cast<std::streamsize>(png.size()));
  if (!stream.flush()) throw FileError(file.string() + ": cannot be written");
  return 0;
}

}  // namespace vasorod
