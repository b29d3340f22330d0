#include <chrono>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <gtest/gtest.h>

#include "app/stop.h"

namespace vasorod {
namespace {

// Asks until it says stop; false where it has not within ten seconds.
bool stops(const std::function<bool()>& stop) {
  const auto begin = std::chrono::steady_clock::now();
  while (std::chrono::steady_clock::now() - begin < std::chrono::seconds(10))
    if (stop()) return true;
  return false;
}

TEST(Stop, WithoutALimitNothingStops) {
  const auto stop = stop_on_signal_or_after(0);
  for (int i = 0; i < 1000; ++i) ASSERT_FALSE(stop());
}

TEST(Stop, ALimitCountsFromTheCall) {
  const auto soon = stop_on_signal_or_after(1e-3), late = stop_on_signal_or_after(3600);
  EXPECT_TRUE(stops(soon));
  EXPECT_TRUE(soon()) << "and stays so";
  EXPECT_FALSE(late());
  EXPECT_EQ(stopped_by_signal_or(1e-3), "the time limit of 0.001 s");
}

// A flag that is up stays up: each signal in a process of its own.
class StopSignal : public ::testing::TestWithParam<int> {};

TEST_P(StopSignal, OnlyRaisesAFlag) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto raised = [] {
    const auto stop = stop_on_signal_or_after(0);
    if (stop()) std::exit(1);
    std::raise(GetParam());
    if (!stop()) std::exit(2);
    std::exit(stopped_by_signal_or(5) == "a signal" ? 0 : 3);
  };
  EXPECT_EXIT(raised(), ::testing::ExitedWithCode(0), "");
}

INSTANTIATE_TEST_SUITE_P(Signals, StopSignal, ::testing::Values(SIGINT, SIGTERM));

}  // namespace
}  // namespace vasorod
