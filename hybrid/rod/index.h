// Node and element numbers are int in the data; containers want std::size_t.
#pragma once

#include <cstddef>

namespace vasorod {

inline std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace vasorod
