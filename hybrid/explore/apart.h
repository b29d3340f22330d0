// Jobs in processes beside this one, a few at once. A process that crashes or finds no memory loses
// one option, and one in the middle of a factorisation can be ended at any time. A process does one
// job after the other: memory that the system has cleared for it once is there for the next.
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace vasorod {

/// How a job ended.
struct ApartEnding {
  std::optional<std::string> answer;      ///< what the job returned
  std::optional<std::string> file_error;  ///< the sentence of a FileError that it threw
  /// Otherwise, one sentence: another exception, or how the process ended.
  std::string failure;
};

struct ApartOptions {
  int at_once = 1;              ///< processes at once, and threads of all, at least 1
  std::function<bool()> stop;   ///< asked ten times a second; true ends the processes
  std::function<void()> begin;  ///< called first in each process; may be empty
};

/// Calls job(0) to job(count - 1) in forked processes that have the state of this one and of the
/// jobs that they did before, and take(k, ending) in this process in the order in which they end. A
/// job's answer must not depend on those before it; after one that failed, another process goes on.
/// Where fewer jobs are left than may run at once, threads() of each becomes its part of all, also
/// in the middle of a job. Call it while this process has one thread. A process ends with its
/// parent, however that ends. False: it was stopped; what had not ended is not taken. An exception
/// of `take` ends the processes too.
bool run_apart(int count, const std::function<std::string(int)>& job,
               const std::function<void(int, const ApartEnding&)>& take,
               const ApartOptions& options);

}  // namespace vasorod
