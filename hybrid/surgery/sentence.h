// Small words for the sentences surgery refuses input with.
#pragma once

#include <cstdio>
#include <string>

#include "geometry/types.h"

namespace vasorod {

inline std::string number_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

inline std::string place_text(const Vec3& p) {
  return "(" + number_text(p.x()) + ", " + number_text(p.y()) + ", " + number_text(p.z()) + ")";
}

}  // namespace vasorod
