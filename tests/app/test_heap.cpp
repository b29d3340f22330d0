#include <algorithm>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <gtest/gtest.h>
#include <memory>
#include <string>
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

bool has_large_pages() {
  std::ifstream setting("/sys/kernel/mm/transparent_hugepage/enabled");
  std::string text;
  std::getline(setting, text);
  return text.find("[madvise]") != std::string::npos || text.find("[always]") != std::string::npos;
}

bool promises_only_its_memory() {
  int accounting = 0;
  std::ifstream("/proc/sys/vm/overcommit_memory") >> accounting;
  return accounting == 2;
}

// Whether the system may hand out large pages at an address ("hg" in its mapping's flags); whether
// it has one at hand is not asked.
bool may_have_large_pages(const void* address) {
  const auto place = reinterpret_cast<std::uintptr_t>(address);
  std::ifstream mappings("/proc/self/smaps");
  bool here = false;
  for (std::string line; std::getline(mappings, line);) {
    std::uintptr_t begin = 0, end = 0;
    if (std::sscanf(line.c_str(), "%" SCNxPTR "-%" SCNxPTR " ", &begin, &end) == 2)
      here = begin <= place && place < end;
    else if (here && line.rfind("VmFlags:", 0) == 0)
      return line.find(" hg") != std::string::npos;
  }
  return false;
}

bool large_blocks_may_have_large_pages() {
  keep_freed_memory();
  constexpr std::size_t bytes = std::size_t{64} << 20;
  const std::unique_ptr<char[]> first(new char[bytes]), second(new char[bytes]);
  return may_have_large_pages(first.get() + bytes / 2) &&
         may_have_large_pages(second.get() + bytes / 2);
}

// Addresses that are set aside must not take the memory's place where they are counted.
bool leaves_limited_addresses() {
  const rlimit most{.rlim_cur = rlim_t{1} << 30, .rlim_max = RLIM_INFINITY};
  if (setrlimit(RLIMIT_AS, &most) != 0) return false;
  keep_freed_memory();
  std::ifstream status("/proc/self/statm");
  long pages = 0;
  return status >> pages && pages * sysconf(_SC_PAGESIZE) < (1L << 30) / 3;
}

// Each in a process of its own, as the heap is the process's.
class Heap : public ::testing::Test {
 protected:
  void SetUp() override {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "the sanitizer has a heap of its own";
#endif
    GTEST_FLAG_SET(death_test_style, "threadsafe");
  }
};

TEST_F(Heap, TheSecondLargeBlockNeedsNoNewPages) {
  EXPECT_EXIT(_exit(second_block_is_kept() ? 0 : 1), ::testing::ExitedWithCode(0), "");
}

TEST_F(Heap, HasLargePagesWhereTheSystemHasThem) {
  if (!has_large_pages()) GTEST_SKIP() << "transparent huge pages are turned off";
  if (promises_only_its_memory()) GTEST_SKIP() << "the system promises no memory that it has not";
  EXPECT_EXIT(_exit(large_blocks_may_have_large_pages() ? 0 : 1), ::testing::ExitedWithCode(0), "");
}

TEST_F(Heap, SetsNothingAsideWhereAddressesAreLimited) {
  EXPECT_EXIT(_exit(leaves_limited_addresses() ? 0 : 1), ::testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace vasorod
