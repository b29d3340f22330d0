// A scene in, a result out: the hybrid model as one call.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <vasorod/result.h>
#include <vasorod/scene.h>

namespace vasorod {

struct SolveOptions {
  std::optional<std::string> fidelity;  ///< one of fidelity_names(); overrides the scene's
  bool certify =
      false;  ///< ask for the inertia of the surfaces' true Hessian too; costs a factorisation
  int threads = 1;             ///< 1: two runs on one machine differ in nothing but seconds
  std::function<bool()> stop;  ///< asked often; true ends with the best state so far; may be empty
  std::function<void(const std::string&)>
      progress;  ///< told one line on what is done now; may be empty

  /// Empty where the options are valid; else one sentence that says which is not.
  std::optional<std::string> is_invalid() const;
};

/// The fidelities there are, from cheap to expensive.
std::vector<std::string> fidelity_names();

/// Solves a scene with the hybrid model: vessels are read and fitted, the operation is done, rods
/// are solved, then what the fidelity adds. Lengths and stresses are in the scene's units. A
/// numerical outcome is the result's status. Throws InputError (one sentence) on what cannot be
/// solved as asked, FileError where a surface cannot be read.
Result predict(const Scene& scene, const SolveOptions& options = {});

}  // namespace vasorod
