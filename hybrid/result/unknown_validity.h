// Whether a result's validity is known, for everything that writes or shows it.
#pragma once

#include <optional>
#include <string>

#include <vasorod/result.h>

namespace vasorod {

/// Whether the model is in its range; empty where nobody can say: the state is no solution, or
/// nothing was solved (`fit`).
std::optional<bool> known_range(const Result& result);

/// The sentence for a state that is no solution; empty text for one that is.
std::string why_unknown(Status status);

}  // namespace vasorod
