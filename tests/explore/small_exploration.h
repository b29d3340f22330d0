// The small shunt of two tubes with options.
#pragma once

#include <vasorod/read_scene.h>

#include "program/small_glenn.h"

namespace vasorod::testing {

/// `options`: what stands in the braces of `explore`.
inline Scene small_exploration(const std::string& options) {
  return read_scene_text(small_glenn("skin") + "explore: {" + options + "}\n");
}

}  // namespace vasorod::testing
