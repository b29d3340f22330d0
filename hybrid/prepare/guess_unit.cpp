#include "prepare/guess_unit.h"

#include "data/sentence.h"

namespace vasorod {

double millimetres(const std::string& unit) {
  return unit == "m" ? 1e3 : unit == "cm" ? 10 : unit == "um" ? 1e-3 : 1;
}

GuessedUnit guess_unit(double radius, double extent) {
  const auto between = [](double value, double least, double most) {
    return value >= least && value <= most;
  };
  const auto guessed = [&](const std::string& unit) {
    const double mm = millimetres(unit);
    return GuessedUnit{unit, unit + " is a guess: then the radius is about " +
                                 number_text(mm * radius, 2) + " mm and the extent " +
                                 number_text(mm * extent, 2) + " mm (--units states another)"};
  };
  for (const std::string unit : {"mm", "cm", "m"})
    if (between(millimetres(unit) * radius, 1.5, 30) &&
        between(millimetres(unit) * extent, 20, 1000))
      return guessed(unit);
  for (const std::string unit : {"mm", "cm", "m"})
    if (between(millimetres(unit) * radius, 0.5, 50)) return guessed(unit);
  return guessed("mm");
}

}  // namespace vasorod
