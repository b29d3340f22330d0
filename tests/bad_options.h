// What every solver's options promise of is_invalid(): the defaults are valid, and a field out of
// its range is named.
#pragma once

#include <gtest/gtest.h>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace vasorod::testing {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// Sets `field` to each value of `bad`, one at a time, and expects a sentence that begins with
/// `name`.
template <class Options, class Owner, class Value>
void expect_named(const std::string& name, Value Owner::*field, const std::vector<Value>& bad) {
  ASSERT_FALSE(bad.empty());
  for (const Value& value : bad) {
    Options options;
    ASSERT_FALSE(options.is_invalid());
    options.*field = value;
    const std::optional<std::string> fault = options.is_invalid();
    ASSERT_TRUE(fault) << name << " = " << ::testing::PrintToString(value) << " was accepted";
    EXPECT_EQ(fault->rfind(name + ": expected ", 0), 0u) << *fault;
  }
}

/// A field that must be a finite number above 0.
template <class Options, class Owner>
void expect_positive(const std::string& name, double Owner::*field) {
  expect_named<Options>(name, field, {0.0, -1.0, infinite, no_number});
}

/// The others stay valid at the ends of their ranges.
template <class Options, class Owner, class Value>
void expect_valid(Value Owner::*field, const std::vector<Value>& good) {
  ASSERT_FALSE(good.empty());
  for (const Value& value : good) {
    Options options;
    options.*field = value;
    const std::optional<std::string> fault = options.is_invalid();
    EXPECT_FALSE(fault) << *fault;
  }
}

}  // namespace vasorod::testing
