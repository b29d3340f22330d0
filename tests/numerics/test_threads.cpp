#include <gtest/gtest.h>
#include <stdexcept>
#include <thread>

#include "numerics/threads.h"

namespace vasorod {
namespace {

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
