#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include "data/memory.h"

namespace vasorod {
namespace {

TEST(Memory, IsAtMostTheMachines) {
  ASSERT_TRUE(memory_limit());
  EXPECT_GT(*memory_limit(), 1e6);
  EXPECT_LE(*memory_limit(), double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGESIZE)));
}

// A limit cannot be raised again: in a process of its own.
TEST(MemoryDeathTest, ALimitOfTheAddressSpaceCounts) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer reserves terabytes of addresses";
#endif
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto limited = [] {
    constexpr rlim_t bytes = 3'000'000'000;
    const rlimit space{bytes, bytes};
    if (setrlimit(RLIMIT_AS, &space) != 0) std::_Exit(2);
    const double expected =
        std::min(double(bytes), double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGESIZE)));
    std::_Exit(memory_limit().value_or(INFINITY) <= expected ? 0 : 1);
  };
  EXPECT_EXIT(limited(), ::testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace vasorod
