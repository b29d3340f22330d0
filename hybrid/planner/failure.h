// What went wrong, in one sentence for the page.
#pragma once

#include <string>

namespace vasorod::planner {

struct Failure {
  int status = 500;  ///< of HTTP
  std::string sentence;
};

/// To be called where an exception is handled.
Failure failure_now();

}  // namespace vasorod::planner
