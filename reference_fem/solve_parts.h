// What solving a tube and solving a join share: checks of the options, and what a path and an error
// estimate say in a result.
#pragma once

#include <cstdio>
#include <string>

#include "reference_fem/refinement.h"
#include "reference_fem/solve_scene.h"

namespace vasorod::fem {

/// printf to a string.
template <class... Values>
std::string text(const char* format, Values... values) {
  char buffer[256];
  std::snprintf(buffer, sizeof buffer, format, values...);
  return buffer;
}

/// Throws InputError for a degree or a number of refinements out of range.
void check_options(const SolveOptions& options);

/// Status, certificate and notes of the path.
void report_path(const StepperSummary& summary, Result& result);

/// "u_num of WHAT: ...".
std::string error_note(const std::string& what, const Convergence& convergence, double ratio);

}  // namespace vasorod::fem
