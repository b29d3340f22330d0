#include <gtest/gtest.h>
#include <stdexcept>
#include <string>

#include "numerics/threads.h"

namespace vasorod {
namespace {

TEST(Threads, EachTaskIsDoneOnce) {
  for (const int threads : {-1, 0, 1, 2, 5, 40}) {
    std::vector<std::atomic<int>> done(23);
    in_parallel(threads, 23, [&](int k) { ++done[static_cast<size_t>(k)]; });
    for (const std::atomic<int>& count : done) EXPECT_EQ(count, 1) << threads << " threads";
  }
  in_parallel(3, 0, [](int) { FAIL() << "there is nothing to do"; });
}

TEST(Threads, TheFirstFailureIsThrownAfterAllHaveEnded) {
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
TEST(Threads, TheFirstFailureInOrderIsThrown) {
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

TEST(Threads, ATaskInTheBackgroundRunsBesideAndItsFailureIsThrownByGet) {
  EXPECT_FALSE(in_background([] { FAIL() << "there is one thread only"; }).valid());
  set_threads(2);
  std::atomic<bool> waiting = true;
  std::future<void> task = in_background([&] {
    EXPECT_EQ(threads(), 1);
    while (waiting) std::this_thread::yield();
  });
  ASSERT_TRUE(task.valid());
  waiting = false;
  task.get();
  EXPECT_THROW(in_background([] { throw std::runtime_error("no"); }).get(), std::runtime_error);
  set_threads(1);
}

TEST(Threads, FollowANumberThatOthersChange) {
  std::atomic<int> count = 1;
  follow_threads(&count);
  EXPECT_EQ(threads(), 1);
  count = 3;
  EXPECT_EQ(threads(), 3);
  std::thread([] { EXPECT_EQ(threads(), 1); }).join();
  set_threads(2);
  EXPECT_EQ(threads(), 3);
  count = 1;
  EXPECT_EQ(threads(), 2);
  count = 1'000'000;  // 136 TB of buffers
  EXPECT_EQ(threads(), 2);
  follow_threads(nullptr);
  set_threads(1);
  EXPECT_EQ(threads(), 1);
}

TEST(Threads, AreThoseOfTheThreadThatAsks) {
  EXPECT_EQ(threads(), 1);
  set_threads(3);
  EXPECT_EQ(threads(), 3);
  std::thread([] { EXPECT_EQ(threads(), 1); }).join();
  set_threads(0);
  EXPECT_EQ(threads(), 1);
  EXPECT_GE(processors(), 1);
}

}  // namespace
}  // namespace vasorod
