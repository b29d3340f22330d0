// The commands of the program as functions: options in, exit code out.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/options.h"

namespace vasorod {

struct CommandOptions {
  std::filesystem::path input, second, folder;
  bool json = false;
  std::string length_unit = "mm";  ///< `fit` only
  std::optional<double> remesh;    ///< `fit` only: target edge, length
  SolveOptions solve;
};

/// "vasorod 0.1.0".
std::string program_version();

int solve_command(const CommandOptions& options);    ///< 0 converged, 1 any other status
int fit_command(const CommandOptions& options);      ///< 0
int compare_command(const CommandOptions& options);  ///< 0

}  // namespace vasorod
