// How much memory this process may have.
#pragma once

#include <optional>

namespace vasorod {

/// Bytes: the least of the machine's memory, the limit of the process's address space (ulimit -v)
/// and the limits of its control groups (containers). Empty where the system does not say.
std::optional<double> memory_limit();

}  // namespace vasorod
