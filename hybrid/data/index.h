// Indices: meshes and trees hold them as int and Eigen counts in ptrdiff_t, containers ask for
// size_t.
#pragma once

#include <cstddef>

namespace vasorod {

/// A non-negative index as the containers take it.
constexpr std::size_t index(std::ptrdiff_t i) {
  return static_cast<std::size_t>(i);
}

}  // namespace vasorod
