// Pressures in millimetres of mercury, the unit of the clinic.
#pragma once

#include <string>

namespace vasorod {

/// Millimetres of mercury (133.322387415 Pa each) per stress unit: Pa, kPa or MPa.
inline double mmhg_per(const std::string& stress_unit) {
  const double pascals = stress_unit == "MPa" ? 1e6 : stress_unit == "kPa" ? 1e3 : 1;
  return pascals / 133.322387415;
}

}  // namespace vasorod
