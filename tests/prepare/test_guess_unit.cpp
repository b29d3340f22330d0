#include <gtest/gtest.h>

#include "prepare/guess_unit.h"

namespace vasorod::testing {
namespace {

// Radius and extent of real vessels, mm: an infant's vein, an adult's aorta, an adult's vein.
TEST(GuessUnit, GreatVesselsAreRecognisedInEveryUnit) {
  for (const auto& [radius, extent] : {std::pair{3.3, 51.0}, {12.0, 250.0}, {8.0, 80.0}})
    for (const std::string unit : {"mm", "cm", "m"}) {
      const double mm = millimetres(unit);
      const GuessedUnit guess = guess_unit(radius / mm, extent / mm);
      EXPECT_EQ(guess.unit, unit) << radius;
      EXPECT_NE(guess.reason.find(unit + " is a guess"), std::string::npos);
    }
}

}  // namespace
}  // namespace vasorod::testing
