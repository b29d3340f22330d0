// The two errors a user can cause; everything else is a named status (a numerical outcome) or a
// bug.
#pragma once

#include <stdexcept>

namespace vasorod {

/// Wrong input or usage: one sentence saying file, place, what was found, what was expected. Exit
/// code 2.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The file system said no, or a program is missing. Exit code 3.
struct FileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace vasorod
