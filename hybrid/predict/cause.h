// What an exception means to who asked for a prediction.
#pragma once

#include <string>

namespace vasorod {

/// Why something was not done, in one sentence.
struct Cause {
  enum class Kind {
    stopped,  ///< before there was a state
    input,    ///< wrong input
    system    ///< the file system, no memory, or a bug
  } kind = Kind::system;
  std::string sentence;
};

/// To be called where an exception is handled.
Cause cause_now();

}  // namespace vasorod
