// How a caller ends a long step, such as a factorisation, before it is done.
#pragma once

#include <functional>

namespace vasorod {

/// Asked in the middle of a step, from the thread that called it; true ends the step with an
/// Interruption. May be empty.
using StopInside = std::function<bool()>;

/// Thrown by a step that was stopped inside. The solver that asked for it catches it and returns
/// the state before the step.
struct Interruption {};

}  // namespace vasorod
