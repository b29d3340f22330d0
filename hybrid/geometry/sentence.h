// Numbers and places as the sentences that refuse an input write them.
#pragma once

#include <cstdio>
#include <string>

#include "geometry/types.h"

namespace vasorod {

/// `digits` significant digits, and no more than the number needs.
inline std::string number_text(double value, int digits = 4) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

/// "(x, y, z)", fine enough to find the place in the file.
inline std::string place_text(const Vec3& p) {
  return "(" + number_text(p.x(), 6) + ", " + number_text(p.y(), 6) + ", " + number_text(p.z(), 6) + ")";
}

}  // namespace vasorod
