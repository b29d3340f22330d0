// Lengths and places in the sentences of `vasorod prepare`.
#pragma once

#include <cmath>
#include <string>

#include <vasorod/types.h>

#include "data/sentence.h"

namespace vasorod {

/// "3.91 mm"
inline std::string in_mm(double value) {
  return number_text(value, 3) + " mm";
}

/// "(21.32, 15.78, 1.15)", to a hundredth.
inline std::string place_mm(const Vec3& place) {
  return place_text(place.unaryExpr([](double x) { return std::round(100 * x) / 100; }), 5);
}

}  // namespace vasorod
