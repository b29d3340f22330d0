// How a command that failed ends the program.
#pragma once

#include <string>

namespace vasorod {

/// To be called where an exception is handled: prints its sentence on standard error and returns
/// the exit code. 1: stopped before there was a state; 2: wrong input; 3: the file system, no
/// memory, or a bug.
int say_failure(const std::string& program = "vasorod");

}  // namespace vasorod
