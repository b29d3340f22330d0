// The vessels of a scene, read and fitted once for several scenes that differ in their operation.
#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <vasorod/predict.h>

#include "vessel/prepared_vessel.h"

namespace vasorod {

/// What `predict` finds before it looks at ends and operation.
struct FittedVessels {
  std::vector<PreparedVessel> vessels;        ///< in the scene's order; obstacles are only read
  std::map<std::string, std::string> inputs;  ///< InputHashes::hashes()

  /// The vessel of that name, which must be there.
  const PreparedVessel& named(const std::string& name) const {
    return *std::find_if(vessels.begin(), vessels.end(),
                         [&](const PreparedVessel& one) { return one.spec.name == name; });
  }
};

/// Reads all vessels and fits those that deform. Of the options only `stop`, `patience` and
/// `progress` count. Throws as predict() does.
FittedVessels fit_vessels(const Scene& scene, const SolveOptions& options = {});

/// The same result as predict(scene, options) for a scene with the vessels that `fitted` was made
/// of; `seconds` has nothing for what was done before.
Result predict(const Scene& scene, const SolveOptions& options, const FittedVessels& fitted);

}  // namespace vasorod
