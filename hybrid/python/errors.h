// The library's errors as Python's.
#pragma once

namespace vasorod::python {

/// InputError -> ValueError, FileError -> OSError, StoppedEarly -> TimeoutError, no memory ->
/// MemoryError; each with the sentence that the program says.
void translate_errors();

}  // namespace vasorod::python
