#include "app/heap.h"

#include <limits>
#include <malloc.h>

namespace vasorod {

void keep_freed_memory() {
#ifdef M_MMAP_MAX
  mallopt(M_MMAP_MAX, 0);  // no blocks of their own, which go back when they are freed
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
#endif
}

}  // namespace vasorod
