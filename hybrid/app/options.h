// What the commands share: options, the wish to stop, and progress on a terminal.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "scene/scene.h"

namespace vasorod {

struct SolveOptions {
  std::optional<Fidelity> fidelity;  ///< overrides the scene's
  bool certify = false;              ///< ask for the inertia of the surfaces' true Hessian too
  int threads = 1;                   ///< 1: two runs on one machine differ in nothing but seconds
  std::function<bool()> stop = [] { return false; };  ///< Ctrl-C or the time limit: end with the best state
  std::function<void(const std::string&)> progress = [](const std::string&) {
  };  ///< one line on what is done now
};

}  // namespace vasorod
