#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "data/sentence.h"

namespace vasorod {
namespace {

using Words = std::vector<std::string>;

TEST(Sentence, NumbersHaveNoMoreDigitsThanTheyNeed) {
  EXPECT_EQ(number_text(0), "0");
  EXPECT_EQ(number_text(2), "2");
  EXPECT_EQ(number_text(-0.25), "-0.25");
  EXPECT_EQ(number_text(1.0 / 3), "0.333333");
  EXPECT_EQ(number_text(1.0 / 3, 2), "0.33");
  EXPECT_EQ(number_text(1234567), "1.23457e+06");
  EXPECT_EQ(number_text(1234567, 7), "1234567");
  EXPECT_EQ(number_text(1e-9), "1e-09");
  EXPECT_EQ(number_text(std::numeric_limits<double>::quiet_NaN()), "nan");
  EXPECT_EQ(number_text(-std::numeric_limits<double>::infinity()), "-inf");
}

TEST(Sentence, ANumberBesideALimitDoesNotReachItByRounding) {
  EXPECT_EQ(number_beside(0.42, 0.6, 2), "0.42");
  EXPECT_EQ(number_beside(0.599, 0.6, 2), "0.599");
  EXPECT_EQ(number_beside(0.59999, 0.6, 2), "0.59999");
  EXPECT_EQ(number_beside(0.6004, 0.6, 2), "0.6004");
  EXPECT_EQ(number_beside(0.6, 0.6, 2), "0.6");
  EXPECT_EQ(number_beside(20.04, 20, 2), "20.04");
  EXPECT_EQ(number_beside(-1.001, -1, 2), "-1.001");
  const double nearest = std::nextafter(0.6, 0);
  EXPECT_EQ(std::stod(number_beside(nearest, 0.6, 2)), nearest);
  EXPECT_EQ(number_beside(std::numeric_limits<double>::infinity(), 1, 2), "inf");
}

TEST(Sentence, TheLongestNumberFits) {
  const double longest = -std::numeric_limits<double>::max();
  EXPECT_EQ(std::stod(number_text(longest, 17)), longest);
}

TEST(Sentence, PlacesAreThreeNumbersInBrackets) {
  EXPECT_EQ(place_text({1, -2.5, 1.0 / 3}), "(1, -2.5, 0.333333)");
  EXPECT_EQ(place_text({1, -2.5, 1.0 / 3}, 3), "(1, -2.5, 0.333)");
}

TEST(Sentence, QuotedTextStaysOnItsLineAndShort) {
  EXPECT_EQ(in_quotes("svc"), "\"svc\"");
  EXPECT_EQ(in_quotes(""), "\"\"");
  EXPECT_EQ(in_quotes("a\nb\tc\x7f"), "\"a\\nb\\tc\\x7f\"");
  EXPECT_EQ(in_quotes("Gefäß"), "\"Gefäß\"");
  EXPECT_EQ(in_quotes(std::string(60, 'x')), "\"" + std::string(60, 'x') + "\"");
  EXPECT_EQ(in_quotes(std::string(61, 'x')), "\"" + std::string(60, 'x') + "...\"");
  EXPECT_EQ(in_quotes(std::string("a\0b", 3)), "\"a\\x00b\"");
}

TEST(Sentence, ListsEndWithOr) {
  EXPECT_EQ(listed({}), "");
  EXPECT_EQ(listed({"rod"}), "rod");
  EXPECT_EQ(listed({"rod", "skin"}), "rod or skin");
  EXPECT_EQ(listed({"rod", "skin", "paper"}), "rod, skin or paper");
}

TEST(Sentence, TheWordThatWasMeantIsAtMostTwoLettersOff) {
  const Words known{"rod", "skin", "paper", "coupled"};
  EXPECT_EQ(nearest_word("paper", known), "paper");
  EXPECT_EQ(nearest_word("papers", known), "paper");     // one more
  EXPECT_EQ(nearest_word("paer", known), "paper");       // one less
  EXPECT_EQ(nearest_word("sken", known), "skin");        // one other
  EXPECT_EQ(nearest_word("copuled", known), "coupled");  // two swapped: two others
  EXPECT_EQ(nearest_word("cupld", known), "coupled");
  EXPECT_FALSE(nearest_word("cpld", known));
  EXPECT_FALSE(nearest_word("elephant", known));
  EXPECT_FALSE(nearest_word("", known));
  EXPECT_FALSE(nearest_word("paper", {}));
}

TEST(Sentence, TheNearestOfSeveralIsMeantAndNothingIsGuessedFromNothing) {
  EXPECT_EQ(nearest_word("end_radios", {"end_radii", "end_radius"}), "end_radius");
  // Two letters off a word of two letters is every word of two letters.
  EXPECT_FALSE(nearest_word("xx", {"at"}));
  EXPECT_EQ(nearest_word("xt", {"at"}), "at");
  EXPECT_FALSE(nearest_word(std::string(101, 'a'), {std::string(101, 'a')}));
}

}  // namespace
}  // namespace vasorod
