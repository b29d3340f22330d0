#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include "app/heap.h"

namespace vasorod {
namespace {

long faults() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_minflt;
}

// Pages that the system had to hand out for a large block that is filled.
long pages_for(std::size_t bytes) {
  const long before = faults();
  void* block = std::malloc(bytes);
  if (block == nullptr) return -1;
  std::memset(block, 1, bytes);
  static_cast<void>(*static_cast<volatile char*>(block));  // it is used
  std::free(block);
  return faults() - before;
}

bool second_block_is_kept() {
  constexpr std::size_t bytes = std::size_t{64} << 20;
  const long pages = static_cast<long>(bytes) / sysconf(_SC_PAGESIZE);
  keep_freed_memory();
  const long first = pages_for(bytes), second = pages_for(bytes);
  // Where the system hands out large pages, the first needs fewer than `pages`.
  return first > 0 && second >= 0 && second < std::min(first, pages / 10);
}

// In a process of its own, as the heap is the process's.
TEST(Heap, TheSecondLargeBlockNeedsNoNewPages) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer has a heap of its own";
#endif
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(_exit(second_block_is_kept() ? 0 : 1), ::testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace vasorod
