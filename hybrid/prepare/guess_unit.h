// The unit of a vessel whose file does not name one.
#pragma once

#include <string>

namespace vasorod {

/// A unit and the sentence that says why.
struct GuessedUnit {
  std::string unit;    ///< mm, cm or m
  std::string reason;  ///< "cm is a guess: in cm the radius is 8.1 mm and the vessel 95 mm long"
};

/// The first of mm, cm and m in which a great vessel may have this typical radius (1.5 to 30 mm)
/// and this extent (20 to 1000 mm); else the first in which the radius is 0.5 to 50 mm; else mm.
GuessedUnit guess_unit(double radius, double extent);

/// Millimetres in a unit: mm, cm, m or um.
double millimetres(const std::string& unit);

}  // namespace vasorod
