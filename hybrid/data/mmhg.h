// Units of pressure, millimetres of mercury (the clinic's) among them.
#pragma once

#include <string>

namespace vasorod {

/// Pascals per unit: mmHg, Pa, kPa or MPa.
inline double pascals_per(const std::string& unit) {
  if (unit == "mmHg") return 133.322387415;
  return unit == "MPa" ? 1e6 : unit == "kPa" ? 1e3 : 1;
}

/// Millimetres of mercury per stress unit: Pa, kPa or MPa.
inline double mmhg_per(const std::string& stress_unit) {
  return pascals_per(stress_unit) / pascals_per("mmHg");
}

}  // namespace vasorod
