// What is told of an error while it is being handled.
#pragma once

namespace vasorod::testing {

/// `told()`, called in the handler of `error`.
template <class Error, class Told>
auto caught(const Error& error, Told told) {
  try {
    throw error;
  } catch (...) {
    return told();
  }
}

}  // namespace vasorod::testing
