// The commands of the program as functions: options in, exit code out.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <vasorod/fit.h>
#include <vasorod/predict.h>

#include "prepare/prepare.h"
#include "report/draw_result.h"

namespace vasorod {

struct CommandOptions {
  std::filesystem::path input, second, folder;
  bool json = false;
  bool report = true;     ///< `solve` only; false: numbers and VTP only
  int picture_width = 0;  ///< `solve` only; pixels, 0: the page's
  FitRequest fit;         ///< `fit` only
  SolveOptions solve;     ///< `solve` only
  DrawOptions draw;       ///< `draw` only; the picture's file is `folder`
};

struct InitOptions {
  std::vector<std::filesystem::path> surfaces;
  std::filesystem::path scene;             ///< must not exist
  std::optional<std::string> length_unit;  ///< empty: guessed
  std::function<void(const std::string&)> progress = [](const std::string&) {};
};

/// What the command line says over the scene's `explore`.
struct ExploreCommandOptions {
  std::filesystem::path scene, folder;
  int threads = 1;
  bool report = true;               ///< false: no pictures and no report.html
  bool progress = false;            ///< a line on standard error that is written over
  std::vector<std::string> stages;  ///< empty: the scene's
  int best = 0;                     ///< 0: the scene's
  int list = 0;                     ///< print the options of this stage, from 1; 0: explore
  std::string only;                 ///< solve this option alone; empty: explore
  std::function<bool()> stop;
};

struct PrepareCommandOptions {
  PrepareRequest request;
  std::filesystem::path output;  ///< VTP; replaced where it exists
  bool json = false;             ///< the report as JSON on standard output
};

int solve_command(const CommandOptions& options);    ///< 0 converged, 1 any other status
int fit_command(const CommandOptions& options);      ///< 0
int compare_command(const CommandOptions& options);  ///< 0
int draw_command(const CommandOptions& options);     ///< 0
int init_command(const InitOptions& options);        ///< 0
/// 0, or 1 where the surface is written but `fit` refuses it.
int prepare_command(const PrepareCommandOptions& options);
/// 0 every option was tried and at least one converged at the last stage, 1 otherwise.
int explore_command(const ExploreCommandOptions& options);

}  // namespace vasorod
