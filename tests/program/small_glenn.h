// A small Glenn shunt of two generated tubes, in the model's range and solved within seconds.
#pragma once

#include <string>

#include "data/whole_file.h"

namespace vasorod::testing {

/// small_glenn.yaml at a fidelity, without its first line, which is for editors.
inline std::string small_glenn(const std::string& fidelity) {
  std::string text = whole_file(VASOROD_SOURCE_DIR "/tests/program/small_glenn.yaml");
  text.erase(0, text.find('\n') + 1);
  const std::string there = "fidelity: skin";
  return text.replace(text.find(there), there.size(), "fidelity: " + fidelity);
}

}  // namespace vasorod::testing
