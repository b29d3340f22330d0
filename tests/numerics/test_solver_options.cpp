#include <chrono>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "numerics/solver_options.h"

namespace vasorod {
namespace {

void wait_until(const StopCheck& stop, double seconds) {
  while (stop.seconds() < seconds) {
  }
}

TEST(StopCheck, WithoutOptionsItNeverStops) {
  const SolverOptions options;
  const StopCheck stop(options);
  EXPECT_FALSE(stop());
  EXPECT_FALSE(stop(SolverProgress{}));
  wait_until(stop, 1e-3);
  EXPECT_FALSE(stop());
}

TEST(StopCheck, ATimeLimitCountsFromConstruction) {
  SolverOptions options;
  options.time_limit = 0;
  const StopCheck at_once(options);
  wait_until(at_once, 1e-6);
  EXPECT_TRUE(at_once());
  EXPECT_TRUE(at_once(SolverProgress{}));
  options.time_limit = 3600;
  const StopCheck later(options);
  EXPECT_FALSE(later());
  EXPECT_FALSE(later(SolverProgress{}));
}

TEST(StopCheck, SecondsAreThoseOfTheWallClock) {
  const SolverOptions options;
  const auto before = std::chrono::steady_clock::now();
  const StopCheck stop(options);
  const auto after = std::chrono::steady_clock::now();
  wait_until(stop, 2e-3);
  const double inner =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - after).count();
  const double measured = stop.seconds();
  const double outer =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
  EXPECT_LE(inner, measured);
  EXPECT_LE(measured, outer);
}

TEST(StopCheck, TheCallerIsAskedEachTimeAndMayChangeHisMind) {
  SolverOptions options;
  int asked = 0;
  bool answer = false;
  options.stop = [&] {
    ++asked;
    return answer;
  };
  const StopCheck stop(options);
  EXPECT_FALSE(stop());
  answer = true;
  EXPECT_TRUE(stop());
  EXPECT_TRUE(stop(SolverProgress{}));
  EXPECT_EQ(asked, 3);
}

TEST(StopCheck, ProgressIsToldBeforeTheCallerIsAsked) {
  SolverOptions options;
  std::vector<std::string> order;
  SolverProgress told;
  options.progress = [&](const SolverProgress& at) {
    told = at;
    order.push_back("told");
  };
  options.stop = [&] {
    order.push_back("asked");
    return true;
  };
  const StopCheck stop(options);
  EXPECT_TRUE(stop({2, 17, 0.125}));
  EXPECT_EQ(told.outer, 2);
  EXPECT_EQ(told.iterations, 17);
  EXPECT_EQ(told.residual, 0.125);
  EXPECT_EQ(order, (std::vector<std::string>{"told", "asked"}));
  EXPECT_TRUE(stop());
  EXPECT_EQ(order.size(), 3u) << "asked without anything to tell";
}

TEST(OptionCheck, TheFirstFaultIsTheOneTold) {
  EXPECT_FALSE(first_fault({}));
  EXPECT_FALSE(first_fault({{true, "a"}, {true, "b"}}));
  EXPECT_EQ(first_fault({{true, "a"}, {false, "b"}, {false, "c"}}), "b");
}

}  // namespace
}  // namespace vasorod
