#include <csignal>
#include <cstdlib>
#include <gtest/gtest.h>
#include <unistd.h>

#include "app/watchdog.h"

namespace vasorod {
namespace {

using namespace std::chrono_literals;

// No test waits this long: it only keeps a failure from hanging.
constexpr unsigned longest = 60;

// A solver that never answers: the watchdog ends the process with `end`'s exit code.
[[noreturn]] void hang() {
  alarm(longest);
  for (;;) pause();
}

TEST(Watchdog, WithoutAStopItDoesNothing) {
  bool ended = false;
  {
    Watchdog watchdog([] { return false; },
                      [&](const Watchdog::MakeResult&, const std::string&) {
                        ended = true;
                        return 9;
                      },
                      1ms);
    std::this_thread::sleep_for(200ms);
  }
  EXPECT_FALSE(ended);
}

TEST(Watchdog, ASolverThatAnswersIsLeftAlone) {
  Watchdog watchdog([] { return true; },
                    [](const Watchdog::MakeResult&, const std::string&) { return 9; }, 1h);
  EXPECT_TRUE(watchdog.stop());
  watchdog.stand_down();
}

TEST(WatchdogDeathTest, ASolverThatDoesNotAnswerIsEndedWithTheLastStateAndStage) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto stuck = [] {
    Watchdog watchdog([] { return true; },
                      [](const Watchdog::MakeResult& state, const std::string& stage) {
                        return state && state().scene == "second" && stage == "factorisation" ? 7
                                                                                              : 8;
                      },
                      300ms);
    for (const std::string name : {"first", "second"})
      watchdog.keep([name] {
        Result result;
        result.scene = name;
        return result;
      });
    watchdog.begin("ordering");
    watchdog.begin("factorisation");
    hang();
  };
  EXPECT_EXIT(stuck(), ::testing::ExitedWithCode(7), "");
}

TEST(WatchdogDeathTest, WithoutAStateItSaysSo) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto stuck = [] {
    Watchdog watchdog(
        [] { return true; },
        [](const Watchdog::MakeResult& state, const std::string&) { return state ? 8 : 7; }, 1ms);
    hang();
  };
  EXPECT_EXIT(stuck(), ::testing::ExitedWithCode(7), "");
}

// Signs of life put the end off, but not for ever.
TEST(WatchdogDeathTest, ASolverThatOnlyTalksIsEndedToo) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto talk = [] {
    Watchdog watchdog([] { return true; },
                      [](const Watchdog::MakeResult&, const std::string&) { return 7; }, 100ms);
    alarm(longest);
    for (;;) watchdog.stop();
  };
  EXPECT_EXIT(talk(), ::testing::ExitedWithCode(7), "");
}

// While the watchdog writes, the solver may come to its end: it must not write too.
TEST(WatchdogDeathTest, OnlyOneOfThemEndsTheProcess) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto late = [] {
    std::atomic<bool> ending{false};
    Watchdog watchdog([] { return true; },
                      [&](const Watchdog::MakeResult&, const std::string&) {
                        ending = true;
                        std::this_thread::sleep_for(300ms);
                        return 7;
                      },
                      1ms);
    while (!ending) std::this_thread::sleep_for(1ms);
    watchdog.stand_down();
    std::_Exit(8);
  };
  EXPECT_EXIT(late(), ::testing::ExitedWithCode(7), "");
}

}  // namespace
}  // namespace vasorod
