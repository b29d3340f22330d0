// The two errors that a user can cause. Every other failure is a named status (a numerical
// outcome) or a bug.
#pragma once

#include <stdexcept>

namespace vasorod {

/// Wrong input or usage. The message is one sentence with the file, the place, what was found and
/// what was expected. The programs exit with code 2.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A file cannot be read or written, or a program is missing. The programs exit with code 3.
struct FileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace vasorod
