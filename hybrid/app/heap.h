// What the process does with memory that was freed, and how it gets more.
#pragma once

namespace vasorod {

/// Freed memory stays with the process for the next allocation, and comes in large pages where the
/// system has them (transparent huge pages, on demand or always). By default glibc returns every
/// large block to the system at once, and the next one is handed out and cleared page by page
/// again, for a `coupled` solve with its large factors and matrices many times; and every access
/// to these looks up one of a few hundred thousand pages. Call before anything large is allocated
/// and before a second thread begins. Large pages need addresses that are set aside: there are none
/// where `ulimit` or the system counts these. Does nothing with another C library.
void keep_freed_memory();

}  // namespace vasorod
