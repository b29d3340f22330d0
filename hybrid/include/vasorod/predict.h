// Solves a scene with the hybrid model: a scene in, a result out.
#pragma once

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <vasorod/result.h>
#include <vasorod/scene.h>

namespace vasorod {

/// The caller stopped a prediction that had no state yet to return. The message is one sentence
/// with what was being done. The programs write nothing and exit with code 1.
struct StoppedEarly : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// How a scene is solved.
struct SolveOptions {
  /// One of fidelity_names(); overrides the scene's fidelity. Empty: the scene's.
  std::optional<std::string> fidelity;
  /// Also compute the inertia of the surfaces' exact Hessian. Costs one factorisation.
  bool certify = false;
  /// Number of threads. The numbers do not depend on it.
  int threads = 1;
  /// Called often; returning true ends the solve with the best state so far. Asked between vessels,
  /// stages and iterations and within factorisations, not within orderings. May be empty.
  std::function<bool()> stop;
  /// What `stop` stops by, for an interrupted result's sentence: "the time limit of 5 s". Asked
  /// after `stop` was true. Empty: "the caller".
  std::function<std::string()> stopped_by;
  /// Seconds for which reading, fitting and surgery go on to reach a first state after `stop` was
  /// first true; then StoppedEarly is thrown.
  double patience = 1.5;
  /// Called with one line of text at each stage and before each ordering and factorisation. May be
  /// empty.
  std::function<void(const std::string&)> progress;
  /// Called with the state so far whenever a new one is worth keeping, as a function that makes a
  /// result (status interrupted) of it. That function may be called later and from another thread,
  /// as long as the scene lives: a program that must end while a long step goes on has something to
  /// write. May be empty.
  std::function<void(std::function<Result()>)> keep;
  /// Called when solving has ended and only the result remains to be put together. May be empty.
  std::function<void()> solved;

  /// Empty if the options are valid; else one sentence that names the invalid option.
  std::optional<std::string> is_invalid() const;
};

/// Names of the available fidelities, from cheap to expensive.
std::vector<std::string> fidelity_names();

/// Solves a scene with the hybrid model: reads and fits the vessels, performs the operation, solves
/// the rods, then the fidelity's own surface problem. Lengths and stresses are in the scene's
/// units. A numerical outcome is the result's status. Throws InputError (one sentence) if the scene
/// cannot be solved as requested, a missing surface too; FileError if one may not be read;
/// StoppedEarly if it was stopped before there was a state; std::bad_alloc if the memory does not
/// suffice.
Result predict(const Scene& scene, const SolveOptions& options = {});

}  // namespace vasorod
