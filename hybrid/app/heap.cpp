#include "app/heap.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <malloc.h>
#include <sys/mman.h>
#include <sys/resource.h>

#include "data/memory.h"

namespace vasorod {
namespace {

// Of the memory that the process may have. What it needs beyond comes in ordinary pages.
constexpr double set_aside = 0.5;
constexpr std::uintptr_t large_page = std::uintptr_t{2} << 20;

// An allocation that nothing reads or writes, or the compiler would leave it out.
void* allocate(std::size_t bytes) {
  void* volatile block = std::malloc(bytes);
  return block;
}

// Whether addresses count although nothing was put there: by a limit of the process, or for the
// whole machine, where the system promises no more memory than it has.
bool addresses_are_limited() {
  for (const auto resource : {RLIMIT_AS, RLIMIT_DATA})
    if (rlimit space{}; getrlimit(resource, &space) != 0 || space.rlim_cur != RLIM_INFINITY)
      return true;
  constexpr int strict = 2;  // vm.overcommit_memory
  int accounting = strict;
  return !(std::ifstream("/proc/sys/vm/overcommit_memory") >> accounting) || accounting == strict;
}

// Addresses for the heap, which take no memory before they are used: the heap grows through them.
// What it grows by later would have ordinary pages, as glibc asks for no others unless its
// environment tells it to when the process begins.
void set_large_pages_aside() {
  if (addresses_are_limited()) return;
  const double most = memory_limit().value_or(0);
  if (most <= 0) return;
  const auto bytes = static_cast<std::size_t>(set_aside * most);
  void* block = allocate(bytes);
  if (block == nullptr) return;
  const auto begin = reinterpret_cast<std::uintptr_t>(block);
  const std::uintptr_t first = (begin + large_page - 1) / large_page * large_page,
                       last = (begin + bytes) / large_page * large_page;
  if (first < last) madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
  std::free(block);
}

}  // namespace

void keep_freed_memory() {
#ifdef M_MMAP_MAX
  mallopt(M_MMAP_MAX, 0);         // no blocks of their own, which go back when they are freed
  mallopt(M_TRIM_THRESHOLD, -1);  // nothing goes back from the heap's end
  mallopt(M_ARENA_MAX, 1);        // nor to heaps of single threads, which have no large pages
  set_large_pages_aside();
#endif
}

}  // namespace vasorod
