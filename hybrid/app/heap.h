// What the process does with memory that was freed.
#pragma once

namespace vasorod {

/// Freed memory stays with the process for the next allocation. By default glibc returns every
/// large block to the system at once, and the next one is handed out and cleared page by page
/// again: a ninth of the time of a `coupled` solve, whose factors and matrices are large. Call
/// first of all. Does nothing with another C library.
void keep_freed_memory();

}  // namespace vasorod
