// Solves a scene with the hybrid model: a scene in, a result out.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <vasorod/result.h>
#include <vasorod/scene.h>

namespace vasorod {

/// How a scene is solved.
struct SolveOptions {
  /// One of fidelity_names(); overrides the scene's fidelity. Empty: the scene's.
  std::optional<std::string> fidelity;
  /// Also compute the inertia of the surfaces' exact Hessian. Costs one factorisation.
  bool certify = false;
  /// Number of threads. With 1, two runs on one machine agree in everything but their times.
  int threads = 1;
  /// Called often; returning true ends the solve with the best state so far. May be empty.
  std::function<bool()> stop;
  /// Called with one line of text at each stage. May be empty.
  std::function<void(const std::string&)> progress;

  /// Empty if the options are valid; else one sentence that names the invalid option.
  std::optional<std::string> is_invalid() const;
};

/// Names of the available fidelities, from cheap to expensive.
std::vector<std::string> fidelity_names();

/// Solves a scene with the hybrid model: reads and fits the vessels, performs the operation, solves
/// the rods, then the fidelity's own surface problem. Lengths and stresses are in the scene's
/// units. A numerical outcome is the result's status. Throws InputError (one sentence) if the scene
/// cannot be solved as requested, a missing surface too; FileError if one may not be read.
Result predict(const Scene& scene, const SolveOptions& options = {});

}  // namespace vasorod
