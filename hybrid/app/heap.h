// What the process does with memory that was freed.
#pragma once

namespace vasorod {

/// Freed memory stays with the process for the next allocation. By default glibc returns every
/// large block to the system at once, and the next one is handed out and cleared page by page
/// again, for a `coupled` solve with its large factors and matrices many times. Call
/// before anything large is allocated. Does nothing with another C library.
void keep_freed_memory();

}  // namespace vasorod
