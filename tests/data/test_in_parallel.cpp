#include <gtest/gtest.h>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "data/in_parallel.h"

namespace vasorod {
namespace {

TEST(InParallel, EachTaskIsDoneOnce) {
  for (const int threads : {-1, 0, 1, 2, 5, 40}) {
    std::vector<std::atomic<int>> done(23);
    in_parallel(threads, 23, [&](int k) { ++done[static_cast<size_t>(k)]; });
    for (const std::atomic<int>& count : done) EXPECT_EQ(count, 1) << threads << " threads";
  }
  in_parallel(3, 0, [](int) { FAIL() << "there is nothing to do"; });
}

TEST(InParallel, TheFirstFailureIsThrownAfterAllHaveEnded) {
  for (const int threads : {1, 4}) {
    std::atomic<int> working = 0, most = 0;
    const auto task = [&](int k) {
      ++working;
      most = std::max<int>(most, k);
      const bool bad = k == 5;
      --working;
      if (bad) throw std::runtime_error("five");
    };
    EXPECT_THROW(in_parallel(threads, 1000000, task), std::runtime_error);
    EXPECT_EQ(working, 0);
    EXPECT_LT(most, 999999) << "the rest is not begun";
  }
}

// Whichever fails first in time.
TEST(InParallel, TheFirstFailureInOrderIsThrown) {
  for (int repeat = 0; repeat < 20; ++repeat) {
    std::atomic<bool> second = false;
    const auto task = [&](int k) {
      if (k == 0)
        while (!second) std::this_thread::yield();
      second = second || k == 1;
      throw std::runtime_error(std::to_string(k));
    };
    try {
      in_parallel(2, 2, task);
      ADD_FAILURE();
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "0");
    }
  }
}

TEST(InParallel, ATaskThatSharesItsOwnWorkDoesItAlone) {
  std::vector<std::atomic<int>> done(30);
  in_parallel(2, 3, [&](int i) {
    in_parallel(2, 10, [&](int j) { ++done[static_cast<std::size_t>(10 * i + j)]; });
  });
  for (const std::atomic<int>& count : done) EXPECT_EQ(count, 1);
}

}  // namespace
}  // namespace vasorod
